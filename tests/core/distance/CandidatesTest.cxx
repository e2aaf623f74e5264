// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/Candidates.h"

#include "support/NaiveDistance.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <vector>

/**
 * Items that are dropped from lists of candidates are farther than what is kept.
 */
namespace
{

using namespace shapes;
using winding::Candidates;
using winding::CandidateTest;
using winding::NearPoint;
using winding::NearTriangle;

struct Corners
{
  Point a, b, c;
};

/// Triangles of all sizes: some are needles, some have no area.
Corners someTriangle(Random& random, int kind)
{
  const Point a = random.point(-1, 1);
  const double size = std::pow(10, -random(0, 4));
  const Point along = size * random.direction(), beside = size * random.direction();
  switch (kind % 4)
  {
  case 0:
    return {a, a + along, a + beside};
  case 1:
    return {a, a + along, a + along + 1e-6 * beside};
  case 2:
    return {a, a + along, a + 0.3 * along};
  default:
    return {a, a, a};
  }
}

CandidateTest testFor(const Point& x, const Point& low, const Point& high)
{
  CandidateTest test;
  for (int axis = 0; axis < 3; ++axis)
  {
    test.nearest[axis] = x[axis];
    test.gradient[axis] = -(low[axis] + high[axis] - 2 * x[axis]);
    test.size[axis] = high[axis] - low[axis];
  }
  test.slack = 1e-13;
  return test;
}

/// Some samples of a box: its corners, and points in it.
std::vector<Point> samplesOf(Random& random, const Point& low, const Point& high)
{
  std::vector<Point> samples;
  for (int i = 0; i < 20; ++i)
  {
    const Point t = i < 8 ? Point(i & 1, i >> 1 & 1, i >> 2) : random.point(0, 1);
    samples.push_back(low + (high - low).cwiseProduct(t));
  }
  return samples;
}

std::vector<std::uint32_t> numbersOf(const Candidates& candidates)
{
  return {candidates.numbers(), candidates.numbers() + candidates.size()};
}

/// Drops what is farther than the one of the items that is nearest to the centre of a box, and
/// returns the numbers of the others. nearest(i, q): the point of item i that is nearest to q.
template <class Item, class NearestPoint>
std::vector<std::uint32_t> keptOf(
  const std::vector<Item>& items, Random& random, const NearestPoint& nearest)
{
  const Point low = random.point(-1.5, 1.5);
  const Point high = low + random(0, 0.2) * random.point(0, 1);
  const Point center = 0.5 * (low + high);
  Point x = nearest(0, center);
  for (std::size_t i = 1; i < items.size(); ++i)
  {
    const Point other = nearest(i, center);
    x = (other - center).norm() < (x - center).norm() ? other : x;
  }
  Candidates all(std::is_same_v<Item, NearTriangle> ? 3 : 1), kept = all;
  const auto half = static_cast<std::uint32_t>(items.size() / 2);
  all.assign(items.data(), {{0, half}, {half, static_cast<std::uint32_t>(items.size())}});
  EXPECT_EQ(all.size(), items.size());
  std::vector<std::uint32_t> places;
  all.find(testFor(x, low, high), places);
  kept.assign(all, places);
  const std::vector<std::uint32_t> numbers = numbersOf(kept);
  const std::vector<Point> samples = samplesOf(random, low, high);
  for (std::uint32_t i = 0; i < items.size(); ++i)
  {
    if (std::find(numbers.begin(), numbers.end(), i) == numbers.end())
    {
      for (const Point& q : samples)
      {
        EXPECT_GT((nearest(i, q) - q).norm(), (x - q).norm()) << "item " << i;
      }
    }
  }
  return numbers;
}

} // namespace

TEST(Candidates, DroppedTrianglesAreFartherFromAllSamples)
{
  SCOPED_TRACE("seed 821");
  Random random(821);
  std::size_t kept = 0, all = 0;
  for (int round = 0; round < 300; ++round)
  {
    std::vector<NearTriangle> items;
    for (int i = 0; i < 61; ++i)
    {
      const Corners t = someTriangle(random, i);
      items.push_back(winding::nearTriangle(t.a, t.b, t.c));
    }
    const auto nearest = [&](std::size_t i, const Point& q)
    {
      winding::Nearest found = {std::numeric_limits<double>::infinity(), {0, 0, 0}};
      winding::findNearest(&items[i], {0, 1}, q.data(), found);
      return Point(q - Eigen::Map<const Point>(found.offset));
    };
    kept += keptOf(items, random, nearest).size();
    all += items.size();
  }
  const double share = static_cast<double>(kept) / static_cast<double>(all);
  record("part that is kept", share);
  EXPECT_GT(share, 0.01);
  EXPECT_LT(share, 0.5); // what large triangles are kept for
}

TEST(Candidates, DroppedPointsAreFartherFromAllSamples)
{
  SCOPED_TRACE("seed 822");
  Random random(822);
  std::size_t kept = 0, all = 0;
  for (int round = 0; round < 300; ++round)
  {
    std::vector<NearPoint> items;
    for (int i = 0; i < 45; ++i)
    {
      items.push_back(winding::nearPoint(random.point(-1, 1)));
    }
    const auto nearest = [&](std::size_t i, const Point&)
    {
      return Point(Eigen::Map<const Point>(items[i].position));
    };
    kept += keptOf(items, random, nearest).size();
    all += items.size();
  }
  const double share = static_cast<double>(kept) / static_cast<double>(all);
  record("part that is kept", share);
  EXPECT_GT(share, 1.0 / 45);
  EXPECT_LT(share, 0.2);
}

TEST(Candidates, AreThoseOfAllInstructionSets)
{
  SCOPED_TRACE("seed 823");
  Random random(823);
  for (int round = 0; round < 50; ++round)
  {
    std::vector<NearTriangle> items;
    for (int i = 0; i < 100; ++i)
    {
      const Corners t = someTriangle(random, 4 * i);
      items.push_back(winding::nearTriangle(t.a, t.b, t.c));
    }
    Candidates all(3);
    all.assign(items.data(), {{0, 100}});
    const Point low = random.point(-1, 1);
    const CandidateTest test = testFor(random.point(-1, 1), low, low + 0.1 * random.point(0, 1));
    std::vector<std::uint32_t> first, places;
    all.find(test, first);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      all.find(test, places);
      EXPECT_EQ(places, first);
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
}
