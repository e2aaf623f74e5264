// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/ClosedComponents.h"

#include <vector>

namespace winding
{

/// The most that a cap may have of its component's area if the component's sides are to show. So a
/// box without a lid is closed, with a cap of a fifth, and so is a tube as long as it is wide; less
/// than half of a sphere is not. Caps of just that share are common: rounding must not decide.
constexpr double mostOfNearlyClosed = 0.5 + 1e-9;

/// The most that a cap may have of its component's area if the component is to enclose others as
/// closed ones do: w is about 0.9 in the middle of a sphere with a cap of that share.
constexpr double mostOfTightlyClosed = 0.1;

/**
 * Closes the components that are closed except for a part, so that it is known which side of them
 * is out: all components whose cap (Cap.h), one for all of their holes, has at most `mostOfArea` of
 * their own area. Their caps are appended to the surface's triangles, and the components are marked
 * as closed.
 *
 * `edges` belong to the surface, oriented as it is. Returns, by component, whether it was capped.
 */
std::vector<char> capNearlyClosed(Surface& surface, const SurfaceEdges& edges,
  Components& components, double mostOfArea = mostOfNearlyClosed);

/// A closed or nearly closed component, and how it lies in others.
struct JudgedComponent
{
  /// How it lies in tightly closed components or, if it is none itself, in nearly closed ones.
  ClosedComponent lies;
  bool isNearlyClosed; ///< and not closed
  /// Whether a tightly closed component has the wrong sense only if nearly closed ones count, or
  /// only if they do not, as a ball in a tub has.
  bool isUnclear;

  bool isWrong() const { return lies.isInverted() || lies.isNestedSolid(); }
};

/// Judges all components that are closed or nearly closed; the same for every executor. `isCapped`
/// receives by component whether it is nearly closed. Throws Interrupted.
std::vector<JudgedComponent> judgedComponents(const Surface& surface, const SurfaceEdges& edges,
  const Components& components, std::vector<char>& isCapped, Executor& executor);

} // namespace winding
