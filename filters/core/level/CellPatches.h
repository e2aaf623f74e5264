// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace winding
{

/// The pieces of a surface in one cell of a grid, which are discs: loops of crossed edges around
/// the cell.
struct CellPatches
{
  int count = 0;                      ///< number of patches, 0 to 4
  std::array<signed char, 12> ofEdge; ///< patch of each edge, in VTK's order; -1 if not crossed
  /// A face on which all four edges are crossed and belong to one patch, which comes to it twice;
  /// -1 if there is none. No cell has two.
  int doubledFace = -1;
};

/// How the four crossed edges of a face are joined whose corners are inside and outside in turn.
enum class AmbiguousFaces
{
  insideApart, ///< around each inside corner
  outsideApart ///< around each outside corner
};

/// The patches of a cell; bit n of `inside` says whether its corner n is inside, in the order of
/// VTK's hexahedra.
const CellPatches& cellPatches(int inside, AmbiguousFaces rule);

/// The corners of a cell's face, one after the other around it. Faces come in the order low and
/// high x, low and high y, low and high z.
const std::array<int, 4>& cornersOfFace(int face);

} // namespace winding
