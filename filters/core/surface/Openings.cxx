#include "surface/Openings.h"

#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace winding
{

namespace
{

/// Finds the sides of the bounds in which openings lie. The edges in a side go round an area there,
/// seen from its middle, that is a twentieth of the surface's or more, and no triangle lies in it.
void findPlanes(
  Openings& openings, const BoundaryEdges& boundary, const Surface& surface, double area)
{
  const Bounds& bounds = surface.bounds;
  const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
  const double reach = 1e-6 * bounds.sizes().maxCoeff();
  const double scale = unitScale(bounds);
  const Eigen::Vector3d center = bounds.center();
  int inward = 0, outward = 0;
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
        openings.planes += (openings.planes.empty() ? "" : " and ") + std::string(text);
        // The vector areas of the faces and of what would close them add up to 0.
        ++((twice > 0) == (place > center[axis]) ? inward : outward);
      }
    }
  }
  openings.lookInward = inward > 0 && outward == 0;
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
  constexpr double leastOfSide = 0.2;
  if (openings.share > leastOfSide && !openings.areOfSheet())
  {
    findPlanes(openings, boundary, surface, scaledArea);
  }
  return openings;
}

Message openSideAdvice(const Openings& openings)
{
  const std::string facts = "openings" + (openings.planes.empty() ? "" : " at " + openings.planes) +
                            " are " + percentOf(openings.share) + " as large as its faces";
  if (openings.lookInward)
  {
    return {"the surface is open on a whole side and looks inward",
      {{"turn its faces", {{Parameter::orientFaces, 1}}}}, facts};
  }
  return {"the surface is open on a whole side",
    {{"close it by a base or its mirror image", {}},
      {"take all that its faces look away from", {{Parameter::windingThreshold, 0}}}},
    facts};
}

} // namespace winding
