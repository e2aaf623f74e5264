// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/QuadSplit.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using shapes::Point;
using shapes::Random;
using winding::betterSplit;
using winding::QuadAroundEdge;
using winding::QuadSplit;

/// A quad over the corners of a square around the edge, at these heights.
QuadAroundEdge overSquare(double a, double b, double c, double d, double crossing)
{
  return {
    {{-0.5, -0.5, a}, {0.5, -0.5, b}, {0.5, 0.5, c}, {-0.5, 0.5, d}}, crossing, Point::Ones()};
}

/// Whether a point is in the tetrahedra that the edge spans with the sides of the quad.
bool isInTetrahedra(const QuadAroundEdge& quad, const Point& point)
{
  constexpr double rounding = 1e-12;
  for (int n = 0; n < 4; ++n)
  {
    Eigen::Matrix4d corners;
    corners << quad.corners[n], quad.corners[(n + 1) % 4], Point::Zero(), Point(0, 0, 1), 1, 1, 1,
      1;
    const Eigen::Vector4d shares = corners.inverse() * point.homogeneous();
    if ((shares.array() >= -rounding).all())
    {
      return true;
    }
  }
  return false;
}

/// Whether the triangles of a split stay in the tetrahedra, by points of them.
bool staysInTetrahedra(const QuadAroundEdge& quad, int from)
{
  for (const int second : {1, 3})
  {
    constexpr int steps = 40;
    for (int u = 0; u <= steps; ++u)
    {
      for (int v = 0; u + v <= steps; ++v)
      {
        const Point point = (u * quad.corners[from] + v * quad.corners[(from + second) % 4] +
                              (steps - u - v) * quad.corners[(from + 2) % 4]) /
                            steps;
        if (!isInTetrahedra(quad, point))
        {
          return false;
        }
      }
    }
  }
  return true;
}

} // namespace

TEST(QuadSplit, FollowsARidge)
{
  EXPECT_EQ(betterSplit(overSquare(0.5, 0.2, 0.5, 0.2, 0.5)), QuadSplit::first);
  EXPECT_EQ(betterSplit(overSquare(0.2, 0.5, 0.2, 0.5, 0.5)), QuadSplit::second);
  // A valley along the other diagonal has the same corners, but another crossing.
  EXPECT_EQ(betterSplit(overSquare(0.5, 0.2, 0.5, 0.2, 0.2)), QuadSplit::second);
}

TEST(QuadSplit, OfAFlatQuadIsTheShorterDiagonal)
{
  QuadAroundEdge quad = overSquare(0.5, 0.5, 0.5, 0.5, 0.5);
  EXPECT_EQ(betterSplit(quad), QuadSplit::first);
  quad.corners[0].head<2>() *= 1.5;
  EXPECT_EQ(betterSplit(quad), QuadSplit::second);
  quad.corners[1].head<2>() *= 1.9;
  EXPECT_EQ(betterSplit(quad), QuadSplit::first);
}

TEST(QuadSplit, NeverLeavesTheTetrahedraOfItsSides)
{
  Random random(1);
  int counts[3] = {}, unneeded = 0;
  for (int n = 0; n < 3000; ++n)
  {
    QuadAroundEdge quad = overSquare(0, 0, 0, 0, random(0, 1));
    for (Point& corner : quad.corners)
    {
      corner = corner.cwiseProduct(random.point(0.002, 2)) + Point(0, 0, random(-0.2, 1.2));
      corner[2] = std::min(std::max(corner[2], 0.0), 1.0);
    }
    const QuadSplit split = betterSplit(quad);
    ++counts[static_cast<int>(split)];
    if (split == QuadSplit::fan)
    {
      unneeded += staysInTetrahedra(quad, 0) || staysInTetrahedra(quad, 1);
    }
    else
    {
      EXPECT_TRUE(staysInTetrahedra(quad, split == QuadSplit::first ? 0 : 1)) << n;
    }
  }
  EXPECT_GT(*std::min_element(counts, counts + 3), 100);
  EXPECT_LE(unneeded, counts[2] / 15); // measured: 10 of 260, where a diagonal is near to leaving
}
