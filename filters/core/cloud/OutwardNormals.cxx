#include "cloud/OutwardNormals.h"

#include "cloud/ConsistentNormals.h"

#include <cstdio>
#include <utility>

namespace winding
{

namespace
{

/// Chooses areas unless they came with the cloud, and turns all normals round if their field says
/// that they point inward.
CloudOrientation turnOutward(
  PointCloud& cloud, bool hasOwnAreas, const PointAreaOptions& options, Executor& executor)
{
  if (!hasOwnAreas)
  {
    cloud.areas = pointAreas(cloud, options, executor);
  }
  const CloudOrientation orientation = orientationOf(cloud, executor);
  if (!orientation.isInward())
  {
    return orientation;
  }
  for (Eigen::Vector3d& normal : cloud.normals)
  {
    normal = -normal;
  }
  return orientation.reversed();
}

} // namespace

OutwardNormals giveOutwardNormals(
  PointCloud& cloud, NormalEstimation estimation, const PointAreaOptions& areas, Executor& executor)
{
  const bool hasOwnAreas = !cloud.areas.empty();
  OutwardNormals found;
  if (estimation != NormalEstimation::consistent)
  {
    cloud.normals = estimateNormals(cloud.positions, areas.neighbors, executor);
    found.orientation = turnOutward(cloud, hasOwnAreas, areas, executor);
  }
  // Parts of a tenth of all points may be the wrong way round where the field is clear beside the
  // others. Where the spanning tree is right all the same, as for solids that overlap, its field is
  // the clearer one; where nothing is clear, as for noisy points, that says nothing.
  constexpr double sureShare = 0.98;
  if (estimation == NormalEstimation::spanningTree ||
      (estimation == NormalEstimation::automatic && found.orientation.outward >= sureShare))
  {
    return found;
  }
  const CloudOrientation ofTree = found.orientation;
  std::vector<Eigen::Vector3d> normalsOfTree = std::exchange(cloud.normals, {});
  std::vector<double> areasOfTree = cloud.areas;
  cloud.normals =
    consistentNormals(cloud.positions, areas.neighbors, executor, normalsOfTree).normals;
  found.estimation = NormalEstimation::consistent;
  found.orientation = turnOutward(cloud, hasOwnAreas, areas, executor);
  if (estimation == NormalEstimation::automatic && ofTree.isClear() &&
      ofTree.outward >= found.orientation.outward)
  {
    cloud.normals = std::move(normalsOfTree);
    cloud.areas = std::move(areasOfTree);
    return {NormalEstimation::spanningTree, ofTree};
  }
  return found;
}

std::string adviceOnNormals(const CloudOrientation& orientation)
{
  char figures[200];
  std::snprintf(figures, sizeof figures,
    "w is about 1 behind and 0 before %.0f %% of the points, with medians of %.2f and %.2f",
    100 * orientation.outward, orientation.behind, orientation.before);
  return std::string("take more points, or normals from where the points come from: estimated ones "
                     "do not tell inside from outside everywhere, for ") +
         figures;
}

} // namespace winding
