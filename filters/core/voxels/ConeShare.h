// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace winding
{

/// A triangle that may cross a cone. Its corners are relative to the apex.
struct ConeTriangle
{
  std::array<Eigen::Vector3d, 3> corners;
  std::array<std::int32_t, 3> ids; ///< of its vertices, which triangles share
  std::int32_t multiplicity;       ///< how often it counts
};

/**
 * The share of a tetrahedron, the cone from an apex over a triangle, that is inside a surface of
 * triangles: exact up to rounding.
 *
 * w(x) − w(apex) is the sum of the crossings of the segment from the apex to x. So a triangle, cut
 * off by the cone, changes w in its shadow, which is the cone over its projection from the apex to
 * the face opposite, less the cone over itself. Seen from the apex, the inverse of the depth is
 * linear over a triangle. Where no ray meets two triangles, the share is 1 or 0 by w(apex), and
 * each triangle adds its shadow, times the change of what is inside there.
 *
 * Triangles that overlap as seen from the apex are cut along the lines where they pass through or
 * meet each other, or where one lies on another, so that w before each piece is one number, by the
 * crossings before a point of the piece. Triangles that are seen edge-on, or as narrower than
 * rounding, are left out. What overlaps their neighbors is cut along their edges, for it may pass
 * through them. For a surface that is closed within the cone this holds for any rule and any number
 * of solids through each other. Elsewhere w before a piece is taken to be what it is before that
 * point.
 *
 * Takes time in proportion to the triangles, and to the pairs whose boxes overlap as seen from the
 * apex. Hundreds of triangles that all pass through each other would be cut in n³ pieces. Where
 * that would take far longer than meshes do, the share is the mean over rays from the apex, each
 * exact: 4096 of them, fewer from 1000 polygons on, and 256 from 15 600 on. Of sixty boxes through
 * each other it was as near as 60 000 samples: 0.0014. A cell of more than 16 cones has the work
 * and the rays of 16, and 16 rays for a cone at least.
 */
class ConeShare
{
public:
  /// `isParity` says that w is the parity of crossings, as RayParity.h has it, not their sum.
  ConeShare(const InsideTest& isInside, bool isParity = false)
    : isInside_(isInside)
    , isParity_(isParity)
  {
  }

  /// Returns the share, with rounding below 0 or above 1. `corners` has the face's corners,
  /// relative to the apex, as columns, and a determinant that is not 0; `winding` is w at the
  /// apex, which must lie off the triangles; `cones` is the number of cones that share the work of
  /// a cell.
  double of(const Eigen::Matrix3d& corners, const std::vector<ConeTriangle>& triangles,
    double winding, std::size_t cones);

private:
  /// A corner as seen from the apex: the weights of the face's first two corners, and the inverse
  /// of the depth, which is 1 in the face.
  using Corner = Eigen::Vector3d;

  /// A triangle cut off by the cone, counter-clockwise as seen from the apex.
  struct Polygon
  {
    std::array<Corner, 8> corners;
    int count;
    Eigen::Array2d low, high;             ///< its box
    double doubleArea;                    ///< in units in which the face has 1
    Eigen::Vector3d inverseDepth;         ///< of its plane, as a linear function of (q₁, q₂, 1)
    double rounding;                      ///< of that, as a part of it
    std::array<Eigen::Vector3d, 3> whole; ///< corners of the triangle, as weights
    std::array<std::int32_t, 3> ids;
    bool isTurned; ///< whether the corners of `whole` are clockwise
    int step;      ///< the change of w beyond it
  };
  using Piece = std::vector<Corner>;

  /// A line to cut a polygon along, where that overlaps another one.
  struct Line
  {
    Eigen::Vector3d along;
    std::uint32_t other;
  };

  using Edge = std::pair<std::int32_t, std::int32_t>; ///< its vertices, the lower first

  /// A polygon that overlaps another; `liesOn` says that both lie on each other, so that the one of
  /// the lower number counts as the one before.
  struct Overlap
  {
    std::uint32_t polygon;
    bool liesOn;
  };

  void add(const ConeTriangle& triangle, const Eigen::Matrix3d& weights, bool isInverted);
  void findPairs();
  void cutPair(std::size_t a, std::size_t b);
  void cutAtLostEdges(std::size_t number, std::size_t otherNumber);
  double change(std::size_t polygon, double winding);
  bool isInsideAt(double winding) const;
  double shadowOf(const Corner* corners, std::size_t count, double before, int step) const;
  double before(std::size_t polygon, const Eigen::Vector3d& at, double winding) const;
  static bool isMet(const Polygon& polygon, const Eigen::Vector3d& direction);
  double meanOverRays(double winding, double portion) const;

  /// Counts work, in comparisons of boxes, and returns whether it may go on.
  bool spend(double work)
  {
    left_ -= work;
    return left_ > 0;
  }

  InsideTest isInside_;
  bool isParity_;
  std::vector<Polygon> polygons_;
  std::vector<Edge> lostEdges_; ///< of the triangles that are left out, sorted
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Overlap>> others_; ///< by polygon, those that overlap it
  std::vector<std::vector<Line>> lines_;     ///< by polygon
  double left_ = 0;                          ///< work that may still be done
  std::vector<Piece> pieces_, nextPieces_;
};

} // namespace winding
