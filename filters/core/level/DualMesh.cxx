// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/DualMesh.h"

namespace winding
{

namespace
{

/// The corner of an edge's quad at which each cell lies whose edge it is.
constexpr std::array<std::size_t, 12> cornerOfCell = {2, 1, 3, 2, 1, 0, 0, 3, 2, 3, 1, 0};

/// Whether the cell at a corner of an edge's quad lies in the layer below the edge's sample, by the
/// edge's axis.
constexpr bool isBelow[3][4] = {
  {true, true, false, false}, {true, false, false, true}, {false, false, false, false}};

constexpr std::size_t edgesPerBlock = 4096;

} // namespace

DualMesh::DualMesh(const Grid& grid, const LevelEdges& edges, Executor& executor)
  : edges_(edges)
  , first_(-edges.border())
  , ends_(grid.dimensions - Eigen::Vector3i::Constant(1 + first_))
  , layerStarts_(static_cast<std::size_t>(ends_[2] - first_) + 1)
  , quads_(edges.size(), Quad{none, none, none, none})
{
  runBlocks(
    this->layers(), 1,
    [this](std::size_t layer, std::size_t, std::size_t)
    { layerStarts_[layer + 1] = this->fillQuads(layer); },
    executor);
  for (std::size_t layer = 0; layer < this->layers(); ++layer)
  {
    layerStarts_[layer + 1] += layerStarts_[layer];
  }
  runBlocks(
    edges.size(), edgesPerBlock,
    [this](std::size_t, std::size_t first, std::size_t last) { this->addStarts(first, last); },
    executor);
}

/// Numbers the vertices of a layer from 0 on, which the quads get, and returns how many there are.
/// Every cell has corners of its own in the quads around it, so that layers do not wait for each
/// other.
std::size_t DualMesh::fillQuads(std::size_t layer)
{
  std::size_t vertex = 0;
  this->forCells(layer,
    [&](const std::array<int, 3>&, const CellPatches& patches, const CellEdges& edges)
    {
      for (std::size_t n = 0; n < edges.size(); ++n)
      {
        if (patches.ofEdge[n] >= 0)
        {
          quads_[edges[n]][cornerOfCell[n]] =
            static_cast<std::uint32_t>(vertex + static_cast<std::size_t>(patches.ofEdge[n]));
        }
      }
      vertex += static_cast<std::size_t>(patches.count);
    });
  return vertex;
}

/// Adds to the vertices of some edges' quads what the layers below have.
void DualMesh::addStarts(std::size_t firstEdge, std::size_t endOfEdges)
{
  for (std::size_t n = firstEdge; n < endOfEdges; ++n)
  {
    const GridEdge& edge = edges_[n];
    const auto above = static_cast<std::size_t>(edge.sample[2] - first_);
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      std::uint32_t& vertex = quads_[n][corner];
      if (vertex != none)
      {
        const std::size_t layer = above - (isBelow[edge.axis][corner] ? 1 : 0);
        vertex = static_cast<std::uint32_t>(vertex + layerStarts_[layer]);
      }
    }
  }
}

/// The patches of a cell, which depend on the neighbour behind a face that a patch comes to twice.
const CellPatches& DualMesh::patchesOf(const std::array<int, 3>& cell, int inside) const
{
  const CellPatches& patches = cellPatches(inside, AmbiguousFaces::insideApart);
  if (patches.doubledFace < 0)
  {
    return patches;
  }
  const int axis = patches.doubledFace / 2;
  std::array<int, 3> neighbor = cell;
  int& place = neighbor[static_cast<std::size_t>(axis)];
  place += patches.doubledFace % 2 == 0 ? -1 : 1;
  if (place < first_ || place >= ends_[axis])
  {
    return patches;
  }
  const int opposite = patches.doubledFace ^ 1;
  const CellPatches& beside = cellPatches(this->insideOf(neighbor), AmbiguousFaces::insideApart);
  return beside.doubledFace == opposite ? cellPatches(inside, AmbiguousFaces::outsideApart)
                                        : patches;
}

/// The corners of a cell that are inside, as cellPatches() takes them.
int DualMesh::insideOf(const std::array<int, 3>& cell) const
{
  int inside = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    // Corners go around each of two layers.
    const int x = (corner ^ corner >> 1) & 1, y = corner >> 1 & 1, z = corner >> 2;
    inside |= edges_.isSampleInside({cell[0] + x, cell[1] + y, cell[2] + z}) << corner;
  }
  return inside;
}

} // namespace winding
