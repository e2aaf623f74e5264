// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/PointCloud.h"
#include "source/Surface.h"

namespace winding
{

/**
 * The definition itself, one term after the other, one atan2 per triangle. Every other method is
 * tested and verified against it. It takes O(n) per sample and is slow; see DirectSum.h for the
 * same sum made fast by another formulation.
 *
 * Scalar is double or long double (the calculation's precision; the input is double). There is one
 * area per point of the cloud, which has the lengths over which points are spread, if any.
 */
template <class Scalar> Scalar referenceSum(const Surface& surface, const Eigen::Vector3d& sample);
template <class Scalar>
Scalar referenceSum(
  const PointCloud& cloud, const std::vector<double>& areas, const Eigen::Vector3d& sample);

extern template double referenceSum<double>(const Surface&, const Eigen::Vector3d&);
extern template long double referenceSum<long double>(const Surface&, const Eigen::Vector3d&);
extern template double referenceSum<double>(
  const PointCloud&, const std::vector<double>&, const Eigen::Vector3d&);
extern template long double referenceSum<long double>(
  const PointCloud&, const std::vector<double>&, const Eigen::Vector3d&);

} // namespace winding
