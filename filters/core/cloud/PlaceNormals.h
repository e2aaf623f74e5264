// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"
#include "cloud/PlacesField.h"
#include "source/DistinctPoints.h"

#include <memory>
#include <vector>

/**
 * @file
 * Normals of a cloud's places, found by trying all places in several ways; the one
 * with the least deviation is taken. All of these functions throw Interrupted.
 */
namespace winding
{

/// A cloud whose points have normals: by place, and by how much w deviates from 1/2 there.
struct OrientedPlaces
{
  Normals normals;
  double deviation;
  bool triedPatches;
};

/// Orients a cloud by all ways and takes the one with the least deviation. The graph has at least
/// that number of neighbours; it is given up where it is needed no more. byTree: the normals that
/// the spanning tree gives, by place, or none where they are not known.
OrientedPlaces orientDensely(const DistinctPoints& places,
  std::unique_ptr<const NeighborGraph> graph, const std::vector<double>& spacings,
  std::size_t neighbors, bool isNoisy, Normals byTree, Executor& executor);

/// The normal at each place. Where several points stand at a place, it is the one that comes first
/// by its coordinates, whatever the order of the points.
Normals normalsByPlace(const DistinctPoints& places, const Normals& normals);

/// Turns normals that may have any sense by their patches, unless they fit as they are or as the
/// spanning tree turns them, and one by one in the end where this is asked for.
OrientedPlaces orientByPatches(
  const DistinctPoints& places, Normals normals, bool turnsSinglePoints, Executor& executor);

} // namespace winding
