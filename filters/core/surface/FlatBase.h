// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Message.h"
#include "source/Plane.h"
#include "source/Surface.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace winding
{

/// The openings that a base has closed, and those it has left.
struct BasedOpenings
{
  std::size_t closed = 0;
  std::size_t left = 0;
  bool cutsSurface = false; ///< whether the surface reaches beyond the base
};

/// Returns what a user should know of a base, nothing where all is closed.
std::vector<Message> notesOn(const BasedOpenings& openings);

/**
 * A flat base for surfaces that are open on one side, as scans and terrain are. Walls go from the
 * rim to the base, at right angles to it, and a plane closes them (PlaneCap.h).
 *
 * Openings are closed that face the base: the vector area of their lid (½ ∑ p × q) is within 60° of
 * its normal, and a tenth or more of the largest one's that faces it. So holes in a roof, beneath a
 * chin, or at the top of a vase stay what they are. From 20 000 edges on the cap of the base is any
 * that has its rims (Cap.h).
 *
 * Bores stay open: their lower rims are closed, too, which face away from the base. Faces rise from
 * these within 45° of upright, and they are as large, or within a tenth of the height from the
 * lowest vertex. Rims that faces hang from as steeply are left where their piece has others of a
 * tenth of the largest. Rims that lie in the base, up to a millionth of the bounds, are closed.
 *
 * Rims that meet at a vertex go on across the gap between triangles there, the narrowest one first.
 * Where more than 16 meet, or edges count twice, an order of coordinates decides.
 *
 * Faces count as outward. They count as inward if the openings next to the base say so, within a
 * tenth of the surface's height, and walls from there make the larger solid. Openings of less than
 * a hundredth of the largest say nothing. Connected pieces with two large rims or more are judged
 * by themselves, as the inner wall of a ring is, others with all of the surface.
 *
 * Guaranteed: the base depends on the set of triangles, not on the order of these or of vertices.
 */
class FlatBase
{
public:
  /// Takes a plane as planesIn() does, or a direction as directionIn() does, in which the base
  /// touches the surface from outside. After a direction, a number as in "down 0.5" is a distance
  /// from the surface. Throws Refusal for other texts; an empty one is no base.
  explicit FlatBase(const std::string& text);

  bool isNone() const { return !plane_ && direction_.isZero(); }

  /// Returns bounds that are large enough for a surface with these bounds and its base.
  Bounds completed(const Bounds& bounds) const;

  /// Adds walls and base behind a surface's triangles. Throws Interrupted.
  BasedOpenings addTo(Surface& surface, Executor& executor) const;

  /// Returns the text of the same base in coordinates that begin at `origin`, along axes at right
  /// angles with this inverse.
  std::string along(const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const;

private:
  Plane planeBelow(const std::vector<Eigen::Vector3d>& positions) const;

  std::optional<Plane> plane_;
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
  double depth_ = 0; ///< of the base below the surface, along the direction
};

} // namespace winding
