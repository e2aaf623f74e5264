#include "SurfaceReport.h"

#include "DistinctPoints.h"
#include "Edges.h"
#include "UnitScale.h"

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

/// Disjoint sets of 0 … n − 1.
class UnionFind
{
public:
  explicit UnionFind(std::size_t count)
    : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  std::int32_t find(std::int32_t item)
  {
    while (parent_[item] != item)
    {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  /// Returns whether they were apart.
  bool unite(std::int32_t a, std::int32_t b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<std::int32_t> parent_;
};

std::size_t countDuplicates(const Surface& surface)
{
  std::vector<Triangle> sorted = surface.triangles;
  for (Triangle& triangle : sorted)
  {
    std::sort(triangle.begin(), triangle.end());
  }
  std::sort(sorted.begin(), sorted.end());
  const auto unique = std::unique(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - unique);
}

std::size_t countVertexComponents(const Surface& surface)
{
  UnionFind pieces(surface.vertices.size());
  std::size_t count = surface.vertices.size();
  for (const Triangle& triangle : surface.triangles)
  {
    count -= pieces.unite(triangle[0], triangle[1]);
    count -= pieces.unite(triangle[1], triangle[2]);
  }
  return count;
}

} // namespace

EdgeCounts countEdges(const Surface& surface)
{
  EdgeCounts counts;
  counts.components = surface.triangles.size();
  UnionFind pieces(surface.triangles.size());
  UnionFind rims(surface.vertices.size());
  std::vector<std::int32_t> rimVertices;
  SerialExecutor executor;
  EdgeUses(surface, executor)
    .forEachEdge(
      [&](std::int32_t low, const EdgeUse* first, const EdgeUse* last)
      {
        std::ptrdiff_t net = 0;
        for (const EdgeUse* use = first; use != last; ++use)
        {
          net += use->sense();
          counts.components -= pieces.unite(first->triangle(), use->triangle());
        }
        const std::ptrdiff_t used = last - first;
        ++counts.edges;
        counts.netBoundary += net != 0;
        counts.nonManifold += used > 2;
        counts.inconsistent += used == 2 && net != 0;
        if (used == 1)
        {
          ++counts.boundary;
          rims.unite(low, first->high());
          rimVertices.push_back(low);
        }
      });
  for (std::int32_t& vertex : rimVertices)
  {
    vertex = rims.find(vertex);
  }
  std::sort(rimVertices.begin(), rimVertices.end());
  counts.boundaryLoops = static_cast<std::size_t>(
    std::unique(rimVertices.begin(), rimVertices.end()) - rimVertices.begin());
  return counts;
}

SurfaceReport reportOn(const Surface& surface)
{
  SurfaceReport report;
  report.edges = countEdges(surface);
  report.vertexComponents = countVertexComponents(surface);
  report.duplicateTriangles = countDuplicates(surface);
  const Eigen::Vector3d center =
    surface.bounds.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(surface.bounds.center());
  for (const Triangle& triangle : surface.triangles)
  {
    // Only the volume is taken from the centre: its rounding would give area to points on a line.
    const Eigen::Vector3d& a = surface.vertices[triangle[0]];
    const Eigen::Vector3d& b = surface.vertices[triangle[1]];
    const Eigen::Vector3d& c = surface.vertices[triangle[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    report.zeroAreaTriangles += normal == Eigen::Vector3d::Zero();
    report.area += 0.5 * normal.norm();
    report.volume += (a - center).dot(normal) / 6;
  }
  report.eulerCharacteristic = static_cast<long long>(surface.vertices.size()) -
                               static_cast<long long>(report.edges.edges) +
                               static_cast<long long>(surface.triangles.size());
  return report;
}

VertexCounts countVertices(
  const std::vector<VectorsView>& points, const Surface& surface, Executor& executor)
{
  VertexCounts counts;
  std::vector<Eigen::Vector3d> finite;
  Bounds bounds;
  for (const VectorsView& view : points)
  {
    counts.points += view.size();
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      const Eigen::Vector3d point = view[i];
      if (point.allFinite())
      {
        finite.push_back(point);
        bounds.extend(point);
      }
    }
  }
  counts.different = DistinctPoints(finite, unitScale(bounds), executor).size();
  counts.unreferenced = counts.different - std::min(counts.different, surface.vertices.size());
  return counts;
}

} // namespace winding
