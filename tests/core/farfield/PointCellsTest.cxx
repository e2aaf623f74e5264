// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/PointCells.h"

#include "base/Views.h"
#include "support/Samples.h"
#include "support/Serial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace
{
using shapes::Point;
using shapes::serial;
using winding::PointCells;
using winding::TargetBlock;
using winding::TargetCell;
using winding::TargetCells;

constexpr double scale = 0.5;
const Eigen::AlignedBox3d region(Point::Constant(-64), Point::Constant(64));

/// Takes the values of samples.
class Values final : public winding::PointSink
{
public:
  void askFor(std::size_t) const override {}
  explicit Values(std::vector<double>& values)
    : values_(values)
  {
  }

  void point(std::size_t sample, double value, bool) const override { values_[sample] = value; }

private:
  std::vector<double>& values_;
};

winding::VectorsView viewOf(const std::vector<Point>& samples)
{
  return {samples.empty() ? nullptr : samples[0].data(), samples.size()};
}

/// Sets of samples: random, clustered, equal, a single one, and on a line.
std::vector<std::vector<Point>> manySamples()
{
  std::vector<std::vector<Point>> all;
  all.push_back(shapes::randomPoints(3000, -1, 1, 391));
  std::vector<Point> clusters = shapes::randomPoints(500, -1e-6, 1e-6, 392);
  for (const Point& p : shapes::randomPoints(500, 99.9999, 100, 393))
  {
    clusters.push_back(p);
  }
  all.push_back(clusters);
  all.emplace_back(700, Point(1.5, -2.5, 3.5));
  all.emplace_back(1, Point(1.5, -2.5, 3.5));
  all.emplace_back();
  for (int i = 0; i < 1000; ++i)
  {
    all.back().emplace_back(0.001 * i, -0.002 * i, 7);
  }
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

TEST(PointCells, DeliverEverySampleOnceAtEveryLevel)
{
  SCOPED_TRACE("seeds 391 … 393");
  for (const std::vector<Point>& samples : manySamples())
  {
    const winding::VectorsView view = viewOf(samples);
    std::vector<double> values(samples.size());
    const Values sink(values);
    const PointCells cells(view, region, scale, 3, &sink, serial);
    ASSERT_TRUE(cells.others().empty());
    for (int level = 0; level <= cells.root().level; ++level)
    {
      std::fill(values.begin(), values.end(), -1);
      std::size_t delivered = 0;
      visitCells(cells, cells.root(),
        [&](const TargetCell& cell)
        {
          if (cell.level != level)
          {
            return;
          }
          ASSERT_EQ(cell.samples, cell.allSamples);
          TargetBlock block;
          float sums[winding::SampleBlock::capacity];
          for (std::size_t first = 0; first < cell.samples; first += block.samples.count)
          {
            cells.fill(cell, first, block);
            for (std::size_t n = 0; n < block.samples.count; ++n)
            {
              // The value tells samples apart.
              sums[n] = static_cast<float>(
                block.samples.x[n] + 3 * block.samples.y[n] + 7 * block.samples.z[n]);
            }
            cells.store(cell, first, block.samples.count, sums, nullptr);
            delivered += block.samples.count;
          }
        });
      EXPECT_EQ(delivered, samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const Point q = samples[i] * scale;
        ASSERT_EQ(values[i], static_cast<float>(q[0] + 3 * q[1] + 7 * q[2])) << level;
      }
    }
  }
}

TEST(PointCells, AreWithinTheirRadiusAndSideAndSphere)
{
  for (const std::vector<Point>& samples : manySamples())
  {
    const winding::VectorsView view = viewOf(samples);
    const PointCells cells(view, region, scale, 3, nullptr, serial);
    visitCells(cells, cells.root(),
      [&](const TargetCell& cell)
      {
        const winding::TargetLevel& level = cells.level(cell.level);
        const winding::TargetSphere sphere = cells.sphereOf(cell);
        TargetBlock block;
        for (std::size_t first = 0; first < cell.samples; first += block.samples.count)
        {
          cells.fill(cell, first, block);
          for (std::size_t n = 0; n < block.samples.count; ++n)
          {
            const Point q(block.samples.x[n], block.samples.y[n], block.samples.z[n]);
            // The coordinates themselves are rounded.
            const double rounding = 1e-15 * q.norm();
            ASSERT_LE((q - cell.center).norm(), level.radius + rounding);
            ASSERT_LE(
              (q - cell.center).cwiseAbs().maxCoeff(), 0.5 * level.side * (1 + 1e-9) + rounding);
            ASSERT_LE((q - sphere.center).norm(), sphere.radius * (1 + 1e-12) + rounding);
            const Point relative(block.u[n], block.v[n], block.w[n]);
            ASSERT_LT(
              (level.side * relative + cell.center - q).norm(), 1e-6 * level.side + rounding);
          }
        }
      });
  }
}

TEST(PointCells, PutChildrenWhereTheShiftsSay)
{
  for (const std::vector<Point>& samples : manySamples())
  {
    const winding::VectorsView view = viewOf(samples);
    const PointCells cells(view, region, scale, 3, nullptr, serial);
    visitCells(cells, cells.root(),
      [&](const TargetCell& cell)
      {
        TargetCells::Child children[8];
        const int count = cells.childrenOf(cell, children);
        std::size_t total = 0;
        std::set<int> octants;
        for (int i = 0; i < count; ++i)
        {
          const winding::LocalShifts& shifts = *cells.level(cell.level - 1).fromParent;
          const int octant = children[i].octant;
          const Point sign(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
          const double side = cells.level(cell.level).side;
          const Point expected = cell.center + side * sign.cwiseProduct(shifts.quarter);
          ASSERT_LT(
            (children[i].cell.center - expected).norm(), 1e-12 * side + 1e-15 * cell.center.norm());
          ASSERT_TRUE(octants.insert(octant).second);
          ASSERT_GT(children[i].cell.samples, 0u);
          total += children[i].cell.samples;
        }
        ASSERT_EQ(total, cell.level > 0 ? cell.samples : 0);
      });
  }
}

TEST(PointCells, LeaveOutWhatHasNoPlaceOrIsFarAway)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  std::vector<Point> samples = {{nan, 0, 0}, {1, 1, 1}, {0, infinity, 0}, {1e300, 0, 0},
    {0, 0, 128}, {0, -128.001, 0}, {0, 0, 0}, {0, 0, -infinity}};
  const winding::VectorsView view = viewOf(samples);
  const PointCells cells(view, region, scale, 3, nullptr, serial);
  // The border of the region is at 128 · scale, and belongs to it.
  EXPECT_EQ(cells.others(), (std::vector<std::uint32_t>{0, 2, 3, 5, 7}));
  EXPECT_FALSE(cells.empty());
  EXPECT_EQ(cells.root().samples, 3u);
}

TEST(PointCells, MayBeEmpty)
{
  const std::vector<Point> none, far(5, Point(0, 1e6, 0));
  const winding::VectorsView viewOfNone = viewOf(none), viewOfFar = viewOf(far);
  EXPECT_TRUE(PointCells(viewOfNone, region, scale, 3, nullptr, serial).empty());
  const PointCells cells(viewOfFar, region, scale, 3, nullptr, serial);
  EXPECT_TRUE(cells.empty());
  EXPECT_EQ(cells.others().size(), 5u);
}
