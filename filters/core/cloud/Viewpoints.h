// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace winding
{

/**
 * The places from which points were seen, so that their normals look there: one position or
 * several, as a scanner's, or a direction, as up for points from the air. Of several positions each
 * point takes the nearest.
 */
class Viewpoints
{
public:
  /// No viewpoints: the field decides what is outward.
  Viewpoints() = default;

  /// Takes positions "x y z; x y z; …", a direction "direction x y z", or one of the words up,
  /// down, +x, -x, +y, -y, +z and -z. An empty text has none. Throws Refusal for other texts.
  explicit Viewpoints(const std::string& text);

  bool empty() const { return positions_.empty() && direction_.isZero(); }

  /// Returns whether there are several, which may see a wall from both sides.
  bool areSeveral() const { return positions_.size() > 1; }

  /// Returns the text of the same viewpoints in coordinates that begin at `origin`, along axes with
  /// this inverse.
  std::string textAlong(const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const;

  /// Returns the unit vectors from places to their viewpoints; 0 at a viewpoint itself.
  std::vector<Eigen::Vector3d> directionsFrom(
    const DistinctPoints& places, Executor& executor) const;

private:
  std::vector<Eigen::Vector3d> positions_;
  Eigen::Vector3d direction_ = Eigen::Vector3d::Zero();
};

/// The normals of points, by point, and the share of places that have two or more of their nearest
/// eight neighbours in the same plane look the other way.
struct SeenNormals
{
  std::vector<Eigen::Vector3d> normals;
  double opposed = 0;
};

/**
 * Estimates unit normals that look to `directions`, by place, of planes through each place and its
 * neighbours, as estimateNormals() finds them. Planes that are seen at a grazing angle, within 15°,
 * say little; their senses are handed on from neighbours, as estimateNormals() does it, beginning
 * with the others. A piece of the graph without others keeps what its clearest plane says. The bits
 * are the same for any executor and any order of the points. Throws Interrupted.
 */
SeenNormals normalsToward(const std::vector<Eigen::Vector3d>& directions,
  const DistinctPoints& places, int neighbors, Executor& executor);

} // namespace winding
