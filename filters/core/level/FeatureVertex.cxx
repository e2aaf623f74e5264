// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/FeatureVertex.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace winding
{

namespace
{

constexpr double margin = 1.0 / (1 << 12);

/// The error function's share, relative to its largest eigenvalue, along directions that are
/// dropped. It is there to choose among the points of a cell that are equally good otherwise.
constexpr double shareOfDropped = 1.0 / (1 << 20);

/// A quadratic function by its minimum and its second derivatives.
struct Quadratic
{
  Eigen::Vector3d minimum;
  Eigen::Matrix3d metric;

  double at(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d offset = point - minimum;
    return offset.dot(metric * offset);
  }
};

/// The normal equations of the planes, about the mean of the crossings.
struct PlaneSums
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
  Eigen::Vector3d offsets = Eigen::Vector3d::Zero();
};

PlaneSums sumsOf(const HermiteCrossing* crossings, std::size_t count)
{
  PlaneSums sums;
  for (std::size_t n = 0; n < count; ++n)
  {
    sums.mean += crossings[n].position;
  }
  sums.mean /= static_cast<double>(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    const Eigen::Vector3d& normal = crossings[n].normal;
    for (int j = 0; j < 3; ++j)
    {
      for (int i = j; i < 3; ++i)
      {
        sums.planes(i, j) += normal[i] * normal[j];
      }
    }
    sums.offsets += normal * normal.dot(crossings[n].position - sums.mean);
  }
  sums.planes(0, 1) = sums.planes(1, 0);
  sums.planes(0, 2) = sums.planes(2, 0);
  sums.planes(1, 2) = sums.planes(2, 1);
  return sums;
}

/// Whether planes are so nearly parallel that no eigenvalue but the largest is kept, which is said
/// without finding them, for most patches are flat. Sets the direction that is kept and its
/// eigenvalue.
bool isFlat(const HermiteCrossing* crossings, std::size_t count, const PlaneSums& sums,
  Eigen::Vector3d& direction, double& along)
{
  direction.setZero();
  for (std::size_t n = 0; n < count; ++n)
  {
    const Eigen::Vector3d& normal = crossings[n].normal;
    direction += normal.dot(crossings[0].normal) < 0 ? -normal : normal;
  }
  const double length = direction.norm();
  if (!(length > 0))
  {
    return false;
  }
  direction /= length;
  // The other eigenvalues are not more than what is left of the trace.
  along = direction.dot(sums.planes * direction);
  return sums.planes.trace() - along < leastEigenvalue * along;
}

/// The second derivatives of the error function of planes that are flat.
Eigen::Matrix3d metricOfFlat(const Eigen::Vector3d& direction, double along)
{
  return along * ((1 - shareOfDropped) * direction * direction.transpose() +
                   shareOfDropped * Eigen::Matrix3d::Identity());
}

Quadratic errorFunction(const PlaneSums& sums)
{
  Quadratic error = {sums.mean, Eigen::Matrix3d::Zero()};
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(sums.planes);
  const Eigen::Vector3d& eigenvalues = solver.eigenvalues();
  const double largest = eigenvalues[2];
  if (!(largest > 0))
  {
    error.metric.setIdentity();
    return error;
  }
  for (int n = 0; n < 3; ++n)
  {
    const Eigen::Vector3d direction = solver.eigenvectors().col(n);
    const bool isKept = eigenvalues[n] >= leastEigenvalue * largest;
    if (isKept)
    {
      error.minimum += direction * (direction.dot(sums.offsets) / eigenvalues[n]);
    }
    const double weight = isKept ? eigenvalues[n] : shareOfDropped * largest;
    error.metric += weight * direction * direction.transpose();
  }
  return error;
}

/// The minimum of a function on a face, an edge or a corner of a box: where sides[axis] is 0 or 1
/// the point is at the low or high end of the box, where it is 2 it is free, as at most two are.
Eigen::Vector3d minimumAt(const Quadratic& function, const Eigen::Vector3d& low,
  const Eigen::Vector3d& high, const int (&sides)[3])
{
  const Eigen::Matrix3d& m = function.metric;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  int free[3], count = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (sides[axis] == 2)
    {
      free[count++] = axis;
    }
    else
    {
      offset[axis] = (sides[axis] == 0 ? low[axis] : high[axis]) - function.minimum[axis];
    }
  }
  const Eigen::Vector3d slope = m * offset;
  if (count == 1)
  {
    offset[free[0]] = -slope[free[0]] / m(free[0], free[0]);
  }
  else if (count == 2)
  {
    const int u = free[0], v = free[1];
    const double determinant = m(u, u) * m(v, v) - m(u, v) * m(u, v);
    offset[u] = (m(u, v) * slope[v] - m(v, v) * slope[u]) / determinant;
    offset[v] = (m(u, v) * slope[u] - m(u, u) * slope[v]) / determinant;
  }
  return function.minimum + offset;
}

/// The minimum of a function in a box, which is at one of its faces, edges or corners.
Eigen::Vector3d minimumInBox(
  const Quadratic& function, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  Eigen::Vector3d best = function.minimum.cwiseMax(low).cwiseMin(high);
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 26; ++n) // 26 would be free along all axes
  {
    const int sides[3] = {n % 3, n / 3 % 3, n / 9};
    const Eigen::Vector3d found = minimumAt(function, low, high, sides);
    const Eigen::Vector3d point = found.cwiseMax(low).cwiseMin(high);
    const double error = function.at(point);
    if (point.allFinite() && error < least)
    {
      least = error;
      best = point;
    }
  }
  return best;
}

} // namespace

Eigen::Vector3d featureVertex(
  const HermiteCrossing* crossings, std::size_t count, const Bounds& cell)
{
  const Eigen::Vector3d low = cell.min() + margin * cell.sizes();
  const Eigen::Vector3d high = cell.max() - margin * cell.sizes();
  const auto isInside = [&](const Eigen::Vector3d& point)
  {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
  };
  const PlaneSums sums = sumsOf(crossings, count);
  Eigen::Vector3d direction;
  double along = 0;
  if (isFlat(crossings, count, sums, direction, along))
  {
    const Eigen::Vector3d minimum = sums.mean + direction * (direction.dot(sums.offsets) / along);
    return isInside(minimum) ? minimum
                             : minimumInBox({minimum, metricOfFlat(direction, along)}, low, high);
  }
  const Quadratic error = errorFunction(sums);
  return isInside(error.minimum) ? error.minimum : minimumInBox(error, low, high);
}

} // namespace winding
