// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"

#include <cstddef>
#include <vector>

namespace winding
{

class Field;
class ProbeQueries;

/// The bytes that cutDistances() takes for each sample, its result included. What it takes for the
/// samples of cells that are cut comes in addition.
constexpr double bytesPerSampleOfCuts = 9;

/// Returns the memory that cutDistances() is expected to take in addition to the field at `samples`
/// samples: cells that are cut have about as many as a surface crosses in a grid of that size.
std::size_t bytesOfCutDistances(const Field& field, std::size_t samples);

/**
 * Numbers at the points of data sets, more than 0 at those that are kept and less than 0 at the
 * others, by which a clip that interpolates along edges finds where what is kept ends. `kept` has
 * an entry for each sample.
 *
 * The size of a number is the distance from that end, to first order: the smaller one of the
 * distance to the source's triangles or points, where w jumps or is steep, and of
 * |w − threshold| / |∇w|, a step of Newton's method towards the level, which ends what is kept
 * across holes and between the points of a cloud. So the numbers fall evenly towards a plane end. w
 * itself is the same everywhere on either side of one, and its interpolation half way along every
 * edge.
 *
 * Only the points of cells that are cut are evaluated; all others get 1 or −1. No number is 0.
 * Throws Interrupted, and OutOfMemory before anything is evaluated.
 */
std::vector<double> cutDistances(const Field& field, const ProbeQueries& queries,
  const unsigned char* kept, const InsideTest& isInside, Executor& executor);

} // namespace winding
