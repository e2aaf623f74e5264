// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NeighborSearch.h"

#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using shapes::serial;
using winding::DistinctPoints;
using winding::Neighbor;
using winding::NeighborSearch;
using Point = Eigen::Vector3d;

/// The nearest other places, by a look at all of them.
std::vector<Neighbor> nearestOf(const DistinctPoints& places, std::size_t place, std::size_t count)
{
  std::vector<Neighbor> others;
  for (std::size_t other = 0; other < places.size(); ++other)
  {
    if (other != place)
    {
      others.push_back({static_cast<std::uint32_t>(other),
        (places.positions()[other] - places.positions()[place]).squaredNorm()});
    }
  }
  const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(count, others.size()));
  std::partial_sort(others.begin(), end, others.end(), winding::isNearer);
  others.erase(end, others.end());
  return others;
}

void expectEqual(const std::vector<Neighbor>& found, const std::vector<Neighbor>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].place, expected[i].place) << "neighbour " << i;
    EXPECT_EQ(found[i].squaredDistance, expected[i].squaredDistance) << "neighbour " << i;
  }
}

/// Checks the neighbours of every place, or of one in `step`.
void check(const std::vector<Point>& points, std::size_t count, std::size_t step = 1)
{
  const DistinctPoints places(points, 1, serial);
  const NeighborSearch search(places, serial);
  std::vector<Neighbor> found;
  NeighborSearch::Last last;
  for (std::size_t place = 0; place < places.size(); place += step)
  {
    SCOPED_TRACE("place " + std::to_string(place));
    search.find(place, count, found, last);
    expectEqual(found, nearestOf(places, place, count));
  }
}

} // namespace

TEST(NeighborSearch, FindsTheNearestOthers)
{
  for (unsigned seed = 901; seed < 911; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(shapes::randomPoints(400, -1, 1, seed), 1 + 3 * (seed - 901));
  }
}

TEST(NeighborSearch, FindsAllWhereThereAreFew)
{
  check({Point(1, 2, 3)}, 5);
  check({Point(1, 2, 3), Point(1, 2, 3)}, 5);
  check({Point(1, 2, 3), Point(3, 2, 1), Point(1, 2, 3)}, 5);
  check(shapes::randomPoints(8, -1, 1, 921), 7);
  check(shapes::randomPoints(8, -1, 1, 921), 8);
}

TEST(NeighborSearch, FindsThemOnLinesLatticesAndFarFromOutliers)
{
  std::vector<Point> line, lattice, graded;
  for (int i = 0; i < 500; ++i)
  {
    line.emplace_back(i, 2 * i, -i);
    lattice.emplace_back(i % 8, i / 8 % 8, i / 64);
    graded.emplace_back(std::ldexp(1.0, -i % 60), 0, 0);
  }
  check(line, 6);
  check(lattice, 6);
  check(graded, 6);
  std::vector<Point> withOutlier = shapes::randomPoints(300, -1, 1, 931);
  withOutlier.emplace_back(3e6, 1e6, 0);
  check(withOutlier, 8);
}

TEST(NeighborSearch, FindsThemInAllTreesOfManyPlaces)
{
  // There are three trees; every place of the lattice has others as far away, also in other trees.
  std::vector<Point> points = shapes::randomPoints(200000, 0, 1, 961);
  for (int i = 0; i < 100000; ++i)
  {
    points.emplace_back(2 + i % 100 / 64.0, i / 100 % 100 / 64.0, i / 10000 / 64.0);
  }
  check(points, 20, 3001);
}

TEST(NeighborSearch, FindsAsManyAsAreAskedFor)
{
  const std::vector<Point> points = shapes::randomPoints(3000, -1, 1, 971);
  for (const std::size_t count : {1, 2, 100, 1000})
  {
    check(points, count, 7);
  }
}

TEST(NeighborSearch, IsTheSameEveryTimeAndOnSeveralThreads)
{
  std::vector<Point> lattice; // a lattice is full of equal distances
  for (int i = 0; i < 4096; ++i)
  {
    lattice.emplace_back(i % 16, i / 16 % 16, i / 256);
  }
  const DistinctPoints places(lattice, 1, serial);
  const NeighborSearch search(places, serial), again(places, serial);
  std::vector<std::vector<std::uint32_t>> byThreads(places.size());
  shapes::ShuffledThreads threads(941);
  winding::runBlocks(
    places.size(), 64,
    [&](std::size_t, std::size_t first, std::size_t end)
    {
      std::vector<Neighbor> found;
      NeighborSearch::Last last;
      for (std::size_t place = first; place < end; ++place)
      {
        search.find(place, 10, found, last);
        for (const Neighbor& neighbor : found)
        {
          byThreads[place].push_back(neighbor.place);
        }
      }
    },
    threads);
  std::vector<Neighbor> found;
  NeighborSearch::Last last;
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    again.find(place, 10, found, last);
    ASSERT_EQ(found.size(), byThreads[place].size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i].place, byThreads[place][i]);
    }
  }
}

TEST(NeighborSearch, NeverFindsItselfWhereSquaresUnderflow)
{
  std::vector<Point> points;
  for (int i = 0; i < 50; ++i)
  {
    points.emplace_back(1e-200 * i, 0, 0);
  }
  points.emplace_back(1, 0, 0);
  const DistinctPoints places(points, 1, serial);
  const NeighborSearch search(places, serial);
  std::vector<Neighbor> found;
  NeighborSearch::Last last;
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    search.find(place, 5, found, last);
    ASSERT_EQ(found.size(), 5u);
    for (const Neighbor& neighbor : found)
    {
      EXPECT_NE(neighbor.place, place);
    }
  }
}

TEST(NeighborSearch, FindsTheSameWhateverWasSearchedBefore)
{
  std::vector<Point> points = shapes::randomPoints(700, -1, 1, 951);
  for (int i = 0; i < 700; ++i)
  {
    points.emplace_back(i % 9, i / 9 % 9, i / 81);           // full of equal distances
    points.emplace_back(5 + std::ldexp(1.0, -i % 60), 0, 0); // far apart, and all but at one place
  }
  const DistinctPoints places(points, 1, serial);
  const NeighborSearch search(places, serial);
  std::vector<Neighbor> found, expected;
  NeighborSearch::Last last;
  for (std::size_t n = 0; n < 3 * places.size(); ++n)
  {
    // The first round is in the order of places, the others jump about.
    const std::size_t place = n < places.size() ? n : n * 7919 % places.size();
    const std::size_t count = n % 50 == 0 ? 30 : 12;
    search.find(place, count, found, last);
    NeighborSearch::Last none;
    search.find(place, count, expected, none);
    SCOPED_TRACE("place " + std::to_string(place));
    expectEqual(found, expected);
  }
}
