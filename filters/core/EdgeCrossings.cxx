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
  TriangleOnLines(const LevelEdges& edges, const Grid& grid)
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
        const int sign = triangle.crossingSign(j, k);
        if (sign == 0)
        {
          continue;
        }
        const int first = triangle.firstBehind(j, k, sign, 0, dimensions_[axis] - 1) - 1;
        if (first < 0 || first == dimensions_[axis] - 1)
        {
          continue; // not between samples
        }
        std::array<int, 3> sample;
        sample[axis] = first;
        sample[y] = j;
        sample[z] = k;
        const std::size_t edge = edges_.find(sample, axis);
        if (edge != edges_.size())
        {
          const double fraction = std::clamp(triangle.crossingAt(j, k) - first, 0.0, 1.0);
          crossings.push_back({static_cast<std::uint32_t>(edge), fraction});
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

  const LevelEdges& edges_;
  Eigen::Vector3i dimensions_;
};

} // namespace

EdgeCrossings::EdgeCrossings(
  const Surface& surface, const Grid& grid, const LevelEdges& edges, Executor& executor)
{
  const TriangleOnLines lines(edges, grid);
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
