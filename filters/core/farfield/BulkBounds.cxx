// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/BulkBounds.h"

#include <algorithm>
#include <array>
#include <functional>
#include <mutex>

namespace winding
{

namespace
{

/// The points that are left out at either end of an axis.
std::size_t twentiethOf(const std::vector<Eigen::Vector3d>& points)
{
  return points.size() / 20;
}

/// Whether the middle nine tenths of the points are certain to have a length of `least` at least
/// along an axis, by the numbers of points in equal parts of the bounds. All lengths are halved:
/// the difference of two very large coordinates may leave the range.
bool areSpread(const std::vector<Eigen::Vector3d>& points, const Bounds& bounds, int axis,
  double leastHalf, Executor& executor)
{
  constexpr std::size_t parts = 64, pointsPerBlock = 65536;
  const double low = 0.5 * bounds.min()[axis], half = 0.5 * bounds.max()[axis] - low;
  if (!(half > 0 && half >= leastHalf))
  {
    return false;
  }
  std::array<std::size_t, parts> counts{};
  std::mutex mutex;
  runBlocks(
    points.size(), pointsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::array<std::size_t, parts> ofBlock{};
      for (std::size_t i = first; i < last; ++i)
      {
        const double part =
          (0.5 * points[i][axis] - low) / half * parts; // 1 / half may be infinite
        ++ofBlock[static_cast<std::size_t>(std::min(std::max(part, 0.0), parts - 1.0))];
      }
      const std::lock_guard<std::mutex> lock(mutex);
      std::transform(counts.begin(), counts.end(), ofBlock.begin(), counts.begin(), std::plus<>());
    },
    executor);
  // The part that holds the n-th point from either end.
  const std::size_t n = twentiethOf(points);
  std::size_t first = 0, last = parts - 1;
  for (std::size_t below = counts[first]; below <= n; below += counts[++first])
  {
  }
  for (std::size_t above = counts[last]; above <= n; above += counts[--last])
  {
  }
  return last > first && static_cast<double>(last - first - 1) * half >= parts * leastHalf;
}

/// The box of the middle nine tenths of the points along each axis.
Bounds middleOf(const std::vector<Eigen::Vector3d>& points)
{
  const auto twentieth = static_cast<std::ptrdiff_t>(twentiethOf(points));
  Bounds middle;
  middle.min() = middle.max() = Eigen::Vector3d::Zero();
  std::vector<double> coordinates(points.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    std::transform(points.begin(), points.end(), coordinates.begin(),
      [axis](const Eigen::Vector3d& point) { return point[axis]; });
    const auto low = coordinates.begin() + twentieth, high = coordinates.end() - 1 - twentieth;
    std::nth_element(coordinates.begin(), low, coordinates.end());
    middle.min()[axis] = *low;
    std::nth_element(low, high, coordinates.end());
    middle.max()[axis] = *high;
  }
  return middle;
}

} // namespace

Bounds bulkBounds(
  const std::vector<Eigen::Vector3d>& points, const Bounds& bounds, Executor& executor)
{
  constexpr std::size_t enough = 64;
  // Coordinates are halved first, since the difference of two very large ones may leave the range.
  const double whole =
    points.size() < enough ? 0 : (0.5 * bounds.max() - 0.5 * bounds.min()).maxCoeff();
  const double leastHalf = whole / 16;
  const auto areSpreadAlong = [&](int axis)
  {
    return areSpread(points, bounds, axis, leastHalf, executor);
  };
  if (whole == 0 || areSpreadAlong(0) || areSpreadAlong(1) || areSpreadAlong(2))
  {
    return bounds;
  }
  const Bounds middle = middleOf(points);
  const double bulk = 4 * (0.5 * middle.max() - 0.5 * middle.min()).maxCoeff();
  if (!(bulk > 0) || 4 * bulk >= whole)
  {
    return bounds;
  }
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(std::max(bulk, 1e-7 * whole));
  const Eigen::Vector3d center = middle.center();
  return {center - half, center + half};
}

} // namespace winding
