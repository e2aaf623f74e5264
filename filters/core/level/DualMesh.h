// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/CellPatches.h"
#include "level/CrossedCells.h"
#include "level/LevelEdges.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace winding
{

/**
 * The mesh that is dual to marching cubes' (Nielson, Dual marching cubes, 2004): a vertex for each
 * patch of the surface in a cell of the grid, and a quad for each crossed edge, whose corners are
 * the vertices of the four patches around the edge.
 *
 * Where the corners of a face are inside and outside in turn, inside corners are kept apart. A
 * patch may come to that face twice. If the patch of the neighbour does so, too, both are cut in
 * two by keeping outside corners apart instead (Wenger, Isosurfaces: Geometry, Topology, and
 * Algorithms, 2013): their vertices would share an edge of four quads. A cell with that patch has
 * no other ambiguous face, so nothing else changes.
 *
 * Guaranteed: (1) an edge of the mesh is one of two quads, or of one at the border of the grid; (2)
 * the quads around a vertex make one fan; (3) no two quads have more than an edge in common, and
 * opposite corners of one are opposite corners of no other, so that quads may be cut along any of
 * their diagonals; (4) everything is the same for every executor.
 *
 * Time: linear in the crossed cells. Memory: 16 bytes for each edge.
 */
class DualMesh
{
public:
  /// The corner of a quad that would lie outside the grid.
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Four vertices around an edge, counterclockwise as seen from its end. The first lies before the
  /// edge along both axes across it, the second behind it along the first of these axes, which
  /// follows the edge's own in the order x, y, z, x.
  using Quad = std::array<std::uint32_t, 4>;

  /// A vertex: its cell and the edges that the patch crosses.
  struct Patch
  {
    std::array<int, 3> cell; ///< first corner of the cell
    bool isAlone;            ///< whether the cell has no other patch
    int size;                ///< number of edges, 3 to 12
    CellEdges edges;         ///< the first `size` are valid
  };

  /// Keeps references. The grid and its border together have two samples or more along each axis.
  /// Throws Interrupted.
  DualMesh(const Grid& grid, const LevelEdges& edges, Executor& executor);

  /// The number of vertices.
  std::size_t size() const { return layerStarts_.back(); }

  /// The quad of an edge.
  const Quad& quad(std::size_t edge) const { return quads_[edge]; }

  /// Whether the edge has four cells around it: others have no quad.
  bool isComplete(std::size_t edge) const
  {
    const Quad& corners = quads_[edge];
    return corners[0] != none && corners[1] != none && corners[2] != none && corners[3] != none;
  }

  ///@{
  /// Vertices come by layers of cells. Calls visit(vertex, patch) for all of a layer, in order.
  std::size_t layers() const { return layerStarts_.size() - 1; }
  template <class Visit> void forVertices(std::size_t layer, const Visit& visit) const;
  ///@}

private:
  template <class Visit> void forCells(std::size_t layer, const Visit& visit) const;
  const CellPatches& patchesOf(const std::array<int, 3>& cell, int inside) const;
  int insideOf(const std::array<int, 3>& cell) const;
  std::size_t fillQuads(std::size_t layer);
  void addStarts(std::size_t firstEdge, std::size_t endOfEdges);

  const LevelEdges& edges_;
  int first_;                            ///< first sample along each axis: the border's, or 0
  Eigen::Vector3i ends_;                 ///< behind the last cell along each axis
  std::vector<std::size_t> layerStarts_; ///< first vertex of each layer of cells
  std::vector<Quad> quads_;              ///< by edge
};

template <class Visit> void DualMesh::forCells(std::size_t layer, const Visit& visit) const
{
  const int k = first_ + static_cast<int>(layer);
  for (int j = first_; j < ends_[1]; ++j)
  {
    forCrossedCells(edges_, j, k, first_, ends_[0],
      [&](int i, int inside, const CellEdges& edges)
      {
        const std::array<int, 3> cell = {i, j, k};
        visit(cell, this->patchesOf(cell, inside), edges);
      });
  }
}

template <class Visit> void DualMesh::forVertices(std::size_t layer, const Visit& visit) const
{
  std::size_t vertex = layerStarts_[layer];
  this->forCells(layer,
    [&](const std::array<int, 3>& cell, const CellPatches& patches, const CellEdges& edges)
    {
      Patch found[4];
      for (int patch = 0; patch < patches.count; ++patch)
      {
        found[patch].cell = cell;
        found[patch].isAlone = patches.count == 1;
        found[patch].size = 0;
      }
      for (std::size_t n = 0; n < edges.size(); ++n)
      {
        if (patches.ofEdge[n] >= 0)
        {
          Patch& patch = found[patches.ofEdge[n]];
          patch.edges[static_cast<std::size_t>(patch.size++)] = edges[n];
        }
      }
      for (int patch = 0; patch < patches.count; ++patch)
      {
        visit(vertex++, found[patch]);
      }
    });
}

} // namespace winding
