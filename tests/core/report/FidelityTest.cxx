// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Fidelity.h"

#include "support/Fields.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::Fidelity;
using winding::Field;

Fidelity compare(
  const Field& field, const Mesh& surface, unsigned seed, winding::Executor& executor)
{
  const winding::TriangleList triangles(surface.triangles.begin(), surface.triangles.end());
  return winding::compareWithSource(field, surface.points, triangles, 0.1, 5000, seed, executor);
}

Fidelity compare(const Field& field, const Mesh& surface, unsigned seed = 1)
{
  return compare(field, surface, seed, serial);
}

} // namespace

TEST(Fidelity, OfAShiftedFaceIsTheShift)
{
  const Mesh box = cube();
  const auto field = fieldOf(box);
  const Fidelity same = compare(*field, box);
  EXPECT_LT(same.largestFromSource + same.largestToSource, 1e-14);
  EXPECT_NEAR(same.sourceVolume, 1, 1e-15);
  EXPECT_NEAR(same.volume, 1, 1e-15);
  EXPECT_EQ(same.components, 1u);
  EXPECT_EQ(same.lostComponents, 0u);
  EXPECT_EQ(same.samples, 5000u);
  const Fidelity higher = compare(*field, cube({0, 0, 0}, {1, 1, 1.25}));
  EXPECT_NEAR(higher.largestFromSource, 0.25, 1e-12);
  EXPECT_NEAR(higher.largestToSource, 0.25, 1e-12);
  // The top is a sixth of the source, and points of it near the sides are nearer to these.
  EXPECT_LT(higher.meanFromSource, 0.25 / 6);
  EXPECT_GT(higher.meanFromSource, 0.1 / 6);
  EXPECT_NEAR(higher.volume, 1.25, 1e-12);
}

TEST(Fidelity, TakesMemoryForPointsAndForTriangles)
{
  const auto field = fieldOf(cube());
  const double least = winding::bytesForComparison(*field, 1000, 0);
  EXPECT_GE(least, 100 * 1000);
  EXPECT_EQ(winding::bytesForComparison(*field, 1000, 10), least); // not at the same time
  const double million = winding::bytesForComparison(*field, 1000, 1e6);
  // A point took 64 bytes, measured as the difference of 1 and 3 million of them.
  EXPECT_NEAR(winding::bytesForComparison(*field, 1000, 3e6) - million, 2e6 * 64, 2e6 * 6);
}

TEST(Fidelity, TellsOnePartFromTheOtherAndWhichIsLost)
{
  const Mesh ball = icosphere(2);
  const Mesh small = ball.mapped([](const Point& p) -> Point { return 0.1 * p + Point(3, 0, 0); });
  const auto field = fieldOf(ball.with(small));
  EXPECT_EQ(compare(*field, ball.with(small)).lostComponents, 0u);
  const Fidelity lost = compare(*field, ball);
  EXPECT_EQ(lost.components, 2u);
  EXPECT_EQ(lost.lostComponents, 1u);
  EXPECT_GT(lost.largestFromSource, 1.9);
  EXPECT_LT(lost.largestToSource, 1e-14);
  EXPECT_EQ(compare(*field, Mesh()).lostComponents, 2u);
  EXPECT_EQ(compare(*field, Mesh()).samples, 0u);
}

TEST(Fidelity, FindsPartsOfWhichOnlyACornerOrTheMiddleOfAFaceIsNear)
{
  const Mesh ball = icosphere(2);
  const Mesh small = ball.scaled(0.01);
  const Mesh large = tetrahedron().scaled(50);
  for (const Point& place : {large.points[0], large.points[2],
         Point((large.points[0] + large.points[1] + large.points[2]) / 3)})
  {
    const auto field = fieldOf(
      ball.mapped([](const Point& p) -> Point { return p - Point(500, 0, 0); }).with(large));
    const Mesh near = small.moved(place);
    const Fidelity found = compare(*field, near);
    EXPECT_EQ(found.components, 2u);
    EXPECT_EQ(found.lostComponents, 1u);
  }
}

TEST(Fidelity, HasNoVolumeOfOpenSourcesAndNoPartsOfClouds)
{
  EXPECT_TRUE(std::isnan(compare(*fieldOf(openCube()), cube()).sourceVolume));
  const Cloud cloud = sphereCloud(1000);
  const auto field = fieldOf(cloud);
  const Fidelity found = compare(*field, icosphere(3));
  EXPECT_EQ(found.components, 0u);
  EXPECT_TRUE(std::isnan(found.sourceVolume));
  EXPECT_LT(found.largestFromSource, 0.02);
  EXPECT_LT(found.largestToSource, 0.1);
}

TEST(Fidelity, HasTheSameBitsForAnyExecutorAndOtherPointsForAnotherSeed)
{
  const Mesh ball = icosphere(3);
  const auto field = fieldOf(ball);
  const Mesh other = icosphere(2);
  const Fidelity one = compare(*field, other);
  ShuffledThreads threads(3);
  const Fidelity again = compare(*field, other, 1, threads);
  EXPECT_EQ(one.largestFromSource, again.largestFromSource);
  EXPECT_EQ(one.meanToSource, again.meanToSource);
  EXPECT_NE(one.meanToSource, compare(*field, other, 2).meanToSource);
}
