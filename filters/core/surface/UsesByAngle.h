// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include <vector>

namespace winding
{

/// Angles that differ by less, in radians, are taken for equal.
constexpr double leastAngle = 1e-6;

/// The use of an edge, and the angle of its triangle around it.
struct AngledUse
{
  double angle;      ///< −π to π
  bool hasDirection; ///< whether the triangle is wide enough for an angle
  SurfaceEdges::Use use;

  /// Returns whether the triangle's normal points to where angles grow.
  bool facesNext() const { return use.sense > 0; }
};

/// Returns the uses of an edge in the order of their angles, and of their triangles where these are
/// equal.
std::vector<AngledUse> usesByAngle(
  const Surface& surface, const SurfaceEdges& edges, const SurfaceEdges::Crowd& crowd);

} // namespace winding
