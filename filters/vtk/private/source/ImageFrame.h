// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace winding
{

/// The coordinates in which an image is a straight grid: along its axes, from its origin.
/// Sums and products stand here one by one, for the package in Python has the same bits.
struct ImageFrame
{
  /// The inverse of the axes, which are the columns of a matrix, in the order of the indices.
  Eigen::Matrix3d inverseAxes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  ImageFrame() = default;
  ImageFrame(const Eigen::Matrix3d& axes, const Eigen::Vector3d& from)
    : origin(from)
  {
    const Eigen::Vector3d x = axes.col(0), y = axes.col(1), z = axes.col(2);
    const Eigen::Vector3d across = y.cross(z);
    const double volume = x[0] * across[0] + x[1] * across[1] + x[2] * across[2];
    inverseAxes.row(0) = across / volume;
    inverseAxes.row(1) = z.cross(x) / volume;
    inverseAxes.row(2) = x.cross(y) / volume;
  }

  bool operator==(const ImageFrame& other) const
  {
    return inverseAxes == other.inverseAxes && origin == other.origin;
  }

  /// Whether the coordinates are the same as in space.
  bool isStraight() const { return *this == ImageFrame(); }

  /// Whether the axes are left-handed, so that faces look the other way.
  bool isMirrored() const { return inverseAxes.determinant() < 0; }

  Eigen::Vector3d position(const Eigen::Vector3d& inSpace) const
  {
    return this->direction(inSpace - origin);
  }
  /// Returns the position in space of one in these coordinates, up to rounding.
  Eigen::Vector3d inSpace(const Eigen::Vector3d& position) const
  {
    return this->isStraight() ? position
                              : Eigen::Vector3d(inverseAxes.inverse() * position + origin);
  }
  Eigen::Vector3d direction(const Eigen::Vector3d& inSpace) const
  {
    return inSpace[0] * inverseAxes.col(0) + inSpace[1] * inverseAxes.col(1) +
           inSpace[2] * inverseAxes.col(2);
  }
};

} // namespace winding
