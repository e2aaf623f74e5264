#include "EdgeCrossings.h"

#include "RowTriangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace winding
{

namespace
{

/// With an axis for x, the axes that are y and z: a turn, which keeps the orientation of triangles.
int turned(int axis, int by)
{
  return (axis + by) % 3;
}

/// Finds edges by the line of samples that they lie on.
class EdgesByLine
{
public:
  EdgesByLine(const Grid& grid, const std::vector<GridEdge>& edges)
    : dimensions_(grid.dimensions)
  {
    std::size_t lines = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      firstLine_[axis] = lines;
      lines += static_cast<std::size_t>(dimensions_[turned(axis, 1)]) *
               static_cast<std::size_t>(dimensions_[turned(axis, 2)]);
    }
    // Counted two places up, so that filling leaves each start where it belongs.
    starts_.assign(lines + 2, 0);
    for (const GridEdge& edge : edges)
    {
      ++starts_[this->lineOf(edge) + 2];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    items_.resize(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const GridEdge& edge = edges[i];
      items_[starts_[this->lineOf(edge) + 1]++] = {
        edge.sample[edge.axis], static_cast<std::uint32_t>(i)};
    }
    for (std::size_t line = 0; line < lines; ++line)
    {
      const auto first = items_.begin() + starts_[line], last = items_.begin() + starts_[line + 1];
      if (!std::is_sorted(first, last, before))
      {
        std::sort(first, last, before);
      }
    }
  }

  struct Item
  {
    int first;          ///< index of the edge's first sample along the line
    std::uint32_t edge; ///< its number
  };

  /// Those on line (j, k) along an axis, ascending.
  std::pair<const Item*, const Item*> on(int axis, int j, int k) const
  {
    const std::size_t line = this->lineOf(axis, j, k);
    return {items_.data() + starts_[line], items_.data() + starts_[line + 1]};
  }

private:
  static bool before(const Item& a, const Item& b) { return a.first < b.first; }

  std::size_t lineOf(int axis, int j, int k) const
  {
    return firstLine_[axis] +
           static_cast<std::size_t>(k) * static_cast<std::size_t>(dimensions_[turned(axis, 1)]) +
           static_cast<std::size_t>(j);
  }

  std::size_t lineOf(const GridEdge& edge) const
  {
    return this->lineOf(
      edge.axis, edge.sample[turned(edge.axis, 1)], edge.sample[turned(edge.axis, 2)]);
  }

  Eigen::Vector3i dimensions_;
  std::size_t firstLine_[3];
  std::vector<std::uint32_t> starts_;
  std::vector<Item> items_;
};

/// So few are asked at once, rather than narrowed down.
constexpr int fewRows = 4;

struct Crossing
{
  std::uint32_t edge;
  double fraction;
};

/// The crossings of one triangle with the edges along one axis.
class TriangleOnLines
{
public:
  TriangleOnLines(const EdgesByLine& edges, const Grid& grid)
    : edges_(edges)
    , dimensions_(grid.dimensions)
  {
  }

  /// Corners in units of the grid.
  void cross(const Eigen::Vector3d (&corners)[3], int axis, std::vector<Crossing>& crossings) const
  {
    const int y = turned(axis, 1), z = turned(axis, 2);
    const auto [firstJ, lastJ] = this->samplesBetween(corners, y);
    const auto [firstK, lastK] = this->samplesBetween(corners, z);
    if (firstJ > lastJ || firstK > lastK)
    {
      return;
    }
    Eigen::Vector3d turnedCorners[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      turnedCorners[corner] = {corners[corner][axis], corners[corner][y], corners[corner][z]};
    }
    const RowTriangle triangle(turnedCorners[0], turnedCorners[1], turnedCorners[2]);
    for (int k = firstK; k <= lastK; ++k)
    {
      const RowTriangle::Range range = lastJ - firstJ < fewRows ? RowTriangle::Range{firstJ, lastJ}
                                                                : triangle.rowsIn(k, firstJ, lastJ);
      for (int j = range.first; j <= range.last; ++j)
      {
        const auto [first, last] = edges_.on(axis, j, k);
        const int sign = first == last ? 0 : triangle.crossingSign(j, k);
        if (sign == 0)
        {
          continue;
        }
        const int behind = triangle.firstBehind(j, k, sign, 0, dimensions_[axis] - 1);
        const auto* found = std::lower_bound(first, last, behind - 1,
          [](const EdgesByLine::Item& item, int index) { return item.first < index; });
        if (found != last && found->first == behind - 1)
        {
          const double fraction = triangle.crossingAt(j, k) - (behind - 1);
          crossings.push_back({found->edge, std::clamp(fraction, 0.0, 1.0)});
        }
      }
    }
  }

private:
  /// First and last index along an axis of samples between a triangle's lowest and highest corner;
  /// none if the first is the larger one.
  std::pair<int, int> samplesBetween(const Eigen::Vector3d (&corners)[3], int axis) const
  {
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    const double first = std::max(std::ceil(low), 0.0);
    const double last = std::min<double>(std::floor(high), dimensions_[axis] - 1);
    return first <= last ? std::pair(static_cast<int>(first), static_cast<int>(last))
                         : std::pair(0, -1);
  }

  const EdgesByLine& edges_;
  Eigen::Vector3i dimensions_;
};

} // namespace

EdgeCrossings::EdgeCrossings(
  const Surface& surface, const Grid& grid, const std::vector<GridEdge>& edges, Executor& executor)
{
  const EdgesByLine edgesByLine(grid, edges);
  const TriangleOnLines lines(edgesByLine, grid);
  constexpr std::size_t perBlock = 1024;
  std::vector<Eigen::Vector3d> vertices(surface.vertices.size()); // in units of the grid
  runBlocks(
    vertices.size(), perBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        vertices[i] = (surface.vertices[i] - grid.firstSample).cwiseQuotient(grid.spacing);
      }
    },
    executor);
  std::vector<std::vector<Crossing>> found((surface.triangles.size() + perBlock - 1) / perBlock);
  runBlocks(
    surface.triangles.size(), perBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::vector<Crossing>& crossings = found[block];
      for (std::size_t i = first; i < last; ++i)
      {
        const Triangle& ids = surface.triangles[i];
        const Eigen::Vector3d corners[3] = {vertices[ids[0]], vertices[ids[1]], vertices[ids[2]]};
        for (int axis = 0; axis < 3; ++axis)
        {
          lines.cross(corners, axis, crossings);
        }
      }
    },
    executor);

  starts_.assign(edges.size() + 2, 0);
  for (const std::vector<Crossing>& crossings : found)
  {
    for (const Crossing& crossing : crossings)
    {
      ++starts_[crossing.edge + 2];
    }
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  fractions_.resize(starts_.back());
  for (const std::vector<Crossing>& crossings : found)
  {
    for (const Crossing& crossing : crossings)
    {
      fractions_[starts_[crossing.edge + 1]++] = crossing.fraction;
    }
  }
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (starts_[edge + 1] - starts_[edge] > 1)
    {
      std::sort(fractions_.begin() + static_cast<std::ptrdiff_t>(starts_[edge]),
        fractions_.begin() + static_cast<std::ptrdiff_t>(starts_[edge + 1]));
    }
  }
}

} // namespace winding
