// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"
#include "cloud/NormalPatches.h"
#include "cloud/OverlapSigns.h"
#include "cloud/PlacesField.h"
#include "source/DistinctPoints.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/**
 * Finds and judges normals of clouds whose solids may lie in each other. The winding number is
 * k + 1/2 at a wall with k solids around it, and a wall that enters a solid goes on smoothly. Walls
 * within solids that are turned round have 1/2, too, but are cut off from their sheets there.
 *
 * The faults of normals are the mean square of how far w is from k + 1/2 (faultAtWall()), and the
 * costs of cuts: steps between neighbours along one sheet whose normals have opposite senses. The
 * mean is taken over places on one sheet only, away from edges and from walls through each other.
 * A cut around a tenth of n places has some √n steps, and costs about as much as faults of w that
 * are as large as can be at a tenth of all places. Nothing depends on units or on n.
 *
 * All results are the same for any executor. All methods throw Interrupted.
 */
class OverlappingNormals
{
public:
  /// The graph has the most neighbours that planes go through. The places must outlive this, and
  /// must not be noisy (isNoisy()), for noise makes areas too large to say what w is. Takes about
  /// 120 bytes per place.
  OverlappingNormals(const DistinctPoints& places, const NeighborGraph& graph, Executor& executor);

  /// Returns the faults of unit normals, by place: 0.0001 to 0.04 where they are right.
  double faultsOf(const Normals& normals) const;

  /// Normals, and their faults.
  struct Found
  {
    Normals normals;
    double faults = 0;
    /// The faults after turning patches that have an odd number of solids around them. It is far
    /// more where walls go through solids, and about the same where solids do not meet.
    double faultsByParity = 0;
    double withinSolids = 0; ///< the share of places with solids around them
  };

  /// Turns patches of normals (NormalPatches.h) as long as that lowers the faults, beginning with
  /// the senses of normals that are right in part. Several bounds of doubt are tried, and the
  /// normals with the least faults are taken. Takes as much memory again.
  Found improved(const Normals& senses) const;

private:
  double costOf(const NormalPatches::Link& link) const;
  double cutsOf(const Turns& turns) const;
  OverlapSigns signsOf(const NormalPatches::Followers& followers, std::size_t patches) const;

  const DistinctPoints& places_;
  Executor& executor_;
  const std::vector<double> spacings_;
  const Normals planes_; ///< their normals in either sense
  const NormalPatches patches_;
  const PlacesField field_;
};

/// Whether some faults are far more than others, which are the faults of normals that are right.
bool areFarMore(double faults, double others);

} // namespace winding
