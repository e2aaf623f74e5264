#pragma once

#include "base/Bounds.h"
#include "source/Surface.h"

#include <functional>
#include <limits>

namespace winding
{

/**
 * How large a triangle may be for a far field: a large one is near to many samples though most of it
 * is far from each of them, so it is cut in pieces that are not.
 */
struct SplitRule
{
  Bounds region;                                                ///< of the samples
  double longestSide = std::numeric_limits<double>::infinity(); ///< of triangles among the samples

  bool operator==(const SplitRule& other) const
  {
    return longestSide == other.longestSide && region.min() == other.region.min() &&
           region.max() == other.region.max();
  }

  /// Away from the samples sides may be half as long as the distance.
  double allowedFor(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const;
};

/// Whether the rule leaves all triangles whole.
bool leavesWhole(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const std::vector<Triangle>& triangles);

/**
 * Calls visit(a, b, c) for pieces of triangles whose sides are as short as the rule allows, up to a
 * limit: where there would be more than `mostPieces`, the rule is relaxed until there are not.
 *
 * A triangle is cut in two across its longest side, and its pieces again. Sides are cut in the
 * middle by their length alone, so that pieces of neighbours meet vertex to vertex where both are
 * cut.
 */
void forEachPiece(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const std::vector<Triangle>& triangles, std::size_t mostPieces,
  const std::function<void(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)>& visit);

} // namespace winding
