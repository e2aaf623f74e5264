// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Pi.h"
#include "sums/DirectSum.h"

#include "source/PointCloud.h"
#include "sums/ReferenceSum.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::DipoleSum;

std::vector<double> someAreas(std::size_t count, unsigned seed)
{
  Random random(seed);
  std::vector<double> areas(count);
  for (double& area : areas)
  {
    area = random(0, 0.01);
  }
  return areas;
}

/// Values grow without bound towards a point, so differences are taken relative to those above 1.
double largestRelativeDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const double difference = std::abs(a[i] - b[i]) / std::max(1.0, std::abs(b[i]));
    largest = difference <= largest ? largest : difference;
  }
  return largest;
}

struct Case
{
  winding::PointCloud cloud;
  std::vector<double> areas;
  std::vector<Point> samples;

  std::vector<double> values() const { return valuesOf(DipoleSum(cloud, areas), samples); }

  /// The case after a similarity: normals stay, and areas grow with the square of the scale.
  Case scaledAndMoved(double scale, const Point& shift) const
  {
    Case result{cloud, areas, samples};
    result.cloud.bounds.setEmpty();
    for (Point& p : result.cloud.positions)
    {
      p = scale * p + shift;
      result.cloud.bounds.extend(p);
    }
    for (Point& q : result.samples)
    {
      q = scale * q + shift;
    }
    for (double& area : result.areas)
    {
      area = area * scale * scale;
    }
    return result;
  }
};

Case someCase()
{
  Case result{clean(randomCloud(2000, 41)), someAreas(2000, 42), randomPoints(300, -2, 2, 43)};
  Random random(44);
  for (const double distance : {1e-2, 1e-4, 1e-8})
  {
    for (int i = 0; i < 50; ++i)
    {
      result.samples.push_back(
        result.cloud.positions[random.bits() % 2000] + distance * random.direction());
    }
  }
  return result;
}

constexpr const char* seeds = "seeds 41 to 44";

} // namespace

TEST(DipoleSum, EqualsTheLongDoubleReference)
{
  SCOPED_TRACE(seeds);
  const Case some = someCase();
  std::vector<double> expected;
  for (const Point& q : some.samples)
  {
    expected.push_back(
      static_cast<double>(winding::referenceSum<long double>(some.cloud, some.areas, q)));
  }
  const double error = largestRelativeDifference(some.values(), expected);
  record("error", error);
  EXPECT_LT(error, 1e-11); // measured: 5.0e-15
}

TEST(DipoleSum, OfASphereIsOneInsideAndZeroOutside)
{
  const std::size_t count = 10000;
  const winding::PointCloud cloud = clean(sphereCloud(count));
  const std::vector<double> areas(count, 4 * winding::pi / count);
  const DipoleSum sum(cloud, areas);
  SCOPED_TRACE("seed 45");
  double worst = 0;
  for (const Point& q : randomPoints(500, -2, 2, 45))
  {
    // A sampled surface has no sharp sides within a few distances of its points, here 0.035.
    if (std::abs(q.norm() - 1) > 0.1)
    {
      worst = std::max(worst, std::abs(valuesOf(sum, {q})[0] - (q.norm() < 1)));
    }
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-3); // measured: 1.8e-5
}

TEST(DipoleSum, IsProportionalToTheAreas)
{
  SCOPED_TRACE(seeds);
  Case some = someCase();
  std::vector<double> expected = some.values();
  for (double& w : expected)
  {
    w *= 8;
  }
  for (double& area : some.areas)
  {
    area *= 8;
  }
  EXPECT_EQ(some.values(), expected);
}

TEST(DipoleSum, ReversingTheNormalsReversesTheSignToTheBit)
{
  SCOPED_TRACE(seeds);
  Case some = someCase();
  std::vector<double> expected = some.values();
  for (double& w : expected)
  {
    w = -w;
  }
  for (Point& normal : some.cloud.normals)
  {
    normal = -normal;
  }
  EXPECT_EQ(some.values(), expected);
}

TEST(DipoleSum, PowersOfTwoChangeNoBit)
{
  SCOPED_TRACE(seeds);
  const Case unit = someCase();
  for (const double scale : {0x1p-400, 0x1p-100, 0x1p-20, 0x1p20, 0x1p100, 0x1p400})
  {
    EXPECT_EQ(unit.scaledAndMoved(scale, {0, 0, 0}).values(), unit.values()) << scale;
  }
}

TEST(DipoleSum, OtherUnitsOfLengthChangeNothingButRounding)
{
  SCOPED_TRACE(seeds);
  // The scaled positions round by 1e-16, and so w near a point, which is about 1e-3/d² at a
  // distance d, changes by 1e-16/d of that: the samples at 1e-8 are left out.
  Case unit = someCase();
  unit.samples.resize(400);
  double worst = 0;
  for (const double scale : {1e-100, 1e-30, 1e-6, 1e6, 1e30, 1e100})
  {
    worst = std::max(worst,
      largestRelativeDifference(unit.scaledAndMoved(scale, {0, 0, 0}).values(), unit.values()));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-9); // measured: 8.9e-11
}

TEST(DipoleSum, FarFromTheOriginTheFieldIsTheSame)
{
  SCOPED_TRACE(seeds);
  Case still = someCase();
  const auto toLattice = [](Point& p)
  {
    p = ((p * 0x1p28).array().round() * 0x1p-28).matrix();
  };
  std::for_each(still.cloud.positions.begin(), still.cloud.positions.end(), toLattice);
  std::for_each(still.samples.begin(), still.samples.end(), toLattice);
  // The samples at 1e-8 are left out: the lattice is 4e-9 wide, and may bring them onto points.
  still.samples.resize(400);
  const Case moved = still.scaledAndMoved(1, {4e6, -3e6, 5e6});
  const double error = largestRelativeDifference(moved.values(), still.values());
  record("error", error);
  EXPECT_LT(error, 1e-12); // measured: 0
}

TEST(DipoleSum, OfAPointAtTheSampleIsZeroAndEveryValueIsFinite)
{
  SCOPED_TRACE(seeds);
  Case some = someCase();
  some.samples = some.cloud.positions;
  for (const double far : {0x1p-1074, 1e-300, 1e100, 1e200, 1.7e308})
  {
    some.samples.push_back(some.cloud.positions[0] + Point(far, 0, 0));
    some.samples.push_back({far, -far, far});
  }
  for (const double w : some.values())
  {
    ASSERT_TRUE(std::isfinite(w));
  }
  const winding::PointCloud one = clean(Cloud{{{1, 2, 3}}, {{0, 0, 1}}});
  const std::vector<double> area(1, 1);
  EXPECT_EQ(valuesOf(DipoleSum(one, area), {{1, 2, 3}})[0], 0);
}

TEST(DipoleSum, OfOneSampleDoesNotDependOnTheOthers)
{
  SCOPED_TRACE(seeds);
  const Case some = someCase();
  const std::vector<double> whole = some.values();
  const DipoleSum sum(some.cloud, some.areas);
  for (std::size_t i = 0; i < some.samples.size(); ++i)
  {
    ASSERT_EQ(valuesOf(sum, {some.samples[i]})[0], whole[i]);
  }
}
