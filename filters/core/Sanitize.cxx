#include "Sanitize.h"

#include "Refusal.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace winding
{

namespace
{

/// Gives equal coordinates equal ids, in order of first appearance. Open addressing, linear
/// probing.
class Welder
{
public:
  explicit Welder(std::vector<Eigen::Vector3d>& vertices)
    : vertices_(vertices)
    , slots_(64, empty)
  {
  }

  std::int32_t weld(const Eigen::Vector3d& point)
  {
    if (vertices_.size() * 2 >= slots_.size())
    {
      grow();
    }
    std::int32_t& slot = find(point);
    if (slot == empty)
    {
      if (vertices_.size() == static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      {
        throw Refusal("the surface has more than 2147483647 vertices; split it");
      }
      slot = static_cast<std::int32_t>(vertices_.size());
      vertices_.push_back(point);
    }
    return slot;
  }

private:
  static constexpr std::int32_t empty = -1;

  static std::uint64_t hash(const Eigen::Vector3d& point)
  {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &point[axis], sizeof bits);
      // Multiply and fold: coordinates that share most bits must still spread over the table.
      h = (h ^ bits) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return h;
  }

  std::int32_t& find(const Eigen::Vector3d& point)
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(point) & mask;
    while (slots_[i] != empty && vertices_[slots_[i]] != point)
    {
      i = (i + 1) & mask;
    }
    return slots_[i];
  }

  void grow()
  {
    slots_.assign(slots_.size() * 2, empty);
    for (std::size_t id = 0; id < vertices_.size(); ++id)
    {
      find(vertices_[id]) = static_cast<std::int32_t>(id);
    }
  }

  std::vector<Eigen::Vector3d>& vertices_;
  std::vector<std::int32_t> slots_;
};

bool hasValidIds(const TrianglesView& view, std::size_t triangle)
{
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::int64_t id = view.triangles(triangle, corner);
    if (id < 0 || static_cast<std::uint64_t>(id) >= view.points.size())
    {
      return false;
    }
  }
  return true;
}

Eigen::Vector3d corner(const TrianglesView& view, std::size_t triangle, std::size_t index)
{
  return view.points[static_cast<std::size_t>(view.triangles(triangle, index))];
}

enum class PointFault
{
  none,
  nonFinite,
  zeroNormal,
  badArea
};

PointFault faultOf(const OrientedPointsView& view, std::size_t i)
{
  const Eigen::Vector3d normal = view.normals[i];
  const double area = view.areas.empty() ? 0 : view.areas[i];
  if (!view.positions[i].allFinite() || !normal.allFinite() || !std::isfinite(area))
  {
    return PointFault::nonFinite;
  }
  if (normal == Eigen::Vector3d::Zero())
  {
    return PointFault::zeroNormal;
  }
  return area < 0 ? PointFault::badArea : PointFault::none;
}

void checkLengths(const OrientedPointsView& view)
{
  const std::size_t points = view.positions.size();
  if (view.normals.size() != points || (!view.areas.empty() && view.areas.size() != points))
  {
    throw Refusal("the cloud has " + std::to_string(points) + " points but " +
                  std::to_string(view.normals.size()) + " normals and " +
                  std::to_string(view.areas.size()) + " areas; give one of each to every point");
  }
}

} // namespace

Surface sanitize(const std::vector<TrianglesView>& views)
{
  Surface surface;
  for (const TrianglesView& view : views)
  {
    surface.inputTriangles += view.triangles.size();
  }
  if (surface.inputTriangles > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Refusal("the surface has more than 2147483647 triangles; split it");
  }
  surface.triangles.reserve(surface.inputTriangles);
  surface.vertices.reserve(surface.inputTriangles / 2 + 3);

  Welder welder(surface.vertices);
  for (const TrianglesView& view : views)
  {
    for (std::size_t i = 0; i < view.triangles.size(); ++i)
    {
      if (!hasValidIds(view, i))
      {
        ++surface.invalidIdTriangles;
        continue;
      }
      // Adding +0 turns −0 into +0, which compares equal but has other bits to hash.
      const Eigen::Array3d plusZero = Eigen::Array3d::Zero();
      const Eigen::Vector3d a = corner(view, i, 0).array() + plusZero;
      const Eigen::Vector3d b = corner(view, i, 1).array() + plusZero;
      const Eigen::Vector3d c = corner(view, i, 2).array() + plusZero;
      if (!a.allFinite() || !b.allFinite() || !c.allFinite())
      {
        ++surface.nonFiniteTriangles;
      }
      else if (a == b || b == c || c == a)
      {
        ++surface.collapsedTriangles;
      }
      else
      {
        surface.triangles.push_back({welder.weld(a), welder.weld(b), welder.weld(c)});
      }
    }
  }
  for (const Eigen::Vector3d& vertex : surface.vertices)
  {
    surface.bounds.extend(vertex);
  }
  if (surface.inputTriangles > 0 && surface.dropped() == surface.inputTriangles)
  {
    throw Refusal(
      "all " + std::to_string(surface.inputTriangles) + " triangles are unusable: " +
      std::to_string(surface.nonFiniteTriangles) + " with NaN or infinite coordinates, " +
      std::to_string(surface.invalidIdTriangles) + " with ids of points that do not exist");
  }
  return surface;
}

PointCloud sanitize(const std::vector<OrientedPointsView>& views)
{
  PointCloud cloud;
  bool withAreas = false, withoutAreas = false;
  for (const OrientedPointsView& view : views)
  {
    checkLengths(view);
    withAreas = withAreas || !view.areas.empty();
    withoutAreas = withoutAreas || (view.areas.empty() && !view.positions.empty());
    cloud.inputPoints += view.positions.size();
  }
  if (withAreas && withoutAreas)
  {
    throw Refusal("some parts of the cloud have areas and others have none; give areas to all");
  }
  cloud.positions.reserve(cloud.inputPoints);
  cloud.normals.reserve(cloud.inputPoints);

  for (const OrientedPointsView& view : views)
  {
    for (std::size_t i = 0; i < view.positions.size(); ++i)
    {
      switch (faultOf(view, i))
      {
      case PointFault::nonFinite:
        ++cloud.nonFinitePoints;
        continue;
      case PointFault::zeroNormal:
        ++cloud.zeroNormalPoints;
        continue;
      case PointFault::badArea:
        ++cloud.badAreaPoints;
        continue;
      case PointFault::none:
        break;
      }
      cloud.positions.push_back(view.positions[i]);
      // By the largest component first: the square of a very long or short normal leaves the range.
      const Eigen::Vector3d normal = view.normals[i];
      cloud.normals.push_back((normal / normal.cwiseAbs().maxCoeff()).normalized());
      if (withAreas)
      {
        cloud.areas.push_back(view.areas[i]);
      }
      cloud.bounds.extend(cloud.positions.back());
    }
  }
  if (cloud.inputPoints > 0 && cloud.positions.empty())
  {
    throw Refusal("all " + std::to_string(cloud.inputPoints) + " points are unusable: " +
                  std::to_string(cloud.nonFinitePoints) + " with NaN or infinite values, " +
                  std::to_string(cloud.zeroNormalPoints) + " with normals of length 0, " +
                  std::to_string(cloud.badAreaPoints) + " with negative areas");
  }
  return cloud;
}

Bounds boundsOf(const std::vector<TrianglesView>& views)
{
  Bounds bounds;
  for (const TrianglesView& view : views)
  {
    for (std::size_t i = 0; i < view.triangles.size(); ++i)
    {
      if (!hasValidIds(view, i))
      {
        continue;
      }
      const Eigen::Vector3d a = corner(view, i, 0), b = corner(view, i, 1), c = corner(view, i, 2);
      if (a.allFinite() && b.allFinite() && c.allFinite() && a != b && b != c && c != a)
      {
        bounds.extend(a).extend(b).extend(c);
      }
    }
  }
  return bounds;
}

Bounds boundsOf(const std::vector<OrientedPointsView>& views)
{
  Bounds bounds;
  for (const OrientedPointsView& view : views)
  {
    checkLengths(view);
    for (std::size_t i = 0; i < view.positions.size(); ++i)
    {
      if (faultOf(view, i) == PointFault::none)
      {
        bounds.extend(view.positions[i]);
      }
    }
  }
  return bounds;
}

} // namespace winding
