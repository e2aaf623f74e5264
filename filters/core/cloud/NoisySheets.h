// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"
#include "source/DistinctPoints.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/// Planes of noisy sheets that are close to each other, by place.
struct SheetPlanes
{
  std::vector<Eigen::Vector3d> normals; ///< of unit length, in either sense
  std::vector<Eigen::Vector3d> feet;    ///< the places, moved along their normals onto their planes
};

/**
 * Finds the sheet that each place belongs to where noise is about as large as the spacing, and
 * sheets are a few spacings apart. A plane through all neighbours mixes several sheets; here a
 * neighbour counts the less the farther it is from the plane, by a Gaussian a third of a spacing
 * wide, and the plane is found again with these weights (Fleishman et al., Robust moving
 * least-squares fitting with sharp features, 2005). This begins with planes through few and through
 * many neighbours; the one that most neighbours lie on is taken.
 *
 * spacings: by place. The result is the same for any executor. Throws Interrupted.
 */
SheetPlanes sheetPlanes(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, const std::vector<std::size_t>& neighbors,
  Executor& executor);

/// Smooths oriented normals along noisy sheets: each becomes the mean of the normals of neighbours
/// whose planes pass near the place, and then the normal of the plane through neighbours that are
/// near to this plane and have similar normals (Öztireli, Guennebaud, Gross, Feature preserving
/// point set surfaces based on non-linear kernel regression, 2009). Near is 0.7 spacings.
/// Neighbours on other sheets do not count, whose planes pass far away or whose normals are
/// opposite. Senses may change where the neighbours' contradict them. The result is the same for
/// any executor. Throws Interrupted.
std::vector<Eigen::Vector3d> smoothedAlongSheets(const DistinctPoints& places,
  const NeighborGraph& graph, const std::vector<double>& spacings,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor);

} // namespace winding
