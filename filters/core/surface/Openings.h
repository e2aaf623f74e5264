#pragma once

#include "base/Bounds.h"
#include "base/Message.h"
#include "surface/Boundary.h"

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
  /// Whether the faces look to where the surface would go on behind all of these openings: a closed
  /// surface of the same faces would look inward.
  bool lookInward = false;

  /// Returns whether the openings are so wide that w may be below ½ well behind the surface.
  bool areWide() const { return share > 0.6; }

  /// Returns whether the surface is nearly plane, so that it has no depth to be closed at.
  bool areOfSheet() const { return share >= 0.95; }
};

/// Finds how open a surface is whose triangles have the area `area`.
Openings openingsOf(const BoundaryEdges& boundary, const Surface& surface, double area);

/// Returns what to do about wide openings.
Message openSideAdvice(const Openings& openings);

} // namespace winding
