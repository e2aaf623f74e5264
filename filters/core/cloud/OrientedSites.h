// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/DistinctPoints.h"
#include "source/PointCloud.h"

#include <vector>

namespace winding
{

/// Whether two unit normals are within 70 degrees of each other. Neighbours on one side of a
/// surface have similar normals; points on the two sides of a thin part or around an edge have not.
inline bool areSimilar(const Eigen::Vector3d& normal, const Eigen::Vector3d& other)
{
  return normal.dot(other) > 0.34202014332566873; // cos 70°
}

/// Points at one place with similar normals, seen as one.
struct OrientedSite
{
  Eigen::Vector3d normal; ///< mean of the points' normals, made unit length
  std::uint32_t points;   ///< number of points
};

/**
 * The sites of an oriented cloud: each place has as many as its points have different orientations.
 * Every normal is similar to the normal of the first point of its site, and normals of first points
 * are not similar to each other, so that a place has nine sites at most. First is the point whose
 * normal comes first by compareCoordinates(). Guaranteed: the sites are the same for any executor,
 * and do not depend on the order of the points.
 */
class OrientedSites
{
public:
  /// Takes linear time where few points are at one place; 36 bytes per site and place, and 4 per
  /// point. Throws Interrupted.
  OrientedSites(const PointCloud& cloud, const DistinctPoints& places, Executor& executor);

  ///@{
  /// The sites of a place.
  std::size_t begin(std::size_t place) const { return starts_[place]; }
  std::size_t end(std::size_t place) const { return starts_[place + 1]; }
  ///@}

  std::size_t size() const { return sites_.size(); }
  const OrientedSite& operator[](std::size_t site) const { return sites_[site]; }

  /// The site of a point.
  std::size_t siteOf(std::size_t point) const { return siteOf_[point]; }

  /// Whether there is a site at a place with a normal similar to this one.
  bool hasSimilar(std::size_t place, const Eigen::Vector3d& normal) const
  {
    for (std::size_t site = this->begin(place); site < this->end(place); ++site)
    {
      if (areSimilar(sites_[site].normal, normal))
      {
        return true;
      }
    }
    return false;
  }

private:
  std::vector<OrientedSite> sites_;
  std::vector<std::uint32_t> starts_; ///< first site of each place, and the end of the last place's
  std::vector<std::uint32_t> siteOf_;
};

} // namespace winding
