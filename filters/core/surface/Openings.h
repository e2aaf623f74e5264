// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Message.h"
#include "surface/Boundary.h"
#include "surface/Components.h"

#include <string>
#include <vector>

namespace winding
{

/// How far a surface is open on one side, as terrain is from below.
struct Openings
{
  /// The length of the boundary's vector area (½ ∑ p × q over its edges), as a share of the area
  /// of the surface: 0 for closed ones, ½ for half a sphere, 1 for a plane sheet. It is at most 1.
  double share = 0;
  /// The sides of the bounds that large openings lie in, as "y = 0 and z = 2"; none for sheets.
  std::string planes;
  /// Whether the surface would look inward if flat lids closed it (sideBehindLids()).
  bool lookInward = false;

  /// Returns whether the openings are so wide that w may be below ½ well behind the surface.
  bool areWide() const { return share > 0.6; }

  /// Returns whether they leave no room between the surface and its openings for an inside.
  bool boundNothing() const { return share >= 0.75; }

  /// Returns whether the surface is nearly plane, so that it has no depth to be closed at.
  bool areOfSheet() const { return share >= 0.95; }
};

/**
 * Returns 1 if a surface looks outward once flat lids close it, −1 if it looks inward, and 0 if no
 * lids would. All of its boundary must lie in at most three sides of its bounds, of different axes,
 * or within a tenth of the bounds from them. A point in all of these sides sees no volume below the
 * lids; so the volume below the triangles alone, ⅙ ∑ a · (b × c) from there, has the sign
 * (divergence theorem). Less than 0.03 times the area and the size of the bounds is 0, since
 * ragged rims leave about that much unknown.
 */
int sideBehindLids(const BoundaryEdges& boundary, const Surface& surface);

/// A component that is not closed, and its boundary.
struct OpenComponent
{
  std::int32_t component;
  Surface surface; ///< with vertices of its own
  BoundaryEdges edges;
};

/// Returns the components that are not closed and bound something: of four triangles or more.
/// Takes the time of boundaryChain(). Throws Interrupted.
std::vector<OpenComponent> openComponents(
  const Surface& surface, const Components& components, Executor& executor);

/// Finds how open a surface is whose triangles have the area `area`.
Openings openingsOf(const BoundaryEdges& boundary, const Surface& surface, double area);

/// Returns what to do about wide openings.
Message openSideAdvice(const Openings& openings);

} // namespace winding
