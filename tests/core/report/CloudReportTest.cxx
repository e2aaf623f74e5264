// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/CloudReport.h"

#include "base/Refusal.h"
#include "base/Views.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace
{

using namespace shapes;
using winding::CloudReport;
using winding::OrientedPointsView;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

CloudReport report(const std::vector<OrientedPointsView>& views)
{
  return winding::reportOn(views, serial);
}

CloudReport report(const Cloud& cloud)
{
  return report(std::vector<OrientedPointsView>{cloud.view()});
}

Cloud bare(std::vector<Point> positions)
{
  return {std::move(positions), {}};
}

/// Expects that all numbers of two reports have the same bits.
void expectSame(const CloudReport& a, const CloudReport& b)
{
  const auto counts = [](const CloudReport& r)
  {
    return std::make_tuple(
      r.points, r.nonFinite, r.places, r.duplicates, r.hasNormals, r.zeroNormals, r.nonUnitNormals);
  };
  const auto measures = [](const CloudReport& r)
  {
    return std::make_tuple(
      r.spacing.smallest, r.spacing.median, r.spacing.mean, r.spacing.largest, r.oppositeNeighbors);
  };
  EXPECT_EQ(counts(a), counts(b));
  EXPECT_EQ(measures(a), measures(b));
  EXPECT_EQ(a.bounds.min(), b.bounds.min());
  EXPECT_EQ(a.bounds.max(), b.bounds.max());
}

/// The report by definition, found by looking at all pairs.
CloudReport bruteForce(const Cloud& cloud)
{
  CloudReport expected;
  expected.points = cloud.positions.size();
  expected.hasNormals = !cloud.normals.empty();
  std::map<std::array<double, 3>, Point> sums;
  std::size_t finite = 0;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
  {
    const Point &p = cloud.positions[i], &n = cloud.normals[i];
    if (!p.allFinite() || !n.allFinite())
    {
      ++expected.nonFinite;
      continue;
    }
    ++finite;
    expected.bounds.extend(p);
    expected.zeroNormals += n.norm() == 0;
    expected.nonUnitNormals += n.norm() != 0 && std::abs(n.norm() - 1) > 1e-3;
    Point& sum =
      sums.emplace(std::array<double, 3>{p[0], p[1], p[2]}, Point(0, 0, 0)).first->second;
    sum += n.norm() == 0 ? n : n.normalized();
  }
  expected.places = sums.size();
  expected.duplicates = finite - sums.size();

  std::vector<double> spacings;
  double pairs = 0, opposite = 0;
  for (const auto& [place, normal] : sums)
  {
    std::vector<std::pair<double, Point>> others;
    for (const auto& [other, otherNormal] : sums)
    {
      if (other != place)
      {
        others.emplace_back((Point(other.data()) - Point(place.data())).norm(), otherNormal);
      }
    }
    const std::size_t count = std::min<std::size_t>(8, others.size());
    std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
      others.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    spacings.push_back(others[0].first);
    for (std::size_t i = 0; i < count && normal != Point(0, 0, 0); ++i)
    {
      pairs += others[i].second != Point(0, 0, 0);
      opposite += others[i].second.dot(normal) < 0;
    }
  }
  expected.oppositeNeighbors = opposite / pairs;
  std::sort(spacings.begin(), spacings.end());
  expected.spacing = {spacings.front(), spacings[spacings.size() / 2],
    std::accumulate(spacings.begin(), spacings.end(), 0.0) / static_cast<double>(spacings.size()),
    spacings.back()};
  return expected;
}

/// A cloud with everything that can be wrong, here and there.
Cloud damagedCloud(std::size_t count, unsigned seed)
{
  Cloud cloud = randomCloud(count, seed);
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto other = static_cast<std::size_t>(random.bits() % count);
    switch (random.bits() % 12)
    {
    case 0:
    case 1:
      cloud.positions[i] = cloud.positions[other];
      break;
    case 2:
      cloud.normals[i].setZero();
      break;
    case 3:
      cloud.normals[i] *= random(0.1, 3);
      break;
    case 4:
      cloud.positions[i][1] = notANumber;
      break;
    case 5:
      cloud.normals[i][2] = -infinity;
      break;
    default:
      break;
    }
  }
  return cloud;
}

} // namespace

TEST(CloudReport, IsWhatAllPairsSay)
{
  for (unsigned seed = 701; seed < 721; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Cloud cloud = damagedCloud(20 + 30 * (seed - 701), seed);
    const CloudReport found = report(cloud), expected = bruteForce(cloud);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.nonFinite, expected.nonFinite);
    EXPECT_EQ(found.places, expected.places);
    EXPECT_EQ(found.duplicates, expected.duplicates);
    EXPECT_EQ(found.hasNormals, expected.hasNormals);
    EXPECT_EQ(found.zeroNormals, expected.zeroNormals);
    EXPECT_EQ(found.nonUnitNormals, expected.nonUnitNormals);
    EXPECT_DOUBLE_EQ(found.spacing.smallest, expected.spacing.smallest);
    EXPECT_DOUBLE_EQ(found.spacing.median, expected.spacing.median);
    EXPECT_DOUBLE_EQ(found.spacing.mean, expected.spacing.mean);
    EXPECT_DOUBLE_EQ(found.spacing.largest, expected.spacing.largest);
    EXPECT_DOUBLE_EQ(found.oppositeNeighbors, expected.oppositeNeighbors);
    EXPECT_TRUE(found.bounds.isApprox(expected.bounds));
  }
}

TEST(CloudReport, IsTheSameForAnyExecutorAndOrder)
{
  SCOPED_TRACE("seed 731");
  Cloud cloud = damagedCloud(20'000, 731);
  // Sums of normals at one place depend on their order by rounding, which the share does not see.
  const CloudReport expected = report(cloud);
  ShuffledThreads threads(732);
  expectSame(winding::reportOn({cloud.view()}, threads), expected);
  Random random(733);
  for (std::size_t i = cloud.positions.size(); i > 1; --i)
  {
    const auto j = static_cast<std::size_t>(random.bits() % i);
    std::swap(cloud.positions[i - 1], cloud.positions[j]);
    std::swap(cloud.normals[i - 1], cloud.normals[j]);
  }
  expectSame(report(cloud), expected);
}

TEST(CloudReport, TakesViewsAsOneCloud)
{
  SCOPED_TRACE("seed 741");
  const Cloud cloud = damagedCloud(1000, 741);
  Cloud first = cloud, second = cloud;
  first.positions.resize(300);
  first.normals.resize(300);
  second.positions.erase(second.positions.begin(), second.positions.begin() + 300);
  second.normals.erase(second.normals.begin(), second.normals.begin() + 300);
  expectSame(report({first.view(), bare({}).view(), second.view()}), report(cloud));
}

TEST(CloudReport, HasNoNormalsUnlessAllViewsHave)
{
  const Cloud with = sphereCloud(100), without = bare({{5, 5, 5}, {6, 5, 5}});
  const CloudReport both = report({with.view(), without.view()});
  EXPECT_FALSE(both.hasNormals);
  EXPECT_EQ(both.places, 102u);
  EXPECT_EQ(both.zeroNormals, 0u);
  EXPECT_EQ(both.oppositeNeighbors, 0);
  EXPECT_FALSE(report(without).hasNormals);
  EXPECT_EQ(report(without).spacing.median, 1);
}

TEST(CloudReport, TellsTheShareOfOppositeNeighbors)
{
  Cloud cloud = sphereCloud(20'000);
  EXPECT_EQ(report(cloud).oppositeNeighbors, 0);
  SCOPED_TRACE("seed 751");
  Random random(751);
  for (const double flipped : {0.1, 0.5})
  {
    Cloud mixed = cloud;
    for (Point& normal : mixed.normals)
    {
      normal *= random(0, 1) < flipped ? -1 : 1;
    }
    EXPECT_NEAR(report(mixed).oppositeNeighbors, 2 * flipped * (1 - flipped), 0.01);
  }
}

TEST(CloudReport, TakesTheSumOfTheNormalsOfAPlace)
{
  // Each place of the sheet has points of both sides, whose normals cancel.
  Cloud sheet;
  for (int i = 0; i < 400; ++i)
  {
    const Point p(i % 20, i / 20, 0);
    sheet.positions.insert(sheet.positions.end(), {p, p});
    sheet.normals.insert(sheet.normals.end(), {Point(0, 0, 1), Point(0, 0, -1)});
  }
  EXPECT_EQ(report(sheet).oppositeNeighbors, 0);
  EXPECT_EQ(report(sheet).duplicates, 400u);
  // A third point at each place decides, upward in one half of the sheet and downward in the other:
  // neighbours on either side of the middle disagree.
  for (int i = 0; i < 400; ++i)
  {
    sheet.positions.emplace_back(i % 20, i / 20, 0);
    sheet.normals.emplace_back(0, 0, i / 20 < 10 ? 1 : -1);
  }
  EXPECT_NEAR(report(sheet).oppositeNeighbors, 40 * 3 / 3200.0, 0.01);
}

TEST(CloudReport, OfFewPointsHasNoSpacing)
{
  for (const std::vector<Point>& points :
    {std::vector<Point>{}, {Point(1, 2, 3)}, std::vector<Point>(200'000, Point(0.1, 0.2, 0.3))})
  {
    const CloudReport found = report(Cloud{points, std::vector<Point>(points.size(), {0, 0, 1})});
    EXPECT_EQ(found.points, points.size());
    EXPECT_EQ(found.places, points.empty() ? 0u : 1u);
    EXPECT_EQ(found.duplicates, points.empty() ? 0u : points.size() - 1);
    EXPECT_EQ(found.spacing.largest, 0);
    EXPECT_EQ(found.oppositeNeighbors, 0);
    EXPECT_EQ(found.bounds.isEmpty(), points.empty());
  }
  const CloudReport nothing = report(bare({{notANumber, 0, 0}, {0, infinity, 0}}));
  EXPECT_EQ(nothing.nonFinite, 2u);
  EXPECT_EQ(nothing.places, 0u);
  EXPECT_TRUE(nothing.bounds.isEmpty());
  EXPECT_FALSE(report(std::vector<OrientedPointsView>{}).hasNormals);
}

TEST(CloudReport, OfPointsOnALineAndAnOutlier)
{
  std::vector<Point> line;
  for (int i = 0; i < 100'000; ++i)
  {
    line.emplace_back(i, 2 * i, 2 * i);
  }
  const CloudReport straight = report(bare(line));
  EXPECT_DOUBLE_EQ(straight.spacing.smallest, 3);
  EXPECT_DOUBLE_EQ(straight.spacing.mean, 3);
  EXPECT_DOUBLE_EQ(straight.spacing.largest, 3);

  Cloud cloud = sphereCloud(50'000);
  const CloudReport before = report(cloud);
  cloud.positions.emplace_back(0, 0, 3.5e6);
  cloud.normals.emplace_back(0, 0, 1);
  const CloudReport after = report(cloud);
  EXPECT_NEAR(after.spacing.median, before.spacing.median, 1e-6);
  EXPECT_NEAR(after.spacing.largest, 3.5e6, 2);
}

TEST(CloudReport, DoesNotDependOnTheUnitOfLength)
{
  const Cloud cloud = sphereCloud(1000);
  const CloudReport expected = report(cloud);
  for (const double unit : {0x1p-332, 0x1p332}) // 1e±100
  {
    Cloud scaled = cloud;
    for (Point& p : scaled.positions)
    {
      p *= unit;
    }
    const CloudReport found = report(scaled);
    EXPECT_EQ(found.spacing.smallest, expected.spacing.smallest * unit);
    EXPECT_EQ(found.spacing.mean, expected.spacing.mean * unit);
    EXPECT_EQ(found.oppositeNeighbors, expected.oppositeNeighbors);
  }
}

TEST(CloudReport, TakesNormalsOfAnyLength)
{
  Cloud cloud = sphereCloud(7);
  const double lengths[] = {1, 1.0005, 0.9995, 1.002, 1e-300, 1e300, 5e-324};
  for (std::size_t i = 0; i < 7; ++i)
  {
    cloud.normals[i] = Point(0, 0, lengths[i]);
  }
  const CloudReport found = report(cloud);
  EXPECT_EQ(found.nonUnitNormals, 4u);
  EXPECT_EQ(found.zeroNormals, 0u);
  EXPECT_EQ(found.oppositeNeighbors, 0);
}

TEST(CloudReport, AsksTheFieldWhichWayTheNormalsPoint)
{
  Cloud cloud = sphereCloud(2000);
  cloud.positions[7][0] = notANumber;
  cloud.normals[9] = Point(0, 0, 0);
  const CloudReport outward = report(cloud);
  ASSERT_TRUE(outward.orientation);
  EXPECT_GT(outward.orientation->outward, 0.99);
  for (Point& normal : cloud.normals)
  {
    normal = -3 * normal;
  }
  EXPECT_GT(report(cloud).orientation->inward, 0.99);
  cloud.normals.assign(2000, Point(0, 0, 0));
  EXPECT_FALSE(report(cloud).orientation);
  EXPECT_FALSE(report(bare(cloud.positions)).orientation);
}

TEST(CloudReport, RefusesArraysOfDifferentLengths)
{
  Cloud cloud = sphereCloud(10);
  cloud.normals.pop_back();
  EXPECT_THROW(report(cloud), winding::Refusal);
}

TEST(CloudReport, KnowsNormalsThatAreEqualWhereNoPlaneIs)
{
  const auto with = [](std::vector<Point> positions, const Point& normal, std::size_t others)
  {
    Cloud cloud{std::move(positions), {}};
    cloud.normals.assign(cloud.positions.size(), normal);
    for (std::size_t i = 0; i < others; ++i)
    {
      cloud.normals[7 * i] = Point(1, static_cast<double>(i), 0.5);
    }
    return cloud;
  };
  const Point up(0, 0, 1);
  const std::vector<Point> ball = icosphere(3).points; // 642
  for (const std::size_t others : {0, 1, 6})
  {
    EXPECT_EQ(report(with(ball, up, others)).equalNormalsExcept, others);
    EXPECT_EQ(report(with(ball, Point(0.3, -2, 0.1), others)).equalNormalsExcept, others);
  }
  Cloud noisy = with(ball, up, 1);
  Random random(3705);
  for (Point& normal : noisy.normals)
  {
    normal.x() += random(-1e-4, 1e-4);
  }
  EXPECT_EQ(report(noisy).equalNormalsExcept, 1u);
  EXPECT_FALSE(report(with(ball, up, 7)).equalNormalsExcept) << "more than a hundredth";
  EXPECT_FALSE(report(Cloud{ball, ball}).equalNormalsExcept);

  // Roofs over flat ground, and a plane with slopes of 20 % in it: up is right there, or nearly.
  std::vector<Point> roofs, slopes, plane;
  for (int i = 0; i < 30; ++i)
  {
    for (int j = 0; j < 30; ++j)
    {
      roofs.emplace_back(i, j, i / 10 % 2 == 0 && j / 10 % 2 == 0 ? 8 : 0);
      slopes.emplace_back(i, j, 0.2 * std::abs(i - 15));
      plane.emplace_back(i, j, 0);
    }
  }
  for (const std::vector<Point>& points : {roofs, slopes, plane})
  {
    for (const std::size_t others : {0, 1, 9})
    {
      EXPECT_FALSE(report(with(points, up, others)).equalNormalsExcept);
    }
  }
  EXPECT_EQ(report(with(plane, up, 0)).equalNormalsExcept, std::nullopt);
  plane.back() = Point(0, 0, 100);
  EXPECT_FALSE(report(with(plane, up, 1)).equalNormalsExcept) << "an outlier over a plane";
}
