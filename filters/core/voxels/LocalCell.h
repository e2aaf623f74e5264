// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "voxels/CellShape.h"

#include <array>
#include <cstddef>
#include <vector>

namespace winding
{

/// The kind of a cell, and what of a source lies in it.
enum class CellState : unsigned char
{
  clear,   ///< nothing of the source is near
  touched, ///< a triangle's box meets the cell's box, or a point is near it
  onRim,   ///< so does an edge of the boundary, around which w takes all values
  flat,
  open, ///< its faces do not close
  nowhere
};

/**
 * A cell in coordinates of its own: from its first point, in units of its box's diagonal. Its faces
 * are cut into triangles, as CellFractions.h says.
 */
class LocalCell
{
public:
  /// Returns what kind of cell it is, `clear` if it has a volume.
  CellState set(const CellShape& shape);

  Eigen::Vector3d local(const Eigen::Vector3d& position) const
  {
    return (position - origin_) / size_;
  }
  Eigen::Vector3d global(const Eigen::Vector3d& position) const
  {
    return origin_ + size_ * position;
  }

  const Bounds& box() const { return box_; }
  const Eigen::Vector3d& middle() const { return middle_; }

  /// Six times the volume, negative for cells that are turned inside out.
  double volume() const { return volume_; }

  std::size_t cones() const { return triangles_.size(); }

  /// The corners of a triangle of the faces, relative to an apex, as columns.
  Eigen::Matrix3d cone(std::size_t triangle, const Eigen::Vector3d& apex) const;

  std::size_t corners() const { return corners_; }
  const Eigen::Vector3d& corner(std::size_t i) const { return points_[i]; }

private:
  bool isPlanar(const int* corners, std::size_t count) const;
  void addFace(const int* corners, std::size_t count);

  Bounds box_;
  Eigen::Vector3d origin_, middle_;
  double size_ = 0, volume_ = 0;
  std::size_t corners_ = 0;
  std::vector<Eigen::Vector3d> points_; ///< corners, and the means of faces
  std::vector<std::array<std::size_t, 3>> triangles_;
};

} // namespace winding
