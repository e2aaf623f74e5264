// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Components.h"

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The solids that a surface is made of: its components (Components.h), each closed one that is
 * oriented inward and lies in others, as the wall of a cavity does (ClosedComponents.h), taken
 * together with the innermost of these. Solids that touch are separate if they look outward.
 *
 * Solids are numbered by their volumes (SourceVolume.h), the largest first, and by their lowest
 * vertices where four digits of these are equal. So the numbers do not depend on the order of the
 * triangles, except for solids that have both in common.
 */
struct SolidParts
{
  std::vector<std::int32_t> ofTriangle; ///< solid of each triangle
  std::size_t count = 0;                ///< number of solids
};

/// Finds the solids; the same for every executor. Takes the time and memory of edgesOf() and
/// closedComponents(). Throws Interrupted.
SolidParts solidPartsOf(const Surface& surface, const PolygonParts& parts, Executor& executor);

} // namespace winding
