// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestKernels.h"

#include "support/NaiveDistance.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace
{

using namespace shapes;
using winding::Nearest;
using winding::NearTriangle;

constexpr double infinite = std::numeric_limits<double>::infinity();

double findDistance(const NearTriangle& triangle, const Point& q)
{
  Nearest nearest = {infinite, {0, 0, 0}};
  winding::findNearest(&triangle, {0, 1}, q.data(), nearest);
  return std::sqrt(nearest.squared);
}

struct Corners
{
  Point a, b, c;
};

/// Triangles of all shapes: needles, caps, nearly and exactly without area, large for their
/// distance and small.
Corners someTriangle(Random& random, int kind)
{
  const Point a = random.point(-1, 1), along = random.direction(), beside = random.direction();
  const double thin = std::pow(10, -random(1, 14));
  switch (kind)
  {
  case 0:
    return {a, random.point(-1, 1), random.point(-1, 1)};
  case 1:
    return {a, a + along, a + along + thin * beside};
  case 2:
    return {a, a + along, a + random(0, 1) * along + thin * beside};
  case 3:
    return {a, a + thin * along, a + thin * beside};
  case 4:
    return {a, a + 0.5 * along, a + 0.25 * along};
  case 5:
    return {a, a + along, a + random(-1, 2) * along}; // as thin as rounding
  default:
    return {a, a + along, a + along};
  }
}

} // namespace

TEST(NearestKernels, DistancesFromTrianglesOfAnyShapeAreExact)
{
  SCOPED_TRACE("seed 801");
  Random random(801);
  double worst = 0;
  for (int i = 0; i < 140000; ++i)
  {
    const Corners t = someTriangle(random, i % 7);
    const double distance = std::pow(10, random(-6, 2));
    const double u = random(-0.5, 1.5), v = random(-0.5, 1.5);
    const Point q = t.a + u * (t.b - t.a) + v * (t.c - t.a) + distance * random.direction();
    const double expected = naiveDistance(q, t.a, t.b, t.c);
    const double found = findDistance(winding::nearTriangle(t.a, t.b, t.c), q);
    // The rounding of positions of size 1 tells where a triangle is thin.
    const double error = std::abs(found - expected) / (0.1 + expected);
    ASSERT_LT(error, 3e-12) << "triangle " << i; // measured: 9e-13, for a needle 1e-7 thick
    worst = std::max(worst, error);
  }
  record("largest error", worst);
}

TEST(NearestKernels, TrianglesAsThinAsRoundingHaveNoInside)
{
  // Three points on a line up to rounding each: distances came out a tenth, a third and two
  // thirds too small, because weights that were off by 0.25 or 1e16 fell between 0 and 1.
  const std::pair<Corners, Point> cases[] = {
    {{{0x1.2666666666666p+0, 0x1.4cccccccccccdp-1, -0x1.6666666666666p-2},
       {0x1.4cccccccccccdp-1, 0x1.4cccccccccccdp-1, 0x1.3333333333334p-3},
       {-0x1.6666666666666p-2, 0x1.4cccccccccccdp-1, 0x1.2666666666666p+0}},
      {-0x1.b333333333333p-1, -0x1.6666666666666p-2, 0x1.a666666666666p+0}},
    {{{-0.69999999999999996, 0.30000000000000004, -0.69999999999999996},
       {-0.69999999999999996, 1.3, 0.30000000000000004},
       {-0.69999999999999996, 2.2999999999999998, 1.3}},
      {-2.8096085769228294, 1.6828640499370056, -2.5267329247832935}},
    {{{3.2999999999999998, 2.2999999999999998, 1.2999999523162842},
       {-0.69999999999999996, 2.2999999999999998, 3.2999999523162842},
       {1.3, 2.2999999999999998, 2.2999999523162842}},
      {-2.7000000000000002, 1.2999999999999998, -2.6999999582767487}}};
  for (const auto& [t, q] : cases)
  {
    EXPECT_NEAR(findDistance(winding::nearTriangle(t.a, t.b, t.c), q),
      naiveDistance(q, t.a, t.b, t.c), 1e-14);
  }
}

TEST(NearestKernels, CornersAreAtNoDistance)
{
  SCOPED_TRACE("seed 802");
  Random random(802);
  for (int i = 0; i < 600; ++i)
  {
    const Corners t = someTriangle(random, i % 7);
    // Offsets to b and c are rounded, a itself is not.
    EXPECT_EQ(findDistance(winding::nearTriangle(t.a, t.b, t.c), t.a), 0);
  }
}

TEST(NearestKernels, AllSamplesOfABlockAndAllInstructionSetsAgree)
{
  SCOPED_TRACE("seed 803");
  Random random(803);
  std::vector<NearTriangle> triangles;
  std::vector<winding::NearPoint> points;
  for (int i = 0; i < 40; ++i)
  {
    const Corners t = someTriangle(random, i % 7);
    triangles.push_back(winding::nearTriangle(t.a, t.b, t.c));
    points.push_back(winding::nearPoint(t.a));
  }
  std::vector<std::uint32_t> numbers = {0, 1, 2, 3, 4, 7};
  for (std::uint32_t i = 39; i >= 20; --i)
  {
    numbers.push_back(i);
  }
  winding::SampleBlock block;
  block.count = 77;
  for (std::size_t i = 0; i < block.count; ++i)
  {
    block.set(i, random.point(-2, 2));
  }
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    alignas(64) double ofTriangles[winding::SampleBlock::capacity];
    alignas(64) double ofPoints[winding::SampleBlock::capacity];
    std::fill(std::begin(ofTriangles), std::end(ofTriangles), infinite);
    std::fill(std::begin(ofPoints), std::end(ofPoints), infinite);
    winding::lowerSquaredDistances(
      triangles.data(), numbers.data(), numbers.size(), block, ofTriangles);
    winding::lowerSquaredDistances(points.data(), numbers.data(), numbers.size(), block, ofPoints);
    for (std::size_t i = 0; i < block.count; ++i)
    {
      const double q[3] = {block.x[i], block.y[i], block.z[i]};
      Nearest triangle = {infinite, {0, 0, 0}}, point = triangle;
      for (const std::uint32_t number : numbers)
      {
        winding::findNearest(triangles.data(), {number, number + 1}, q, triangle);
        winding::findNearest(points.data(), {number, number + 1}, q, point);
      }
      ASSERT_NEAR(std::sqrt(ofTriangles[i]), std::sqrt(triangle.squared), 1e-14);
      ASSERT_NEAR(std::sqrt(ofPoints[i]), std::sqrt(point.squared), 1e-14);
      // The offset to the nearest point has the length whose square was found.
      ASSERT_NEAR(Eigen::Map<const Point>(triangle.offset).squaredNorm(), triangle.squared, 1e-14);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(NearestKernels, NearestOfEachSampleIsThatOfItAlone)
{
  SCOPED_TRACE("seed 805");
  Random random(805);
  std::vector<NearTriangle> triangles;
  std::vector<winding::NearPoint> points;
  for (int i = 0; i < 60; ++i)
  {
    const Corners t = someTriangle(random, i % 7);
    triangles.push_back(winding::nearTriangle(t.a, t.b, t.c));
    points.push_back(winding::nearPoint(t.a));
  }
  const std::vector<std::uint32_t> numbers = {59, 3, 8, 9, 10, 30, 31, 44, 1};
  for (std::size_t count = 1; count <= winding::samplesAtOnce; ++count)
  {
    winding::SampleBlock block;
    block.count = count;
    for (std::size_t i = 0; i < count; ++i)
    {
      block.set(i, random.point(-2, 2));
    }
    const auto check = [&](const auto& items)
    {
      Nearest found[winding::samplesAtOnce];
      winding::findNearestOfEach(items.data(), numbers.data(), numbers.size(), block, found);
      for (std::size_t i = 0; i < count; ++i)
      {
        const double q[3] = {block.x[i], block.y[i], block.z[i]};
        Nearest alone = {infinite, {0, 0, 0}};
        for (const std::uint32_t number : numbers)
        {
          winding::findNearest(items.data(), {number, number + 1}, q, alone);
        }
        EXPECT_EQ(found[i].squared, alone.squared);
        EXPECT_EQ(found[i].item, alone.item);
        EXPECT_EQ(Point(Eigen::Map<const Point>(found[i].offset)),
          Point(Eigen::Map<const Point>(alone.offset)));
      }
    };
    check(triangles);
    check(points);
  }
}

TEST(NearestKernels, NearerIsWhatIsWithinALimit)
{
  SCOPED_TRACE("seed 804");
  Random random(804);
  winding::SampleBlock corners;
  corners.count = winding::samplesAtOnce;
  alignas(64) double limits[winding::samplesAtOnce];
  for (std::size_t i = 0; i < winding::samplesAtOnce; ++i)
  {
    corners.set(i, random.point(-1, 1));
    limits[i] = std::pow(random(0, 0.3), 2);
  }
  int count = 0;
  for (int n = 0; n < 200; ++n)
  {
    const Corners t = someTriangle(random, n % 7);
    const NearTriangle triangle = winding::nearTriangle(t.a, t.b, t.c);
    bool isNearer = false;
    for (std::size_t i = 0; i < winding::samplesAtOnce; ++i)
    {
      const Point q(corners.x[i], corners.y[i], corners.z[i]);
      isNearer = isNearer || findDistance(triangle, q) <= std::sqrt(limits[i]);
    }
    EXPECT_EQ(winding::isNearer(triangle, corners, limits), isNearer) << n;
    count += isNearer;
  }
  EXPECT_GT(count, 10);
  EXPECT_LT(count, 180);
}
