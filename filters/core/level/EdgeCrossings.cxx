// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/EdgeCrossings.h"

#include "base/BucketSort.h"
#include "rays/RowTriangle.h"
#include "source/CoordinateOrder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

namespace
{

/// Returns the axis that follows another one after `by` steps. Taking `axis` for x, turned(axis,
/// 1) for y and turned(axis, 2) for z is a rotation, which keeps the orientation of triangles.
int turned(int axis, int by)
{
  return (axis + by) % 3;
}

/// Up to this number of rows are all asked, without narrowing them down before.
constexpr int fewRows = 4;

/// A triangle of a surface and how often it counts there.
struct CountedTriangle
{
  Triangle ids;
  std::int32_t multiplicity;
};

struct FoundCrossing
{
  std::uint32_t edge;
  EdgeCrossings::Crossing crossing;
};

/// Finds the crossings of triangles with the edges.
class TriangleOnLines
{
public:
  TriangleOnLines(const LevelEdges& edges, const Grid& grid)
    : edges_(edges)
    , dimensions_(grid.dimensions)
    , stretching_(grid.spacing.maxCoeff() * grid.spacing.cwiseInverse())
  {
  }

  /// Appends the crossings of a triangle, which counts `multiplicity` times, with all edges. The
  /// corners are in units of the grid.
  void cross(const Eigen::Vector3d (&corners)[3], int multiplicity,
    std::vector<FoundCrossing>& crossings) const
  {
    IndexRange ranges[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      ranges[axis] = indicesBetween(low, high, 0, dimensions_[axis] - 1);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const IndexRange &rows = ranges[turned(axis, 1)], &layers = ranges[turned(axis, 2)];
      if (rows.first <= rows.second && layers.first <= layers.second)
      {
        this->crossLines(corners, multiplicity, axis, rows, layers, crossings);
      }
    }
  }

private:
  /// Appends the crossings of a triangle with the edges along an axis, which is taken for x.
  void crossLines(const Eigen::Vector3d (&corners)[3], int multiplicity, int axis,
    const IndexRange& rows, const IndexRange& layers, std::vector<FoundCrossing>& crossings) const
  {
    const int y = turned(axis, 1), z = turned(axis, 2);
    Eigen::Vector3d turnedCorners[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      turnedCorners[corner] = {corners[corner][axis], corners[corner][y], corners[corner][z]};
    }
    const RowTriangle triangle(turnedCorners[0], turnedCorners[1], turnedCorners[2]);
    const auto [firstJ, lastJ] = rows;
    for (int k = layers.first; k <= layers.second; ++k)
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
          continue; // the crossing is not between two samples
        }
        std::array<int, 3> sample;
        sample[axis] = first;
        sample[y] = j;
        sample[z] = k;
        const double fraction = std::clamp(triangle.crossingAt(j, k) - first, 0.0, 1.0);
        const auto add = [&](double at, int change)
        {
          const std::size_t edge = edges_.find(sample, axis);
          if (edge != edges_.size())
          {
            crossings.push_back(
              {static_cast<std::uint32_t>(edge), {at, this->normalOf(triangle, axis), change}});
          }
        };
        add(fraction, -sign * multiplicity);
        const int next = fraction < 0.5 ? first - 1 : first + 1;
        if (std::min(fraction, 1 - fraction) < EdgeCrossings::atSample && next >= 0 &&
            next < dimensions_[axis] - 1)
        {
          sample[axis] = next;
          add(fraction < 0.5 ? 1 : 0, 0);
        }
      }
    }
  }

  /// The unit normal, in the caller's coordinates, of a triangle that has `axis` for x.
  Eigen::Vector3f normalOf(const RowTriangle& triangle, int axis) const
  {
    Eigen::Vector3d normal;
    for (int by = 0; by < 3; ++by)
    {
      normal[turned(axis, by)] = triangle.areaVector()[by];
    }
    return normal.cwiseProduct(stretching_).stableNormalized().cast<float>();
  }

  const LevelEdges& edges_;
  Eigen::Vector3i dimensions_;
  /// Factors that turn normals in units of the grid into the caller's; 1 along a voxel's longest
  /// side.
  Eigen::Vector3d stretching_;
};

} // namespace

EdgeCrossings::EdgeCrossings(
  const Surface& surface, const Grid& grid, const LevelEdges& edges, Executor& executor)
{
  const TriangleOnLines lines(edges, grid);
  const ChainView chain(surface);
  constexpr std::size_t perBlock = 1024;
  std::vector<Eigen::Vector3d> vertices(surface.vertices.size()); // in units of the grid
  forEachItem(
    vertices.size(), [&](std::size_t i) { vertices[i] = grid.inGridUnits(surface.vertices[i]); },
    executor);
  // Triangles are sorted by layer, as the edges are, so that few of the edges are at work at a
  // time.
  const int layers = grid.dimensions[2];
  const int shift = bucketShift(static_cast<std::size_t>(layers), 1);
  const auto emit = [&](std::size_t first, std::size_t last, const auto& put)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      const Triangle& ids = chain[i];
      const double lowest =
        std::min({vertices[ids[0]][2], vertices[ids[1]][2], vertices[ids[2]][2]});
      const double layer = std::clamp<double>(lowest, 0, layers - 1);
      put(static_cast<std::size_t>(layer) >> shift, CountedTriangle{ids, chain.multiplicity(i)});
    }
  };
  const Buckets<CountedTriangle> triangles =
    distribute<CountedTriangle>(chain.size(), bucketsFor(layers, shift), emit, executor);
  const CountedTriangle* const firstTriangle = triangles.begin(0);
  std::vector<std::vector<FoundCrossing>> found(
    (surface.triangles.size() + perBlock - 1) / perBlock);
  runBlocks(
    surface.triangles.size(), perBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::vector<FoundCrossing>& crossings = found[block];
      for (std::size_t i = first; i < last; ++i)
      {
        const auto& [ids, multiplicity] = firstTriangle[i];
        Eigen::Vector3d corners[3] = {vertices[ids[0]], vertices[ids[1]], vertices[ids[2]]};
        turnToFirstOrder(corners);
        lines.cross(corners, multiplicity, crossings);
      }
    },
    executor);

  crossings_.sort(edges.size(),
    [&](const auto& visit)
    {
      for (const std::vector<FoundCrossing>& crossings : found)
      {
        for (const FoundCrossing& crossing : crossings)
        {
          visit(crossing.edge, crossing.crossing);
        }
      }
    });
  // Crossings at one place stand in an order by all of their numbers, so that the order of the
  // triangles does not matter.
  const auto isBefore = [](const Crossing& a, const Crossing& b)
  {
    if (a.fraction != b.fraction || a.change != b.change)
    {
      return a.fraction != b.fraction ? a.fraction < b.fraction : a.change < b.change;
    }
    return compareCoordinates(a.normal.cast<double>(), b.normal.cast<double>()) < 0;
  };
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (crossings_.end(edge) - crossings_.begin(edge) > 1)
    {
      std::sort(crossings_.begin(edge), crossings_.end(edge), isBefore);
    }
  }
}

} // namespace winding
