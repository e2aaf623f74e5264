#include "source/MeshVertices.h"

#include "base/CountingSort.h"
#include "source/CompareCoordinates.h"
#include "source/CoordinateOrder.h"

#include <algorithm>
#include <array>
#include <optional>

namespace winding
{

namespace
{

using Ids = std::array<std::size_t, 3>;

std::optional<Ids> validIds(const TrianglesView& view, std::size_t triangle, std::size_t points)
{
  Ids ids;
  for (std::size_t i = 0; i < 3; ++i)
  {
    ids[i] = static_cast<std::size_t>(view.triangles(triangle, i));
    if (ids[i] >= view.points.size() || ids[i] >= points)
    {
      return std::nullopt;
    }
  }
  return ids;
}

Eigen::Vector3d areaVectorOf(const TrianglesView& view, const Ids& ids)
{
  Eigen::Vector3d corners[3] = {view.points[ids[0]], view.points[ids[1]], view.points[ids[2]]};
  turnToFirstOrder(corners);
  return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

/// The length of a vector of any size. The bits of Eigen's stableNorm() depend on where in memory
/// the vector stands.
double lengthOf(const Eigen::Vector3d& vector)
{
  const double largest = vector.cwiseAbs().maxCoeff();
  return largest > 0 ? largest * (vector / largest).norm() : 0;
}

} // namespace

MeshVertices meshVertices(const std::vector<TrianglesView>& views, std::size_t points)
{
  CountingSort<Eigen::Vector3d> around; // area vectors of triangles, by point
  around.sort(points,
    [&](const auto& visit)
    {
      for (const TrianglesView& view : views)
      {
        for (std::size_t t = 0; t < view.triangles.size(); ++t)
        {
          const std::optional<Ids> ids = validIds(view, t, points);
          const Eigen::Vector3d areaVector =
            ids ? areaVectorOf(view, *ids) : Eigen::Vector3d::Zero();
          for (std::size_t i = 0; ids && areaVector.allFinite() && i < 3; ++i)
          {
            visit((*ids)[i], areaVector);
          }
        }
      }
    });
  MeshVertices vertices;
  vertices.normals.resize(3 * points);
  vertices.areas.resize(points);
  for (std::size_t point = 0; point < points; ++point)
  {
    // The order in which triangles came must not decide how their sum is rounded.
    std::sort(around.begin(point), around.end(point),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
      { return compareCoordinates(a, b) < 0; });
    Eigen::Map<Eigen::Vector3d> normal(&vertices.normals[3 * point]);
    for (const Eigen::Vector3d* vector = around.begin(point); vector != around.end(point); ++vector)
    {
      normal += *vector;
      vertices.areas[point] += lengthOf(*vector) / 3;
    }
  }
  return vertices;
}

} // namespace winding
