// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"

#include <vector>

namespace winding
{

/**
 * Moves points onto others that are no farther away than `tolerance`, so that slits close: between
 * files of one body, or where a program has rounded. Coordinates have the unit of the points; a
 * tolerance of 0 moves none.
 *
 * Places are taken in an order that depends on positions only (DistinctPoints.h). Each moves to the
 * nearest place before it that has stayed, or stays itself. So no point moves by more than the
 * tolerance, and none that have stayed are nearer than that to each other. NaN and infinite points
 * stay what they are. Takes linear time where few points stay within a tolerance of another.
 *
 * Returns for each view its points, packed. The same for every executor. Throws Interrupted, and
 * Refusal for more than 2³² − 1 points.
 */
std::vector<std::vector<double>> snappedPoints(
  const std::vector<VectorsView>& points, double tolerance, Executor& executor);

} // namespace winding
