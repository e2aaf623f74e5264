// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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

OrderedTriangles inCoordinateOrder(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& chain)
{
  Bounds bounds;
  for (const Triangle& triangle : chain.triangles())
  {
    for (const std::int32_t vertex : triangle)
    {
      bounds.extend(vertices[vertex]);
    }
  }
  const Eigen::Vector3d middle = bounds.isEmpty()
                                   ? Eigen::Vector3d(0, 0, 0)
                                   : Eigen::Vector3d(0.5 * bounds.min() + 0.5 * bounds.max());
  const auto compare = [&](std::int32_t i, std::int32_t j)
  {
    const Eigen::Vector3d &p = vertices[i], &q = vertices[j];
    const int order = compareCoordinates((p - middle).cwiseAbs(), (q - middle).cwiseAbs());
    return order != 0 ? order : compareCoordinates(p, q);
  };
  // Nearly all comparisons end with the first distance, which is therefore stored with the
  // triangle.
  struct Keyed
  {
    double distance;
    Triangle triangle;
    std::int32_t multiplicity;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Triangle triangle = lowestFirst(chain[i], compare);
    const double distance = std::abs(vertices[triangle[0]][0] - middle[0]);
    keyed.push_back({distance, triangle, chain.multiplicity(i)});
  }
  std::sort(keyed.begin(), keyed.end(),
    [&compare](const Keyed& a, const Keyed& b)
    {
      if (a.multiplicity != b.multiplicity || a.distance != b.distance)
      {
        return a.multiplicity != b.multiplicity ? a.multiplicity < b.multiplicity
                                                : a.distance < b.distance;
      }
      return compareTriangles(a.triangle, b.triangle, compare) < 0;
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
