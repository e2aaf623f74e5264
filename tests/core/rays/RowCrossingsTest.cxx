// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RowCrossings.h"

#include "base/Bounds.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "support/RowValues.h"
#include "support/Serial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

using namespace shapes;
using winding::Extent;
using winding::Grid;

std::vector<int> valuesOn(const winding::Surface& surface, const Grid& grid)
{
  return rowValues({surface.vertices, surface.triangles}, grid, grid.wholeExtent(), 65536, serial);
}

std::vector<int> valuesOn(const Mesh& mesh, const Grid& grid)
{
  return valuesOn(clean(mesh), grid);
}

/// Samples in a plane of the surface count as moved this way.
const Point symbolicStep(1e-10, 1e-6, 1e-8);

} // namespace

TEST(RowCrossings, AreExactOnLatticeSolidsWhateverTheRowsHit)
{
  // Rows on the lattice and on the half lattice run along faces and edges and through vertices.
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d sheared = (Eigen::Matrix3d() << 1, 2, 1, 0, 1, 1, 0, 0, 1).finished();
  const Eigen::Matrix3d turned = (Eigen::Matrix3d() << 1, -1, 1, 1, 1, 0, -1, 2, 3).finished();
  SCOPED_TRACE("seeds 131, 132");
  for (const Cells& cells : {lShape(), randomCells(4, 131), randomCells(3, 132)})
  {
    for (const Eigen::Matrix3d& matrix : {identity, sheared, turned})
    {
      const Mesh mesh =
        surfaceOf(cells).mapped([&](const Point& p) -> Point { return matrix * p; });
      const winding::Bounds bounds = clean(mesh).bounds;
      const Eigen::Matrix3d inverse = matrix.inverse();
      for (const double spacing : {1.0, 0.5})
      {
        const Grid grid = gridOf(bounds.min() - Point::Constant(spacing), Point::Constant(spacing),
          ((bounds.sizes() / spacing).array() + 3).cast<int>());
        const std::vector<int> values = valuesOn(mesh, grid);
        for (std::size_t n = 0; n < values.size(); ++n)
        {
          const Point q = grid.sample(n);
          ASSERT_EQ(values[n], shapes::windingOf(cells, inverse * (q + symbolicStep)))
            << q.transpose();
        }
      }
    }
  }
}

TEST(RowCrossings, GiveBoxesOnGridPlanesTheirLowerFacesAndNotTheUpper)
{
  const Grid grid = gridOf({-2, -2, -2}, {0.5, 0.5, 0.5}, {16, 16, 16});
  const std::vector<int> values = valuesOn(cube({-1, -0.5, 0}, {2, 2.5, 3}), grid);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const Point q = grid.sample(n);
    const bool isIn = (q.array() >= Point(-1, -0.5, 0).array()).all() &&
                      (q.array() < Point(2, 2.5, 3).array()).all();
    ASSERT_EQ(values[n], isIn) << q.transpose();
  }
}

TEST(RowCrossings, GiveEverySampleToOneOfTheBoxesThatFillARoom)
{
  // Boxes and grids have decimal sizes: coordinates are rounded, but alike for neighbours.
  Mesh room;
  for (int n = 0; n < 27; ++n)
  {
    const Point low = 0.3 * Point(n % 3, n / 3 % 3, n / 9);
    const Point high = 0.3 * Point(n % 3 + 1, n / 3 % 3 + 1, n / 9 + 1);
    room = room.with(cube(low, high));
  }
  for (const double spacing : {0.1, 0.05, 0.3, 0.15})
  {
    const int count = static_cast<int>(std::ceil(0.7 / spacing));
    const Grid grid = gridOf(Point::Constant(0.1), Point::Constant(spacing), {count, count, count});
    const std::vector<int> values = valuesOn(room, grid);
    EXPECT_EQ(values, std::vector<int>(values.size(), 1)) << spacing;
  }
}

TEST(RowCrossings, AgreeWithTheDirectSumOffTheSurface)
{
  SCOPED_TRACE("seed 133");
  Random random(133);
  const auto stretched = [](const Point& p) -> Point
  {
    return {1e3 * p[0], p[1], 1e-3 * p[2]};
  };
  for (const Mesh& mesh :
    {tetrahedron(), icosphere(3), torus(48, 24), icosphere(2).reversed().with(torus(24, 12)),
      icosphere(1).with(icosphere(1)), torus(7, 5).mapped(stretched)})
  {
    const winding::Surface surface = clean(mesh);
    const winding::TriangleSum sum(surface);
    // The grid is anisotropic and reaches a little beyond the bounds.
    const Point spacing = surface.bounds.sizes().cwiseQuotient(random.point(11, 31));
    const Grid grid = gridOf(surface.bounds.min() - 1.3 * spacing, spacing, {33, 34, 35});
    const std::vector<int> values = valuesOn(mesh, grid);
    std::vector<Point> samples;
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      samples.push_back(grid.sample(n));
    }
    const std::vector<double> expected = shapes::valuesOf(sum, samples);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      // Slivers cost the direct sum digits, but no turn.
      ASSERT_NEAR(values[n], expected[n], 1e-6) << samples[n].transpose();
    }
  }
}

TEST(RowCrossings, OfAClosedChainSumToZeroAlongEveryRow)
{
  // The rows begin and end outside.
  SCOPED_TRACE("seed 134");
  for (const Mesh& mesh : {icosphere(3), torus(48, 24), surfaceOf(randomCells(6, 134))})
  {
    const winding::Surface surface = clean(mesh);
    const Point spacing = surface.bounds.sizes() / 24;
    const Grid grid = gridOf(surface.bounds.min() - spacing, spacing, {27, 27, 27});
    const std::vector<int> values = valuesOn(mesh, grid);
    for (std::size_t row = 0; row < values.size(); row += 27)
    {
      ASSERT_EQ(values[row], 0);
      ASSERT_EQ(values[row + 26], 0);
    }
  }
}

TEST(RowCrossings, DoNotDependOnExtentBandsOrThreads)
{
  SCOPED_TRACE("seeds 135 …");
  for (unsigned seed = 135; seed < 165; ++seed)
  {
    const ClosedLatticeChain chain(seed);
    const winding::RowCrossings rows = chain.rows();
    const Extent whole = chain.grid().wholeExtent();
    const std::vector<int> expected = rowValues(rows, chain.grid(), whole, 65536, serial);
    ShuffledThreads threads(seed);
    for (const std::size_t samplesPerBlock : {1, 7, 1'000'000'000})
    {
      ASSERT_EQ(rowValues(rows, chain.grid(), whole, samplesPerBlock, serial), expected);
      ASSERT_EQ(rowValues(rows, chain.grid(), whole, samplesPerBlock, threads), expected);
    }
    Random random(seed);
    for (int i = 0; i < 20; ++i)
    {
      Extent part;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto size = static_cast<std::uint64_t>(chain.grid().dimensions[axis]);
        const int one = static_cast<int>(random.bits() % size);
        const int other = static_cast<int>(random.bits() % size);
        part[2 * axis] = std::min(one, other);
        part[2 * axis + 1] = std::max(one, other);
      }
      const std::vector<int> values = rowValues(rows, chain.grid(), part, 40, serial);
      for (std::size_t n = 0; n < values.size(); ++n)
      {
        ASSERT_EQ(values[n], expected[winding::sampleNumber(whole, winding::sampleIndex(part, n))]);
      }
    }
  }
}

TEST(RowCrossings, OfMeshesFinerThanTheGridAreThoseOnAFinerGrid)
{
  // Rows along x, y and z through vertices of the sphere are among both grids' rows.
  const winding::Surface surface = clean(icosphere(5));
  const winding::RowCrossings rows(surface.vertices, surface.triangles);
  const Grid coarse = gridOf(Point::Constant(-1.25), Point::Constant(0.25), {11, 11, 11});
  const Grid fine = gridOf(Point::Constant(-1.25), Point::Constant(0.0625), {41, 41, 41});
  const std::vector<int> expected = rowValues(rows, fine, fine.wholeExtent(), 65536, serial);
  ShuffledThreads threads(166);
  for (const std::size_t samplesPerBlock : {1, 40, 1'000'000})
  {
    const Extent whole = coarse.wholeExtent();
    const std::vector<int> values = rowValues(rows, coarse, whole, samplesPerBlock, threads);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const Eigen::Vector3i index = 4 * winding::sampleIndex(whole, n);
      ASSERT_EQ(values[n],
        expected[winding::sampleNumber(fine.wholeExtent(), index[0], index[1], index[2])]);
    }
  }
}

/// Very deep grids, along y or z.
class RowCrossingsOfDeepGrids : public testing::TestWithParam<int>
{
};

INSTANTIATE_TEST_SUITE_P(Axes, RowCrossingsOfDeepGrids, testing::Values(1, 2));

TEST_P(RowCrossingsOfDeepGrids, AreFoundSlabBySlabWithProgress)
{
  /// Remembers the shares of all work that it was told.
  class Log final : public winding::Executor
  {
  public:
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      largest = std::max(largest, count);
      serial_.run(count, work);
    }
    void setShare(double first, double last) override { shares.emplace_back(first, last); }
    std::pair<double, double> share() const override { return {0.5, 1}; }

    std::vector<std::pair<double, double>> shares;
    std::size_t largest = 0;

  private:
    winding::SerialExecutor serial_;
  };

  // Forty of the faces reach through all layers or rows, which is more than are listed at once.
  const int axis = this->GetParam();
  constexpr int depth = 2500000, boxes = 10;
  Mesh mesh;
  for (int n = 0; n < boxes; ++n)
  {
    Point low(-1.0 + 0.01 * n, -1, -1), high(1.0 + 0.01 * n, 1, 1);
    low[axis] = 0.1;
    high[axis] = 0.9;
    const Mesh box = cube(low, high);
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), box.points.begin(), box.points.end());
    for (const auto& [a, b, c] : box.triangles)
    {
      mesh.triangles.push_back({a + first, b + first, c + first});
    }
  }
  const winding::Surface surface = clean(mesh);
  Point origin(0, 0, 0), spacing(1, 1, 1);
  Eigen::Vector3i dimensions(1, 1, 1);
  origin[axis] = 0.5 / depth;
  spacing[axis] = 1.0 / depth;
  dimensions[axis] = depth;
  const Grid grid = gridOf(origin, spacing, dimensions);
  const winding::RowCrossings rows(surface.vertices, surface.triangles);
  Log log;
  std::vector<int> values(depth, -1);
  rows.evaluate(
    grid, grid.wholeExtent(), 1,
    [&](int j, int k, const std::vector<winding::RowRun>& runs)
    { values[static_cast<std::size_t>(axis == 1 ? j : k)] = runs[0].value; },
    log);
  for (int k = 0; k < depth; ++k)
  {
    const double place = origin[axis] + k * spacing[axis];
    ASSERT_EQ(values[static_cast<std::size_t>(k)], place > 0.1 && place < 0.9 ? boxes : 0) << k;
  }
  EXPECT_GT(log.shares.size(), 2u);
  EXPECT_LT(log.largest, depth);
  double end = 0.5;
  for (std::size_t n = 0; n + 1 < log.shares.size(); ++n)
  {
    EXPECT_DOUBLE_EQ(log.shares[n].first, end);
    end = log.shares[n].second;
  }
  EXPECT_EQ(end, 1);
  EXPECT_EQ(log.shares.back(), std::make_pair(0.5, 1.0)) << "the whole share, again";
}

TEST(RowCrossings, OfManyPlatesBetweenSamplesAreAddedUp)
{
  SCOPED_TRACE("seed 11");
  Random random(11);
  constexpr int plates = 1000, samples = 7;
  Mesh mesh;
  int expected[samples] = {};
  for (int n = 0; n < plates; ++n)
  {
    const double low = random(-1, samples), high = low + random(0, 2);
    mesh = mesh.with(cube({low, -1, -1}, {high, samples, 1}));
    for (int i = 0; i < samples; ++i)
    {
      expected[i] += low < i && i < high ? 1 : 0;
    }
  }
  const Grid grid = gridOf({0, 0, 0}, {1, 1, 1}, {samples, samples, 1});
  const std::vector<int> values = valuesOn(mesh, grid);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    EXPECT_EQ(values[n], expected[n % samples]) << n;
  }
}

TEST(RowCrossings, OfOneSampleAreThoseOfItsRow)
{
  SCOPED_TRACE("seeds 166 …");
  for (unsigned seed = 166; seed < 366; ++seed)
  {
    const ClosedLatticeChain chain(seed);
    const winding::RowCrossings rows = chain.rows();
    const Extent whole = chain.grid().wholeExtent();
    const std::vector<int> expected = rowValues(rows, chain.grid(), whole, 65536, serial);
    for (std::size_t n = 0; n < expected.size(); ++n)
    {
      const Eigen::Vector3i index = winding::sampleIndex(whole, n);
      const Extent alone = {index[0], index[0], index[1], index[1], index[2], index[2]};
      ASSERT_EQ(rowValues(rows, chain.grid(), alone, 65536, serial)[0], expected[n]) << seed;
    }
  }
}

TEST(RowCrossings, FindTheInsideOfTrianglesFarLargerThanTheGrid)
{
  const Mesh huge =
    tetrahedron().mapped([](const Point& p) -> Point { return 4e7 * (p - Point(0.2, 0.2, 0.2)); });
  const Grid grid = gridOf({-8, -8, -8}, {1, 1, 1}, {17, 17, 17});
  const std::vector<int> values = valuesOn(huge, grid);
  EXPECT_EQ(values, std::vector<int>(values.size(), 1));
  // The plane x + y + z = 0 goes through samples; these count as moved over it.
  const Mesh cut =
    huge.mapped([](const Point& p) -> Point { return p - Point::Constant(16e6 / 3); });
  const winding::Surface surface = clean(cut);
  const std::vector<int> inside = valuesOn(cut, grid);
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    const Eigen::Vector3i index = winding::sampleIndex(grid.wholeExtent(), n);
    const int sum = index.sum() - 24;
    if (sum != 0)
    {
      ASSERT_EQ(inside[n], sum < 0);
    }
  }
}

TEST(RowCrossings, AreNoneFarAwayAndRightOnAGridOfOneSample)
{
  for (const double distance : {10.0, -10.0, 1e9, -1e12})
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Grid grid = gridOf(distance * Point::Unit(axis), {0.1, 0.2, 0.3}, {5, 6, 7});
      EXPECT_EQ(valuesOn(icosphere(1), grid), std::vector<int>(210, 0));
    }
  }
  EXPECT_EQ(valuesOn(icosphere(1), gridOf({0.1, 0, 0}, {1, 1, 1}, {1, 1, 1})), std::vector<int>{1});
  EXPECT_EQ(valuesOn(icosphere(1), gridOf({2, 0, 0}, {1, 1, 1}, {1, 1, 1})), std::vector<int>{0});
  EXPECT_EQ(valuesOn(Mesh(), gridOf({0, 0, 0}, {1, 1, 1}, {2, 1, 1})), (std::vector<int>{0, 0}));
}

TEST(RowCrossings, DoNotDependOnTheUnitOfLengthOrTheDistanceFromTheOrigin)
{
  SCOPED_TRACE("seed 137");
  const Mesh solid = surfaceOf(randomCells(4, 137)).with(icosphere(2));
  const Grid grid = gridOf({-1.13, -1.13, -1.13}, {0.31, 0.31, 0.31}, {19, 19, 19});
  const std::vector<int> expected = valuesOn(solid, grid);
  for (const double scale : {1e-200, 1e-30, 1e-6, 1e6, 1e30, 1e200})
  {
    const Grid same = gridOf(scale * grid.firstSample, scale * grid.spacing, grid.dimensions);
    EXPECT_EQ(valuesOn(cleanScaled(solid, scale), same), expected) << scale;
  }
  // The solid and its grid move a million diagonals away.
  const Point away(6e6, -5e6, 4e6);
  const Mesh moved = solid.moved(away);
  const Grid there = gridOf(grid.firstSample + away, grid.spacing, grid.dimensions);
  EXPECT_EQ(valuesOn(moved, there), expected);
}
