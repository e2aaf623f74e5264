// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/Components.h"

#include <vector>

namespace winding
{

/**
 * Closes the components that are closed except for a part, so that it is known which side of them
 * is out: all components whose cap (Cap.h), one for all of their holes, has at most half of their
 * own area. Their caps are appended to the surface's triangles, and the components are marked as
 * closed. So a box without a lid is closed (its cap has a fifth of its area), and so is a tube as
 * long as it is wide; less than half of a sphere is not.
 *
 * `edges` belong to the surface, oriented as it is. Returns, by component, whether it was capped.
 */
std::vector<char> capNearlyClosed(
  Surface& surface, const SurfaceEdges& edges, Components& components);

/// Does the same, and appends the middles of the capped components' own triangles to the surface's
/// vertices: closedComponents() needs them.
void closeNearlyClosed(Surface& surface, const SurfaceEdges& edges, Components& components);

} // namespace winding
