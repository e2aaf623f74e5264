// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/SharpContour.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr std::size_t edgesPerBlock = 4096;

} // namespace

SharpContour::SharpContour(const Grid& grid, const LevelEdges& edges, const EdgeRoots* roots,
  bool areTriangles, Executor& executor)
  : grid_(grid)
  , edges_(edges)
  , areTriangles_(areTriangles)
  , mesh_(grid, edges, executor)
  , vertices_(grid, edges, roots, mesh_, executor)
  , splits_(edges.size(), QuadSplit::first)
  , starts_((edges.size() + edgesPerBlock - 1) / edgesPerBlock + 1)
{
  runBlocks(
    edges.size(), edgesPerBlock,
    [this](std::size_t block, std::size_t first, std::size_t last)
    {
      Start& counts = starts_[block + 1];
      for (std::size_t edge = first; edge < last; ++edge)
      {
        if (!mesh_.isComplete(edge))
        {
          continue;
        }
        splits_[edge] = vertices_.splitOf(edge);
        const bool isFan = splits_[edge] == QuadSplit::fan;
        counts.fan += isFan;
        counts.polygon += isFan ? 4 : areTriangles_ ? 2 : 1;
        counts.corner += isFan ? 12 : areTriangles_ ? 6 : 4;
      }
    },
    executor);
  for (std::size_t block = 0; block < this->blocks(); ++block)
  {
    starts_[block + 1].polygon += starts_[block].polygon;
    starts_[block + 1].corner += starts_[block].corner;
    starts_[block + 1].fan += starts_[block].fan;
  }
  fans_.reserve(starts_.back().fan);
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (splits_[edge] == QuadSplit::fan)
    {
      fans_.push_back(static_cast<std::uint32_t>(edge));
    }
  }
}

/// Calls visit(vertices, count, edge) for each polygon of a block of edges.
template <class Visit> void SharpContour::forPolygons(std::size_t block, const Visit& visit) const
{
  std::size_t fan = mesh_.size() + starts_[block].fan;
  const std::size_t end = std::min(edges_.size(), (block + 1) * edgesPerBlock);
  for (std::size_t edge = block * edgesPerBlock; edge < end; ++edge)
  {
    if (!mesh_.isComplete(edge))
    {
      continue;
    }
    // Corners go around the edge as seen from its end, and around what leaves the inside there.
    const DualMesh::Quad& quad = mesh_.quad(edge);
    const std::size_t from = splits_[edge] == QuadSplit::second ? 1 : 0;
    const std::size_t step = edges_[edge].firstIsInside ? 1 : 3;
    std::size_t corners[4];
    for (std::size_t n = 0; n < 4; ++n)
    {
      corners[n] = quad[(from + n * step) % 4];
    }
    if (splits_[edge] == QuadSplit::fan)
    {
      for (std::size_t n = 0; n < 4; ++n)
      {
        const std::size_t triangle[3] = {fan, corners[n], corners[(n + 1) % 4]};
        visit(triangle, 3, edge);
      }
      ++fan;
    }
    else if (areTriangles_)
    {
      const std::size_t second[3] = {corners[0], corners[2], corners[3]};
      visit(corners, 3, edge);
      visit(second, 3, edge);
    }
    else
    {
      visit(corners, 4, edge);
    }
  }
}

/// The place of a vertex in units of the grid.
Eigen::Vector3d SharpContour::placeOf(std::size_t vertex) const
{
  return vertex < mesh_.size() ? vertices_.places()[vertex]
                               : vertices_.crossing(fans_[vertex - mesh_.size()]);
}

template <class Real> void SharpContour::place(Real* points, Executor& executor) const
{
  runBlocks(
    this->vertices(), edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t vertex = first; vertex < last; ++vertex)
      {
        const Eigen::Vector3d position =
          grid_.firstSample + this->placeOf(vertex).cwiseProduct(grid_.spacing);
        Eigen::Map<Eigen::Matrix<Real, 3, 1>>(points + 3 * vertex) = position.template cast<Real>();
      }
    },
    executor);
}

void SharpContour::writePolygons(std::int64_t* offsets, std::int64_t* ids, Executor& executor) const
{
  runBlocks(
    this->blocks(), 1,
    [&](std::size_t block, std::size_t, std::size_t)
    {
      std::size_t polygon = starts_[block].polygon, corner = starts_[block].corner;
      this->forPolygons(block,
        [&](const std::size_t* vertices, std::size_t count, std::size_t)
        {
          offsets[polygon++] = static_cast<std::int64_t>(corner);
          for (std::size_t n = 0; n < count; ++n)
          {
            ids[corner++] = static_cast<std::int64_t>(vertices[n]);
          }
        });
    },
    executor);
  offsets[this->polygons()] = static_cast<std::int64_t>(this->corners());
}

void SharpContour::writeEdges(std::uint32_t* numbers, Executor& executor) const
{
  runBlocks(
    this->blocks(), 1,
    [&](std::size_t block, std::size_t, std::size_t)
    {
      std::size_t polygon = starts_[block].polygon;
      this->forPolygons(block, [&](const std::size_t*, std::size_t, std::size_t edge)
        { numbers[polygon++] = static_cast<std::uint32_t>(edge); });
    },
    executor);
}

void SharpContour::writeNormals(float* normals, Executor& executor) const
{
  const Eigen::Vector3d units = grid_.spacing / grid_.spacing.maxCoeff();
  runBlocks(
    this->blocks(), 1,
    [&](std::size_t block, std::size_t, std::size_t)
    {
      std::size_t polygon = starts_[block].polygon;
      this->forPolygons(block,
        [&](const std::size_t* vertices, std::size_t count, std::size_t)
        {
          const auto place = [&](int n) -> Eigen::Vector3d
          {
            return this->placeOf(vertices[n]).cwiseProduct(units);
          };
          // A triangle is a quad that ends where it begins.
          const Eigen::Vector3d first = place(0);
          const Eigen::Vector3d last = count == 3 ? first : place(3);
          const Eigen::Vector3d area = (place(2) - first).cross(last - place(1));
          const Eigen::Vector3f normal = area.stableNormalized().cast<float>();
          std::copy_n(normal.data(), 3, normals + 3 * polygon++);
        });
    },
    executor);
}

template void SharpContour::place(float*, Executor&) const;
template void SharpContour::place(double*, Executor&) const;

} // namespace winding
