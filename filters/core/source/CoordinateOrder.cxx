#include "source/CoordinateOrder.h"

#include "source/SourceTree.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>

namespace winding
{

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
  const auto compare = [&vertices](std::int32_t i, std::int32_t j)
  {
    return i == j ? 0 : compareCoordinates(vertices[i], vertices[j]);
  };
  // Corners are compared in ascending order, so that reversed triangles stand in the same order.
  const bool isUpward = compare(a[1], a[2]) < 0, isOtherUpward = compare(b[1], b[2]) < 0;
  const Triangle sorted = isUpward ? a : Triangle{a[0], a[2], a[1]};
  const Triangle other = isOtherUpward ? b : Triangle{b[0], b[2], b[1]};
  int result = 0;
  for (std::size_t corner = 0; result == 0 && corner < 3; ++corner)
  {
    result = compare(sorted[corner], other[corner]);
  }
  return result != 0 ? result : int(isOtherUpward) - int(isUpward);
}

OrderedTriangles inCoordinateOrder(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& chain)
{
  // Nearly all comparisons end with the first size, which stands beside the triangle therefore.
  struct Keyed
  {
    double size;
    Triangle triangle;
    std::int32_t multiplicity;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Triangle triangle = lowestFirst(vertices, chain[i]);
    keyed.push_back({std::abs(vertices[triangle[0]][0]), triangle, chain.multiplicity(i)});
  }
  std::sort(keyed.begin(), keyed.end(),
    [&vertices](const Keyed& a, const Keyed& b)
    {
      if (a.multiplicity != b.multiplicity || a.size != b.size)
      {
        return a.multiplicity != b.multiplicity ? a.multiplicity < b.multiplicity : a.size < b.size;
      }
      return compareTriangles(vertices, a.triangle, b.triangle) < 0;
    });
  OrderedTriangles ordered;
  ordered.triangles.reserve(keyed.size());
  ordered.multiplicities.reserve(chain.isOnceEach() ? 0 : keyed.size());
  for (const Keyed& item : keyed)
  {
    ordered.triangles.push_back(item.triangle);
    if (!chain.isOnceEach())
    {
      ordered.multiplicities.push_back(item.multiplicity);
    }
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
  constexpr std::size_t leafSize = 16;
  return SourceTree(cloud.positions, leafSize, executor, isBefore).order();
}

} // namespace winding
