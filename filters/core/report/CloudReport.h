#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "cloud/CloudOrientation.h"

#include <optional>
#include <vector>

namespace winding
{

/// How far the different positions of a cloud are from the nearest others. All are 0 for less than two.
struct Spacing
{
  double smallest = 0;
  double median = 0; ///< of an even number, the larger one of the two in the middle
  double mean = 0;
  double largest = 0; ///< of an outlier, many times the median
};

/// The health of an oriented cloud, as it came in.
struct CloudReport
{
  std::size_t points = 0;
  std::size_t nonFinite = 0; ///< a position or normal is NaN or infinite; all below leaves them out
  std::size_t places = 0;    ///< different positions
  std::size_t duplicates = 0; ///< points beyond the first at their place

  bool hasNormals = false; ///< in every view that has points; else those of the others are ignored
  std::size_t zeroNormals = 0;
  std::size_t nonUnitNormals = 0; ///< neither 0 nor within 1e-3 of length 1

  Spacing spacing;

  /**
   * The share of neighbours with opposite normals: of all pairs of a place and one of its 8 nearest
   * other places, those whose normals are more than 90° apart. The normal of a place is the sum of the
   * unit normals of its points; places where that is 0 are in no pair. 0 where there are no pairs.
   *
   * About ½ where normals point to either side at random; 0 to a few per cent where they agree, for
   * thin parts and sharp edges have such neighbours, too.
   */
  double oppositeNeighbors = 0;

  Bounds bounds; ///< empty without finite points

  /// What the field itself says about the normals, with Voronoi areas; none where no point has a
  /// usable normal, and for less than two places.
  std::optional<CloudOrientation> orientation;
};

/**
 * Views may have any content. O(n log n) time, for the most part on the executor's threads; about 250
 * bytes per point while it runs; the same for any executor, and up to rounding for any order of the
 * points. Throws Refusal when a view's arrays differ in length, Interrupted when the executor was.
 */
CloudReport reportOn(const std::vector<OrientedPointsView>& views, Executor& executor);

} // namespace winding
