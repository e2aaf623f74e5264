#include "RowCrossings.h"

#include "RowTriangle.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

Eigen::Vector3d inGridUnits(const Grid& grid, const Eigen::Vector3d& point)
{
  return (point - grid.firstSample).cwiseQuotient(grid.spacing);
}

/// The triangles whose z range holds a layer, for every layer of an extent.
class Layers
{
public:
  Layers(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles,
    const std::vector<Triangle>& cap, const Extent& extent)
    : first_(extent[4])
    , starts_(static_cast<std::size_t>(extent[5] - extent[4] + 1) + 2, 0)
  {
    const auto forEach = [&](const auto& visit)
    {
      std::uint32_t number = 0;
      for (const std::vector<Triangle>* list : {&triangles, &cap})
      {
        for (const Triangle& triangle : *list)
        {
          const double za = vertices[triangle[0]][2];
          const double zb = vertices[triangle[1]][2];
          const double zc = vertices[triangle[2]][2];
          const double low = std::max<double>(std::ceil(std::min({za, zb, zc})), extent[4]);
          const double high = std::min<double>(std::floor(std::max({za, zb, zc})), extent[5]);
          if (low <= high)
          {
            for (int k = static_cast<int>(low); k <= static_cast<int>(high); ++k)
            {
              visit(static_cast<std::size_t>(k - extent[4]), number);
            }
          }
          ++number;
        }
      }
    };
    // Counted two places up, so that filling leaves each start where it belongs.
    forEach([&](std::size_t layer, std::uint32_t) { ++starts_[layer + 2]; });
    for (std::size_t i = 2; i < starts_.size(); ++i)
    {
      starts_[i] += starts_[i - 1];
    }
    triangles_.resize(starts_.back());
    forEach(
      [&](std::size_t layer, std::uint32_t number) { triangles_[starts_[layer + 1]++] = number; });
  }

  const std::uint32_t* begin(int k) const
  {
    return triangles_.data() + starts_[static_cast<std::size_t>(k - first_)];
  }
  const std::uint32_t* end(int k) const { return this->begin(k + 1); }

private:
  int first_;
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> triangles_;
};

struct Crossing
{
  int row;    ///< j
  int behind; ///< first sample behind it
  int sign;
};

/// Sorts the crossings of a layer by row: a counting sort, for there are as many rows as crossings.
class RowBuckets
{
public:
  void sort(const std::vector<Crossing>& crossings, int firstRow, int rows)
  {
    starts_.assign(static_cast<std::size_t>(rows) + 2, 0);
    for (const Crossing& crossing : crossings)
    {
      ++starts_[static_cast<std::size_t>(crossing.row - firstRow) + 2];
    }
    for (std::size_t i = 2; i < starts_.size(); ++i)
    {
      starts_[i] += starts_[i - 1];
    }
    sorted_.resize(crossings.size());
    for (const Crossing& crossing : crossings)
    {
      sorted_[starts_[static_cast<std::size_t>(crossing.row - firstRow) + 1]++] = crossing;
    }
  }

  Crossing* begin(int row) { return sorted_.data() + starts_[static_cast<std::size_t>(row)]; }
  Crossing* end(int row) { return this->begin(row + 1); }

private:
  std::vector<std::size_t> starts_;
  std::vector<Crossing> sorted_;
};

/// Turns the crossings of a row into runs of equal values over [low, high].
void makeRuns(Crossing* first, Crossing* last, int low, int high, std::vector<RowRun>& runs)
{
  std::sort(first, last, [](const Crossing& a, const Crossing& b) { return a.behind < b.behind; });
  runs.clear();
  // A sample's value is the sum of the signs of the crossings ahead of it.
  int value = 0;
  for (const Crossing* crossing = first; crossing != last; ++crossing)
  {
    value += crossing->sign;
  }
  int begin = low;
  for (const Crossing* crossing = first; crossing != last; ++crossing)
  {
    if (crossing->behind > begin)
    {
      runs.push_back({begin, crossing->behind, value});
      begin = crossing->behind;
    }
    value -= crossing->sign;
  }
  if (begin <= high)
  {
    runs.push_back({begin, high + 1, value});
  }
}

/// A chain's vertices in units of a grid, and its triangles by the layers that they reach.
class ChainOnGrid final : public RowCrossings::OnGrid
{
public:
  ChainOnGrid(const Grid& grid, const Extent& extent, const std::vector<Eigen::Vector3d>& vertices,
    const std::vector<Triangle>& triangles, const std::vector<Triangle>& cap)
    : extent_(extent)
    , vertices_(vertices.size())
    , triangles_(triangles)
    , cap_(cap)
  {
    std::transform(vertices.begin(), vertices.end(), vertices_.begin(),
      [&grid](const Eigen::Vector3d& vertex) { return inGridUnits(grid, vertex); });
    layers_ = std::make_unique<const Layers>(vertices_, triangles_, cap_, extent);
  }

  void evaluate(int k, int firstRow, int lastRow, const RowCrossings::RowWork& work) const override
  {
    std::vector<Crossing> crossings;
    for (const std::uint32_t* number = layers_->begin(k); number != layers_->end(k); ++number)
    {
      const Triangle& ids =
        *number < triangles_.size() ? triangles_[*number] : cap_[*number - triangles_.size()];
      const RowTriangle triangle(vertices_[ids[0]], vertices_[ids[1]], vertices_[ids[2]]);
      const RowTriangle::Range range = triangle.rowsIn(k, firstRow, lastRow);
      for (int j = range.first; j <= range.last; ++j)
      {
        if (const int sign = triangle.crossingSign(j, k))
        {
          crossings.push_back({j, triangle.firstBehind(j, k, sign, extent_[0], extent_[1]), sign});
        }
      }
    }
    RowBuckets buckets;
    buckets.sort(crossings, firstRow, lastRow - firstRow + 1);
    std::vector<RowRun> runs;
    for (int j = firstRow; j <= lastRow; ++j)
    {
      makeRuns(
        buckets.begin(j - firstRow), buckets.end(j - firstRow), extent_[0], extent_[1], runs);
      work(j, k, runs);
    }
  }

private:
  Extent extent_;
  std::vector<Eigen::Vector3d> vertices_;
  const std::vector<Triangle>& triangles_;
  const std::vector<Triangle>& cap_;
  std::unique_ptr<const Layers> layers_;
};

} // namespace

RowCrossings::RowCrossings(const std::vector<Eigen::Vector3d>& vertices,
  const std::vector<Triangle>& triangles, const std::vector<Triangle>& cap)
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
  const Grid& grid, const Extent& extent) const
{
  return std::make_unique<const ChainOnGrid>(grid, extent, vertices_, triangles_, cap_);
}

bool RowCrossings::evaluate(const Grid& grid, const Extent& extent, std::size_t samplesPerBlock,
  const RowWork& work, Executor& executor) const
{
  if (sampleCount(extent) == 0)
  {
    return true;
  }
  const std::unique_ptr<const OnGrid> onGrid = this->on(grid, extent);
  // A block is a band of rows of a layer.
  const std::size_t width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const std::size_t rows = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t bandRows = std::clamp<std::size_t>(samplesPerBlock / width, 1, rows);
  const std::size_t bands = (rows + bandRows - 1) / bandRows;
  const std::size_t depth = static_cast<std::size_t>(extent[5] - extent[4] + 1);
  return executor.run(bands * depth,
    [&](std::size_t block)
    {
      const int k = extent[4] + static_cast<int>(block / bands);
      const int firstRow = extent[2] + static_cast<int>(block % bands * bandRows);
      const int lastRow = std::min(extent[3], firstRow + static_cast<int>(bandRows) - 1);
      onGrid->evaluate(k, firstRow, lastRow, work);
    });
}

int RowCrossings::valueAt(const Grid& grid, int i, int j, int k) const
{
  int value = 0;
  for (const std::vector<Triangle>* list : {&triangles_, &cap_})
  {
    for (const Triangle& ids : *list)
    {
      const RowTriangle triangle(inGridUnits(grid, vertices_[ids[0]]),
        inGridUnits(grid, vertices_[ids[1]]), inGridUnits(grid, vertices_[ids[2]]));
      const int sign = triangle.crossingSign(j, k);
      value += sign != 0 && triangle.firstBehind(j, k, sign, i, i) > i ? sign : 0;
    }
  }
  return value;
}

} // namespace winding
