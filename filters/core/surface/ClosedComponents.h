#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Components.h"

namespace winding
{

/**
 * A closed component as a solid of its own, and how it lies in the others.
 *
 * It lies inside another closed component if that winds round each of its vertices (w ≠ 0 there, exactly,
 * found by counting signed crossings of rays), those left out that are vertices of other components as
 * well. So what pokes out of another one does not lie inside it, and of components that do not
 * cross each other the answer is the right one.
 */
struct ClosedComponent
{
  std::int32_t component; ///< its number among all components
  int sense; ///< the sign of its volume, +1 if oriented outward; 0 if that is no more than rounding
  int depth; ///< how many closed components it lies inside of

  /// Oriented inward with nothing around it that it could be a cavity of: w is −1 inside, or is one too
  /// small. Inward inside an odd number of others is right: the wall of a cavity.
  bool isInverted() const { return sense < 0 && depth % 2 == 0; }

  /// Oriented outward inside an odd number of others: a solid where there is one already, w is 2, or a
  /// cavity whose wall is turned round. Nothing tells which.
  bool isNestedSolid() const { return sense > 0 && depth % 2 == 1; }
};

/// In the order of the components; the same for every executor. O((n + k) log n) time if there are
/// several, where k counts the triangles that rays from vertices of nested components meet: nesting has
/// to be a thousand deep to be felt. Up to 60 bytes per triangle while it runs, and 4 for each
/// component around another. Throws Interrupted.
std::vector<ClosedComponent> closedComponents(
  const Surface& surface, const Components& components, Executor& executor);

} // namespace winding
