// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/SharpVertices.h"

#include "level/FeatureVertex.h"

namespace winding
{

namespace
{

Eigen::Vector3d sampleOf(const GridEdge& edge)
{
  return Eigen::Vector3d(edge.sample[0], edge.sample[1], edge.sample[2]);
}

} // namespace

SharpVertices::SharpVertices(const Grid& grid, const LevelEdges& edges, const EdgeRoots* roots,
  const DualMesh& mesh, Executor& executor)
  : edges_(edges)
  , roots_(roots)
  , mesh_(mesh)
  , size_(grid.spacing / grid.spacing.maxCoeff())
  , places_(mesh.size())
{
  runBlocks(
    mesh.layers(), 1,
    [this](std::size_t layer, std::size_t, std::size_t)
    {
      mesh_.forVertices(layer,
        [this](std::size_t vertex, const DualMesh::Patch& patch)
        {
          const Eigen::Vector3d corner(patch.cell[0], patch.cell[1], patch.cell[2]);
          places_[vertex] =
            corner + (roots_ ? this->placeIn(patch) : Eigen::Vector3d(0.5, 0.5, 0.5));
        });
    },
    executor);
}

/// Returns the place of a vertex in its cell. It is sought in units of the largest spacing, so that
/// voxels have their shape, and no unit of length leaves the range of numbers.
Eigen::Vector3d SharpVertices::placeIn(const DualMesh::Patch& patch) const
{
  const Eigen::Vector3d corner(patch.cell[0], patch.cell[1], patch.cell[2]);
  HermiteCrossing crossings[12];
  for (int n = 0; n < patch.size; ++n)
  {
    const std::size_t edge = patch.edges[static_cast<std::size_t>(n)];
    Eigen::Vector3d place = sampleOf(edges_[edge]) - corner;
    place[edges_[edge].axis] += roots_->fractions[edge];
    const Eigen::Vector3f normal = edges_.isAtBorder(edges_[edge])
                                     ? Eigen::Vector3f(Eigen::Vector3f::Unit(edges_[edge].axis))
                                     : roots_->normals[edge];
    crossings[n] = {place.cwiseProduct(size_), normal.cast<double>()};
  }
  // Patches of one cell keep to boxes of their own, so that they seldom get into each other's way.
  const Bounds cell(Eigen::Vector3d::Zero(), size_);
  Bounds room = cell;
  if (!patch.isAlone)
  {
    room.setEmpty();
    for (int n = 0; n < patch.size; ++n)
    {
      room.extend(crossings[n].position);
    }
  }
  return featureVertex(crossings, static_cast<std::size_t>(patch.size), room).cwiseQuotient(size_);
}

QuadSplit SharpVertices::splitOf(std::size_t edge) const
{
  if (!roots_)
  {
    return QuadSplit::first;
  }
  const int axes[3] = {(edges_[edge].axis + 1) % 3, (edges_[edge].axis + 2) % 3, edges_[edge].axis};
  const Eigen::Vector3d start = sampleOf(edges_[edge]);
  QuadAroundEdge quad;
  for (int n = 0; n < 3; ++n)
  {
    quad.spacing[n] = size_[axes[n]];
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const Eigen::Vector3d& place = places_[mesh_.quad(edge)[corner]];
      quad.corners[corner][n] = place[axes[n]] - start[axes[n]];
    }
  }
  quad.crossing = roots_->fractions[edge];
  return betterSplit(quad);
}

} // namespace winding
