#include "source/CoordinateOrder.h"

#include "source/SourceTree.h"
#include "source/UnitScale.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr std::size_t leafSize = 16;

} // namespace

void turnToFirstOrder(Eigen::Vector3d (&corners)[3])
{
  const auto isBefore = [&corners](int first, int other)
  {
    int order = 0;
    for (int i = 0; order == 0 && i < 3; ++i)
    {
      order = compareCoordinates(corners[(first + i) % 3], corners[(other + i) % 3]);
    }
    return order < 0;
  };
  const int lower = isBefore(1, 0) ? 1 : 0;
  std::rotate(corners, corners + (isBefore(2, lower) ? 2 : lower), corners + 3);
}

int compareTriangles(
  const std::vector<Eigen::Vector3d>& vertices, const Triangle& a, const Triangle& b)
{
  int result = 0;
  for (std::size_t corner = 0; result == 0 && corner < 3; ++corner)
  {
    result =
      a[corner] == b[corner] ? 0 : compareCoordinates(vertices[a[corner]], vertices[b[corner]]);
  }
  return result;
}

OrderedTriangles inCoordinateOrder(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& chain, Executor& executor)
{
  std::vector<Triangle> turned;
  std::vector<Eigen::Vector3d> centers;
  turned.reserve(chain.size());
  centers.reserve(chain.size());
  for (const Triangle& triangle : chain.triangles())
  {
    const Triangle& t = turned.emplace_back(lowestFirst(vertices, triangle));
    centers.emplace_back(vertices[t[0]] / 3 + (vertices[t[1]] / 3 + vertices[t[2]] / 3));
  }
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    return compareTriangles(vertices, turned[a], turned[b]) < 0;
  };
  std::vector<std::uint32_t> order = SourceTree(centers, leafSize, executor, isBefore).order();
  OrderedTriangles ordered;
  if (!chain.isOnceEach())
  {
    std::stable_sort(order.begin(), order.end(),
      [&chain](std::uint32_t a, std::uint32_t b)
      { return chain.multiplicity(a) < chain.multiplicity(b); });
    ordered.multiplicities.reserve(order.size());
    for (const std::uint32_t i : order)
    {
      ordered.multiplicities.push_back(chain.multiplicity(i));
    }
  }
  ordered.triangles.reserve(order.size());
  for (const std::uint32_t i : order)
  {
    ordered.triangles.push_back(turned[i]);
  }
  return ordered;
}

std::vector<std::uint32_t> coordinateOrder(
  const PointCloud& cloud, const std::vector<double>& areas, Executor& executor)
{
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  {
    const int byNormal = compareCoordinates(cloud.normals[a], cloud.normals[b]);
    if (byNormal != 0 || areas[a] != areas[b])
    {
      return byNormal != 0 ? byNormal < 0 : areas[a] < areas[b];
    }
    const std::vector<double>& lengths = cloud.regularizationLengths;
    return !lengths.empty() && lengths[a] < lengths[b];
  };
  return SourceTree(cloud.positions, leafSize, executor, isBefore).order();
}

} // namespace winding
