#include "cloud/OutwardNormals.h"

#include "cloud/ConsistentNormals.h"
#include "cloud/SheetCuts.h"

#include <cstdio>
#include <utility>

namespace winding
{

namespace
{

void roundToSingle(Eigen::Vector3d& normal)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // GCC 12 at -O2 turns pairs of conversions to single precision and back into nothing, unless
    // the number between them is volatile.
    const volatile float single = static_cast<float>(normal[axis]);
    normal[axis] = static_cast<double>(single);
  }
}

/// Gives the cloud normals and, unless they came with it, areas; turns all normals round if their
/// field says that they point inward.
CloudOrientation takeOutward(PointCloud& cloud, std::vector<Eigen::Vector3d> normals,
  bool hasOwnAreas, const PointAreaOptions& options, Executor& executor)
{
  cloud.normals = std::move(normals);
  for (Eigen::Vector3d& normal : cloud.normals)
  {
    roundToSingle(normal);
  }
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
    found.orientation = takeOutward(cloud,
      estimateNormals(cloud.positions, areas.neighbors, executor), hasOwnAreas, areas, executor);
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
  std::vector<Eigen::Vector3d> byTree = std::exchange(cloud.normals, {});
  const bool isTreeClear = estimation == NormalEstimation::automatic && ofTree.isClear();
  const std::vector<Eigen::Vector3d> normals =
    isTreeClear ? byTree : std::vector<Eigen::Vector3d>();
  const std::vector<double> areasByTree = isTreeClear ? cloud.areas : std::vector<double>();
  ConsistentNormals consistent =
    consistentNormals(cloud.positions, areas.neighbors, executor, std::move(byTree));
  found.estimation = NormalEstimation::consistent;
  found.work = consistent.triedPatches ? NormalWork::patches : NormalWork::tree;
  found.orientation =
    takeOutward(cloud, std::move(consistent.normals), hasOwnAreas, areas, executor);
  // Walls inside of another solid, turned round, make the field a little clearer, but wrong.
  constexpr double littleClearer = 0.05;
  const double gain = found.orientation.outward - ofTree.outward;
  if (isTreeClear && (gain <= 0 || (gain < littleClearer &&
                                     cutSheets(cloud.positions, normals, cloud.normals, executor))))
  {
    cloud.normals = normals;
    cloud.areas = areasByTree;
    return {NormalEstimation::spanningTree, ofTree, found.work};
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
