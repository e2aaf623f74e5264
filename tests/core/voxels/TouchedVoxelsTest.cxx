// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/TouchedVoxels.h"

#include "base/Executor.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "support/Grids.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using shapes::Mesh;
using shapes::Point;
using shapes::Random;
using winding::Extent;
using winding::Grid;

using Marks = std::vector<unsigned char>;

/// Voxel (i, j, k) is the box from (i, j, k) to (i, j, k) + 1, times the spacing.
Grid gridOf(const Eigen::Vector3i& dimensions, const Point& spacing = {1, 1, 1})
{
  return {0.5 * spacing, spacing, dimensions};
}

Marks marksOf(const Mesh& mesh, const Grid& grid, const Extent& extent, winding::Executor& executor)
{
  Marks marks(winding::sampleCount(extent), 0);
  winding::markTouched(shapes::clean(mesh), grid, extent, marks.data(), executor);
  return marks;
}

Marks marksOf(const Mesh& mesh, const Grid& grid)
{
  winding::SerialExecutor executor;
  return marksOf(mesh, grid, grid.wholeExtent(), executor);
}

/**
 * The distance between a triangle and the box of a voxel along the axis that separates them best,
 * of all 13 that can separate them: less than 0 if they overlap, 0 if they touch. It is exact for
 * small integers and halves.
 */
double gapBetween(const std::array<Point, 3>& triangle, const Eigen::Vector3i& voxel)
{
  std::vector<Point> axes = {Point::UnitX(), Point::UnitY(), Point::UnitZ(),
    (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0])};
  for (int edge = 0; edge < 3; ++edge)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      axes.push_back((triangle[(edge + 1) % 3] - triangle[edge]).cross(Point::Unit(axis)));
    }
    // The directions of the edges are more axes for triangles that are no more than segments.
    axes.push_back(triangle[(edge + 1) % 3] - triangle[edge]);
  }
  const Point center = voxel.cast<double>() + Point::Constant(0.5);
  double gap = -std::numeric_limits<double>::infinity();
  for (const Point& axis : axes)
  {
    const double size = axis.cwiseAbs().maxCoeff();
    if (size == 0)
    {
      continue;
    }
    const double radius = 0.5 * axis.cwiseAbs().sum();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& corner : triangle)
    {
      const double along = axis.dot(corner - center);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    gap = std::max(gap, std::max(low - radius, -radius - high) / size);
  }
  return gap;
}

/// A triangle with corners on the lattice (kind 0) or at halves (1), a large one (2), a thin or
/// small one (3 to 5), or one in a plane of the grid (6).
std::array<Point, 3> someTriangle(Random& random, int kind)
{
  const auto corner = [&]() -> Point
  {
    Point p = random.point(-2, 11);
    switch (kind)
    {
    case 0:
      return p.array().round();
    case 1:
      return (2 * p).array().round() / 2;
    case 2:
      return 30 * (p - Point::Constant(4.5));
    default:
      return p;
    }
  };
  std::array<Point, 3> triangle = {corner(), corner(), corner()};
  if (kind == 3) // the triangle is a needle
  {
    triangle[2] = triangle[0] + 1e-6 * (triangle[2] - triangle[0]);
  }
  if (kind == 4) // the triangle is nearly a segment
  {
    triangle[2] = 0.3 * triangle[0] + 0.7 * triangle[1] + Point::Constant(1e-14);
  }
  if (kind == 5) // the triangle is small
  {
    triangle[1] = triangle[0] + 0.3 * random.direction();
    triangle[2] = triangle[0] + 0.3 * random.direction();
  }
  if (kind == 6) // the triangle lies in a plane of the grid
  {
    const int axis = static_cast<int>(random.bits() % 3);
    for (Point& p : triangle)
    {
      p[axis] = 4;
    }
  }
  return triangle;
}

TEST(TouchedVoxels, AreThoseThatNoAxisSeparatesFromTheTriangle)
{
  SCOPED_TRACE("seed 61");
  Random random(61);
  const Point spacing(0.5, 2, 1); // powers of 2, which leave lattices exact
  const Grid grid = gridOf({9, 8, 7}, spacing);
  int touching = 0, ties = 0;
  for (int n = 0; n < 7000; ++n)
  {
    const int kind = n % 7;
    const std::array<Point, 3> triangle = someTriangle(random, kind);
    Mesh mesh;
    mesh.triangles = {{0, 1, 2}};
    for (const Point& corner : triangle)
    {
      mesh.points.push_back(corner.cwiseProduct(spacing));
    }
    if (shapes::clean(mesh).triangles.empty())
    {
      continue; // two corners are one
    }
    const Marks marks = marksOf(mesh, grid);
    for (std::size_t i = 0; i < marks.size(); ++i)
    {
      const Eigen::Vector3i voxel = winding::sampleIndex(grid.wholeExtent(), i);
      const double gap = gapBetween(triangle, voxel);
      const bool isExact = kind < 2;
      // Rounding leaves gaps undecided up to 16 of its units for coordinates up to 400.
      const double undecided = isExact ? 0 : 1e-12;
      if (gap <= -undecided)
      {
        ASSERT_EQ(marks[i], 1) << "kind " << kind << ", gap " << gap;
      }
      if (gap > undecided)
      {
        ASSERT_EQ(marks[i], 0) << "kind " << kind << ", gap " << gap;
      }
      touching += gap <= 0;
      ties += isExact && gap == 0;
    }
  }
  EXPECT_GT(touching, 50000);
  EXPECT_GT(ties, 5000) << "faces, edges and corners that are just met";
}

TEST(TouchedVoxels, FacesBelongToBothVoxels)
{
  // The cube's faces lie in planes of the grid.
  const Grid grid = gridOf({6, 6, 6});
  const Marks marks = marksOf(shapes::cube({2, 2, 2}, {4, 4, 4}), grid);
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    const Eigen::Vector3i voxel = winding::sampleIndex(grid.wholeExtent(), i);
    ASSERT_EQ(marks[i], voxel.minCoeff() >= 1 && voxel.maxCoeff() <= 4) << voxel.transpose();
  }
}

/// Corners at tenths, and voxels of tenths, are none that numbers can hold: rounding may put either
/// first, and both voxels are touched, along every axis.
TEST(TouchedVoxels, FacesAtTenthsBelongToBothVoxelsAlongEveryAxis)
{
  for (const Point& spacing :
    {Point(0.1, 0.1, 0.1), Point(0.1, 0.3, 0.7), Point(0.7, 0.1, 0.3), Point(0.3, 0.7, 0.1)})
  {
    const Grid grid = gridOf({10, 10, 10}, spacing);
    for (int low = 1; low < 9; ++low)
    {
      for (int high = low + 1; high < 9; ++high)
      {
        Point from, to;
        for (int axis = 0; axis < 3; ++axis)
        {
          // Numbers are as written, and no computed multiples.
          const double tenths = std::round(10 * spacing[axis]);
          from[axis] = low * tenths / 10;
          to[axis] = high * tenths / 10;
        }
        const Marks marks = marksOf(shapes::cube(from, to), grid);
        for (std::size_t i = 0; i < marks.size(); ++i)
        {
          const Eigen::Vector3i voxel = winding::sampleIndex(grid.wholeExtent(), i);
          const bool isIn = voxel.minCoeff() >= low - 1 && voxel.maxCoeff() <= high;
          const bool isWithin = voxel.minCoeff() > low && voxel.maxCoeff() < high - 1;
          ASSERT_EQ(marks[i], isIn && !isWithin)
            << voxel.transpose() << " of " << low << " to " << high;
        }
      }
    }
  }
}

/// Far from the origin, rounding is that of the position.
TEST(TouchedVoxels, FacesAtTenthsBelongToBothVoxelsFarAway)
{
  for (const double far : {1000.0, -1000.0, 1e5})
  {
    const Grid grid = {Point::Constant(far + 0.05), Point::Constant(0.1), {5, 5, 5}};
    const auto from = Point::Constant(far + 0.1), to = Point::Constant(far + 0.4);
    const Marks marks = marksOf(shapes::cube(from, to), grid);
    EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 124) << far << ": all but the middle";
  }
}

TEST(TouchedVoxels, PointsTouchTheVoxelsThatMeetThere)
{
  const Grid grid = gridOf({5, 5, 5});
  winding::SerialExecutor executor;
  for (const auto& [point, count] :
    {std::pair(Point(2.5, 2.5, 2.5), 1), std::pair(Point(2, 2.5, 2.5), 2),
      std::pair(Point(2, 3, 2.5), 4), std::pair(Point(2, 3, 2), 8), std::pair(Point(0, 0, 0), 1),
      std::pair(Point(5, 5, 5), 1), std::pair(Point(5.01, 2, 2), 0)})
  {
    winding::PointCloud cloud;
    cloud.positions = {point};
    Marks marks(125, 0);
    winding::markTouched(cloud, grid, grid.wholeExtent(), marks.data(), executor);
    EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), count) << point.transpose();
  }
}

/// The tolerance for voxels that are not touched is relative: voxels and triangles may be of any
/// size, anywhere.
TEST(TouchedVoxels, HoldEveryPointOfTheSurfaceWhereverTheGridLies)
{
  SCOPED_TRACE("seed 62");
  for (const double scale : {1e-90, 1e-6, 1.0, 1e90})
  {
    for (const double offset : {0.0, 1e3, 1e7})
    {
      Random random(62);
      const Mesh mesh = shapes::triangleSoup(60, 62).mapped(
        [&](const Point& p) -> Point { return scale * (p + Point::Constant(offset)); });
      const Grid grid = shapes::gridAround(shapes::clean(mesh).bounds, 23);
      const Marks marks = marksOf(mesh, grid);
      EXPECT_LT(std::count(marks.begin(), marks.end(), 1),
        static_cast<std::ptrdiff_t>(marks.size()) * 3 / 4);
      for (int n = 0; n < 20000; ++n)
      {
        const auto& ids = mesh.triangles[random.bits() % mesh.triangles.size()];
        double u = random(0, 1), v = random(0, 1);
        if (u + v > 1)
        {
          u = 1 - u;
          v = 1 - v;
        }
        const Point& a = mesh.points[static_cast<std::size_t>(ids[0])];
        const Point p = a + u * (mesh.points[static_cast<std::size_t>(ids[1])] - a) +
                        v * (mesh.points[static_cast<std::size_t>(ids[2])] - a);
        const Eigen::Vector3i voxel =
          (p - grid.corner()).cwiseQuotient(grid.spacing).array().floor().cast<int>();
        if ((voxel.array() >= 0).all() && (voxel.array() < grid.dimensions.array()).all())
        {
          ASSERT_EQ(marks[winding::sampleNumber(grid.wholeExtent(), voxel)], 1)
            << scale << " " << offset << " " << p.transpose();
        }
      }
    }
  }
}

TEST(TouchedVoxels, PartsAndThreadsHaveTheBitsOfTheWhole)
{
  const Mesh mesh = shapes::triangleSoup(300, 63);
  const Grid grid = shapes::gridAround(shapes::clean(mesh).bounds, 31);
  const Marks whole = marksOf(mesh, grid);
  shapes::ShuffledThreads threads(64);
  EXPECT_EQ(marksOf(mesh, grid, grid.wholeExtent(), threads), whole);
  for (const Extent& extent : {Extent{3, 20, 5, 5, 2, 22}, Extent{7, 7, 7, 7, 7, 7},
         Extent{0, 4, 10, 25, 0, 0}, Extent{4, 3, 0, 5, 0, 5}})
  {
    const Marks part = marksOf(mesh, grid, extent, threads);
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const Eigen::Vector3i voxel = winding::sampleIndex(extent, i);
      ASSERT_EQ(part[i], whole[winding::sampleNumber(grid.wholeExtent(), voxel)]);
    }
  }
}

/// The bounding boxes of these triangles have 2·10¹¹ voxels in all.
TEST(TouchedVoxels, LongTrianglesAreNotSearchedForInTheirBoxes)
{
  SCOPED_TRACE("seed 65");
  Random random(65);
  Mesh mesh;
  for (int n = 0; n < 2000; ++n)
  {
    for (const Point& corner : {Point(1, 1, 1), Point(479, 479, 479), Point(479, 478, 478)})
    {
      mesh.points.emplace_back(corner + random.point(-1, 1));
    }
    mesh.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
  }
  const Marks marks = marksOf(mesh, gridOf({480, 480, 480}));
  const auto count = std::count(marks.begin(), marks.end(), 1);
  EXPECT_GT(count, 480);
  EXPECT_LT(count, 480 * 50) << "all along the diagonal";
}

TEST(TouchedVoxels, NothingTouchesNothing)
{
  winding::SerialExecutor executor;
  const Grid grid = gridOf({3, 3, 3});
  Marks marks(27, 0);
  winding::markTouched(winding::Surface(), grid, grid.wholeExtent(), marks.data(), executor);
  winding::markTouched(winding::PointCloud(), grid, grid.wholeExtent(), marks.data(), executor);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 0);
  const Marks far = marksOf(shapes::cube({10, 10, 10}, {11, 11, 11}), grid);
  EXPECT_EQ(std::count(far.begin(), far.end(), 1), 0);
  const Marks around = marksOf(shapes::cube({-1, -1, -1}, {4, 4, 4}), grid);
  EXPECT_EQ(std::count(around.begin(), around.end(), 1), 0) << "the surface is not the solid";
}

} // namespace
