// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Message.h"
#include "cloud/CloudOrientation.h"
#include "cloud/NormalEstimation.h"
#include "cloud/PointAreas.h"
#include "cloud/Viewpoints.h"
#include "source/PointCloud.h"

#include <cstddef>
#include <optional>

namespace winding
{

/// The way in which normals were found, and what their own field says of them.
struct OutwardNormals
{
  NormalEstimation estimation = NormalEstimation::spanningTree; ///< never automatic
  CloudOrientation orientation;                                 ///< once turned outward
  double opposed = 0; ///< share of places with opposite neighbours, where viewpoints are several

  /// The share that single places of edges have at most.
  static constexpr double fewOpposed = 0.02;

  /// Whether the field was to be clear and is not. It need not be with viewpoints.
  bool isUnsure() const { return estimation != NormalEstimation::toward && !orientation.isClear(); }
};

/**
 * Gives normals that point outward to a cloud that has none, and areas unless it has them. Normals
 * that it has only look to where each point was seen from, and others take their place. The
 * field that normals and areas make decides what is outward, as a whole.
 *
 * The normals are numbers of single precision, as files and VTK's filters have them, and unit
 * vectors to that precision. The areas belong to the unit vectors that sanitize() makes of them,
 * so that points that were stored with their normals have the same areas when they come back.
 *
 * Normals look toward viewpoints instead, `toward` or of each point, where there are any. The field
 * does not turn them (normalsToward()), which says little where one side alone was seen.
 *
 * Automatic takes the spanning tree where its field is clear nearly everywhere, and otherwise
 * automaticNormals(), which are reported as consistent. The bits are the same for any executor and
 * any order of the points. Takes the time and memory of estimateNormals(), consistentNormals() and
 * pointAreas(). Shows progress within the executor's share. Throws Interrupted, and Refusal as
 * pointAreas() does.
 */
OutwardNormals giveOutwardNormals(PointCloud& cloud, NormalEstimation estimation,
  const Viewpoints& toward, const PointAreaOptions& areas, Executor& executor);

/// Returns what users of a cloud without normals can do, or of one whose normals are all 0.
Message missingNormals(bool areZero = false);

/**
 * Returns how many normals differ from all others by more than a thousandth, at points that lie in
 * no plane across these. Nothing is returned where more than one differs and more than a
 * hundredth, or for a few points. Where there are colours in their place, a surface of one colour
 * has equal normals.
 *
 * Neighbours must lie in no plane either: flat roofs over flat ground do. Takes O(n) time, and
 * DistinctPoints and NeighborSearch where normals are equal. Throws Interrupted.
 */
std::optional<std::size_t> equalNormalsExcept(const PointCloud& cloud, Executor& executor);

/// Returns what to do about normals that are equal except for `except` of them.
Message equalNormals(std::size_t except);

/// Returns what to do where a share of places have neighbours that look the other way, as where
/// scanners see a wall from both sides.
Message opposedNormals(double share);

/// Returns what users can do who ask for estimated normals of points that have some.
Message keptNormals();

/// Returns what users can do about given normals whose field is not clear, with figures.
Message contradictingNormals(const CloudOrientation& orientation);

/// Returns what users of estimated normals can do where their field is not clear, with figures.
Message adviceOnNormals(const CloudOrientation& orientation);

} // namespace winding
