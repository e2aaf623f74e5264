// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/EdgeRoots.h"
#include "source/Surface.h"

namespace winding
{

/// Makes triangles of the surface that crosses edges at their roots. With `isSharp` roots have
/// normals, and the surface has the edges and corners of the source. Throws Interrupted.
Surface surfaceOf(const Grid& grid, const LevelEdges& edges, const EdgeRoots& roots, bool isSharp,
  Executor& executor);

} // namespace winding
