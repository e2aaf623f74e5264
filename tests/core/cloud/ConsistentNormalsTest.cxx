// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Normals that the winding number agrees with: clouds on which a spanning tree fails, noise, bits
/// for threads and orders of points, and clouds that enclose nothing.

#include "cloud/ConsistentNormals.h"

#include "cloud/NormalEstimation.h"
#include "cloud/NormalTrials.h"
#include "cloud/PatchSigns.h"
#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

using namespace shapes;

winding::ConsistentNormals estimate(const std::vector<Point>& positions, int neighbors = 20)
{
  return winding::consistentNormals(placesOf(positions), neighbors, serial);
}

/// Points on surfaces, with their normals.
struct Scan
{
  std::vector<Point> positions, normals;
};

/// Points on a sphere at the origin; sense: 1 for normals that point outward, −1 for a cavity.
void addSphere(Scan& scan, std::size_t count, double radius, int sense, Random& random)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = random(-1, 1), along = random(0, 6.283185307179586);
    const double width = std::sqrt(1 - z * z);
    const Point normal(width * std::cos(along), width * std::sin(along), z);
    scan.positions.push_back(radius * normal);
    scan.normals.push_back(sense * normal);
  }
}

/// Points on the faces of a box, as many as suit the faces' areas.
void addBox(Scan& scan, std::size_t count, const Point& low, const Point& high, Random& random)
{
  const Point size = high - low;
  const double areas[] = {size[1] * size[2], size[2] * size[0], size[0] * size[1]};
  const double all = areas[0] + areas[1] + areas[2];
  for (std::size_t i = 0; i < count; ++i)
  {
    const double choice = random(0, all);
    const int axis = choice < areas[0] ? 0 : choice < areas[0] + areas[1] ? 1 : 2;
    const bool isHigh = random(0, 1) < 0.5;
    Point position{random(low[0], high[0]), random(low[1], high[1]), random(low[2], high[2])};
    position[axis] = isHigh ? high[axis] : low[axis];
    scan.positions.push_back(position);
    scan.normals.push_back((isHigh ? 1 : -1) * Point::Unit(axis));
  }
}

/// Returns the share of normals, which must have length 1, that rightShare() counts.
double unitShare(
  const std::vector<Point>& normals, const std::vector<Point>& expected, double cosine = 0)
{
  for (const Point& normal : normals)
  {
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
  }
  return rightShare(normals, expected, cosine);
}

/// Nested spheres, solid between the first and the second one, and the third and the fourth one.
Scan shells()
{
  Scan scan;
  Random random(1);
  addSphere(scan, 4000, 1, 1, random);
  addSphere(scan, 2500, 0.8, -1, random);
  addSphere(scan, 1500, 0.6, 1, random);
  addSphere(scan, 600, 0.4, -1, random);
  return scan;
}

/// Plates side by side, as far from each other as they are thick.
Scan plates()
{
  Scan scan;
  Random random(4);
  for (int i = 0; i < 3; ++i)
  {
    addBox(scan, 6000, Point(0, 0, 0.3 * i), Point(2, 2, 0.3 * i + 0.15), random);
  }
  return scan;
}

/// Moves points by steps that are about normally distributed.
void addNoise(Scan& scan, double size, Random& random)
{
  for (Point& position : scan.positions)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] += size * random.normal();
    }
  }
}

constexpr double cosineOf8Degrees = 0.99, cosineOf20Degrees = 0.94;

/// A hollow box with `points` points on its outer sheet. Its walls are so thin that many of the
/// neighbours of a point are on the other sheet, and planes through points of both are tilted.
Scan hollowBox(int points, unsigned seed = 11)
{
  Scan scan;
  Random random(seed);
  addBox(scan, points, Point(-1, -1, -1), Point(1, 1, 1), random);
  addBox(scan, points * 11 / 12, Point(-0.9, -0.9, -0.9), Point(0.9, 0.9, 0.9), random);
  std::for_each(scan.normals.begin() + points, scan.normals.end(), [](Point& n) { n = -n; });
  return scan;
}

/// Plates three spacings thick and as far from each other, with noise of half a spacing.
Scan noisyPlates()
{
  Scan scan;
  Random random(12);
  for (int i = 0; i < 4; ++i)
  {
    addBox(scan, 3125, Point(0, 0, 0.076 * i), Point(0.5, 0.5, 0.076 * i + 0.038), random);
  }
  addNoise(scan, 0.0072, random);
  return scan;
}

/// Thin posts and two rails next to them, with noise of more than half a spacing.
Scan noisyFrame()
{
  constexpr double thick = 0.1, crowd = 1500; // points by area
  Scan scan;
  Random random(11);
  constexpr auto points = static_cast<std::size_t>(crowd * (8 * thick + 2 * thick * thick));
  for (int i = 0; i < 5; ++i)
  {
    addBox(scan, points, Point(0.4 * i, 0, 0), Point(0.4 * i + thick, thick, 2), random);
  }
  for (const double low : {0.6, 1.4})
  {
    addBox(scan, points, Point(0, 1.5 * thick, low), Point(2, 2.5 * thick, low + thick), random);
  }
  addNoise(scan, 0.6 / std::sqrt(crowd), random);
  return scan;
}

/// A plate whose noise is twice its thickness, and more than the spacing of its points.
Scan veryNoisyPlate()
{
  Scan scan;
  Random random(14);
  addBox(scan, 8000, Point(0, 0, -0.005), Point(1, 1, 0.005), random);
  addNoise(scan, 0.02, random);
  return scan;
}

} // namespace

TEST(ConsistentNormals, OfNestedShellsPointIntoTheirCavities)
{
  const Scan scan = shells();
  const winding::ConsistentNormals estimated = estimate(scan.positions);
  EXPECT_EQ(unitShare(estimated.normals, scan.normals), 1);
  EXPECT_LT(estimated.deviation, 0.01); // 0.003
}

TEST(ConsistentNormals, OfPlatesSideBySide)
{
  const Scan scan = plates();
  EXPECT_GT(unitShare(estimate(scan.positions).normals, scan.normals), 0.97); // 0.99
}

TEST(ConsistentNormals, OfThinWallsAreThoseOfTheirTwoSheets)
{
  // The walls are 1.6 spacings thick.
  const Scan scan = hollowBox(6000);
  const std::vector<Point> normals = estimate(scan.positions).normals;
  // 0.84; of planes through all neighbours 0.27
  EXPECT_GT(unitShare(normals, scan.normals, cosineOf8Degrees), 0.8);
}

TEST(ConsistentNormals, OfWallsWhoseSensesTheTreeFindsAreThoseOfTheirTwoSheets)
{
  // The walls are 2.4 spacings thick. The tree finds the senses for one seed of twelve.
  const Scan scan = hollowBox(14000, 10);
  const winding::ConsistentNormals estimated = estimate(scan.positions);
  EXPECT_FALSE(estimated.triedPatches);
  // 0.87; of planes through all neighbours 0.67
  EXPECT_GT(unitShare(estimated.normals, scan.normals, cosineOf8Degrees), 0.8);
}

TEST(ConsistentNormals, OfPartsThatTouch)
{
  Scan scan;
  Random random(2);
  addBox(scan, 4000, Point(0, 0, 0), Point(1, 1, 1), random);
  addBox(scan, 4000, Point(1.06, 0.2, 0.1), Point(2, 1.4, 0.9), random);
  addBox(scan, 2000, Point(0.2, 0.3, 1.07), Point(1.8, 0.8, 1.4), random);
  EXPECT_GT(unitShare(estimate(scan.positions).normals, scan.normals), 0.97);
}

TEST(ConsistentNormals, OfNoisyPoints)
{
  // The spacing is 0.04. Patches orient the first cloud, and the spanning tree the second one.
  for (const double noise : {0.025, 0.03})
  {
    Scan scan;
    Random random(3);
    addSphere(scan, 8000, 1, 1, random);
    addSphere(scan, 4000, 0.7, -1, random);
    addNoise(scan, noise, random);
    const std::vector<Point> normals = estimate(scan.positions).normals;
    // 1.0000 and 0.9994; 0.985 and 1.000 as they are found first
    EXPECT_GT(unitShare(normals, scan.normals), 0.995) << noise;
    // 1.0000 and 0.997; 0.985 and 0.836 as they are found first
    EXPECT_GT(unitShare(normals, scan.normals, cosineOf20Degrees), 0.99) << noise;
  }
}

TEST(ConsistentNormals, OfNoisyPlatesSideBySide)
{
  const Scan scan = noisyPlates();
  // 0.954; 0.69 by places of a thinned cloud
  EXPECT_GT(unitShare(estimate(scan.positions).normals, scan.normals), 0.93);
}

TEST(ConsistentNormals, OfANoisyFrame)
{
  const Scan scan = noisyFrame();
  // 0.952; 0.929 where w is to be near 1/2 without a factor for the areas, which are too large. On
  // average of twelve seeds 0.940 and 0.926
  EXPECT_GT(unitShare(estimate(scan.positions).normals, scan.normals), 0.942);
}

TEST(Deviation, UpToScaleIsTheLeastForAnyFactor)
{
  Random random(17);
  for (const double scale : {0.2, 1.0, 3.0})
  {
    Eigen::VectorXd w(200);
    for (double& value : w)
    {
      value = scale * (0.5 + 0.2 * random.normal());
    }
    double least = 0.25;
    for (int i = 1; i < 2000; ++i)
    {
      least = std::min(least, winding::deviationOf(0.003 * i * w));
    }
    EXPECT_LE(winding::deviationUpToScale(w), least);
    EXPECT_NEAR(winding::deviationUpToScale(w), least, 1e-4);
    // No factor makes normals that point inward fit.
    EXPECT_NEAR(winding::deviationUpToScale(-w), 0.25, 1e-12);
  }
}

TEST(ConsistentNormals, OfAPlateThinnerThanItsNoiseTellItsTwoSides)
{
  const Scan scan = veryNoisyPlate();
  const std::vector<Point> normals = estimate(scan.positions).normals;
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    right += normals[i][2] * scan.positions[i][2] > 0;
  }
  // 0.876; 0.848 as they are found first, and 0.751 by places of a thinned cloud
  EXPECT_GT(static_cast<double>(right), 0.86 * static_cast<double>(normals.size()));
}

TEST(ConsistentNormals, HaveTheSameBitsForAnyThreadsAndOrder)
{
  for (const Scan& scan : {plates(), noisyPlates(), noisyFrame(), veryNoisyPlate()})
  {
    const winding::ConsistentNormals expected = estimate(scan.positions);
    std::vector<std::size_t> order(scan.positions.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    std::vector<Point> shuffled;
    for (const std::size_t point : order)
    {
      shuffled.push_back(scan.positions[point]);
    }
    ShuffledThreads threads(5);
    const winding::ConsistentNormals other =
      winding::consistentNormals(placesOf(shuffled), 20, threads);
    EXPECT_EQ(other.deviation, expected.deviation);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ASSERT_EQ(other.normals[i], expected.normals[order[i]]);
    }
  }
}

TEST(NormalsToTurn, AreThoseThatHaveBeenTurned)
{
  const Scan scan = plates();
  EXPECT_EQ(winding::normalsToTurn(scan.positions, scan.normals, serial),
    std::vector<unsigned char>(scan.normals.size(), 0));
  Random random(8);
  for (const double share : {0.02, 0.5, 1.0})
  {
    std::vector<Point> normals = scan.normals;
    std::vector<unsigned char> expected;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      // Regions are turned, as if a cloud were merged from scans.
      const int region = static_cast<int>(
        std::floor(5 * scan.positions[i][0]) + 7 * std::floor(5 * scan.positions[i][1]));
      const bool isTurned = share == 1 || (share == 0.5 ? region % 2 == 0 : random(0, 1) < share);
      expected.push_back(isTurned);
      normals[i] *= isTurned ? -1 : 1;
    }
    const std::vector<unsigned char> turns =
      winding::normalsToTurn(scan.positions, normals, serial);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < turns.size(); ++i)
    {
      wrong += turns[i] != expected[i];
    }
    // A few normals among many leave w about right, and are found by their neighbours only where
    // others are wrong, too.
    const double most = share < 0.1 ? 1.01 * share : 0.01;
    EXPECT_LE(static_cast<double>(wrong), most * static_cast<double>(turns.size())) << share;
  }
}

TEST(NormalsToTurn, DoNotDependOnTheOrderOfPointsAtOnePlace)
{
  // Many places have two points, with normals that are different and may have opposite senses.
  Scan scan = plates();
  Random random(10);
  const std::size_t once = scan.positions.size();
  for (std::size_t i = 0; i < once; i += 3)
  {
    const Point aside = random.point(-0.3, 0.3);
    scan.positions.push_back(scan.positions[i]);
    scan.normals.push_back((random(0, 1) < 0.5 ? -1 : 1) * (scan.normals[i] + aside).normalized());
  }
  for (std::size_t i = 0; i < once; ++i)
  {
    scan.normals[i] *= random(0, 1) < 0.5 ? -1 : 1;
  }
  std::vector<std::size_t> order(scan.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  Scan other;
  for (const std::size_t point : order)
  {
    other.positions.push_back(scan.positions[point]);
    other.normals.push_back(scan.normals[point]);
  }
  ShuffledThreads threads(5);
  const auto expected = winding::normalsToTurn(scan.positions, scan.normals, serial);
  const auto turns = winding::normalsToTurn(other.positions, other.normals, threads);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ASSERT_EQ(turns[i], expected[order[i]]) << i;
  }
}

TEST(ConsistentNormals, AreTheSameWhereTheSpanningTreeIsKnown)
{
  const Scan scan = shells();
  const std::vector<Point> byTree = winding::estimateNormals(placesOf(scan.positions), 20, serial);
  const winding::ConsistentNormals expected = estimate(scan.positions);
  const winding::ConsistentNormals found =
    winding::consistentNormals(placesOf(scan.positions), 20, serial, byTree);
  EXPECT_EQ(found.normals, expected.normals);
  EXPECT_EQ(found.deviation, expected.deviation);
  EXPECT_TRUE(found.triedPatches);
}

/// Clouds that enclose nothing, or are no surfaces at all.
TEST(ConsistentNormals, OfDegenerateCloudsAreFinite)
{
  std::vector<std::vector<Point>> clouds = {{}, {Point(1, 2, 3)}, {Point(0, 0, 0), Point(1, 0, 0)},
    std::vector<Point>(100, Point(1, 1, 1)), {}, {}, {}};
  for (int i = 0; i < 400; ++i)
  {
    clouds[4].emplace_back(i, 2 * i, 3 * i);
    clouds[5].emplace_back(i % 20, i / 20, 0);
    clouds[6].emplace_back(i % 20, i / 20, i % 7);
  }
  clouds[6].emplace_back(1e6, 1e6, 1e6);
  for (const std::vector<Point>& cloud : clouds)
  {
    for (const int neighbors : {3, 20})
    {
      const std::vector<Point> normals = estimate(cloud, neighbors).normals;
      ASSERT_EQ(normals.size(), cloud.size());
      unitShare(normals, normals);
    }
  }
}

TEST(PatchSigns, AreThoseOfTheLeastSquares)
{
  // Any signs can be found again from shares that have been multiplied by them.
  Random random(6);
  constexpr Eigen::Index points = 60, patches = 12;
  for (int repeat = 0; repeat < 20; ++repeat)
  {
    Eigen::MatrixXd shares(points, patches);
    Eigen::VectorXd expected(patches);
    for (Eigen::Index p = 0; p < patches; ++p)
    {
      expected[p] = random(0, 1) < 0.5 ? -1 : 1;
      for (Eigen::Index m = 0; m < points; ++m)
      {
        shares(m, p) = random(-1, 1);
      }
    }
    // The last patch makes the sum one half.
    shares.col(patches - 1).setConstant(0.5);
    expected[patches - 1] = 1;
    shares.col(patches - 1) -= shares.leftCols(patches - 1) * expected.head(patches - 1);
    EXPECT_EQ(winding::patchSigns(shares), expected);
  }
}

TEST(ConsistentNormals, OfPlacesWhoseSquaresOfDistancesUnderflowAreOfUnitLength)
{
  Scan scan;
  Random random(13);
  addSphere(scan, 2000, 1, 1, random);
  addNoise(scan, 0.1, random);
  for (int i = 0; i < 500; ++i)
  {
    scan.positions.emplace_back(1e-200 * (i % 25), 1e-200 * (i / 25), 0);
  }
  for (const Point& normal : estimate(scan.positions).normals)
  {
    ASSERT_NEAR(normal.norm(), 1, 1e-9);
  }
}
