// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Pi.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

/**
 * The part of the plane that is nearer to the origin than to other points: a convex polygon, cut by
 * one perpendicular bisector after the other out of a regular polygon that bounds it.
 */
class VoronoiCell
{
public:
  /// Starts anew from a regular polygon of 16 sides with the area of a circle of this radius.
  void start(double radius)
  {
    static const std::vector<Corner> ofUnitCircle = regularPolygon(16);
    corners_ = ofUnitCircle;
    for (Corner& corner : corners_)
    {
      corner.position *= radius;
    }
    this->findFarthest();
  }

  /// Cuts off the part that is nearer to a point than to the origin; a point at the origin cuts
  /// nothing.
  void cut(const Eigen::Vector2d& point)
  {
    // A bisector cuts nothing if it is farther away than all corners, by more than rounding: so do
    // most points, which come in the order of their distances.
    constexpr double beyondRounding = 1 + 1e-9;
    const double squared = point.squaredNorm();
    if (squared > 4 * beyondRounding * squaredFarthest_)
    {
      return;
    }
    const double half = 0.5 * squared;
    excesses_.clear();
    bool cuts = false;
    for (const Corner& corner : corners_)
    {
      excesses_.push_back(point.dot(corner.position) - half);
      cuts = cuts || excesses_.back() > 0;
    }
    if (!cuts)
    {
      return;
    }
    kept_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      const std::size_t next = i + 1 < corners_.size() ? i + 1 : 0;
      const Corner &from = corners_[i], &to = corners_[next];
      const double before = excesses_[i], after = excesses_[next];
      if (before <= 0)
      {
        kept_.push_back(from);
      }
      if ((before <= 0) != (after <= 0))
      {
        const double t = before / (before - after);
        // A side that begins where the boundary leaves the half-plane is the bisector.
        kept_.push_back(
          {from.position + t * (to.position - from.position), before > 0 && from.isBound});
      }
    }
    corners_.swap(kept_);
    this->findFarthest();
  }

  /// 0 or more, also where rounding leaves nothing of the cell.
  double area() const
  {
    double twice = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      const Eigen::Vector2d& a = corners_[i].position;
      const Eigen::Vector2d& b = corners_[i + 1 < corners_.size() ? i + 1 : 0].position;
      twice += a[0] * b[1] - a[1] * b[0];
    }
    return std::max(0.5 * twice, 0.0);
  }

  /// Whether a side of the polygon at the start remains, where no points bound the cell.
  bool isOpen() const
  {
    for (const Corner& corner : corners_)
    {
      if (corner.isBound)
      {
        return true;
      }
    }
    return false;
  }

  /// Appends the directions in which the cell is open, as angles in [0, 2π): the angles of the
  /// middles of the sides that remain from the start.
  void appendOpenDirections(std::vector<double>& angles) const
  {
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      if (corners_[i].isBound)
      {
        const Eigen::Vector2d twice =
          corners_[i].position + corners_[i + 1 < corners_.size() ? i + 1 : 0].position;
        const double angle = std::atan2(twice[1], twice[0]);
        angles.push_back(angle < 0 ? angle + 2 * pi : angle);
      }
    }
  }

private:
  struct Corner
  {
    Eigen::Vector2d position;
    bool isBound; ///< whether the side to the next corner remains from the polygon at the start
  };

  /// A regular polygon with the area of the unit circle.
  static std::vector<Corner> regularPolygon(int sides)
  {
    const double radius = std::sqrt(2 * pi / sides / std::sin(2 * pi / sides));
    std::vector<Corner> corners;
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2 * pi * (i + 0.5) / sides;
      corners.push_back({{radius * std::cos(angle), radius * std::sin(angle)}, true});
    }
    return corners;
  }

  void findFarthest()
  {
    squaredFarthest_ = 0;
    for (const Corner& corner : corners_)
    {
      squaredFarthest_ = std::max(squaredFarthest_, corner.position.squaredNorm());
    }
  }

  std::vector<Corner> corners_, kept_;
  std::vector<double>
    excesses_; ///< by corner: how far the point's bisector cuts it off, or less than 0
  double squaredFarthest_ = 0; ///< square of the distance of the farthest corner
};

} // namespace winding
