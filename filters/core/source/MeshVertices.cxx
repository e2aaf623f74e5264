#include "source/MeshVertices.h"

#include <Eigen/Geometry>

#include <array>

namespace winding
{

MeshVertices meshVertices(const std::vector<TrianglesView>& views, std::size_t points)
{
  MeshVertices vertices;
  vertices.normals.resize(3 * points);
  vertices.areas.resize(points);
  for (const TrianglesView& view : views)
  {
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
    {
      std::array<std::size_t, 3> id;
      bool isValid = true;
      for (std::size_t i = 0; i < 3; ++i)
      {
        id[i] = static_cast<std::size_t>(view.triangles(t, i));
        isValid = isValid && id[i] < view.points.size() && id[i] < points;
      }
      if (!isValid)
      {
        continue;
      }
      const Eigen::Vector3d a = view.points[id[0]];
      const Eigen::Vector3d areaVector =
        0.5 * (view.points[id[1]] - a).cross(view.points[id[2]] - a);
      if (!areaVector.allFinite())
      {
        continue;
      }
      const double area = areaVector.stableNorm();
      for (const std::size_t corner : id)
      {
        Eigen::Map<Eigen::Vector3d>(&vertices.normals[3 * corner]) += areaVector;
        vertices.areas[corner] += area / 3;
      }
    }
  }
  return vertices;
}

} // namespace winding
