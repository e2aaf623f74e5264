#pragma once

#include "base/Executor.h"
#include "field/Field.h"
#include "level/DualMesh.h"
#include "level/LevelRoots.h"
#include "level/QuadSplit.h"

#include <vector>

namespace winding
{

/**
 * The places of the vertices of a dual mesh, where the planes through the crossings of their
 * patches meet (FeatureVertex.h): edges and corners of the surface stay sharp.
 *
 * The plane of a crossing is the plane of the triangle which LevelRoots found there. Where there is
 * none it is perpendicular to the gradient of the field; in the border of the grid, to the edge. A
 * crossing without either, where the gradient is 0, has no plane.
 *
 * Guaranteed: vertices lie in their cells, no nearer to other cells than 2⁻¹² of the cell; the bits
 * are the same for every executor.
 *
 * Memory: 24 bytes for each vertex.
 */
class SharpVertices
{
public:
  /// Keeps references. The roots must be done. Throws Interrupted.
  SharpVertices(const Field& field, const Grid& grid, const LevelEdges& edges,
    const LevelRoots& roots, const DualMesh& mesh, Executor& executor);

  /// The vertices in units of the grid, as Grid::inGridUnits() has them.
  const std::vector<Eigen::Vector3d>& places() const { return places_; }

  /// The crossing of an edge with the surface, in units of the grid. It keeps the distance of the
  /// vertices from the samples.
  Eigen::Vector3d crossing(std::size_t edge) const;

  /// How to cut the quad of an edge that has one.
  QuadSplit splitOf(std::size_t edge) const;

private:
  void addGradients(const Field& field, Executor& executor);
  Eigen::Vector3d placeOf(const DualMesh::Patch& patch) const;

  const Grid& grid_;
  const LevelEdges& edges_;
  const LevelRoots& roots_;
  const DualMesh& mesh_;
  Eigen::Vector3d size_;                    ///< of a cell, in units of the largest spacing
  std::vector<std::uint32_t> withGradient_; ///< edges without triangles, ascending
  std::vector<Eigen::Vector3f> gradients_;  ///< unit vectors or 0, for these
  std::vector<Eigen::Vector3d> places_;
};

} // namespace winding
