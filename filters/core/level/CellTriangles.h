// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace winding
{

/// The triangles of marching cubes in one cell (Lorensen and Cline, 1987).
struct CellTriangles
{
  int size = 0;                      ///< number of corners, three for each triangle
  std::array<signed char, 15> edges; ///< edges of the cell that the corners lie on, in VTK's order
};

/// Returns the triangles of all 256 cells; bit n of the index says whether corner n of the cell is
/// inside, in the order of VTK's hexahedra. Triangles face outward. They make the patches of
/// AmbiguousFaces::insideApart, so neighbouring cells fit together, and equal VTK's.
const std::array<CellTriangles, 256>& cellTriangles();

} // namespace winding
