// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PointAreas.h"
#include "base/Pi.h"

#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include "cloud/NormalEstimation.h"
#include "cloud/VoronoiCell.h"
#include "source/PointCloud.h"
#include "sums/SolidAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

using namespace shapes;

constexpr double sphereArea = 4 * winding::pi;

std::vector<double> voronoiAreas(const winding::PointCloud& cloud, int neighbors = 20)
{
  return winding::voronoiAreas(cloud, placesOf(cloud.positions), neighbors, serial);
}

double meanPointArea(const winding::PointCloud& cloud)
{
  return winding::meanPointArea(
    cloud, placesOf(cloud.positions), winding::defaultNeighbors, serial);
}

double total(const std::vector<double>& areas)
{
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

double relativeError(double area, double expected)
{
  return std::abs(area / expected - 1);
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// A sphere of random directions; if it is graded, only a tenth of those that point up are kept.
Cloud randomSphere(std::size_t count, unsigned seed, bool isGraded = false)
{
  Random random(seed);
  Cloud cloud;
  while (cloud.positions.size() < count)
  {
    const Point direction = random.direction();
    if (!isGraded || direction[2] < 0 || random(0, 1) < 0.1)
    {
      cloud.positions.push_back(direction);
    }
  }
  cloud.normals = cloud.positions;
  return cloud;
}

/// Points of a plane, in the order of x, then y; `shift` moves each by up to so much.
Cloud lattice(int side, double shift, unsigned seed)
{
  Random random(seed);
  Cloud cloud;
  for (int i = 0; i < side * side; ++i)
  {
    cloud.positions.push_back(
      Point{i % side + random(-shift, shift), i / side + random(-shift, shift), 0});
  }
  cloud.normals.assign(cloud.positions.size(), Point(0, 0, 1));
  return cloud;
}

/// Points of several scans of the same places, each up to `noise` off in each direction.
Cloud scansOf(const Cloud& places, int scans, double noise)
{
  Random random(1);
  Cloud cloud;
  for (int scan = 0; scan < scans; ++scan)
  {
    for (const Point& place : places.positions)
    {
      cloud.positions.push_back(
        place + Point(random(-noise, noise), random(-noise, noise), random(-noise, noise)));
    }
    cloud.normals.insert(cloud.normals.end(), places.normals.begin(), places.normals.end());
  }
  return cloud;
}

/// The area of the part of the unit sphere that is nearer to one point of a cloud than to all
/// others. Bisectors, seen from the centre of the sphere, are straight lines in the point's tangent
/// plane.
double exactAreaOnSphere(const Cloud& cloud, std::size_t point)
{
  const Point center = cloud.positions[point];
  const Point u = center.unitOrthogonal(), v = center.cross(u);
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 4; ++i)
  {
    corners.emplace_back(i == 0 || i == 3 ? 10 : -10, i < 2 ? 10 : -10);
  }
  for (const Point& other : cloud.positions)
  {
    const Point normal = center - other;
    const auto side = [&](const Eigen::Vector2d& p)
    {
      return normal.dot(center + p[0] * u + p[1] * v);
    };
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < corners.size() && other != center; ++i)
    {
      const Eigen::Vector2d &from = corners[i], &to = corners[(i + 1) % corners.size()];
      if (side(from) >= 0)
      {
        kept.push_back(from);
      }
      if ((side(from) >= 0) != (side(to) >= 0))
      {
        kept.push_back(from + side(from) / (side(from) - side(to)) * (to - from));
      }
    }
    corners = other == center ? corners : kept;
  }
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Eigen::Vector2d &p = corners[i], &q = corners[(i + 1) % corners.size()];
    area += winding::solidAngle<double>(
      center, center + p[0] * u + p[1] * v, center + q[0] * u + q[1] * v);
  }
  return area;
}

} // namespace

TEST(VoronoiCell, AreasAreNeverNegative)
{
  // Neighbours on a line through the point, some of them a billion times closer than others, leave
  // cells whose corners are off by more than the cells are wide.
  SCOPED_TRACE("seed 861");
  Random random(861);
  winding::VoronoiCell cell;
  for (int i = 0; i < 20000; ++i)
  {
    cell.start(1);
    for (int neighbor = 0; neighbor < 6; ++neighbor)
    {
      const double distance = std::exp2(random(-60, 0));
      const double angle = neighbor % 2 ? 0 : random(0, 2 * winding::pi);
      const double sense = neighbor % 4 < 2 ? 1 : -1;
      cell.cut({sense * distance * std::cos(angle), distance * std::sin(angle)});
    }
    ASSERT_GE(cell.area(), 0) << "cell " << i;
  }
}

TEST(VoronoiCell, IsThePolygonOfTheNearestPoints)
{
  winding::VoronoiCell cell;
  cell.start(10);
  EXPECT_NEAR(cell.area(), 100 * winding::pi, 1e-9);
  EXPECT_TRUE(cell.isOpen());
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(2, 0), {-2, 0}, {0, 4}, {0, 0}, {100, 100}})
  {
    cell.cut(point);
    EXPECT_TRUE(cell.isOpen());
  }
  cell.cut({0, -4});
  EXPECT_FALSE(cell.isOpen());
  EXPECT_NEAR(cell.area(), 8, 1e-14);
  cell.cut({2, 4});
  // The bisector of (2, 4), x + 2y = 5, touches the corner (1, 2): nothing of [−1, 1] × [−2, 2]
  // goes.
  EXPECT_NEAR(cell.area(), 8, 1e-14);
  cell.cut({2, 2});
  EXPECT_NEAR(cell.area(), 8 - 0.5, 1e-14); // x + y = 2 cuts the triangle (0, 2) (1, 1) (1, 2) off
}

TEST(VoronoiAreas, OfAUniformSphereAreRightInTotalAndEach)
{
  std::vector<double> areas = voronoiAreas(clean(sphereCloud(20'000)));
  const double error = relativeError(total(areas), sphereArea);
  record("total", error);
  EXPECT_LT(error, 1e-3); // measured: 2.0e-4
  for (double& area : areas)
  {
    area = relativeError(area, sphereArea / 20'000);
  }
  record("median", median(areas));
  EXPECT_LT(median(areas), 1e-3); // measured: 2.0e-4
}

TEST(VoronoiAreas, OfRandomSpheresAreThoseOfTheSphericalCells)
{
  SCOPED_TRACE("seeds 71, 72");
  for (const bool isGraded : {false, true})
  {
    const Cloud cloud = randomSphere(20'000, isGraded ? 72 : 71, isGraded);
    const std::vector<double> areas = voronoiAreas(clean(cloud));
    const std::string name = isGraded ? "graded" : "uniform";
    const double error = relativeError(total(areas), sphereArea);
    record(name + "Total", error);
    EXPECT_LT(error, 0.02) << name; // measured: 0.0002 and 0.0021
    std::vector<double> errors;
    for (std::size_t i = 0; i < 20'000; i += 50)
    {
      errors.push_back(relativeError(areas[i], exactAreaOnSphere(cloud, i)));
    }
    record(name + "Median", median(errors));
    EXPECT_LT(median(errors), 0.01) << name; // measured: 2e-4 and 1e-4
  }
}

TEST(VoronoiAreas, OfAnUnevenSphereMakeAPlateauWhereOneAreaForAllMakesNone)
{
  SCOPED_TRACE("seed 72");
  const Cloud cloud = randomSphere(20'000, 72, true);
  const std::vector<double> areas = voronoiAreas(clean(cloud));
  const double mean = total(areas) / 20'000;
  // The flux is summed at two places inside, near the sparse and near the dense half.
  for (const double z : {0.8, -0.8})
  {
    double byVoronoi = 0, byMean = 0;
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
      const Point offset = cloud.positions[i] - Point(0, 0, z);
      byVoronoi += winding::dipoleSolidAngle<double>(offset, cloud.normals[i], areas[i]);
      byMean += winding::dipoleSolidAngle<double>(offset, cloud.normals[i], mean);
    }
    record((z > 0 ? "voronoiSparse" : "voronoiDense"), byVoronoi / sphereArea);
    record((z > 0 ? "meanSparse" : "meanDense"), byMean / sphereArea);
    EXPECT_NEAR(byVoronoi / sphereArea, 1, 0.03);           // measured: 1.000 and 0.999
    EXPECT_GT(std::abs(byMean / sphereArea - 1), 0.3) << z; // measured: 0.49 and 1.51
  }
}

TEST(VoronoiAreas, EndAtTheBorder)
{
  SCOPED_TRACE("seeds 73, 74, 75");
  for (const double shift : {0.0, 0.3, 0.5})
  {
    const std::vector<double> areas =
      voronoiAreas(clean(lattice(100, shift, 73 + static_cast<unsigned>(5 * shift))));
    const double error = relativeError(total(areas), 10'000);
    record("shift" + std::to_string(shift), error);
    EXPECT_LT(error, 0.03) << shift; // measured: 0.0011, 0.0091, 0.0147
    const double largest = *std::max_element(areas.begin(), areas.end());
    record("largest" + std::to_string(shift), largest);
    EXPECT_LT(largest, shift == 0 ? 1.2 : 5) << shift; // measured: 1.14, 3.21, 4.19
    EXPECT_GT(*std::min_element(areas.begin(), areas.end()), shift == 0 ? 0.8 : 0.05);
  }
}

TEST(VoronoiAreas, OfTheTwoSidesOfAThinPlateAreThoseOfEachSide)
{
  SCOPED_TRACE("seed 76");
  const Cloud top = lattice(70, 0.5, 76);
  const std::vector<double> alone = voronoiAreas(clean(top));
  Cloud plate = top;
  for (const Point& p : top.positions)
  {
    // Half of the points are at the same place as one of the other side.
    plate.positions.emplace_back(p[0], p[1], p[0] < 35 ? 0 : -1e-3);
    plate.normals.emplace_back(0, 0, -1);
  }
  const std::vector<double> both = voronoiAreas(clean(plate));
  const double error = relativeError(total(both), 2 * total(alone));
  record("error", error);
  EXPECT_LT(error, 0.02); // measured: 0.006
}

/// Half of the neighbours belong to the other side where a plate is thinner than its spacing. The
/// other half may be too few for a cell.
TEST(VoronoiAreas, OfTheTwoSidesOfAThinPlateAreThoseOfTheOneSide)
{
  SCOPED_TRACE("seed 88");
  Random random(88);
  Cloud top;
  for (int n = 0; n < 4000; ++n)
  {
    top.positions.push_back({random(0, 1), random(0, 1), 0});
    top.normals.push_back({0, 0, 1});
  }
  Cloud plate = top;
  for (int n = 0; n < 4000; ++n)
  {
    plate.positions.push_back({random(0, 1), random(0, 1), -1e-4});
    plate.normals.push_back({0, 0, -1});
  }
  const std::vector<double> alone = voronoiAreas(clean(top)), both = voronoiAreas(clean(plate));
  std::size_t differing = 0;
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    differing += std::abs(both[i] - alone[i]) > 1e-9;
  }
  // Measured: 215 at the border and where points are sparse, and 903 where no place is done again.
  EXPECT_LT(differing, 400u);
}

TEST(VoronoiAreas, AreSharedByPointsAtOnePlace)
{
  SCOPED_TRACE("seed 77");
  Cloud cloud = sphereCloud(2000);
  const std::vector<double> once = voronoiAreas(clean(cloud));
  for (std::size_t i = 0; i < 2000; i += 10)
  {
    cloud.positions.push_back(cloud.positions[i]);
    cloud.normals.push_back(cloud.normals[i]);
  }
  const std::vector<double> twice = voronoiAreas(clean(cloud));
  EXPECT_LT(relativeError(total(twice), total(once)), 1e-12);
  EXPECT_DOUBLE_EQ(twice[10], once[10] / 2);
  EXPECT_DOUBLE_EQ(twice[2001], once[10] / 2);
  EXPECT_DOUBLE_EQ(twice[11], once[11]);
}

TEST(VoronoiAreas, OfThousandsOfEqualPointsAreFoundAtOnce)
{
  // A search of quadratic time would take minutes here.
  Cloud cloud = sphereCloud(500);
  for (int i = 0; i < 200'000; ++i)
  {
    cloud.positions.push_back(cloud.positions[0]);
    cloud.normals.push_back(cloud.normals[i % 500]);
  }
  const std::vector<double> areas = voronoiAreas(clean(cloud));
  EXPECT_TRUE(std::all_of(areas.begin(), areas.end(), [](double area) { return area > 0; }));
}

TEST(VoronoiAreas, OfFewPointsArePositiveAndNoMoreThanTheirDistancesTell)
{
  const Cloud two{{{0, 0, 0}, {2, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  const Cloud three{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
  Cloud line;
  for (int i = 0; i < 50; ++i)
  {
    line.positions.emplace_back(i, 2 * i, 3 * i);
    line.normals.emplace_back(0, 0, 1);
  }
  // Normals along the line leave nothing to be seen in the tangent plane.
  Cloud along = line;
  along.normals.assign(50, Point(1, 2, 3).normalized());
  for (const auto& [cloud, most] :
    {std::pair(two, 8 * winding::pi), std::pair(three, 8 * winding::pi),
      std::pair(line, 400 * winding::pi), std::pair(along, 400 * winding::pi)})
  {
    for (const double area : voronoiAreas(clean(cloud)))
    {
      EXPECT_GT(area, 0) << cloud.positions.size();
      EXPECT_LT(area, most);
    }
  }
}

TEST(VoronoiAreas, AreNeverLessThanNothing)
{
  // The cell of one of these points, which lie in a plane up to 10⁻⁹, is a line: its area was
  // −1e-17, and a negative area is refused where it comes from a file.
  Cloud cloud;
  const int corners[][3] = {{1, 0, 2}, {0, 3, 3}, {3, 3, 1}, {3, 1, 3}, {2, 2, 2}, {3, 2, 1},
    {3, 3, 0}, {0, 1, 1}, {2, 2, 3}, {2, 3, 1}, {3, 2, 0}, {3, 0, 0}, {0, 3, 3}, {2, 0, 1},
    {2, 1, 2}, {3, 2, 1}};
  for (const auto& [x, y, z] : corners)
  {
    cloud.positions.emplace_back(x, 1e-9 * y, z);
  }
  winding::PointCloud points = clean(cloud);
  points.normals = winding::estimateNormals(placesOf(points.positions), 8, serial);
  const std::vector<double> areas =
    winding::pointAreas(points, {winding::PointAreaMethod::voronoi, 0, 8}, serial);
  EXPECT_GE(*std::min_element(areas.begin(), areas.end()), 0);
}

TEST(VoronoiAreas, AreZeroForOnePlaceAndForNone)
{
  EXPECT_TRUE(voronoiAreas(winding::PointCloud()).empty());
  Cloud place;
  place.positions.assign(100, {1, 2, 3});
  place.normals.assign(100, {0, 0, 1});
  EXPECT_EQ(total(voronoiAreas(clean(place))), 0);
  EXPECT_EQ(meanPointArea(clean(place)), 0);
  EXPECT_EQ(meanPointArea(winding::PointCloud()), 0);
}

TEST(VoronoiAreas, AreNotDrawnAwayByAFarOutlier)
{
  Cloud cloud = sphereCloud(2000);
  const std::vector<double> before = voronoiAreas(clean(cloud));
  cloud.positions.push_back({1e7, 0, 0});
  cloud.normals.push_back({1, 0, 0});
  const std::vector<double> after = voronoiAreas(clean(cloud));
  const double largest = *std::max_element(before.begin(), before.end());
  record("outlier", after.back() / largest);
  EXPECT_LT(after.back(), 10 * largest);
  EXPECT_LT(relativeError(total(after) - after.back(), total(before)), 0.01);
}

TEST(VoronoiAreas, OfScansThatShareSpotsAreThoseOfTheSpots)
{
  const Cloud sphere = randomSphere(500, 1); // 0.16 apart
  const Cloud plate = lattice(15, 0.3, 1);
  for (const int scans : {2, 5, 20, 50})
  {
    for (const double noise : {1e-9, 5e-3})
    {
      const Cloud cloud = scansOf(sphere, scans, noise);
      EXPECT_LT(relativeError(total(voronoiAreas(clean(cloud))), sphereArea), 0.02) // 0.009
        << scans << " scans, noise " << noise;
    }
    const double area = total(voronoiAreas(clean(plate)));
    const Cloud scanned = scansOf(plate, scans, 1e-4);
    EXPECT_LT(relativeError(total(voronoiAreas(clean(scanned))), area), 0.1) << scans; // 0.08
  }
}

TEST(VoronoiAreas, DoNotDependOnTheOrderOfThePointsOrTheThreads)
{
  SCOPED_TRACE("seeds 78, 79, 80");
  const Cloud cloud = randomSphere(3000, 78);
  const std::vector<double> areas = voronoiAreas(clean(cloud));
  std::vector<std::size_t> order(3000);
  std::iota(order.begin(), order.end(), 0);
  Random random(79);
  for (std::size_t i = order.size() - 1; i > 0; --i)
  {
    std::swap(order[i], order[random.bits() % (i + 1)]);
  }
  Cloud shuffled;
  for (const std::size_t i : order)
  {
    shuffled.positions.push_back(cloud.positions[i]);
    shuffled.normals.push_back(cloud.normals[i]);
  }
  const std::vector<double> again = voronoiAreas(clean(shuffled));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(again[i], areas[order[i]]);
  }
  EXPECT_EQ(meanPointArea(clean(shuffled)), meanPointArea(clean(cloud)));
  ShuffledThreads threads(80);
  EXPECT_EQ(
    winding::voronoiAreas(clean(cloud), placesOf(clean(cloud).positions), 20, threads), areas);
}

TEST(VoronoiAreas, GrowWithTheSquareOfTheUnitOfLength)
{
  const Cloud unit = sphereCloud(500);
  const std::vector<double> areas = voronoiAreas(clean(unit));
  for (const double scale : {1e-100, 1e-30, 1e-6, 1e6, 1e30, 1e100})
  {
    Cloud scaled = unit;
    for (Point& p : scaled.positions)
    {
      p *= scale;
    }
    const std::vector<double> found = voronoiAreas(clean(scaled));
    for (std::size_t i = 0; i < areas.size(); i += 25)
    {
      EXPECT_LT(relativeError(found[i], areas[i] * scale * scale), 1e-9) << scale;
    }
  }
}

TEST(VoronoiAreas, NeedNotManyNeighbors)
{
  const winding::PointCloud cloud = clean(randomSphere(5000, 81));
  for (const int neighbors : {10, 15, 20, 40})
  {
    const double error = relativeError(total(voronoiAreas(cloud, neighbors)), sphereArea);
    record("neighbors" + std::to_string(neighbors), error);
    EXPECT_LT(error, 0.02) << neighbors; // measured: 0.0052 with 10, 0.0012 at most with others
  }
}

TEST(MeanPointArea, IsTheMeanOfThem)
{
  const winding::PointCloud cloud = clean(randomSphere(1000, 82));
  EXPECT_NEAR(meanPointArea(cloud), total(voronoiAreas(cloud)) / 1000, 1e-15);
}

TEST(VoronoiAreas, OfFlippedPointsAreNotThoseOfMany)
{
  SCOPED_TRACE("seeds 83, 84");
  Cloud cloud = randomSphere(20'000, 83);
  Random random(84);
  std::size_t flipped = 0;
  for (Point& normal : cloud.normals)
  {
    const bool flips = random(0, 1) < 0.1;
    flipped += flips;
    normal *= flips ? -1 : 1;
  }
  const std::vector<double> areas = voronoiAreas(clean(cloud));
  double sum = 0;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    sum += winding::dipoleSolidAngle<double>(cloud.positions[i], cloud.normals[i], areas[i]);
  }
  record("center", sum / sphereArea);
  // The sum was measured as 0.900, where a share of 0.9 is not flipped.
  EXPECT_NEAR(sum / sphereArea, 1 - static_cast<double>(flipped) / 20'000, 0.02);
}
