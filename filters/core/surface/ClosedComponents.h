// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Components.h"

namespace winding
{

/**
 * A closed component as a solid of its own, and how it lies in the others.
 *
 * It lies inside another closed component if the other winds round each of its vertices (w ≠ 0
 * there, exactly, found by counting signed crossings of rays); vertices that it shares with other
 * components are left out. Nearly closed ones, and ones that share all their vertices, lie inside
 * where the other winds round the middles of triangles with most of their area (addMiddles()), for
 * their rims may lie in the caps of others or beyond, as the rim of a pipe's bore does. So a
 * component that pokes out of another one does not lie inside it, and the answer is right for
 * components that do not cross each other.
 */
struct ClosedComponent
{
  std::int32_t component; ///< its number among all components
  int sense; ///< sign of its volume: +1 if oriented outward, 0 if the volume is within rounding
  int depth; ///< number of closed components that it lies inside of
  /// The innermost of these that has a smaller depth itself, by its number among all components;
  /// −1 for none.
  std::int32_t around;

  /// Returns whether the component is oriented inward and lies inside an even number of others, so
  /// that it cannot be a cavity: w inside is −1, or one too small. Inward is right for the wall of
  /// a cavity, which lies inside an odd number of others.
  bool isInverted() const { return sense < 0 && depth % 2 == 0; }

  /// Returns whether the component is oriented outward and lies inside an odd number of others. It
  /// is a solid within a solid, where w is 2, or a cavity whose wall is turned round; nothing
  /// distinguishes which.
  bool isNestedSolid() const { return sense > 0 && depth % 2 == 1; }
};

/// Finds the closed components, in the order of all components; the same for every executor. If
/// there are several, it takes O((n + k) log n) time for n triangles, where k counts the triangles
/// that rays from vertices of nested components meet. Where that would be more than 64 components
/// for each vertex, components are taken not to cross each other. Each is looked for in the next
/// larger ones then, which takes O(n log n) time for nested ones. It takes up to 120 bytes per
/// triangle while it runs. Throws Interrupted.
std::vector<ClosedComponent> closedComponents(
  const Surface& surface, const Components& components, Executor& executor);

} // namespace winding
