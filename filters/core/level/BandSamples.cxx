// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/BandSamples.h"

#include "distance/CellDescent.h"
#include "distance/GridSamples.h"
#include "level/SideRuns.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace winding
{

namespace
{

/// Samples that learn whether they are in a band. Before, their states say whether they are inside.
class SettledSamples : public GridSamples
{
public:
  SettledSamples(const Grid& grid, const Extent& extent, double scale, const DistanceBand& band,
    std::uint8_t* states)
    : GridSamples(grid, extent, scale)
    , extent_(extent)
    , band_(band)
    , states_(states)
  {
  }

  void write(double squared, std::uint32_t, std::size_t sample) const
  {
    states_[sample] = band_.contains(states_[sample] != 0, std::sqrt(squared) / this->scale());
  }

  /// Settles a part if no limit of the band is the distance of any of its samples. Limits below 0
  /// are distances of samples inside, and others of samples outside.
  bool isSettled(const Extent& part, double distance, double rounding) const
  {
    const double radius = 0.5 * this->boxOf(part).diagonal().norm();
    // The last term is more than what these sums and roots are rounded by.
    const double reach = radius + rounding + 1e-12 * (distance + radius);
    for (const double limit : {band_.low, band_.high})
    {
      if (limit != 0 && std::abs(std::abs(limit) * this->scale() - distance) <= reach &&
          this->hasSample(part, limit < 0))
      {
        return false;
      }
    }
    this->settle(part, distance / this->scale());
    return true;
  }

  /// Settles samples whose distances are on the same side of all limits as `distance`.
  void settle(const Extent& part, double distance) const
  {
    const std::uint8_t ifOutside = band_.contains(false, distance),
                       ifInside = band_.contains(true, distance);
    for (int k = part[4]; k <= part[5]; ++k)
    {
      for (int j = part[2]; j <= part[3]; ++j)
      {
        std::uint8_t* const row = states_ + sampleNumber(extent_, part[0], j, k);
        std::transform(row, row + (part[1] - part[0] + 1), row,
          [=](std::uint8_t isInside) { return isInside ? ifInside : ifOutside; });
      }
    }
  }

private:
  /// Returns whether a part has a sample on a side.
  bool hasSample(const Extent& part, bool isInside) const
  {
    for (int k = part[4]; k <= part[5]; ++k)
    {
      for (int j = part[2]; j <= part[3]; ++j)
      {
        const std::uint8_t* const row = states_ + sampleNumber(extent_, part[0], j, k);
        if (std::memchr(row, isInside, static_cast<std::size_t>(part[1] - part[0] + 1)))
        {
          return true;
        }
      }
    }
    return false;
  }

  const Extent& extent_;
  const DistanceBand& band_;
  std::uint8_t* const states_;
};

} // namespace

BandSamples::BandSamples(const DistanceTree& tree, const LevelEdges& solid, const Grid& grid,
  const DistanceBand& band, int first, int end)
  : extent_({0, grid.dimensions[0] - 1, 0, grid.dimensions[1] - 1, first, end - 1})
  , states_(sampleCount(extent_))
{
  std::vector<RowRun> runs;
  for (int k = first; k < end; ++k)
  {
    for (int j = 0; j < grid.dimensions[1]; ++j)
    {
      solid.findRuns(j, k, runs);
      for (const RowRun& run : runs)
      {
        std::fill_n(&states_[sampleNumber(extent_, run.begin, j, k)], run.end - run.begin,
          static_cast<std::uint8_t>(run.value != 0));
      }
    }
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const SettledSamples samples(grid, extent_, tree.scale(), band, states_.data());
  if (tree.empty())
  {
    samples.settle(extent_, infinite);
    return;
  }
  SerialExecutor executor;
  evaluateByCells(tree, infinite, samples, {extent_}, executor);
}

void BandSamples::findRuns(int j, int k, std::vector<RowRun>& runs) const
{
  describeSides(&states_[sampleNumber(extent_, 0, j, k)], extent_[1] + 1, runs);
}

std::unique_ptr<const LevelEdges> bandEdges(const DistanceTree& tree, const LevelEdges& solid,
  const Grid& grid, const DistanceBand& band, Executor& executor)
{
  return std::make_unique<const LevelEdges>(
    grid, solid.border() > 0, BandSamples::layersAtOnce,
    [&](int first, int last) -> LevelEdges::RowRuns
    {
      const auto samples =
        std::make_shared<const BandSamples>(tree, solid, grid, band, first, last);
      return [samples](int j, int k, std::vector<RowRun>& runs)
      {
        samples->findRuns(j, k, runs);
      };
    },
    executor);
}

} // namespace winding
