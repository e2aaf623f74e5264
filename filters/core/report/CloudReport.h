// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "cloud/CloudOrientation.h"

#include <optional>
#include <vector>

namespace winding
{

/// The distances from each of the different positions of a cloud to the nearest other. All are 0
/// for less than two positions.
struct Spacing
{
  double smallest = 0;
  double median = 0; ///< the larger one of the two in the middle if their number is even
  double mean = 0;
  double largest = 0; ///< many times the median if there is an outlier
};

/// The health of an oriented cloud, as it came in.
struct CloudReport
{
  std::size_t points = 0;
  /// The number of points with a position or normal that is NaN or infinite; all figures below
  /// leave them out.
  std::size_t nonFinite = 0;
  std::size_t places = 0;     ///< different positions
  std::size_t duplicates = 0; ///< points beyond the first at their place

  /// Whether every view that has points has normals; if not, the normals of the others are ignored.
  bool hasNormals = false;
  std::optional<std::size_t> equalNormalsExcept; ///< by that function of OutwardNormals.h
  std::size_t zeroNormals = 0;                   ///< normals of length 0
  std::size_t nonUnitNormals = 0; ///< normals whose length is neither 0 nor within 1e-3 of 1

  Spacing spacing;

  /**
   * The share of neighbours with opposite normals: the share of all pairs of a place and one of its
   * 8 nearest other places whose normals are more than 90° apart. The normal of a place is the sum
   * of the unit normals of its points; places where that is 0 are in no pair. The share is 0 where
   * there are no pairs.
   *
   * It is about ½ where normals point to either side at random, and 0 to a few per cent where they
   * agree, since thin parts and sharp edges have these neighbours, too.
   */
  double oppositeNeighbors = 0;

  Bounds bounds; ///< empty without finite points

  /// The orientation of the normals by their own field, with Voronoi areas; none where no
  /// point has a usable normal, and for less than two places.
  std::optional<CloudOrientation> orientation;
};

/**
 * Examines a cloud. Views may have any content. The work takes O(n log n) time, for the most part
 * on the executor's threads, and about 250 bytes per point while it runs. The report is the same
 * for any executor, and up to rounding for any order of the points. Throws Refusal when a view's
 * arrays differ in length and for coordinates out of range (Sanitize.h), Interrupted when the
 * executor was.
 */
CloudReport reportOn(const std::vector<OrientedPointsView>& views, Executor& executor);

} // namespace winding
