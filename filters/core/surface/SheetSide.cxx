#include "surface/SheetSide.h"

#include "base/Directions.h"
#include "base/Refusal.h"
#include "source/UnitScale.h"
#include "surface/Components.h"
#include "surface/SurfaceEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace winding
{

Eigen::Vector3d sheetSideIn(const std::string& text)
{
  const Eigen::Vector3d side = directionIn(text);
  if (side.isZero() && !trimmed(text).empty())
  {
    Message message(Parameter::sheetSide, "is no direction");
    message.remedies = {{"give down, up, +x, -x, +y, -y or direction X Y Z", {}}};
    throw Refusal(std::move(message));
  }
  return side;
}

Sheets turnSheets(
  Surface& surface, const PolygonParts& parts, const Eigen::Vector3d& side, Executor& executor)
{
  const Components components = componentsOf(surface, edgesOf(surface, executor), parts);
  const double scale = unitScale(surface.bounds);
  std::vector<double> along(components.size(), 0); // the side, for the areas of each component
  double area = 0, moment = 0;                     // of open components
  const Eigen::Vector3d center =
    surface.bounds.isEmpty() ? Eigen::Vector3d(0, 0, 0) : surface.bounds.center();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const Triangle& t = surface.triangles[i];
    const auto component = static_cast<std::size_t>(components.ofTriangle[i]);
    const Eigen::Vector3d a = (surface.vertices[t[0]] - center) * scale;
    const Eigen::Vector3d b = (surface.vertices[t[1]] - center) * scale;
    const Eigen::Vector3d c = (surface.vertices[t[2]] - center) * scale;
    const Eigen::Vector3d twiceArea = (b - a).cross(c - a);
    along[component] += side.dot(twiceArea);
    if (!components.isClosed[component])
    {
      area += twiceArea.norm();
      moment += twiceArea.norm() * side.dot(a + b + c) / 3;
    }
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const auto component = static_cast<std::size_t>(components.ofTriangle[i]);
    if (!components.isClosed[component] && along[component] > 0)
    {
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
  }
  const double middle = area > 0 ? moment / area / scale : 0;
  return {static_cast<std::size_t>(
            std::count(components.isClosed.begin(), components.isClosed.end(), char(0))),
    side.dot(center) + middle};
}

} // namespace winding
