#include "farfield/BulkBounds.h"

#include <algorithm>

namespace winding
{

Bounds bulkBounds(const std::vector<Eigen::Vector3d>& points, const Bounds& bounds)
{
  constexpr std::size_t most = 4096, enough = 64;
  if (points.size() < enough)
  {
    return bounds;
  }
  const std::size_t count = std::min(points.size(), most), twentieth = count / 20;
  Bounds middle;
  middle.min() = middle.max() = Eigen::Vector3d::Zero();
  std::vector<double> coordinates(count);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      coordinates[i] = points[i * points.size() / count][axis];
    }
    std::sort(coordinates.begin(), coordinates.end());
    middle.min()[axis] = coordinates[twentieth];
    middle.max()[axis] = coordinates[count - 1 - twentieth];
  }
  // Coordinates are halved first, since the difference of two very large ones may leave the range.
  const double whole = (0.5 * bounds.max() - 0.5 * bounds.min()).maxCoeff();
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
