// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "field/Field.h"

namespace winding
{

/// Largest and root-mean-square difference to the reference, over the samples that were compared.
struct ErrorStatistics
{
  std::size_t samples = 0;
  double max = 0;
  double sumOfSquares = 0;

  void add(double error);
  void add(const ErrorStatistics& other);
  double rms() const;
};

struct Verification
{
  ErrorStatistics everywhere;  ///< samples drawn from the whole grid
  ErrorStatistics nearSurface; ///< samples within two voxels of the source
  /// Samples of both kinds so near to a point of a cloud that its share alone may be 1 or more.
  ErrorStatistics besidePoints;
  std::size_t onSurface = 0; ///< drawn samples of both kinds that were not compared; see verify()
};

/**
 * Compares values with the reference: `samples` random samples of the grid and as many within two
 * voxels of the source (fewer where the grid does not reach the source). The draw depends on the
 * seed and the whole grid only; the samples in the extent are compared, so that
 * the pieces of a grid together compare what the whole does.
 *
 * A sample on the surface has two right values, one for each side, and the reference is one of them
 * or their mean. Samples that lie on it as far as coordinates can decide are therefore counted
 * apart: a triangle is no farther from them than 2⁻⁴⁷ of the largest coordinate of source and grid,
 * which is several times what the methods round coordinates by. Samples that near to a point of a
 * cloud have no right value, unless the cloud is regularized, and are counted apart, too. A value
 * that is not finite, or that the sample's place does not explain, is an error all the same: on one
 * triangle it must differ from the reference by 0, ½ or 1, give or take 0.1; on an edge or a vertex
 * by at most 1, and ½ more for each triangle there.
 *
 * Near a point of a cloud that is not regularized, nearer than √(area/4π), the share of that
 * point alone may be 1 or more, and w is as large as one likes. What is in single precision is
 * rounded by 6e-8 of these values, which exceeds small tolerances, so these samples have statistics
 * of their own and are in no others.
 *
 * Throws Interrupted.
 *
 * valueOf(n) is the value of the n-th sample of the extent.
 */
Verification verify(const Field& field, const Grid& grid, const Extent& extent,
  const std::function<double(std::size_t)>& valueOf, std::size_t samples, unsigned seed,
  Executor& executor);

} // namespace winding
