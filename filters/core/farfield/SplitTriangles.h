#pragma once

#include "base/Bounds.h"
#include "source/Surface.h"

#include <functional>
#include <limits>

namespace winding
{

/**
 * The rule for how large a triangle of a far field may be. A large triangle is near to many samples
 * though most of it is far from each of them, so it is cut in pieces that are not.
 */
struct SplitRule
{
  Bounds region;                                                ///< box of the samples
  double longestSide = std::numeric_limits<double>::infinity(); ///< limit among the samples

  bool operator==(const SplitRule& other) const
  {
    return longestSide == other.longestSide && region.min() == other.region.min() &&
           region.max() == other.region.max();
  }

  /// The longest side that a triangle may have: `longestSide` or, if that is more, half its
  /// distance from the samples.
  double allowedFor(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const;
};

/// Whether the rule leaves all triangles whole.
bool leavesWhole(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const std::vector<Triangle>& triangles);

/**
 * Cuts triangles in pieces whose sides are no longer than the rule allows, and calls
 * visit(a, b, c) for each piece. Where there would be more than `mostPieces`, the rule is relaxed
 * until there are not.
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
