#include "PointAreas.h"

#include "UnitScale.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

/// Each position once.
std::vector<Eigen::Vector3d> distinctPositions(const PointCloud& cloud)
{
  std::vector<Eigen::Vector3d> positions = cloud.positions;
  std::sort(positions.begin(), positions.end(),
    [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); });
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

/// The cloud as nanoflann wants to see it, in unit size: squared distances stay within range.
struct ScaledPoints
{
  const std::vector<Eigen::Vector3d>& positions;
  double scale;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return positions[i][axis] * scale; }
  template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};

using PointTree =
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, ScaledPoints>,
    ScaledPoints, 3, std::uint32_t>;

} // namespace

double meanPointArea(const PointCloud& cloud, Executor& executor, int neighbors)
{
  // Among many equal points a search for the nearest would go through all of them.
  const std::vector<Eigen::Vector3d> positions = distinctPositions(cloud);
  const std::size_t points = positions.size();
  if (points < 2)
  {
    return 0;
  }
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(neighbors, 1)), points - 1);
  const ScaledPoints scaled{positions, unitScale(cloud.bounds)};
  const PointTree tree(3, scaled, nanoflann::KDTreeSingleIndexAdaptorParams(16));

  std::vector<double> areas(points);
  constexpr std::size_t pointsPerBlock = 512;
  runBlocks(
    points, pointsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<std::uint32_t> ids(k + 1);
      std::vector<double> squared(k + 1);
      for (std::size_t i = first; i < last; ++i)
      {
        // One more than k: the nearest is the point itself.
        const Eigen::Vector3d query = positions[i] * scaled.scale;
        tree.knnSearch(query.data(), k + 1, ids.data(), squared.data());
        areas[i] = std::accumulate(squared.begin() + 1, squared.end(), 0.0);
      }
    },
    executor);
  const std::size_t kept = points - points / 100;
  std::nth_element(
    areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(kept - 1), areas.end());
  // Sorted before they are summed: the mean must not depend on the order of the points.
  std::sort(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(kept));
  const double sum =
    std::accumulate(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(kept), 0.0);
  constexpr double pi = 3.14159265358979323846;
  const double perPosition =
    pi * sum / (static_cast<double>(kept) * 0.5 * static_cast<double>(k * (k + 1)));
  const double share = static_cast<double>(points) / static_cast<double>(cloud.positions.size());
  return perPosition * share / scaled.scale / scaled.scale;
}

} // namespace winding
