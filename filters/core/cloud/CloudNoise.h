// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"
#include "source/DistinctPoints.h"

#include <vector>

/**
 * @file
 * The spacing of a cloud's places, and how far noise moves them, by the planes of few neighbours.
 */
namespace winding
{

/// Neighbours of the smallest planes, by which spacings and noise are measured.
constexpr std::size_t fewNeighbors = 8;

/// The distance of each place from others: the square root of its area, which is the area of the
/// circle through a near neighbour, for each place in it.
std::vector<double> spacingsOf(const DistinctPoints& places, const NeighborGraph& graph);

/// Whether points are scattered about their surface. Small planes of noisy points deviate by 0.3
/// spacings and more nearly everywhere; places of clean ones do so in some places only, at edges
/// and thin parts. Throws Interrupted.
bool isNoisy(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, Executor& executor);

/// The deviation from planes, in spacings, that a share of all places stays below.
double quantileInSpacings(
  std::vector<double> deviations, const std::vector<double>& spacings, double share);

} // namespace winding
