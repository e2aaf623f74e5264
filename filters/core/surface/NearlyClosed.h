// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/ClosedComponents.h"

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

/// A closed or nearly closed component, and how it lies in others.
struct JudgedComponent
{
  /// How it lies in closed components and, if it is nearly closed itself, in nearly closed ones.
  ClosedComponent lies;
  bool isNearlyClosed;
  /// Whether a closed component has the wrong sense only if nearly closed ones count as closed, or
  /// only if they do not: a cavity in a skin with a hole, say, or a ball in a tub.
  bool isUnclear;

  bool isWrong() const { return lies.isInverted() || lies.isNestedSolid(); }
};

/// Judges all components that are closed or nearly closed; the same for every executor. `isCapped`
/// receives by component whether it is nearly closed. Throws Interrupted.
std::vector<JudgedComponent> judgedComponents(const Surface& surface, const SurfaceEdges& edges,
  const Components& components, std::vector<char>& isCapped, Executor& executor);

} // namespace winding
