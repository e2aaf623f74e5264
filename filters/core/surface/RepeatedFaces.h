// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// The kind of a face, a triangle or a polygon, among the faces with the same corners in the same
/// cyclic order, whichever way they run.
enum class FaceKind : char
{
  single,   ///< there is no other
  first,    ///< it stands for all of them, and most run as it does
  repeated, ///< it adds nothing to the first, or to the pair
  facing,   ///< as many run either way, and it is the first
  opposite  ///< it is the first of these that runs the other way
};

struct RepeatedFaces
{
  std::vector<FaceKind> kinds;      ///< by triangle
  std::vector<std::int32_t> copies; ///< by triangle: number of its equal faces, itself among them
  std::vector<std::int32_t> groups; ///< by triangle: a number of its equal faces, −1 for single
  std::size_t repeated = 0;         ///< number of repeated faces
  std::size_t pairs = 0;            ///< number of pairs of facing and opposite faces
  std::size_t single = 0;           ///< number of single and first faces

  bool areAny() const { return repeated + pairs > 0; }

  /// Returns whether nothing is left of the surface: all its faces are there as often in one sense
  /// as in the other.
  bool cancelAll() const { return pairs > 0 && single == 0; }
};

/// Returns what to do about a surface that RepeatedFaces::cancelAll() is true for.
inline Message twoSidedAdvice()
{
  return {"every face is there with both senses",
    {{"keep one of each pair", {{Parameter::orientFaces, 1}}}}, "nothing is left of them"};
}

/// Finds the faces that are there more than once. `parts` says which triangles are of one polygon;
/// polygons need not be cut into the same triangles. Takes O(n log n) time.
RepeatedFaces repeatedFaces(const Surface& surface, const PolygonParts& parts);

/**
 * Returns the triangles to leave out so that each face bounds once, by triangle. They are repeated
 * faces, and the opposite ones of pairs in the skin of a solid that was drawn from both sides.
 * Walls between solids that touch, which bound nothing together, stay as a pair of opposite faces,
 * or are left out where there is none.
 *
 * The regions on both sides of a face separate walls from skins (Shells.h), once holes are capped
 * (OddCaps.h), or else without caps, which may lie on faces. Where they do not, pairs that are
 * connected with single faces stay, for they cancel, and so do all of these faces where all that
 * are connected cancel. Of all others one face stays.
 *
 * Closed sets of pairs inside of another solid stay, too: a solid fills a cavity there.
 */
std::vector<char> facesToLeaveOut(const Surface& surface, const SurfaceEdges& edges,
  const RepeatedFaces& faces, const PolygonParts& parts, Executor& executor);

/// Adds the pairs that stay, whose two faces cancel, to the triangles that are left out.
std::vector<char> withWalls(std::vector<char> isLeftOut, const RepeatedFaces& faces);

/// Some triangles of a surface, over all of its vertices.
struct SurfacePart
{
  /// Takes the triangles whose entry of `isChosen` is `choice`.
  SurfacePart(const Surface& surface, const std::vector<char>& isChosen, bool choice);

  /// Returns which triangles are of one polygon. `parts` says so of the surface's triangles.
  PolygonParts partsOf(const PolygonParts& parts) const;

  Surface chain;
  std::vector<std::size_t> numbers; ///< of the triangles in the surface
};

/// Turns triangles of a surface round. `isTurned` says by triangle which.
void turn(Surface& surface, const std::vector<char>& isTurned);

/// Removes triangles from a surface, and vertices that no others use. `isLeftOut` says by triangle
/// which, and is empty for none.
void leaveOut(Surface& surface, const std::vector<char>& isLeftOut);

} // namespace winding
