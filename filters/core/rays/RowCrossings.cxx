// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RowCrossings.h"

#include "base/BucketSort.h"
#include "base/CountingSort.h"
#include "base/Progress.h"
#include "base/UninitializedVector.h"
#include "rays/RowTriangle.h"
#include "source/PrefetchCorners.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace winding
{

namespace
{

/// A vertex among the rows and layers of an extent. Along each axis it has a number that grows with
/// its coordinate: 0 before the first index, 2i + 1 at index i, counted from the first, 2i + 2
/// between i and i + 1 or behind the last index. Two numbers take a third of the room of three
/// coordinates, so that more vertices stay in the caches.
class VertexPlace
{
public:
  VertexPlace() = default;
  VertexPlace(const Eigen::Vector3d& vertex, const Grid& grid, const Extent& extent)
    : row_(numberOf(vertex, grid, extent, 1))
    , layer_(numberOf(vertex, grid, extent, 2))
  {
  }

  ///@{
  /// The indices of an extent from the lowest of three vertices on, and before the highest: rows
  /// there pass by, for they count as moved upwards by infinitesimal steps.
  static IndexRange rowsOf(
    const VertexPlace& a, const VertexPlace& b, const VertexPlace& c, int low)
  {
    return range(std::minmax({a.row_, b.row_, c.row_}), low);
  }
  static IndexRange layersOf(
    const VertexPlace& a, const VertexPlace& b, const VertexPlace& c, int low)
  {
    return range(std::minmax({a.layer_, b.layer_, c.layer_}), low);
  }
  ///@}

private:
  static std::uint32_t numberOf(
    const Eigen::Vector3d& vertex, const Grid& grid, const Extent& extent, int axis)
  {
    const int low = extent[2 * axis], high = extent[2 * axis + 1];
    const double place = grid.inGridUnits(vertex, axis);
    if (!(place >= low))
    {
      return 0;
    }
    const int whole = place > high ? high : static_cast<int>(place);
    return 2 * static_cast<std::uint32_t>(whole - low) + 1 + (whole < place ? 1 : 0);
  }

  static IndexRange range(const std::pair<std::uint32_t, std::uint32_t>& numbers, int low)
  {
    const auto first = static_cast<long long>(numbers.first / 2);
    const auto end = static_cast<long long>(numbers.second / 2);
    return end <= first
             ? IndexRange{0, -1}
             : IndexRange{static_cast<int>(low + first), static_cast<int>(low + end - 1)};
  }

  std::uint32_t row_, layer_;
};

/**
 * The triangles that reach into bands of rows, for all layers of an extent. A band is some rows of
 * a layer that follow each other; the first may begin before the extent.
 */
class Bands
{
public:
  Bands(const Grid& grid, const Extent& extent, const RowBands& rows,
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap,
    Executor& executor)
    : extent_(extent)
    , perLayer_(rows.countIn(extent))
  {
    UninitializedVector<VertexPlace> places(vertices.size());
    forEachItem(
      vertices.size(), [&](std::size_t i) { places[i] = VertexPlace(vertices[i], grid, extent); },
      executor);

    // Most triangles of fine meshes lie between the rows, and are looked at once only.
    const std::vector<std::uint32_t> reaching =
      this->trianglesThatReachRows(places.data(), triangles, cap, executor);
    const std::size_t bands = static_cast<std::size_t>(extent[5] - extent[4] + 1) * perLayer_;
    // A block counts what it has for each band; together the blocks have at most this number of
    // counts.
    constexpr std::size_t mostCounts = 1 << 20;
    const std::size_t mostBlocks = std::max<std::size_t>(1, mostCounts / bands);
    const std::size_t perBlock =
      std::max<std::size_t>(itemsPerBlock, (reaching.size() + mostBlocks - 1) / mostBlocks);
    triangles_ = distribute<std::uint32_t>(
      reaching.size(), bands,
      [&](std::size_t first, std::size_t last, const auto& put)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          const std::uint32_t number = reaching[i];
          const bool isOfCap = number >= triangles.size();
          const Reach reach = this->reachOf(
            places.data(), isOfCap ? cap[number - triangles.size()] : triangles[number]);
          const std::size_t firstBand = rows.bandOf(reach.rows.first);
          const std::size_t lastBand = rows.bandOf(reach.rows.second);
          for (int k = reach.layers.first; k <= reach.layers.second; ++k)
          {
            for (std::size_t band = firstBand; band <= lastBand; ++band)
            {
              put(this->place(k, band), number);
            }
          }
        }
      },
      executor, perBlock);
  }

  /// The number of triangles in all bands together.
  std::size_t size() const
  {
    return static_cast<std::size_t>(triangles_.end(triangles_.count() - 1) - triangles_.begin(0));
  }

  const std::uint32_t* begin(int k, std::size_t band) const
  {
    return triangles_.begin(this->place(k, band));
  }
  const std::uint32_t* end(int k, std::size_t band) const
  {
    return triangles_.end(this->place(k, band));
  }

private:
  static constexpr std::size_t itemsPerBlock = 16384;

  struct Reach
  {
    IndexRange rows, layers;
  };

  Reach reachOf(const VertexPlace* places, const Triangle& triangle) const
  {
    const VertexPlace &a = places[triangle[0]], &b = places[triangle[1]], &c = places[triangle[2]];
    return {VertexPlace::rowsOf(a, b, c, extent_[2]), VertexPlace::layersOf(a, b, c, extent_[4])};
  }

  /// The numbers of the triangles that reach rows of the extent, the cap's after the others.
  std::vector<std::uint32_t> trianglesThatReachRows(const VertexPlace* places,
    const ChainView& triangles, const ChainView& cap, Executor& executor) const
  {
    const std::size_t count = triangles.size() + cap.size();
    std::vector<std::vector<std::uint32_t>> ofBlocks((count + itemsPerBlock - 1) / itemsPerBlock);
    runBlocks(
      count, itemsPerBlock,
      [&](std::size_t block, std::size_t first, std::size_t last)
      {
        std::uint32_t numbers[itemsPerBlock];
        std::size_t found = 0;
        const auto addThose =
          [&](const ChainView& list, std::size_t begin, std::size_t end, std::size_t numberOfFirst)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            prefetchCorners(places, list.triangles(), i);
            // Nobody could predict which triangles reach rows, so that all are written down.
            const Reach reach = this->reachOf(places, list[i]);
            numbers[found] = static_cast<std::uint32_t>(numberOfFirst + i);
            found +=
              reach.rows.first <= reach.rows.second && reach.layers.first <= reach.layers.second;
          }
        };
        addThose(triangles, first, std::min(last, triangles.size()), 0);
        addThose(cap, std::max(first, triangles.size()) - triangles.size(),
          std::max(last, triangles.size()) - triangles.size(), triangles.size());
        ofBlocks[block].assign(numbers, numbers + found);
      },
      executor);
    std::size_t size = 0;
    for (const std::vector<std::uint32_t>& ofBlock : ofBlocks)
    {
      size += ofBlock.size();
    }
    std::vector<std::uint32_t> all;
    all.reserve(size);
    for (std::vector<std::uint32_t>& ofBlock : ofBlocks)
    {
      all.insert(all.end(), ofBlock.begin(), ofBlock.end());
      ofBlock = {}; // so that its memory is free at once
    }
    return all;
  }

  std::size_t place(int k, std::size_t band) const
  {
    return static_cast<std::size_t>(k - extent_[4]) * perLayer_ + band;
  }

  Extent extent_;
  std::size_t perLayer_;
  Buckets<std::uint32_t> triangles_;
};

struct Crossing
{
  int row;    ///< j
  int behind; ///< first sample behind the crossing
  int change; ///< by which w changes there: the sign of the crossing, once for each copy
};

/// Adds up the changes at the same sample of each row, so that no more crossings are left than
/// `sums` has places: `perRow` for samples from `low` on in each row from `firstRow` on. All sums
/// are 0 before and after.
void addUpChanges(std::vector<Crossing>& crossings, int firstRow, int low, std::size_t perRow,
  std::vector<int>& sums)
{
  for (const auto& [row, behind, change] : crossings)
  {
    sums[static_cast<std::size_t>(row - firstRow) * perRow +
         static_cast<std::size_t>(behind - low)] += change;
  }
  crossings.clear();
  for (std::size_t place = 0; place < sums.size(); ++place)
  {
    if (const int change = std::exchange(sums[place], 0))
    {
      crossings.push_back({firstRow + static_cast<int>(place / perRow),
        low + static_cast<int>(place % perRow), change});
    }
  }
}

/// Turns the crossings of a row into runs of equal values over [low, high].
void makeRuns(Crossing* first, Crossing* last, int low, int high, std::vector<RowRun>& runs)
{
  std::sort(first, last, [](const Crossing& a, const Crossing& b) { return a.behind < b.behind; });
  runs.clear();
  // A sample's value is the sum of the changes at the crossings ahead of it.
  int value = 0;
  for (const Crossing* crossing = first; crossing != last; ++crossing)
  {
    value += crossing->change;
  }
  int begin = low;
  for (const Crossing* crossing = first; crossing != last; ++crossing)
  {
    if (crossing->behind > begin)
    {
      runs.push_back({begin, crossing->behind, value});
      begin = crossing->behind;
    }
    value -= crossing->change;
  }
  if (begin <= high)
  {
    runs.push_back({begin, high + 1, value});
  }
}

/// A chain in units of a grid: its triangles by the bands that they reach, and its vertices where
/// the bands ask for most of them. Where few are asked for, as most triangles lie between the rows,
/// each is brought to units of the grid when it is.
class ChainOnGrid final : public RowCrossings::OnGrid
{
public:
  ChainOnGrid(const Grid& grid, const Extent& extent, const RowBands& rows,
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap,
    Executor& executor)
    : grid_(grid)
    , extent_(extent)
    , rows_(rows)
    , vertices_(vertices)
    , triangles_(triangles)
    , cap_(cap)
    , bands_(grid, extent, rows, vertices, triangles, cap, executor)
  {
    if (3 * bands_.size() > vertices.size())
    {
      inGridUnits_.resize(vertices.size());
      forEachItem(
        vertices.size(), [&](std::size_t i) { inGridUnits_[i] = grid.inGridUnits(vertices[i]); },
        executor);
    }
  }

  void evaluate(int k, std::size_t band, const RowCrossings::RowWork& work) const override
  {
    const int firstRow = std::max(extent_[2], rows_.firstRowOf(band));
    const int lastRow = rows_.lastRowIn(extent_, band);
    // All samples of a row may be before a crossing.
    const auto perRow = static_cast<std::size_t>(extent_[1] - extent_[0]) + 2;
    const std::size_t places = static_cast<std::size_t>(lastRow - firstRow + 1) * perRow;
    std::vector<int> sums;
    std::vector<Crossing> crossings;
    for (const std::uint32_t* number = bands_.begin(k, band); number != bands_.end(k, band);
         ++number)
    {
      const bool isOfCap = *number >= triangles_.size();
      const ChainView& list = isOfCap ? cap_ : triangles_;
      const std::size_t place = isOfCap ? *number - triangles_.size() : *number;
      const Triangle& ids = list[place];
      const std::int32_t multiplicity = list.multiplicity(place);
      const RowTriangle triangle(this->vertex(ids[0]), this->vertex(ids[1]), this->vertex(ids[2]));
      const RowTriangle::Range range = triangle.rowsIn(k, firstRow, lastRow);
      for (int j = range.first; j <= range.last; ++j)
      {
        if (const int sign = triangle.crossingSign(j, k))
        {
          crossings.push_back(
            {j, triangle.firstBehind(j, k, sign, extent_[0], extent_[1]), multiplicity * sign});
        }
      }
      if (crossings.size() > 2 * places)
      {
        sums.resize(places);
        addUpChanges(crossings, firstRow, extent_[0], perRow, sums);
      }
    }
    const auto rowOf = [firstRow](int j)
    {
      return static_cast<std::size_t>(j - firstRow);
    };
    // There are about as many rows as crossings, so a counting sort it is.
    CountingSort<Crossing> byRow;
    byRow.sort(rowOf(lastRow + 1),
      [&](const auto& visit)
      {
        for (const Crossing& crossing : crossings)
        {
          visit(rowOf(crossing.row), crossing);
        }
      });
    std::vector<RowRun> runs;
    for (int j = firstRow; j <= lastRow; ++j)
    {
      makeRuns(byRow.begin(rowOf(j)), byRow.end(rowOf(j)), extent_[0], extent_[1], runs);
      work(j, k, runs);
    }
  }

private:
  Eigen::Vector3d vertex(std::int32_t id) const
  {
    return inGridUnits_.empty() ? grid_.inGridUnits(vertices_[id]) : inGridUnits_[id];
  }

  Grid grid_;
  Extent extent_;
  RowBands rows_;
  const std::vector<Eigen::Vector3d>& vertices_;
  ChainView triangles_, cap_;
  Bands bands_;
  std::vector<Eigen::Vector3d> inGridUnits_; ///< the vertices; empty where few are asked for
};

} // namespace

RowCrossings::RowCrossings(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap)
  : vertices_(vertices)
  , triangles_(triangles)
  , cap_(cap)
{
}

const TriangleList& RowCrossings::noTriangles()
{
  static const TriangleList none;
  return none;
}

std::unique_ptr<const RowCrossings::OnGrid> RowCrossings::on(
  const Grid& grid, const Extent& extent, const RowBands& rows, Executor& executor) const
{
  return std::make_unique<const ChainOnGrid>(
    grid, extent, rows, vertices_, triangles_, cap_, executor);
}

void RowCrossings::evaluate(const Grid& grid, const Extent& extent, std::size_t samplesPerBlock,
  const RowWork& work, Executor& executor) const
{
  this->evaluateBlocks(
    grid, extent, samplesPerBlock,
    [&work](const OnGrid& onGrid, int k, std::size_t band) { onGrid.evaluate(k, band, work); },
    executor);
}

void RowCrossings::evaluateBlocks(const Grid& grid, const Extent& extent,
  std::size_t samplesPerBlock, const BlockWork& work, Executor& executor) const
{
  if (sampleCount(extent) == 0)
  {
    return;
  }
  const std::size_t width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const std::size_t height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t depth = static_cast<std::size_t>(extent[5] - extent[4] + 1);
  const RowBands rows = {
    extent[2], static_cast<int>(std::clamp<std::size_t>(samplesPerBlock / width, 1, height))};
  const std::size_t bands = rows.countIn(extent);
  const double atATime = this->layersAtATime(grid, extent, rows);
  const auto layers = std::max<std::size_t>(1, static_cast<std::size_t>(atATime));
  const auto perSlab = std::clamp<std::size_t>(
    static_cast<std::size_t>(atATime * static_cast<double>(bands)), 1, bands);
  const auto shareOf = [&](std::size_t layer, std::size_t band)
  {
    return static_cast<double>(layer * bands + band) / static_cast<double>(depth * bands);
  };
  Progress progress(executor);
  for (std::size_t done = 0; done < depth; done += layers)
  {
    const std::size_t end = std::min(done + layers, depth);
    for (std::size_t band = 0; band < bands; band += perSlab)
    {
      const std::size_t endBand = std::min(band + perSlab, bands), bandsHere = endBand - band;
      const Extent slab = {extent[0], extent[1], rows.firstRowOf(band),
        rows.lastRowIn(extent, endBand - 1), extent[4] + static_cast<int>(done),
        extent[4] + static_cast<int>(end - 1)};
      progress.set(shareOf(done, band), endBand < bands ? shareOf(done, endBand) : shareOf(end, 0));
      const std::unique_ptr<const OnGrid> onGrid =
        this->on(grid, slab, {slab[2], rows.rowsPerBand}, executor);
      executor.run(bandsHere * (end - done), [&](std::size_t block)
        { work(*onGrid, slab[4] + static_cast<int>(block / bandsHere), block % bandsHere); });
    }
  }
}

double RowCrossings::layersAtATime(
  const Grid& grid, const Extent& extent, const RowBands& rows) const
{
  const double depth = extent[5] - extent[4] + 1;
  double entries = static_cast<double>(rows.countIn(extent)) * depth;
  for (const ChainView* list : {&triangles_, &cap_})
  {
    constexpr std::size_t lookedAt = 1 << 16;
    const std::size_t step = list->size() / lookedAt + 1;
    for (std::size_t i = 0; i < list->size(); i += step)
    {
      const auto placeOf = [&, ids = (*list)[i]](int corner)
      {
        return VertexPlace(vertices_[ids[corner]], grid, extent);
      };
      const VertexPlace a = placeOf(0), b = placeOf(1), c = placeOf(2);
      const IndexRange reached = VertexPlace::rowsOf(a, b, c, extent[2]);
      const IndexRange layers = VertexPlace::layersOf(a, b, c, extent[4]);
      if (reached.first <= reached.second)
      {
        entries +=
          static_cast<double>(step) * (layers.second - layers.first + 1) *
          static_cast<double>(rows.bandOf(reached.second) - rows.bandOf(reached.first) + 1);
      }
    }
  }
  constexpr double mostEntries = 1 << 26; // of 4 bytes for a triangle, or 8 for a place
  return std::min(1.0, mostEntries / entries) * depth;
}

} // namespace winding
