// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/GridCells.h"

#include "support/RowValues.h"

#include <cmath>
#include <set>

namespace
{

using namespace shapes;
using winding::Extent;
using winding::Grid;
using winding::GridCells;
using winding::TargetBlock;
using winding::TargetCell;
using winding::TargetCells;

/// Counts the values that arrive at each sample, and keeps the last of them.
class Counter final : public winding::RowSink
{
public:
  explicit Counter(const Extent& extent)
    : counts(winding::sampleCount(extent))
    , values(counts.size())
    , suspects(counts.size())
    , extent_(extent)
  {
  }

  void row(
    int i, int j, int k, std::size_t count, const float* from, const bool* isSuspect) const override
  {
    for (std::size_t n = 0; n < count; ++n)
    {
      const std::size_t at = winding::sampleNumber(extent_, i + static_cast<int>(n), j, k);
      ++counts[at];
      values[at] = from[n];
      suspects[at] = isSuspect && isSuspect[n];
    }
  }

  mutable std::vector<int> counts;
  mutable std::vector<float> values;
  mutable std::vector<char> suspects;

private:
  Extent extent_;
};

struct Layout
{
  Grid grid;
  Extent extent;
};

/// Grids isotropic and not, of powers of two samples and not, of single samples, whole and in part.
std::vector<Layout> layouts()
{
  std::vector<Layout> all;
  const auto add = [&](const Point& spacing, const Eigen::Vector3i& dimensions)
  {
    const Grid grid = gridOf({-1, 2, 0.5}, spacing, dimensions);
    all.push_back({grid, grid.wholeExtent()});
    const Eigen::Vector3i low = dimensions / 3,
                          high = (2 * dimensions).cwiseQuotient(Eigen::Vector3i::Constant(3));
    all.push_back({grid, {low[0], high[0] - (high[0] == dimensions[0]), low[1],
                           std::max(low[1], high[1] - 1), low[2], std::max(low[2], high[2] - 1)}});
  };
  add({0.1, 0.1, 0.1}, {32, 32, 32});
  add({0.1, 0.1, 0.1}, {19, 41, 8});
  add({0.1, 0.1, 0.4}, {33, 20, 7});
  add({0.1, 0.4, 1.6}, {50, 13, 5});
  add({0.1, 10, 0.1}, {21, 3, 40});
  add({0.1, 0.1, 0.1}, {40, 1, 30});
  add({0.1, 1e-6, 1e6}, {100, 1, 1});
  add({0.1, 0.1, 0.1}, {1, 1, 1});
  return all;
}

void visitCells(const TargetCells& cells, const TargetCell& cell,
  const std::function<void(const TargetCell&)>& visit)
{
  visit(cell);
  TargetCells::Child children[8];
  const int count = cells.childrenOf(cell, children);
  for (int i = 0; i < count; ++i)
  {
    visitCells(cells, children[i].cell, visit);
  }
}

} // namespace

TEST(GridCells, HaveEverySampleOnceAtEveryLevel)
{
  for (const Layout& layout : layouts())
  {
    SCOPED_TRACE(testing::Message()
                 << layout.grid.dimensions.transpose() << ", " << layout.grid.spacing.transpose());
    const GridCells cells(layout.grid, layout.extent, 0.5, 3);
    const TargetCell root = cells.root();
    EXPECT_EQ(cells.samplesOf(root), layout.extent);
    EXPECT_EQ(root.allSamples, winding::sampleCount(layout.grid.wholeExtent()));
    std::vector<std::vector<int>> counts(static_cast<std::size_t>(root.level) + 1,
      std::vector<int>(winding::sampleCount(layout.extent)));
    visitCells(cells, root,
      [&](const TargetCell& cell)
      {
        const Extent part = cells.samplesOf(cell);
        ASSERT_EQ(cell.samples, winding::sampleCount(part));
        ASSERT_GT(cell.samples, 0u);
        ASSERT_GE(cell.allSamples, cell.samples);
        for (std::size_t n = 0; n < cell.samples; ++n)
        {
          ++counts[static_cast<std::size_t>(cell.level)]
                  [winding::sampleNumber(layout.extent, winding::sampleIndex(part, n))];
        }
      });
    for (const std::vector<int>& level : counts)
    {
      EXPECT_EQ(level, std::vector<int>(level.size(), 1));
    }
  }
}

TEST(GridCells, AreWithinTheirRadiusAndSide)
{
  for (const Layout& layout : layouts())
  {
    constexpr double scale = 0.25;
    const GridCells cells(layout.grid, layout.extent, scale, 3);
    visitCells(cells, cells.root(),
      [&](const TargetCell& cell)
      {
        const winding::TargetLevel& level = cells.level(cell.level);
        const Extent part = cells.samplesOf(cell);
        for (std::size_t n = 0; n < cell.samples; n += std::max<std::size_t>(1, cell.samples / 50))
        {
          const Point offset = scale * layout.grid.sample(part, n) - cell.center;
          ASSERT_LE(offset.norm(), level.radius * (1 + 1e-9) + 1e-15);
          ASSERT_LE(offset.cwiseAbs().maxCoeff(), 0.5 * level.side);
        }
      });
  }
}

TEST(GridCells, PutChildrenWhereTheShiftsSay)
{
  for (const Layout& layout : layouts())
  {
    const GridCells cells(layout.grid, layout.extent, 0.5, 3);
    visitCells(cells, cells.root(),
      [&](const TargetCell& cell)
      {
        TargetCells::Child children[8];
        const int count = cells.childrenOf(cell, children);
        std::size_t samples = 0, all = 0;
        std::set<int> octants;
        for (int i = 0; i < count; ++i)
        {
          const winding::LocalShifts& shifts = *cells.level(cell.level - 1).fromParent;
          const int octant = children[i].octant;
          const Point sign(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
          const double side = cells.level(cell.level).side;
          const Point expected = cell.center + side * sign.cwiseProduct(shifts.quarter);
          ASSERT_LT((children[i].cell.center - expected).norm(), 1e-12 * side);
          ASSERT_TRUE(octants.insert(octant).second);
          samples += children[i].cell.samples;
          all += children[i].cell.allSamples;
        }
        ASSERT_EQ(samples, count > 0 ? cell.samples : 0);
        ASSERT_LE(all, cell.allSamples);
        ASSERT_EQ(count == 0, cell.level == 0);
      });
  }
}

TEST(GridCells, AreTheSameForAnyExtent)
{
  const Grid grid = gridOf({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, {50, 40, 30});
  const GridCells whole(grid, grid.wholeExtent(), 0.5, 3);
  const GridCells part(grid, {13, 37, 5, 6, 29, 29}, 0.5, 3);
  ASSERT_EQ(part.taskLevel(), whole.taskLevel());
  std::set<std::array<int, 4>> known;
  visitCells(whole, whole.root(),
    [&](const TargetCell& cell) {
      known.insert({cell.level, cell.index[0], cell.index[1], cell.index[2]});
    });
  visitCells(part, part.root(),
    [&](const TargetCell& cell)
    {
      EXPECT_EQ(known.count({cell.level, cell.index[0], cell.index[1], cell.index[2]}), 1u);
      EXPECT_EQ(part.level(cell.level).radius, whole.level(cell.level).radius);
    });
}

TEST(GridCells, AreNearlyCubicBlocks)
{
  // Blocks of about 512 samples are as cubic as powers of two allow: rounded to these, sides differ
  // by a factor of 2, and by more where one is that of a single sample.
  for (const Point& spacing : {Point(1, 1, 1), Point(1, 1, 4), Point(1, 4, 16), Point(1, 100, 1),
         Point(0.3, 0.2, 0.7), Point(64, 1, 1)})
  {
    const Grid grid = gridOf({0, 0, 0}, spacing, {600, 600, 600});
    const GridCells cells(grid, grid.wholeExtent(), 1, 3);
    for (int level = 9; level > 0; --level)
    {
      Point sizes;
      std::size_t samples = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        sizes[axis] = cells.sizeOf(level, axis) * spacing[axis];
        samples *= static_cast<std::size_t>(cells.sizeOf(level, axis));
      }
      if (samples >= 256 && samples <= 1024)
      {
        EXPECT_LT(sizes.maxCoeff() / sizes.minCoeff(), 3.2)
          << spacing.transpose(); // measured: 3.125
        break;
      }
      EXPECT_GT(level, 1) << spacing.transpose();
    }
  }
}

TEST(GridCells, ReachOfSinglesIsThatOfBothEndsOfAGrid)
{
  const winding::Bounds sources(Point(-1, -1, -1), Point(1, 1, 1));
  constexpr double scale = 0.5;
  const double far = 2.1e12 / scale; // the reach is 1e12 units
  for (int axis = 0; axis < 3; ++axis)
  {
    Grid grid = gridOf({-1, -1, -1}, {1, 1, 1}, {3, 3, 3});
    EXPECT_TRUE(winding::isInReachOfSingles(grid, sources, scale));
    grid.spacing[axis] = 0.5 * far; // its last sample is far away
    EXPECT_FALSE(winding::isInReachOfSingles(grid, sources, scale)) << axis;
    grid.firstSample[axis] = -far; // its first one is
    EXPECT_FALSE(winding::isInReachOfSingles(grid, sources, scale)) << axis;
    grid.firstSample[axis] = far; // both are
    EXPECT_FALSE(winding::isInReachOfSingles(grid, sources, scale)) << axis;
    EXPECT_TRUE(winding::isInReachOfSingles(grid, winding::Bounds(), scale)) << "nothing is near";
  }
}

TEST(GridCells, DeliverEverySampleOfAnExtentOnce)
{
  for (const Layout& layout : layouts())
  {
    SCOPED_TRACE(testing::Message()
                 << layout.grid.dimensions.transpose() << ", " << layout.grid.spacing.transpose());
    constexpr double scale = 0.5;
    GridCells cells(layout.grid, layout.extent, scale, 3);
    for (int level = 0; level <= cells.root().level; ++level)
    {
      const Counter counter(layout.extent);
      cells.setSink(counter);
      visitCells(cells, cells.root(),
        [&](const TargetCell& cell)
        {
          if (cell.level != level)
          {
            return;
          }
          TargetBlock block;
          float values[winding::SampleBlock::capacity];
          bool isSuspect[winding::SampleBlock::capacity];
          for (std::size_t first = 0; first < cell.samples; first += block.samples.count)
          {
            cells.fill(cell, first, block);
            ASSERT_GT(block.samples.count, 0u);
            for (std::size_t n = 0; n < block.samples.count; ++n)
            {
              const Point q(block.samples.x[n], block.samples.y[n], block.samples.z[n]);
              const Point relative(block.u[n], block.v[n], block.w[n]);
              ASSERT_LT((cells.level(level).side * relative + cell.center - q).norm(),
                1e-6 * cells.level(level).side + 1e-12);
              // The value is the number of this very sample.
              const Point at =
                (q / scale - layout.grid.firstSample).cwiseQuotient(layout.grid.spacing);
              values[n] = static_cast<float>(winding::sampleNumber(
                layout.extent, (at + Point::Constant(0.5)).array().floor().cast<int>().matrix()));
              isSuspect[n] = static_cast<int>(values[n]) % 3 == 0;
            }
            cells.store(cell, first, block.samples.count, values, isSuspect);
          }
        });
      EXPECT_EQ(counter.counts, std::vector<int>(counter.counts.size(), 1));
      for (std::size_t n = 0; n < counter.values.size(); ++n)
      {
        ASSERT_EQ(counter.values[n], static_cast<float>(n));
        ASSERT_EQ(counter.suspects[n], n % 3 == 0);
      }
    }
  }
}

TEST(GridCells, EvaluatePolynomialsAtEverySample)
{
  SCOPED_TRACE("seed 381");
  Random random(381);
  for (const Layout& layout : layouts())
  {
    for (const int order : {3, 5, 7, 9})
    {
      GridCells cells(layout.grid, layout.extent, 0.5, order);
      std::vector<float> coefficients;
      for (int i = 0; i < (order + 1) * (order + 2) * (order + 3) / 6; ++i)
      {
        coefficients.push_back(static_cast<float>(random(-1, 1)));
      }
      const TargetCell root = cells.root();
      const Counter counter(layout.extent);
      cells.setSink(counter);
      cells.storePolynomial(root, order, coefficients.data());
      EXPECT_EQ(counter.counts, std::vector<int>(counter.counts.size(), 1));
      const double side = cells.level(root.level).side;
      for (std::size_t n = 0; n < counter.values.size(); n += 37)
      {
        const Point s = (0.5 * layout.grid.sample(layout.extent, n) - root.center) / side;
        double expected = 0;
        std::size_t place = 0;
        for (int a = order; a >= 0; --a)
        {
          for (int b = order - a; b >= 0; --b)
          {
            for (int c = order - a - b; c >= 0; --c)
            {
              expected += static_cast<double>(coefficients[place++]) * std::pow(s[0], a) *
                          std::pow(s[1], b) * std::pow(s[2], c);
            }
          }
        }
        ASSERT_NEAR(counter.values[n], expected, 1e-6); // measured: 1.7e-7
      }
    }
  }
}

TEST(GridCells, EvaluatePolynomialsWithTheSameBitsInAnyExtent)
{
  SCOPED_TRACE("seed 382");
  const Grid grid = gridOf({-1, 2, 0.5}, {0.1, 0.1, 0.1}, {32, 32, 32});
  constexpr int order = 5;
  Random random(382);
  std::vector<float> coefficients;
  for (int i = 0; i < (order + 1) * (order + 2) * (order + 3) / 6; ++i)
  {
    coefficients.push_back(static_cast<float>(random(-1, 1)));
  }
  const auto valuesIn = [&](const Extent& extent)
  {
    GridCells cells(grid, extent, 0.5, order);
    const Counter counter(extent);
    cells.setSink(counter);
    cells.storePolynomial(cells.root(), order, coefficients.data());
    return counter.values;
  };
  const Extent whole = grid.wholeExtent();
  const std::vector<float> expected = valuesIn(whole);
  for (const Extent& part :
    {Extent{3, 10, 4, 11, 5, 12}, {0, 31, 7, 7, 9, 9}, {5, 5, 6, 6, 7, 7}, {1, 30, 2, 29, 3, 28}})
  {
    const std::vector<float> values = valuesIn(part);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      ASSERT_EQ(values[n], expected[winding::sampleNumber(whole, winding::sampleIndex(part, n))]);
    }
  }
}

TEST(GridCells, HaveARootForAxesOfAnyLength)
{
  Grid grid;
  grid.dimensions = {2147483646, 1, 1};
  const winding::GridCells cells(grid, {5, 6, 0, 0, 0, 0}, 1, 3);
  EXPECT_EQ(cells.root().samples, 2u);
  EXPECT_GE(cells.sizeOf(cells.root().level, 0), 2147483646);
}

TEST(GridCells, OfSlicesAreSquareHoweverThickTheSlice)
{
  Grid grid;
  grid.dimensions = {300, 300, 1};
  for (const double thickness : {1e-6, 1.0, 1e6})
  {
    grid.spacing = {1, 1, thickness};
    const winding::GridCells cells(grid, grid.wholeExtent(), 1, 3);
    int level = 0;
    while (cells.sizeOf(level, 0) < 16)
    {
      ++level;
    }
    EXPECT_EQ(cells.sizeOf(level, 1), 16);
    EXPECT_EQ(cells.sizeOf(0, 0), 1);
  }
}
