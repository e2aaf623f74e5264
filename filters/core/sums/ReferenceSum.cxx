// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/ReferenceSum.h"

#include "base/Pi.h"
#include "sums/SolidAngle.h"

namespace winding
{

namespace
{
constexpr long double fourPi = 4 * piAs<long double>;
}

template <class Scalar> Scalar referenceSum(const Surface& surface, const Eigen::Vector3d& sample)
{
  const Vector3<Scalar> q = sample.cast<Scalar>();
  Scalar sum = 0;
  for (const Triangle& triangle : surface.triangles)
  {
    const Vector3<Scalar> a = surface.vertices[triangle[0]].cast<Scalar>() - q;
    const Vector3<Scalar> b = surface.vertices[triangle[1]].cast<Scalar>() - q;
    const Vector3<Scalar> c = surface.vertices[triangle[2]].cast<Scalar>() - q;
    sum += solidAngle<Scalar>(a, b, c);
  }
  return sum / static_cast<Scalar>(fourPi);
}

template <class Scalar>
Scalar referenceSum(
  const PointCloud& cloud, const std::vector<double>& areas, const Eigen::Vector3d& sample)
{
  const Vector3<Scalar> q = sample.cast<Scalar>();
  Scalar sum = 0;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
  {
    const Vector3<Scalar> offset = cloud.positions[i].cast<Scalar>() - q;
    const double length = cloud.regularizationLengths.empty() ? 0 : cloud.regularizationLengths[i];
    sum += regularizedDipoleSolidAngle<Scalar>(offset, cloud.normals[i].cast<Scalar>(),
      static_cast<Scalar>(areas[i]), static_cast<Scalar>(length));
  }
  return sum / static_cast<Scalar>(fourPi);
}

template double referenceSum<double>(const Surface&, const Eigen::Vector3d&);
template long double referenceSum<long double>(const Surface&, const Eigen::Vector3d&);
template double referenceSum<double>(
  const PointCloud&, const std::vector<double>&, const Eigen::Vector3d&);
template long double referenceSum<long double>(
  const PointCloud&, const std::vector<double>&, const Eigen::Vector3d&);

} // namespace winding
