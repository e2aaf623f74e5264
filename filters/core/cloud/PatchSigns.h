// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/**
 * Chooses a sign for each patch of a cloud such that winding numbers at points of the cloud come
 * near to 1/2, as they are on a surface. shares(m, p) is what patch p gives to w at point m, with
 * the orientation that it has now. Returns 1 for patches that stay as they are, and −1 for those
 * that are to be turned.
 *
 * The sum of squares of w − 1/2 is minimised over all real factors first, then over signs, from
 * the signs of the factors and from all 1: one sign or two at once are turned as long as the sum
 * decreases. The result is a minimum in this sense, and need not be the least of all. It takes
 * O(#points · #patches² + #patches³) time.
 */
Eigen::VectorXd patchSigns(const Eigen::MatrixXd& shares);

} // namespace winding
