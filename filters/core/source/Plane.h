// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Parameter.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace winding
{

/// The positions x with normal · x = offset; `normal` is a unit vector.
struct Plane
{
  Eigen::Vector3d normal;
  double offset;

  /// Returns the signed distance of a position, which is exact for planes across an axis.
  double height(const Eigen::Vector3d& position) const { return normal.dot(position) - offset; }

  Eigen::Vector3d mirrored(const Eigen::Vector3d& position) const
  {
    return position - 2 * this->height(position) * normal;
  }

  /// Returns the nearest position of the plane, which is exactly in planes across an axis.
  Eigen::Vector3d projected(const Eigen::Vector3d& position) const;
};

/// Returns the corners of bounds.
std::vector<Eigen::Vector3d> cornersOf(const Bounds& bounds);

/// Returns the planes in a text, none for an empty one: "y = 0" or "1 1 0 = 3", which is x + y = 3.
/// Several have blanks, commas or semicolons between them. Throws Refusal that names `subject` and
/// says that it is no `what`.
std::vector<Plane> planesIn(
  const std::string& text, Parameter subject, const std::string& what = "plane");

/// Returns the text of the same planes in coordinates that begin at `origin`, along axes at right
/// angles with this inverse.
std::string textAlong(const std::vector<Plane>& planes, const Eigen::Matrix3d& inverseAxes,
  const Eigen::Vector3d& origin);

} // namespace winding
