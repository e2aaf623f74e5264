// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/RunsOfLayers.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr int samplesPerBlock = 1 << 19; // enough work for a block to be worth it

} // namespace

RunsOfLayers::RunsOfLayers(const RowCrossings& rows, const Grid& grid, int first, int last,
  const LabelOf& labelOf, InsideRule rule, double threshold, Executor& executor)
  : firstLayer_(first)
  , bands_{0, std::clamp(samplesPerBlock / grid.dimensions[0], 1, grid.dimensions[1])}
{
  Extent extent = grid.wholeExtent();
  extent[4] = first;
  extent[5] = last;
  bandsPerLayer_ = bands_.countIn(extent);
  const std::unique_ptr<const RowCrossings::OnGrid> onGrid =
    rows.on(grid, extent, bands_, executor);
  blocks_.resize(bandsPerLayer_ * static_cast<std::size_t>(last - first + 1));
  std::vector<SideCounts> sides(blocks_.size());
  const auto work = [&](std::size_t number)
  {
    Block& block = blocks_[number];
    onGrid->evaluate(first + static_cast<int>(number / bandsPerLayer_), number % bandsPerLayer_,
      [&](int, int, const std::vector<RowRun>& runs)
      {
        const std::size_t start = block.runs.size();
        block.starts.push_back(static_cast<std::uint32_t>(start));
        for (const RowRun& run : runs)
        {
          sides[number].add(
            run.value, threshold, static_cast<std::size_t>(run.end - run.begin), rule);
          const int label = labelOf(run.value);
          if (block.runs.size() > start && block.runs.back().label == label)
          {
            block.runs.back().end = run.end;
          }
          else
          {
            block.runs.push_back({run.end, label});
          }
        }
      });
    block.runs.shrink_to_fit();
  };
  executor.run(blocks_.size(), work);
  for (const SideCounts& counts : sides)
  {
    sides_ += counts;
  }
}

const RunsOfLayers::Run* RunsOfLayers::runAt(int i, int j, int k) const
{
  const std::size_t band = bands_.bandOf(j);
  const Block& block = blocks_[static_cast<std::size_t>(k - firstLayer_) * bandsPerLayer_ + band];
  const auto row = static_cast<std::size_t>(j - bands_.firstRowOf(band));
  const Run* const first = block.runs.data() + block.starts[row];
  const Run* const last =
    block.runs.data() + (row + 1 < block.starts.size() ? block.starts[row + 1] : block.runs.size());
  return std::partition_point(first, last, [i](const Run& run) { return run.end <= i; });
}

bool RunsOfLayers::areEqual(int i, int j, int k, int size) const
{
  const int wanted = this->label(i, j, k);
  for (int layer = k; layer < k + size; ++layer)
  {
    for (int row = j; row < j + size; ++row)
    {
      const Run* const run = this->runAt(i, row, layer);
      if (run->label != wanted || run->end < i + size)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace winding
