// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Verify.h"

#include "base/Pi.h"
#include "base/Views.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace
{

using namespace shapes;
using winding::ErrorStatistics;
using winding::Extent;
using winding::Field;
using winding::Grid;
using winding::Verification;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t drawn = 500;
constexpr unsigned seed = 121;

std::shared_ptr<const Field> sphereField()
{
  const Mesh mesh = icosphere(2);
  return fieldOf(mesh);
}

Grid gridOver(const Point& low, const Point& high, int resolution = 16)
{
  return gridAround({low, high}, resolution);
}

Grid sphereGrid()
{
  return gridOver({-1.3, -1.4, -1.5}, {1.3, 1.4, 1.5});
}

Verification verifyWith(const Field& field, const Grid& grid, const Extent& extent,
  const std::function<double(const Eigen::Vector3i&, double)>& change)
{
  std::vector<double> values(winding::sampleCount(extent));
  winding::FieldOutput output;
  output.doubleValues = values.data();
  field.evaluate(grid, extent, output, serial);
  return winding::verify(
    field, grid, extent,
    [&](std::size_t n) { return change(winding::sampleIndex(extent, n), values[n]); }, drawn, seed,
    serial);
}

double unchanged(const Eigen::Vector3i&, double value)
{
  return value;
}

} // namespace

TEST(Verify, FindsAFieldRight)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = sphereGrid();
  const Verification found = verifyWith(*sphereField(), grid, grid.wholeExtent(), unchanged);
  EXPECT_EQ(found.everywhere.samples, drawn);
  EXPECT_EQ(found.nearSurface.samples, drawn);
  record("max", found.nearSurface.max);
  // Measured: 1.6e-15.
  EXPECT_LT(found.everywhere.max, 1e-12);
  EXPECT_LT(found.nearSurface.max, 1e-12);
  EXPECT_LE(found.everywhere.rms(), found.everywhere.max);
}

TEST(Verify, FindsErrorsThatArePlantedEverywhere)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = sphereGrid();
  const Verification found = verifyWith(*sphereField(), grid, grid.wholeExtent(),
    [](const Eigen::Vector3i&, double value) { return value - 0.125; });
  EXPECT_NEAR(found.everywhere.max, 0.125, 1e-12);
  EXPECT_NEAR(found.everywhere.rms(), 0.125, 1e-12);
  EXPECT_NEAR(found.nearSurface.max, 0.125, 1e-12);
}

TEST(Verify, LooksNearTheSurfaceOnItsOwn)
{
  SCOPED_TRACE("seed 121");
  const auto field = sphereField();
  const Grid grid = gridOver({-2, -2, -2}, {2, 2, 2}, 40);
  const auto distance = [&](const Eigen::Vector3i& i)
  {
    return std::abs(grid.sample(i).norm() - 1);
  };
  // Two voxels and the depth of the mesh below the sphere, 0.02.
  const double farthest = 2 * grid.spacing[0] + 0.02;
  const Verification near = verifyWith(*field, grid, grid.wholeExtent(),
    [&](const Eigen::Vector3i& i, double w) { return distance(i) <= farthest ? w + 1 : w; });
  EXPECT_NEAR(near.nearSurface.rms(), 1, 1e-12) << "all of these are near";
  EXPECT_LT(near.everywhere.rms(), 0.6) << "most of these are not";
  EXPECT_GT(near.everywhere.max, 0.9);
}

TEST(Verify, ComparesWithTheValueOfTheVerySample)
{
  SCOPED_TRACE("seed 121");
  const auto field = sphereField();
  const Grid grid = sphereGrid();
  // Were two axes exchanged or an extent's origin forgotten, these errors would not come out.
  const Extent extent = {2, 11, 1, 13, 4, 15};
  const Verification found = verifyWith(*field, grid, extent,
    [&](const Eigen::Vector3i& i, double) { return field->reference(grid.sample(i)); });
  EXPECT_GT(found.everywhere.samples, 100u);
  EXPECT_EQ(found.everywhere.max, 0);
  EXPECT_EQ(found.nearSurface.max, 0);
}

TEST(Verify, OfThePiecesTogetherIsThatOfTheWhole)
{
  SCOPED_TRACE("seed 121");
  const auto field = sphereField();
  const Grid grid = sphereGrid();
  const auto change = [](const Eigen::Vector3i& i, double value)
  {
    return value + 0.001 * i[0] + 0.01 * i[1] - 0.02 * i[2];
  };
  const Extent whole = grid.wholeExtent();
  const Verification expected = verifyWith(*field, grid, whole, change);
  ErrorStatistics everywhere, near;
  for (int piece = 0; piece < 4; ++piece)
  {
    Extent extent = whole;
    extent[4] = piece * 4;
    extent[5] = piece == 3 ? whole[5] : piece * 4 + 3;
    const Verification part = verifyWith(*field, grid, extent, change);
    everywhere.add(part.everywhere);
    near.add(part.nearSurface);
  }
  EXPECT_EQ(everywhere.samples, expected.everywhere.samples);
  EXPECT_EQ(near.samples, expected.nearSurface.samples);
  EXPECT_EQ(everywhere.max, expected.everywhere.max);
  EXPECT_EQ(near.max, expected.nearSurface.max);
  EXPECT_DOUBLE_EQ(everywhere.rms(), expected.everywhere.rms());
  EXPECT_DOUBLE_EQ(near.rms(), expected.nearSurface.rms());
}

TEST(Verify, HasNoNearSamplesWhereTheGridMissesTheSourceOrThereIsNone)
{
  SCOPED_TRACE("seed 121");
  const Grid away = gridOver({10, 10, 10}, {12, 12, 12});
  const Verification found = verifyWith(*sphereField(), away, away.wholeExtent(), unchanged);
  EXPECT_EQ(found.everywhere.samples, drawn);
  EXPECT_EQ(found.nearSurface.samples, 0u);
  const auto empty = Field::build(std::vector<winding::TrianglesView>(), {}, serial);
  const Grid grid = sphereGrid();
  const Verification none = verifyWith(*empty, grid, grid.wholeExtent(), unchanged);
  EXPECT_EQ(none.everywhere.max, 0);
  EXPECT_EQ(none.nearSurface.samples, 0u);
}

TEST(Verify, CountsAValueThatIsNoNumberAsInfinitelyWrong)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = sphereGrid();
  const Verification found = verifyWith(*sphereField(), grid, grid.wholeExtent(),
    [](const Eigen::Vector3i& i, double value) { return i[0] == 3 ? notANumber : value; });
  EXPECT_EQ(found.everywhere.max, infinity);
  EXPECT_EQ(found.everywhere.rms(), infinity);
}

namespace
{

constexpr winding::Method valueMethods[] = {
  winding::Method::rows, winding::Method::hierarchical, winding::Method::direct};

/// 13³ samples at multiples of an eighth, from −0.25 to 1.25; 386 lie on faces of the unit cube.
Grid gridThroughTheCube()
{
  Grid grid;
  grid.firstSample = Point::Constant(-0.25);
  grid.spacing = Point::Constant(0.125);
  grid.dimensions = Eigen::Vector3i::Constant(13);
  return grid;
}

bool isOnTheCube(const Point& p)
{
  return p.minCoeff() >= 0 && p.maxCoeff() <= 1 && (p.minCoeff() == 0 || p.maxCoeff() == 1);
}

std::size_t samplesOf(const Verification& found)
{
  return found.everywhere.samples + found.nearSurface.samples + found.onSurface;
}

} // namespace

TEST(Verify, CountsSamplesOnTheSurfaceApart)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = gridThroughTheCube();
  for (const winding::Method method : valueMethods)
  {
    const auto field = fieldOf(cube(), method);
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(), unchanged);
    EXPECT_LT(found.everywhere.max, 1e-3) << winding::nameOf(method);
    EXPECT_LT(found.nearSurface.max, 1e-3) << winding::nameOf(method);
    EXPECT_EQ(samplesOf(found), 2 * drawn);
    const Verification wrong = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w) { return isOnTheCube(grid.sample(i)) ? w : w + 1; });
    EXPECT_EQ(wrong.onSurface, found.onSurface);
    EXPECT_GT(wrong.onSurface, drawn / 4);
    EXPECT_NEAR(wrong.everywhere.rms(), 1, 1e-3);
    EXPECT_NEAR(wrong.nearSurface.rms(), 1, 1e-3);
  }
}

TEST(Verify, CountsSamplesThatAreOnTheSurfaceUpToRoundingApart)
{
  SCOPED_TRACE("seed 121");
  // An octahedron whose faces go through samples, at places that no double is.
  Grid grid;
  grid.firstSample = {0.3, -7.7, 1000.1};
  grid.spacing = {0.1, 0.3, 0.7};
  grid.dimensions = Eigen::Vector3i::Constant(17);
  const Mesh lattice = {{{14, 8, 8}, {2, 8, 8}, {8, 14, 8}, {8, 2, 8}, {8, 8, 14}, {8, 8, 2}},
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const Mesh mesh = lattice.mapped([&](const Point& p) { return grid.sample(p.cast<int>()); });
  const auto distanceFromFaces = [](const Eigen::Vector3i& i)
  {
    return std::abs((i - Eigen::Vector3i::Constant(8)).cwiseAbs().sum() - 6);
  };
  for (const winding::Method method : valueMethods)
  {
    const auto field = fieldOf(mesh, method);
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(), unchanged);
    EXPECT_LT(found.everywhere.max, 1e-3) << winding::nameOf(method);
    EXPECT_LT(found.nearSurface.max, 1e-3) << winding::nameOf(method);
    EXPECT_EQ(samplesOf(found), 2 * drawn);
    EXPECT_GT(found.onSurface, drawn / 20);
    const Verification wrong = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w) { return distanceFromFaces(i) == 0 ? w : w + 1; });
    EXPECT_EQ(wrong.onSurface, found.onSurface);
    EXPECT_NEAR(wrong.nearSurface.rms(), 1, 1e-3);
  }
}

TEST(Verify, FindsWrongValuesBesideTheSurface)
{
  SCOPED_TRACE("seed 121");
  // Less than a billionth of a voxel off it, where a value is as right or wrong as any.
  const Mesh beside = cube(Point::Constant(1e-12), Point::Constant(1 + 1e-12));
  const Grid grid = gridThroughTheCube();
  for (const winding::Method method : valueMethods)
  {
    const auto field = fieldOf(beside, method);
    EXPECT_LT(verifyWith(*field, grid, grid.wholeExtent(), unchanged).nearSurface.max, 1e-3);
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w) { return isOnTheCube(grid.sample(i)) ? 0.5 : w; });
    EXPECT_EQ(found.onSurface, 0u);
    EXPECT_NEAR(found.everywhere.max, 0.5, 1e-3);
    EXPECT_NEAR(found.nearSurface.max, 0.5, 1e-3);
  }
}

TEST(Verify, FindsWhatNoSideOfTheSurfaceExplains)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = gridThroughTheCube();
  const auto field = fieldOf(cube(), winding::Method::rows);
  for (const double wrong : {notANumber, infinity, 7.5, -7.5})
  {
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w) { return isOnTheCube(grid.sample(i)) ? wrong : w; });
    EXPECT_EQ(found.onSurface, 0u);
    EXPECT_GE(found.nearSurface.max, 7);
  }
}

TEST(Verify, FindsErrorsOnFacesAndEdgesThatNoChoiceOfASideMakes)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = gridThroughTheCube();
  const auto sidesOf = [&](const Eigen::Vector3i& i)
  {
    const Point p = grid.sample(i);
    return (p.array() == 0).count() + (p.array() == 1).count();
  };
  // Samples on the diagonals of the faces belong to two triangles, so they may err by any number up
  // to 2.
  const auto isOnDiagonal = [&](const Eigen::Vector3i& i)
  {
    const Point p = grid.sample(i);
    return p[0] == p[1] || p[1] == p[2] || p[0] == p[2] || p[0] + p[1] == 1 || p[1] + p[2] == 1 ||
           p[0] + p[2] == 1;
  };
  for (const winding::Method method : valueMethods)
  {
    const auto field = fieldOf(cube(), method);
    const Verification onFaces = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w)
      { return isOnTheCube(grid.sample(i)) && sidesOf(i) == 1 && !isOnDiagonal(i) ? w + 0.3 : w; });
    EXPECT_GT(onFaces.nearSurface.max, 0.19) << winding::nameOf(method);
    // The edges of the cube have two to six triangles at a sample.
    const Verification onEdges = verifyWith(*field, grid, grid.wholeExtent(),
      [&](const Eigen::Vector3i& i, double w)
      { return isOnTheCube(grid.sample(i)) && sidesOf(i) > 1 ? w + 5.2 : w; });
    EXPECT_GT(onEdges.nearSurface.max, 4.1) << winding::nameOf(method);
  }
}

TEST(Verify, CountsSamplesOnTheSurfaceInEachPiece)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = gridThroughTheCube();
  const auto field = fieldOf(openCube(), winding::Method::automatic);
  const Verification whole = verifyWith(*field, grid, grid.wholeExtent(), unchanged);
  std::size_t inPieces = 0;
  for (int k = 0; k < 13; ++k)
  {
    inPieces += verifyWith(*field, grid, {0, 12, 0, 12, k, k}, unchanged).onSurface;
  }
  EXPECT_GT(whole.onSurface, 0u);
  EXPECT_EQ(inPieces, whole.onSurface);
}

TEST(Verify, CountsSamplesAtPointsOfACloudApartUnlessTheyAreRegularized)
{
  SCOPED_TRACE("seed 121");
  const Grid grid = gridThroughTheCube();
  Cloud cloud;
  for (const auto& [axis, side] : {std::pair(0, 0), {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}})
  {
    for (int n = 0; n < 81; ++n)
    {
      Point position, normal = Point::Zero();
      position[axis] = side;
      position[(axis + 1) % 3] = 0.125 * (n % 9);
      position[(axis + 2) % 3] = 0.125 * (n / 9);
      normal[axis] = side ? 1 : -1;
      // Every other point is moved by less than coordinates can tell.
      cloud.positions.push_back(position + (n % 2) * Point::Constant(1e-16));
      cloud.normals.push_back(normal);
    }
  }
  for (const double regularization : {0.0, 1.0})
  {
    const auto field = fieldOf(cloud, &winding::FieldOptions::regularization, regularization);
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(), unchanged);
    EXPECT_LT(found.everywhere.max, 1e-3);
    EXPECT_LT(found.nearSurface.max, 1e-3);
    EXPECT_EQ(samplesOf(found), 2 * drawn);
    EXPECT_EQ(found.onSurface > 0, regularization == 0);
    const Verification wrong = verifyWith(
      *field, grid, grid.wholeExtent(), [](const Eigen::Vector3i&, double) { return notANumber; });
    EXPECT_EQ(wrong.onSurface, 0u);
  }
}

TEST(Verify, CountsSamplesApartUpToTheRadiusAtWhichTheShareOfAPointIsOne)
{
  // The share of a point with this area is 1 at a distance of 0.5 along its normal.
  const std::vector<double> areas = {4 * winding::pi * 0.25};
  const Cloud cloud{{{0, 0, 0}}, {{0, 0, 1}}};
  winding::OrientedPointsView view = cloud.view();
  view.areas = {areas.data(), 1};
  const auto field = Field::build(std::vector<winding::OrientedPointsView>{view}, {}, serial);
  for (const auto& [distance, isNear] : {std::pair(0.495, true), {0.505, false}})
  {
    const Grid grid = {{0, 0, distance}, {1, 1, 1}, {1, 1, 1}};
    const Verification found = verifyWith(*field, grid, grid.wholeExtent(), unchanged);
    EXPECT_EQ(found.besidePoints.samples > 0, isNear) << distance;
    EXPECT_EQ(found.everywhere.samples > 0, !isNear) << distance;
  }
}

TEST(ErrorStatistics, HaveTheLargestAndTheRootMeanSquareError)
{
  ErrorStatistics statistics;
  EXPECT_EQ(statistics.rms(), 0);
  statistics.add(-4);
  statistics.add(3);
  EXPECT_EQ(statistics.samples, 2u);
  EXPECT_EQ(statistics.max, 4);
  EXPECT_DOUBLE_EQ(statistics.rms(), std::sqrt(12.5));
  statistics.add(notANumber);
  statistics.add(1);
  EXPECT_EQ(statistics.max, infinity);
  EXPECT_EQ(statistics.rms(), infinity);
}
