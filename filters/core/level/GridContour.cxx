// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/GridContour.h"

#include "level/CellTriangles.h"
#include "level/CrossedCells.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

constexpr std::size_t verticesPerBlock = 8192;

/// Adds the corners of the triangles in the cells between four rows.
void addTriangles(const LevelEdges& edges, int j, int k, int firstCell, int endOfCells,
  std::vector<std::uint32_t>& corners)
{
  const std::array<CellTriangles, 256>& table = cellTriangles();
  forCrossedCells(edges, j, k, firstCell, endOfCells,
    [&](int, int inside, const CellEdges& vertices)
    {
      const CellTriangles& cell = table[static_cast<std::size_t>(inside)];
      for (std::size_t n = 0; n < static_cast<std::size_t>(cell.size); ++n)
      {
        const auto edge = static_cast<std::size_t>(cell.edges[n]);
        corners.push_back(static_cast<std::uint32_t>(vertices[edge]));
      }
    });
}

} // namespace

bool needsDoublePoints(const Grid& grid)
{
  const double largest =
    (grid.firstSample.cwiseAbs() + grid.dimensions.cast<double>().cwiseProduct(grid.spacing))
      .maxCoeff();
  const double finest = 1e-4 * grid.spacing.minCoeff();
  using Single = std::numeric_limits<float>;
  return largest > Single::max() || finest < Single::min() ||
         finest < 0.5 * Single::epsilon() * largest;
}

GridContour::GridContour(const Grid& grid, const LevelEdges& edges, Executor& executor)
  : grid_(grid)
  , edges_(edges)
{
  const int first = -edges.border();
  const Eigen::Vector3i end = grid.dimensions - Eigen::Vector3i::Constant(1 + first);
  corners_.resize(static_cast<std::size_t>(end[2] - first));
  runBlocks(
    corners_.size(), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = first + static_cast<int>(layer);
      // Closed surfaces have about twice as many triangles as vertices.
      const std::size_t vertices =
        edges.inRow(0, first, k + 1).first - edges.inRow(0, first, k).first;
      corners_[layer].reserve(6 * vertices + vertices / 2);
      for (int j = first; j < end[1]; ++j)
      {
        addTriangles(edges, j, k, first, end[0], corners_[layer]);
      }
    },
    executor);
  layerStarts_.assign(1, 0);
  for (const std::vector<std::uint32_t>& layer : corners_)
  {
    layerStarts_.push_back(layerStarts_.back() + layer.size() / 3);
  }
}

void GridContour::takeTriangles(std::int64_t* ids, Executor& executor)
{
  runBlocks(
    corners_.size(), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    { std::copy(corners_[layer].begin(), corners_[layer].end(), ids + 3 * layerStarts_[layer]); },
    executor);
  std::vector<std::vector<std::uint32_t>>().swap(corners_);
}

template <class Real>
void GridContour::place(const EdgeRoots& roots, Real* points, Executor& executor) const
{
  runBlocks(
    edges_.size(), verticesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d position =
          grid_.firstSample + roots.place(edges_[i], i).cwiseProduct(grid_.spacing);
        Eigen::Map<Eigen::Matrix<Real, 3, 1>>(points + 3 * i) = position.template cast<Real>();
      }
    },
    executor);
}

/// Sums twice the vector areas of each vertex's triangles, in units of a voxel, so that no unit of
/// length leaves the range of numbers.
template <class Real>
std::vector<Eigen::Vector3d> GridContour::areasAround(
  const std::int64_t* ids, const Real* points, Executor& executor) const
{
  using Point = Eigen::Map<const Eigen::Matrix<Real, 3, 1>>;
  std::vector<Eigen::Vector3d> sums(edges_.size(), Eigen::Vector3d::Zero());
  const double unit = grid_.spacing.maxCoeff();
  const auto scaled = [unit](const auto& vector) -> Eigen::Vector3d
  {
    return vector.template cast<double>() / unit;
  };
  const std::size_t layers = layerStarts_.size() - 1;
  // The triangles of a layer share vertices with the next one's, but with no others.
  for (std::size_t parity = 0; parity < 2; ++parity)
  {
    runBlocks((layers + 1 - parity) / 2, 1,
      [&](std::size_t n, std::size_t, std::size_t)
      {
        const std::size_t layer = 2 * n + parity;
        for (std::size_t triangle = layerStarts_[layer]; triangle < layerStarts_[layer + 1];
             ++triangle)
        {
          const std::int64_t* corner = ids + 3 * triangle;
          const Point a(points + 3 * corner[0]), b(points + 3 * corner[1]);
          const Point c(points + 3 * corner[2]);
          const Eigen::Vector3d area = scaled(b - a).cross(scaled(c - a));
          for (int i = 0; i < 3; ++i)
          {
            sums[static_cast<std::size_t>(corner[i])] += area;
          }
        }
      },
      executor);
  }
  return sums;
}

template <class Real>
void GridContour::writeNormals(const std::int64_t* ids, const Real* points,
  const std::vector<Eigen::Vector3f>& known, float* normals, Executor& executor) const
{
  const auto set = [normals](std::size_t vertex, const Eigen::Vector3f& normal)
  {
    std::copy_n(normal.data(), 3, normals + 3 * vertex);
  };
  std::vector<std::vector<std::size_t>> left(
    (edges_.size() + verticesPerBlock - 1) / verticesPerBlock);
  runBlocks(
    edges_.size(), verticesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const GridEdge& edge = edges_[i];
        const float along = known[i][edge.axis];
        if (along != 0)
        {
          // The surface is left along its edge, from the sample inside to that outside.
          const float sense = (along > 0) == edge.firstIsInside ? 1.0f : -1.0f;
          set(i, sense * known[i]);
        }
        else
        {
          left[block].push_back(i);
        }
      }
    },
    executor);
  if (std::any_of(left.begin(), left.end(), [](const auto& some) { return !some.empty(); }))
  {
    const std::vector<Eigen::Vector3d> areas = this->areasAround(ids, points, executor);
    runBlocks(
      left.size(), 1,
      [&](std::size_t block, std::size_t, std::size_t)
      {
        for (const std::size_t i : left[block])
        {
          set(i, areas[i].stableNormalized().cast<float>());
        }
      },
      executor);
  }
}

template void GridContour::place(const EdgeRoots&, float*, Executor&) const;
template void GridContour::place(const EdgeRoots&, double*, Executor&) const;
template void GridContour::writeNormals(
  const std::int64_t*, const float*, const std::vector<Eigen::Vector3f>&, float*, Executor&) const;
template void GridContour::writeNormals(
  const std::int64_t*, const double*, const std::vector<Eigen::Vector3f>&, float*, Executor&) const;

} // namespace winding
