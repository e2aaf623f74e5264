#include "NaiveSums.h"

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
  cloud.normals.assign(surface.vertices.size(), Eigen::Vector3d::Zero());
  cloud.areas.assign(surface.vertices.size(), 0);
  for (const winding::Triangle& ids : surface.triangles)
  {
    const auto corner = [&](int i) -> const Eigen::Vector3d&
    {
      return surface.vertices[static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])];
    };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (const std::int32_t id : ids)
    {
      cloud.normals[static_cast<std::size_t>(id)] += normal;
      cloud.areas[static_cast<std::size_t>(id)] += normal.stableNorm() / 6;
    }
  }
  for (Eigen::Vector3d& normal : cloud.normals)
  {
    normal.stableNormalize();
  }
  cloud.bounds = surface.bounds;
  cloud.inputPoints = cloud.positions.size();
  return cloud;
}
