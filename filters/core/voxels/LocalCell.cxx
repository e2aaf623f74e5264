// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/LocalCell.h"

#include <Eigen/LU>

#include <cmath>

namespace winding
{

namespace
{

/// Cells of less than this part of the cube of their box's diagonal have no volume.
constexpr double leastVolume = 1e-13;

/// Faces are planar whose corners give tetrahedra of less than this part of that cube.
constexpr double leastWarp = 1e-10;

} // namespace

CellState LocalCell::set(const CellShape& shape)
{
  box_.setEmpty();
  bool isFinite = !shape.points.empty();
  for (const Eigen::Vector3d& point : shape.points)
  {
    isFinite = isFinite && point.allFinite();
    box_.extend(point);
  }
  origin_ = isFinite ? shape.points[0] : Eigen::Vector3d::Zero();
  size_ = isFinite ? box_.sizes().stableNorm() : 0;
  if (!isFinite || !std::isfinite(size_))
  {
    return CellState::nowhere;
  }
  if (!shape.isClosed())
  {
    return CellState::open;
  }
  points_.clear();
  triangles_.clear();
  middle_.setZero();
  for (const Eigen::Vector3d& point : shape.points)
  {
    points_.push_back(size_ > 0 ? this->local(point) : Eigen::Vector3d::Zero());
    middle_ += points_.back();
  }
  middle_ /= static_cast<double>(points_.size());
  corners_ = points_.size();
  for (std::size_t face = 0; face < shape.faces(); ++face)
  {
    this->addFace(shape.faceCorners.data() + shape.faceEnds[face],
      std::size_t(shape.faceEnds[face + 1] - shape.faceEnds[face]));
  }
  volume_ = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
  {
    volume_ += this->cone(i, middle_).determinant();
  }
  return std::abs(volume_) > 6 * leastVolume ? CellState::clear : CellState::flat;
}

Eigen::Matrix3d LocalCell::cone(std::size_t triangle, const Eigen::Vector3d& apex) const
{
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i)
  {
    corners.col(i) = points_[triangles_[triangle][std::size_t(i)]] - apex;
  }
  return corners;
}

bool LocalCell::isPlanar(const int* corners, std::size_t count) const
{
  const auto at = [&](std::size_t i) -> const Eigen::Vector3d&
  {
    return points_[std::size_t(corners[i])];
  };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < count; ++i)
  {
    normal += (at(i - 1) - at(0)).cross(at(i) - at(0));
  }
  for (std::size_t i = 1; i < count; ++i)
  {
    if (std::abs(normal.dot(at(i) - at(0))) > leastWarp)
    {
      return false;
    }
  }
  return true;
}

void LocalCell::addFace(const int* corners, std::size_t count)
{
  const auto id = [corners](std::size_t i)
  {
    return static_cast<std::size_t>(corners[i]);
  };
  if (count == 3 || this->isPlanar(corners, count))
  {
    for (std::size_t i = 2; i < count; ++i)
    {
      triangles_.push_back({id(0), id(i - 1), id(i)});
    }
    return;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i)
  {
    mean += points_[id(i)];
  }
  points_.push_back(mean / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    triangles_.push_back({points_.size() - 1, id(i), id(i + 1 < count ? i + 1 : 0)});
  }
}

} // namespace winding
