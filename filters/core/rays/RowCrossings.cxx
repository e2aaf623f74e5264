#include "rays/RowCrossings.h"

#include "base/CountingSort.h"
#include "rays/RowTriangle.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/**
 * The triangles that reach into bands of rows, for all layers of an extent. A band is some rows of
 * a layer that stand beside each other; the first may begin before the extent.
 */
class Bands
{
public:
  Bands(const Extent& extent, const RowBands& rows, const std::vector<Eigen::Vector3d>& vertices,
    const ChainView& triangles, const ChainView& cap)
    : firstLayer_(extent[4])
    , perLayer_(rows.countIn(extent))
  {
    const auto forEach = [&](const auto& visit)
    {
      std::uint32_t number = 0;
      for (const ChainView* list : {&triangles, &cap})
      {
        for (const Triangle& triangle : list->triangles())
        {
          const auto [firstRow, lastRow] = samplesBetween(vertices, triangle, 1, extent);
          const auto [firstLayer, lastLayer] = samplesBetween(vertices, triangle, 2, extent);
          if (firstRow <= lastRow)
          {
            const std::size_t firstBand = rows.bandOf(firstRow), lastBand = rows.bandOf(lastRow);
            for (int k = firstLayer; k <= lastLayer; ++k)
            {
              for (std::size_t band = firstBand; band <= lastBand; ++band)
              {
                visit(this->place(k, band), number);
              }
            }
          }
          ++number;
        }
      }
    };
    triangles_.sort(static_cast<std::size_t>(extent[5] - extent[4] + 1) * perLayer_, forEach);
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
  /// The indices of an extent along an axis between a triangle's lowest and highest vertex.
  static IndexRange samplesBetween(const std::vector<Eigen::Vector3d>& vertices,
    const Triangle& triangle, int axis, const Extent& extent)
  {
    const auto [low, high] = std::minmax(
      {vertices[triangle[0]][axis], vertices[triangle[1]][axis], vertices[triangle[2]][axis]});
    return indicesBetween(low, high, extent[2 * axis], extent[2 * axis + 1]);
  }

  std::size_t place(int k, std::size_t band) const
  {
    return static_cast<std::size_t>(k - firstLayer_) * perLayer_ + band;
  }

  int firstLayer_;
  std::size_t perLayer_;
  CountingSort<std::uint32_t> triangles_;
};

struct Crossing
{
  int row;    ///< j
  int behind; ///< first sample behind the crossing
  int change; ///< by which w changes there: the sign of the crossing, once for each copy
};

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

/// A chain's vertices in units of a grid, and its triangles by the bands that they reach.
class ChainOnGrid final : public RowCrossings::OnGrid
{
public:
  ChainOnGrid(const Grid& grid, const Extent& extent, const RowBands& rows,
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap)
    : extent_(extent)
    , rows_(rows)
    , vertices_(vertices.size())
    , triangles_(triangles)
    , cap_(cap)
  {
    std::transform(vertices.begin(), vertices.end(), vertices_.begin(),
      [&grid](const Eigen::Vector3d& vertex) { return grid.inGridUnits(vertex); });
    bands_ = std::make_unique<const Bands>(extent, rows, vertices_, triangles_, cap_);
  }

  void evaluate(int k, std::size_t band, const RowCrossings::RowWork& work) const override
  {
    const int firstRow = std::max(extent_[2], rows_.firstRowOf(band));
    const int lastRow = rows_.lastRowIn(extent_, band);
    std::vector<Crossing> crossings;
    for (const std::uint32_t* number = bands_->begin(k, band); number != bands_->end(k, band);
         ++number)
    {
      const bool isOfCap = *number >= triangles_.size();
      const ChainView& list = isOfCap ? cap_ : triangles_;
      const std::size_t place = isOfCap ? *number - triangles_.size() : *number;
      const Triangle& ids = list[place];
      const std::int32_t multiplicity = list.multiplicity(place);
      const RowTriangle triangle(vertices_[ids[0]], vertices_[ids[1]], vertices_[ids[2]]);
      const RowTriangle::Range range = triangle.rowsIn(k, firstRow, lastRow);
      for (int j = range.first; j <= range.last; ++j)
      {
        if (const int sign = triangle.crossingSign(j, k))
        {
          crossings.push_back(
            {j, triangle.firstBehind(j, k, sign, extent_[0], extent_[1]), multiplicity * sign});
        }
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
  Extent extent_;
  RowBands rows_;
  std::vector<Eigen::Vector3d> vertices_;
  ChainView triangles_, cap_;
  std::unique_ptr<const Bands> bands_;
};

} // namespace

RowCrossings::RowCrossings(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap)
  : vertices_(vertices)
  , triangles_(triangles)
  , cap_(cap)
{
}

const std::vector<Triangle>& RowCrossings::noTriangles()
{
  static const std::vector<Triangle> none;
  return none;
}

std::unique_ptr<const RowCrossings::OnGrid> RowCrossings::on(
  const Grid& grid, const Extent& extent, const RowBands& rows) const
{
  return std::make_unique<const ChainOnGrid>(grid, extent, rows, vertices_, triangles_, cap_);
}

bool RowCrossings::evaluate(const Grid& grid, const Extent& extent, std::size_t samplesPerBlock,
  const RowWork& work, Executor& executor) const
{
  return this->evaluateBlocks(
    grid, extent, samplesPerBlock,
    [&work](const OnGrid& onGrid, int k, std::size_t band) { onGrid.evaluate(k, band, work); },
    executor);
}

bool RowCrossings::evaluateBlocks(const Grid& grid, const Extent& extent,
  std::size_t samplesPerBlock, const BlockWork& work, Executor& executor) const
{
  if (sampleCount(extent) == 0)
  {
    return true;
  }
  const std::size_t width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const std::size_t height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t depth = static_cast<std::size_t>(extent[5] - extent[4] + 1);
  const RowBands rows = {
    extent[2], static_cast<int>(std::clamp<std::size_t>(samplesPerBlock / width, 1, height))};
  const std::size_t bands = rows.countIn(extent);
  const std::size_t layers = this->layersAtATime(grid, extent, rows);
  const auto [first, last] = executor.share();
  const double perLayer = (last - first) / static_cast<double>(depth);
  bool isComplete = true;
  for (std::size_t done = 0; isComplete && done < depth; done += layers)
  {
    const std::size_t end = std::min(done + layers, depth);
    Extent slab = extent;
    slab[4] = extent[4] + static_cast<int>(done);
    slab[5] = extent[4] + static_cast<int>(end - 1);
    const std::unique_ptr<const OnGrid> onGrid = this->on(grid, slab, rows);
    executor.setShare(first + perLayer * static_cast<double>(done),
      end == depth ? last : first + perLayer * static_cast<double>(end));
    isComplete = executor.run(bands * (end - done), [&](std::size_t block)
      { work(*onGrid, slab[4] + static_cast<int>(block / bands), block % bands); });
  }
  executor.setShare(first, last);
  return isComplete;
}

std::size_t RowCrossings::layersAtATime(
  const Grid& grid, const Extent& extent, const RowBands& rows) const
{
  const auto depth = static_cast<std::size_t>(extent[5] - extent[4] + 1);
  const auto places = static_cast<double>(rows.countIn(extent)) * static_cast<double>(depth);
  constexpr double manyPlaces = 1 << 20; // fewer are not worth looking at the triangles
  if (places <= manyPlaces)
  {
    return depth;
  }
  double entries = places;
  for (const ChainView* list : {&triangles_, &cap_})
  {
    for (const Triangle& ids : list->triangles())
    {
      Bounds box;
      for (const auto id : ids)
      {
        box.extend(vertices_[id].cwiseQuotient(grid.spacing));
      }
      const Eigen::Vector3d sides = box.sizes();
      entries +=
        std::min(sides[1] / rows.rowsPerBand + 1, static_cast<double>(rows.countIn(extent))) *
        std::min(sides[2] + 1, static_cast<double>(depth));
    }
  }
  constexpr double mostEntries = 1 << 26; // of 4 bytes for a triangle, or 8 for a place
  const double share = std::min(1.0, mostEntries / entries);
  return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(depth)));
}

} // namespace winding
