#include "PointAreas.h"

#include "Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace shapes;

double meanPointArea(const winding::PointCloud& cloud, int neighbors = 20)
{
  winding::SerialExecutor serial;
  return winding::meanPointArea(cloud, serial, neighbors);
}

constexpr double sphereArea = 4 * 3.14159265358979323846;

Cloud randomSphereCloud(std::size_t count, unsigned seed)
{
  Random random(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    cloud.positions.push_back(random.direction());
  }
  cloud.normals = cloud.positions;
  return cloud;
}

double relativeError(double area, double expected)
{
  return std::abs(area / expected - 1);
}

} // namespace

TEST(MeanPointArea, OfEvenlySampledSpheresIsTheAreaPerPoint)
{
  double worst = 0;
  for (const std::size_t count : {500, 2000, 10000})
  {
    const double area = meanPointArea(clean(sphereCloud(count)));
    worst = std::max(worst, relativeError(area, sphereArea / static_cast<double>(count)));
  }
  record("worst", worst);
  EXPECT_LT(worst, 0.05); // measured: 0.040
}

TEST(MeanPointArea, OfRegularGridsIsTheAreaOfACell)
{
  // Many neighbours are equally far: how many of them are among the nearest must not matter much.
  for (const bool hexagonal : {false, true})
  {
    Cloud cloud;
    for (int i = 0; i < 100 * 100; ++i)
    {
      const int x = i % 100, y = i / 100;
      cloud.positions.emplace_back(
        x + (hexagonal && y % 2 == 1 ? 0.5 : 0), hexagonal ? y * std::sqrt(0.75) : y, 0);
    }
    cloud.normals.assign(cloud.positions.size(), Point(0, 0, 1));
    const double error =
      relativeError(meanPointArea(clean(cloud)), hexagonal ? std::sqrt(0.75) : 1);
    record(hexagonal ? "hexagonal" : "square", error);
    EXPECT_LT(error, 0.1); // measured: 0.044 and 0.093
  }
}

TEST(MeanPointArea, OfRandomlySampledSpheresIsTheAreaPerPoint)
{
  SCOPED_TRACE("seed 71");
  const double area = meanPointArea(clean(randomSphereCloud(5000, 71)));
  const double error = relativeError(area, sphereArea / 5000);
  record("error", error);
  EXPECT_LT(error, 0.05); // measured: 0.011
}

TEST(MeanPointArea, DependsLittleOnTheNumberOfNeighbors)
{
  const winding::PointCloud cloud = clean(sphereCloud(2000));
  for (const int neighbors : {20, 40, 100})
  {
    const double error = relativeError(meanPointArea(cloud, neighbors), sphereArea / 2000);
    record("neighbors" + std::to_string(neighbors), error);
    EXPECT_LT(error, 0.06) << neighbors; // measured: 0.039 with 20
  }
}

TEST(MeanPointArea, TakesAllOtherPointsWhereThereAreFewerThanNeighbors)
{
  const Cloud three{{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}}, {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
  EXPECT_NE(meanPointArea(clean(three), 2), meanPointArea(clean(three), 1));
  EXPECT_EQ(meanPointArea(clean(three)), meanPointArea(clean(three), 2));
  // The nearest is 2 away from each.
  EXPECT_DOUBLE_EQ(meanPointArea(clean(three), 1), sphereArea / 4 * 4);
  EXPECT_EQ(meanPointArea(clean(three), 0), meanPointArea(clean(three), 1));
}

TEST(MeanPointArea, IsZeroForOnePointAndForOnePlace)
{
  EXPECT_EQ(meanPointArea(winding::PointCloud()), 0);
  EXPECT_EQ(meanPointArea(clean(Cloud{{{1, 2, 3}}, {{0, 0, 1}}})), 0);
  Cloud place;
  place.positions.assign(100, {1, 2, 3});
  place.normals.assign(100, {0, 0, 1});
  EXPECT_EQ(meanPointArea(clean(place)), 0);
}

TEST(MeanPointArea, OfACloudWithEveryPointTwiceIsHalfAsLarge)
{
  Cloud twice = sphereCloud(2000);
  const Cloud once = twice;
  twice.positions.insert(twice.positions.end(), once.positions.begin(), once.positions.end());
  twice.normals.insert(twice.normals.end(), once.normals.begin(), once.normals.end());
  const double error = relativeError(meanPointArea(clean(twice)), sphereArea / 4000);
  record("error", error);
  EXPECT_LT(error, 0.1); // measured: 0.070
}

TEST(MeanPointArea, IsNotDrawnAwayByAFarOutlier)
{
  Cloud cloud = sphereCloud(2000);
  const double before = meanPointArea(clean(cloud));
  cloud.positions.push_back({1e9, 0, 0});
  cloud.normals.push_back({1, 0, 0});
  const double error = relativeError(meanPointArea(clean(cloud)), before);
  record("error", error);
  EXPECT_LT(error, 0.01); // measured: 5.5e-6
}

TEST(MeanPointArea, DoesNotDependOnTheOrderOfThePoints)
{
  SCOPED_TRACE("seeds 72, 73");
  Cloud cloud = randomSphereCloud(1000, 72);
  const double area = meanPointArea(clean(cloud));
  Random random(73);
  for (std::size_t i = cloud.positions.size() - 1; i > 0; --i)
  {
    std::swap(cloud.positions[i], cloud.positions[random.bits() % (i + 1)]);
  }
  EXPECT_EQ(meanPointArea(clean(cloud)), area);
}

TEST(MeanPointArea, GrowsWithTheSquareOfTheUnitOfLength)
{
  const Cloud unit = sphereCloud(500);
  const double area = meanPointArea(clean(unit));
  for (const double scale : {1e-100, 1e-30, 1e-6, 1e6, 1e30, 1e100})
  {
    Cloud scaled = unit;
    for (Point& p : scaled.positions)
    {
      p *= scale;
    }
    EXPECT_LT(relativeError(meanPointArea(clean(scaled)), area * scale * scale), 1e-12) << scale;
  }
}

TEST(MeanPointArea, OfThousandsOfEqualPointsIsFoundAtOnce)
{
  // Quadratic time would take minutes.
  Cloud cloud = sphereCloud(500);
  for (int i = 0; i < 100'000; ++i)
  {
    cloud.positions.push_back(cloud.positions[0]);
    cloud.normals.push_back(cloud.normals[0]);
  }
  const double all = meanPointArea(clean(cloud)) * static_cast<double>(cloud.positions.size());
  EXPECT_LT(relativeError(all, sphereArea), 0.05); // measured: 0.04
}
