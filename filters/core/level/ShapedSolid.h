// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/SolidShape.h"
#include "field/Field.h"
#include "level/EdgeRoots.h"
#include "level/FilledCavities.h"

#include <cstddef>
#include <memory>

namespace winding
{

/// The origins of the distances of a shape.
enum class DistanceBase
{
  source,  ///< all triangles of the source
  surface, ///< the solid's surface, as the grid shows it
};

/// Returns whether a shape is a shell about the triangles of an open source, whose inside does not
/// matter then.
bool isSheet(const FieldInfo& info, const SolidShape& shape);

/**
 * The shape of a solid, as edges of a grid and their roots.
 *
 * Distances are measured from the triangles of the source where these are the solid's surface: the
 * source is closed, and each triangle has the inside on one side only, a 1024th of a voxel away
 * from points of it. These are two voxels apart, or farther where there would be more than a
 * million. A shell about a sheet, which is centered and moved by 0, is measured from the triangles
 * of any open source; its inside does not matter. In all other cases distances are from the solid's
 * surface as a grid shows it, smooth or sharp: of clouds, of solids that overlap, of filled
 * cavities, of holes that the field closes. Where the grid reaches far beyond the source, that is
 * another grid, of as many voxels over the source alone. If that leaves a filled cavity open, or
 * has another one, the given grid decides, and distances are from the surface on it.
 *
 * Guaranteed: the bits are the same for every executor.
 */
class ShapedSolid
{
public:
  /// Makes the shape of the solid of a field that has this `tolerance`. `solid` and `roots` are its
  /// edges, which are done, and their roots; with `isSharp` they have normals of all triangles.
  /// Keeps references to `grid`, `solid` and `roots`. Throws Interrupted.
  ShapedSolid(const Field& field, const Grid& grid, const InsideTest& isInside, double tolerance,
    const LevelEdges& solid, const EdgeRoots& roots, const SolidShape& shape, bool isSharp,
    Executor& executor);

  /// Returns the memory of the shape of a solid whose surface crosses `edges` edges, in addition to
  /// that surface, in bytes.
  static double bytesFor(
    const Field& field, const Grid& grid, const SolidShape& shape, double edges);

  const LevelEdges& edges() const { return *edges_; }
  const EdgeRoots& roots() const { return *roots_; }
  std::size_t cavities() const { return filled_ ? filled_->count : 0; }

  /// Whether gaps stay open, since the border of the grid is too near the surface.
  bool isTight() const { return filled_ && filled_->isTight; }

  /// The origin of the distances.
  DistanceBase base() const { return base_; }

  /// The tree of the surface that distances are measured from; null unless base() is that.
  const std::shared_ptr<const DistanceTree>& surfaceTree() const { return surfaceTree_; }

private:
  void move(const Field& field, const Grid& grid, const InsideTest& isInside, double tolerance,
    const LevelEdges& solid, const SolidShape& shape, bool isSharp, Executor& executor);

  std::unique_ptr<const FilledCavities> filled_;
  std::unique_ptr<const LevelEdges> movedEdges_;
  EdgeRoots movedRoots_ = EdgeRoots(0);
  const LevelEdges* edges_;
  const EdgeRoots* roots_;
  DistanceBase base_ = DistanceBase::source;
  std::shared_ptr<const DistanceTree> surfaceTree_;
};

} // namespace winding
