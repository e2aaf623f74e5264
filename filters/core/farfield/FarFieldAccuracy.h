#pragma once

namespace winding
{

/// What the far field does to keep a tolerance.
struct FarFieldAccuracy
{
  int order;     ///< of the expansions
  float theta;   ///< a node and a cell are apart if their radii are at most theta of their distance
  float epsilon; ///< estimated error of w that one node may add to a cell
  /// How many lengths over which a point is spread it must be away to be taken for a pure dipole.
  float spreadMargin = 5;

  /// How many radii a node must be away from a single sample.
  float momentMargin() const { return 2 / theta - 1; }

  /// Whether near points may be summed in single precision, with offsets in double.
  bool allowsSingleSums() const { return order < 7; }

  /// Tolerances below this are for the direct sum: single precision ends here.
  static constexpr double finest = 1e-6;

  /**
   * For a largest absolute error of w over all samples, at least `finest`. Measured on meshes and
   * clouds of all kinds (tests/core/farfield/FarFieldTest.cxx has the figures), the largest errors are mostly a
   * tenth to a half of the tolerance, plus single precision's rounding of what is summed beside points.
   * What the margins leave out, 1 − S (SolidAngle.h), is at most a hundredth of the tolerance times the
   * sum of the shares so far away: one half for a surface, but hundreds beside a heap of points.
   */
  static FarFieldAccuracy of(double tolerance)
  {
    if (tolerance >= 1e-2)
    {
      return {3, 0.7f, 3e-3f, 3.3f};
    }
    if (tolerance >= 1e-3)
    {
      return {5, 0.62f, 1e-3f, 3.7f};
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
