// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BooleanOperation.h"
#include "base/InsideRule.h"
#include "base/SolidShape.h"
#include "field/Field.h"
#include "level/EdgeRoots.h"
#include "level/ShapedSolid.h"
#include "tasks/ResultNotes.h"
#include "tasks/Sink.h"
#include "tasks/Task.h"

#include <memory>
#include <vector>

namespace winding
{

/// The ways to make the surface of what is inside.
enum class Features
{
  smooth, ///< marching cubes (GridContour.h); edges of the source are cut off inside of voxels
  sharp,  ///< dual contouring (SharpContour.h); edges and corners of the source stay sharp
  voxels  ///< the sides of the voxels around the samples that are inside
};

/// The types of a surface's coordinates.
enum class PointType
{
  automatic, ///< single precision where that separates places (needsDoublePoints())
  float32,
  float64
};

/// The wishes for a surface.
struct SurfaceOptions
{
  InsideTest isInside;
  SolidShape shape; ///< plain for a BooleanTask
  Features features = Features::smooth;
  bool areTriangles = false; ///< whether quads are cut
  bool closesBorder = false; ///< whether what is beyond the grid counts as outside
  bool hasNormals = true;
  bool hasImage = false; ///< whether the samples that are inside are a result, too
  PointType pointType = PointType::automatic;
};

/// The needs of a surface, as they are expected.
struct SurfaceNeeds
{
  double bytes = 0; ///< of memory, for the surface and the work on it
  double edges = 0; ///< of the grid, which the surface crosses
};

/// Returns what makeSurface() is expected to need. Throws OutOfMemory where it is not free, and
/// Interrupted. Where the source's area promises too many vertices, as it does for triangles one
/// behind the other, a coarse grid says more.
SurfaceNeeds claimSurface(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Run& run);

/// The facts about how a surface came about.
struct SurfaceResult
{
  Facing facing;            ///< of the source, where it matters
  std::size_t cavities = 0; ///< that were filled
  DistanceBase distancesFrom = DistanceBase::source;
  std::shared_ptr<const DistanceTree> surfaceTree; ///< null unless distances are from the surface
};

/**
 * Makes the surface between the inside and the outside of a field, or of a shape of its solid, as
 * the executor's share of progress. The arrays are Output::points, offsets and corners, and where
 * they are wanted pointNormals of a smooth surface, polygonNormals of any other one, and inside.
 * Warns of sides, of what the grid loses, and of a surface that is open or empty. Throws
 * Interrupted, and OutOfMemory where the edges are too many.
 */
SurfaceResult makeSurface(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Sink& sink, Run& run);

/// The surface of an operation on solids. It has the arrays of makeSurface(), and
/// Output::operands. Functions throw as these for one solid do.
class BooleanTask
{
public:
  /// Keeps a reference to the grid.
  BooleanTask(const Grid& grid, BooleanOperation operation, const SurfaceOptions& options);

  /// Returns the memory that the next operand, and the result with it, are expected to take.
  double claim(const Field& field, const InsideTest& isInside, Run& run);

  /// Adds an operand, as the executor's share of progress, and warns if it is lost. Keeps no
  /// reference to the field. Returns how its source faces.
  Facing add(const Field& field, const InsideTest& isInside, Run& run);

  /// Makes the surface of the result.
  void run(Sink& sink, Run& run);

private:
  struct Operand
  {
    std::unique_ptr<const LevelEdges> edges;
    EdgeRoots roots;
  };

  const Grid& grid_;
  BooleanOperation operation_;
  SurfaceOptions options_;
  std::vector<Operand> operands_;
  double keptBytes_ = 0, keptEdges_ = 0;
};

} // namespace winding
