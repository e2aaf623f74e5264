// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/// The parameters by which the far field keeps a tolerance.
struct FarFieldAccuracy
{
  int order; ///< order of the expansions
  /// A node and a cell are apart if their radii add up to at most theta of their distance.
  float theta;
  float epsilon; ///< estimated error of w that one node may add to a cell
  /// A point that is spread over a length is taken for a pure dipole from this many lengths on.
  float spreadMargin = 5;

  /// A node acts on a single sample through its moments from this many of its radii on.
  float momentMargin() const { return 2 / theta - 1; }

  /// Whether near points may be summed in single precision, with offsets in double.
  bool allowsSingleSums() const { return order < 7; }

  /// Tolerances below this are for the direct sum: single precision ends here.
  static constexpr double finest = 1e-6;

  /**
   * The parameters for a tolerance, the largest absolute error of w over all samples, at least
   * `finest`. Measured on meshes and clouds of all kinds (tests/core/farfield/FarFieldTest.cxx has
   * the figures), the largest errors are mostly a tenth to a half of the tolerance, plus single
   * precision's rounding of what is summed near points. Points taken for pure dipoles lose
   * 1 − S (SolidAngle.h) of their shares, at most a hundredth of the tolerance times the sum of
   * these shares: that sum is one half for a surface, but hundreds near a heap of points.
   */
  static FarFieldAccuracy of(double tolerance)
  {
    if (tolerance >= 1e-2)
    {
      return {3, 0.7f, 2.4e-3f, 3.3f};
    }
    if (tolerance >= 1e-3)
    {
      return {5, 0.62f, 5e-4f, 3.7f};
    }
    if (tolerance >= 1e-4)
    {
      return {5, 0.47f, 3e-5f, 4.2f};
    }
    if (tolerance >= 1e-5)
    {
      return {7, 0.5f, 2e-6f, 4.5f};
    }
    return {9, 0.5f, 2e-7f, 4.8f};
  }
};

} // namespace winding
