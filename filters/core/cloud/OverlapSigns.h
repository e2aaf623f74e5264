// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/// Returns the square of how far `w` at a wall is from k + 1/2, where k is any number of solids
/// around the wall: 0, 1, 2, …
double faultAtWall(double w);

/// Returns the mean fault of winding numbers.
double faultsAtWalls(const Eigen::VectorXd& w);

/**
 * Signs of the patches of a cloud whose solids may lie in each other. shares(m, p) is what patch p
 * gives to w at point m, as for patchSigns(). bonds(p, q) is positive where patches p and q are to
 * have the same sign, and negative where they are to have opposite ones; its size is what it costs
 * if they have not.
 */
class OverlapSigns
{
public:
  OverlapSigns(Eigen::MatrixXd shares, Eigen::MatrixXd bonds);

  /// Returns w at the points for some signs.
  Eigen::VectorXd valuesOf(const Eigen::VectorXd& signs) const { return shares_ * signs; }

  /// Turns one sign, or two that have a bond, as long as that lowers the sum of the mean fault and
  /// the costs. The result is a minimum in this sense, and near to the signs given. It takes
  /// O(n (p + b)) time for n points, p patches and b bonds, in each of up to 50 rounds.
  Eigen::VectorXd improved(Eigen::VectorXd signs) const;

private:
  const Eigen::MatrixXd shares_;
  const Eigen::MatrixXd bonds_;
};

} // namespace winding
