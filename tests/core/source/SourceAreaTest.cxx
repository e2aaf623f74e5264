// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceArea.h"

#include "support/Shapes.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;

TEST(SourceArea, IsThatOfTheTriangles)
{
  const winding::Surface surface = clean(cube({1, 1, 1}, {2, 3, 4}));
  EXPECT_DOUBLE_EQ(winding::areaOf(surface.vertices, surface.triangles), 22);
  EXPECT_EQ(winding::areaOf(surface.vertices, {}), 0);
}

TEST(SourceArea, IsNearlyThatOfTheTrianglesWhereSomeOfManyAreAsked)
{
  const winding::Surface few = clean(icosphere(3)), many = clean(icosphere(7));
  EXPECT_EQ(winding::approximateAreaOf(few.vertices, few.triangles),
    winding::areaOf(few.vertices, few.triangles));
  EXPECT_EQ(winding::approximateAreaOf(few.vertices, {}), 0);
  ASSERT_GT(many.triangles.size(), 4 * 65536u);
  const double area = winding::areaOf(many.vertices, many.triangles);
  EXPECT_NEAR(winding::approximateAreaOf(many.vertices, many.triangles), area, 0.01 * area);
}

TEST(SourceArea, HasSamplesInTheBoundsAndATwentiethAround)
{
  const winding::Bounds bounds(Point(1, 1, 1), Point(2, 3, 5));
  EXPECT_NEAR(
    winding::distanceBetweenSamples(bounds, 1000), std::cbrt(1.4 * 2.4 * 4.4 / 1000), 1e-12);
  const winding::Bounds flat(Point(0, 0, 0), Point(1e200, 1e200, 0));
  EXPECT_NEAR(
    winding::distanceBetweenSamples(flat, 1000), std::cbrt(1.1 * 1.1 * 0.1 / 1000) * 1e200, 1e188);
  EXPECT_EQ(winding::distanceBetweenSamples(bounds, 0), 0);
  EXPECT_EQ(winding::distanceBetweenSamples(winding::Bounds(), 1000), 0);
}

} // namespace
