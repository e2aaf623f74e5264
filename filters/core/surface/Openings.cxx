#include "surface/Openings.h"

#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace winding
{

namespace
{

/// Returns the sides of the bounds in which openings lie, in words. The edges in a side go round an
/// area there, seen from its middle, that is a twentieth of the surface's or more, and no triangle
/// lies in it.
std::string planesOf(const BoundaryEdges& boundary, const Surface& surface, double area)
{
  const Bounds& bounds = surface.bounds;
  const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
  const double reach = 1e-6 * bounds.sizes().maxCoeff();
  const double scale = unitScale(bounds);
  const Eigen::Vector3d center = bounds.center();
  std::string planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double place : {bounds.min()[axis], bounds.max()[axis]})
    {
      const auto isThere = [&](std::int32_t vertex)
      {
        return std::abs(vertices[vertex][axis] - place) <= reach;
      };
      double twice = 0;
      for (const BoundaryEdge& edge : boundary)
      {
        if (isThere(edge.from) && isThere(edge.to))
        {
          const Eigen::Vector3d p = (vertices[edge.from] - center) * scale;
          const Eigen::Vector3d q = (vertices[edge.to] - center) * scale;
          twice += edge.multiplicity * p.cross(q)[axis];
        }
      }
      const bool isOpen = std::abs(twice) >= 0.1 * area &&
                          std::none_of(surface.triangles.begin(), surface.triangles.end(),
                            [&isThere](const Triangle& t)
                            { return isThere(t[0]) && isThere(t[1]) && isThere(t[2]); });
      if (isOpen)
      {
        char text[60];
        std::snprintf(text, sizeof text, "%c = %.6g", "xyz"[axis], place);
        planes += (planes.empty() ? "" : " and ") + std::string(text);
      }
    }
  }
  return planes;
}

} // namespace

Openings openingsOf(const BoundaryEdges& boundary, const Surface& surface, double area)
{
  Openings openings;
  const double scale = unitScale(surface.bounds);
  const double scaledArea = area * scale * scale;
  if (boundary.empty() || !(scaledArea > 0))
  {
    return openings;
  }
  const Eigen::Vector3d center = surface.bounds.center();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BoundaryEdge& edge : boundary)
  {
    const Eigen::Vector3d p = (surface.vertices[edge.from] - center) * scale;
    const Eigen::Vector3d q = (surface.vertices[edge.to] - center) * scale;
    sum += static_cast<double>(edge.multiplicity) * p.cross(q);
  }
  openings.share = std::min(0.5 * sum.norm() / scaledArea, 1.0);
  constexpr double mostOfSheet = 0.95;
  if (openings.areWide() && openings.share < mostOfSheet)
  {
    openings.planes = planesOf(boundary, surface, scaledArea);
  }
  return openings;
}

Message openSideAdvice(const Openings& openings)
{
  return {"the surface is open on a whole side",
    {{"close it by a base or its mirror image", {}},
      {"take all that its faces look away from", {{Parameter::windingThreshold, 0}}}},
    "openings" + (openings.planes.empty() ? "" : " at " + openings.planes) + " are " +
      percentOf(openings.share) + " as large as its faces"};
}

} // namespace winding
