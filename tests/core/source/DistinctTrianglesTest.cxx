// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/DistinctTriangles.h"

#include "sums/DirectSum.h"
#include "sums/ReferenceSum.h"
#include "support/HostileSoups.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;
using winding::distinctTriangles;
using winding::Triangle;

const std::vector<char> anywhere(10, 1);

} // namespace

TEST(DistinctTriangles, CountWhatIsThereSeveralTimes)
{
  const auto distinct = distinctTriangles(
    {{0, 1, 2}, {3, 4, 5}, {1, 2, 0}, {5, 4, 3}, {0, 2, 3}, {2, 0, 1}, {6, 7, 8}}, anywhere);
  ASSERT_TRUE(distinct);
  EXPECT_EQ(
    distinct->triangles, (winding::TriangleList{{3, 4, 5}, {0, 2, 3}, {6, 7, 8}, {0, 1, 2}}));
  EXPECT_EQ(distinct->multiplicities, (winding::Multiplicities{0, 1, 1, 3}));
}

TEST(DistinctTriangles, AreTurnedWhereMoreRunTheOtherWay)
{
  const auto distinct = distinctTriangles({{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}, anywhere);
  ASSERT_TRUE(distinct);
  EXPECT_EQ(distinct->triangles, (winding::TriangleList{{0, 2, 1}}));
  EXPECT_EQ(distinct->multiplicities, (winding::Multiplicities{1}));
}

TEST(DistinctTriangles, AreNoneWhereNoTwoAreEqual)
{
  EXPECT_FALSE(distinctTriangles({}, anywhere));
  EXPECT_FALSE(distinctTriangles({{0, 1, 2}, {0, 1, 3}}, anywhere));
  EXPECT_FALSE(distinctTriangles({{0, 1, 2}, {0, 1, 2}}, std::vector<char>(10, 0)));
}

TEST(DistinctTriangles, HaveTheSumOfAll)
{
  const Mesh mesh = copiesOf(latticeSoup(40, 3, 1510), 2).with(latticeSoup(60, 2, 1511));
  const winding::Surface all = clean(mesh);
  auto distinct = distinctTriangles(all.triangles, std::vector<char>(all.vertices.size(), 1));
  ASSERT_TRUE(distinct);
  EXPECT_LT(distinct->triangles.size(), all.triangles.size() - 40);
  EXPECT_GT(distinct->multiplicities.back(), 2);
  EXPECT_TRUE(std::is_sorted(distinct->multiplicities.begin(), distinct->multiplicities.end()));
  winding::Surface merged = all;
  merged.triangles = distinct->triangles;
  merged.multiplicities = distinct->multiplicities;
  const std::vector<Point> samples = randomPoints(200, -0.5, 2.5, 1512);
  const std::vector<double> values = valuesOf(winding::TriangleSum(merged), samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_NEAR(values[i], winding::referenceSum<long double>(all, samples[i]), 1e-12);
  }
}
