// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BooleanOperation.h"
#include "base/InsideRule.h"
#include "base/SolidShape.h"
#include "diagnosis/ResultVolume.h"
#include "diagnosis/ResultWalls.h"
#include "field/Field.h"
#include "level/EdgeRoots.h"
#include "level/ShapedSolid.h"
#include "tasks/ResultNotes.h"
#include "tasks/Sink.h"
#include "tasks/Task.h"

#include <cstdint>
#include <memory>
#include <string>
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
  bool mendsSource = false;  ///< whether sources are mended (MendedSource.h), and the border closed
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
 * isClosed, parts, volume and inputVolume are single numbers.
 * Warns of sides, of what the grid loses, and of a surface that is open or empty. Throws
 * Interrupted, and OutOfMemory where the edges are too many.
 */
SurfaceResult makeSurface(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Sink& sink, Run& run);

/// Returns what a surface encloses in words, by the single numbers of its task: "1 part, volume 0.5
/// (input 0.51)". An `inputVolume` of NaN is left out.
std::string solidInWords(bool isClosed, std::int64_t parts, double volume, double inputVolume);

/// The surface of an operation on solids. It has the arrays of makeSurface(), and
/// Output::operands, without inputVolume. Functions throw as these for one solid do.
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
    std::unique_ptr<const ShapedSolid> plate; ///< that an open sheet became; null for none

    const LevelEdges& shown() const { return plate ? plate->edges() : *edges; }
    const EdgeRoots& shownRoots() const { return plate ? plate->roots() : roots; }
  };

  void keepPlate(
    const Field& field, double plate, std::unique_ptr<const LevelEdges> edges, Run& run);
  void keep(Operand operand);

  bool mayBound(const Eigen::Vector3d& point) const;

  const Grid& grid_;
  BooleanOperation operation_;
  SurfaceOptions options_;
  std::vector<Operand> operands_;
  ResultWalls walls_;
  ResultVolume volume_;
  bool isAnyLost_ = false; ///< whether the grid shows nothing of an operand
  double keptBytes_ = 0, keptEdges_ = 0;
};

} // namespace winding
