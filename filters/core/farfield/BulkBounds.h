// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"

#include <vector>

namespace winding
{

/**
 * A box around nearly all points, from which the unit of length is taken where single precision
 * computes. One point a million sizes away would leave it no digits for all others.
 *
 * It is the given bounds of the points, unless the box of the middle nine tenths of the points
 * along each axis has a longest side of less than a sixteenth of theirs. Then it is a cube around
 * the middle with four times that side, but no less than 1e-7 of the bounds. Bounds of fewer than
 * 64 points stay, and where nine tenths of the points are equal. The order of the points does
 * not matter. Takes linear time: a pass over the points mostly, some more where the bounds shrink.
 * Throws Interrupted.
 */
Bounds bulkBounds(
  const std::vector<Eigen::Vector3d>& points, const Bounds& bounds, Executor& executor);

} // namespace winding
