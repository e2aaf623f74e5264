// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/DirectSum.h"

#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/Samples.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

// The winding number must not change with the place of the mesh, its rotation and its unit of
// length. Its sign must change with the orientation.

namespace
{

using namespace shapes;

struct Case
{
  Mesh mesh;
  std::vector<Point> samples;

  std::vector<double> values() const
  {
    const winding::Surface surface = clean(mesh);
    return valuesOf(winding::TriangleSum(surface), samples);
  }

  template <class Map> Case mapped(const Map& map) const
  {
    Case result{mesh.mapped(map), samples};
    for (Point& q : result.samples)
    {
      q = map(q);
    }
    return result;
  }
};

/// A case without samples within rounding of the surface, which a motion may round to the other
/// side.
Case someCase()
{
  Case result{triangleSoup(500, 31).with(icosphere(2).part(0, 300)), {}};
  result.samples = randomPoints(200, -2, 2, 32);
  const std::vector<Point> near = pointsNear(result.mesh, 200, 1e-3, 33);
  result.samples.insert(result.samples.end(), near.begin(), near.end());
  return result;
}

constexpr const char* seeds = "seeds 31, 32, 33";

} // namespace

TEST(TriangleSumSymmetry, ReversingTheTrianglesReversesTheSignToTheBit)
{
  SCOPED_TRACE(seeds);
  Case forward = someCase();
  Case reversed{forward.mesh.reversed(), forward.samples};
  std::vector<double> expected = forward.values();
  for (double& w : expected)
  {
    w = -w;
  }
  EXPECT_EQ(reversed.values(), expected);
}

TEST(TriangleSumSymmetry, RigidMotionsChangeNothingButRounding)
{
  SCOPED_TRACE(seeds);
  const Case still = someCase();
  const std::vector<double> expected = still.values();
  double worst = 0;
  Random random(34);
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(random(0, 6), random.direction()));
    const Point shift = random.point(-10, 10);
    const Case moved = still.mapped([&](const Point& p) -> Point { return turn * p + shift; });
    worst = std::max(worst, largestDifference(moved.values(), expected));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-11); // measured: 1.9e-13
}

TEST(TriangleSumSymmetry, MirroringReversesTheSign)
{
  SCOPED_TRACE(seeds);
  const Case still = someCase();
  const Case mirrored = still.mapped([](const Point& p) -> Point { return {-p[0], p[1], p[2]}; });
  std::vector<double> expected = still.values();
  for (double& w : expected)
  {
    w = -w;
  }
  EXPECT_EQ(mirrored.values(), expected);
}

TEST(TriangleSumSymmetry, PowersOfTwoChangeNoBit)
{
  SCOPED_TRACE(seeds);
  const Case unit = someCase();
  const std::vector<double> expected = unit.values();
  for (const double scale : {0x1p-900, 0x1p-366, 0x1p-20, 0x1p20, 0x1p366, 0x1p900})
  {
    std::vector<Point> samples = unit.samples;
    for (Point& q : samples)
    {
      q *= scale;
    }
    const winding::Surface scaled = cleanScaled(unit.mesh, scale);
    EXPECT_EQ(valuesOf(winding::TriangleSum(scaled), samples), expected) << scale;
  }
}

TEST(TriangleSumSymmetry, OtherUnitsOfLengthChangeNothingButRounding)
{
  SCOPED_TRACE(seeds);
  const Case unit = someCase();
  const std::vector<double> expected = unit.values();
  double worst = 0;
  for (const double scale : {1e-100, 1e-30, 1e-6, 1e6, 1e30, 4e99}) // the soup reaches to 2
  {
    const Case scaled = unit.mapped([&](const Point& p) -> Point { return scale * p; });
    const double error = largestDifference(scaled.values(), expected);
    EXPECT_LT(error, 1e-12) << scale; // measured: 1.6e-14
    worst = std::max(worst, error);
  }
  record("worst", worst);
}

TEST(TriangleSumSymmetry, FarFromTheOriginTheFieldIsTheSame)
{
  SCOPED_TRACE(seeds);
  // Coordinates a million diagonals away keep nine digits of the shape in double. On a lattice of
  // 2^-28 they move without rounding, so the field must be the same to rounding, not to 1e-9.
  const auto onLattice = [](const Point& p) -> Point
  {
    return (p * 0x1p28).array().round().matrix() * 0x1p-28;
  };
  const Case still = someCase().mapped(onLattice);
  const Case moved =
    still.mapped([](const Point& p) -> Point { return p + Point(4e6, -3e6, 5e6); });
  const double error = largestDifference(moved.values(), still.values());
  record("error", error);
  EXPECT_LT(error, 1e-12); // measured: 0
}

TEST(TriangleSumSymmetry, FarFromTheOriginClosedShapesStillGiveIntegers)
{
  SCOPED_TRACE("seeds 35, 36");
  const Point far(4e6, -3e6, 5e6);
  const Mesh sphere = icosphere(3).moved(far);
  std::vector<Point> samples = randomPoints(500, -1.5, 1.5, 35);
  for (Point& q : samples)
  {
    q += far;
  }
  const std::vector<Point> near = pointsNear(sphere, 500, 1e-6, 36);
  samples.insert(samples.end(), near.begin(), near.end());
  const winding::Surface surface = clean(sphere);
  double worst = 0;
  for (const double w : valuesOf(winding::TriangleSum(surface), samples))
  {
    worst = std::max(worst, std::abs(w - std::round(w)));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 5.7e-16
}
