#include "bench/NaiveSums.h"

#include "base/Executor.h"
#include "source/MeshVertices.h"

#include <utility>

bool naiveParity(const winding::Surface& surface, const Eigen::Vector3d& sample)
{
  const Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  bool odd = false;
  for (const winding::Triangle& ids : surface.triangles)
  {
    const Eigen::Vector3d& a = surface.vertices[static_cast<std::size_t>(ids[0])];
    const Eigen::Vector3d ab = surface.vertices[static_cast<std::size_t>(ids[1])] - a;
    const Eigen::Vector3d ac = surface.vertices[static_cast<std::size_t>(ids[2])] - a;
    const Eigen::Vector3d p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0)
    {
      continue;
    }
    const Eigen::Vector3d s = sample - a;
    const double u = s.dot(p) / determinant;
    if (u < 0 || u > 1)
    {
      continue;
    }
    const Eigen::Vector3d q = s.cross(ab);
    const double v = direction.dot(q) / determinant;
    odd = odd != (v >= 0 && u + v <= 1 && ac.dot(q) / determinant > 0);
  }
  return odd;
}

winding::PointCloud verticesOf(const winding::Surface& surface)
{
  winding::PointCloud cloud;
  cloud.positions = surface.vertices;
  const std::size_t points = surface.vertices.size();
  if (points == 0)
  {
    return cloud;
  }
  winding::SerialExecutor serial;
  const winding::MeshVertices vertices =
    winding::meshVertices({{{surface.vertices[0].data(), points},
                            {surface.triangles[0].data(), surface.triangles.size()}}},
      points, serial);
  for (std::size_t i = 0; i < points; ++i)
  {
    cloud.normals.push_back(vertices.normals()[i].stableNormalized());
    cloud.areas.push_back(vertices.areas()[i]);
  }
  cloud.bounds = surface.bounds;
  cloud.inputPoints = points;
  return cloud;
}
