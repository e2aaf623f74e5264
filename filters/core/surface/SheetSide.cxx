// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/SheetSide.h"

#include "base/Directions.h"
#include "base/Refusal.h"
#include "source/UnitScale.h"
#include "surface/Components.h"
#include "surface/SurfaceEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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
  std::vector<double> areas(components.size(), 0);
  std::vector<Eigen::AlignedBox2d> footprints(components.size());
  double area = 0, moment = 0; // of open components
  const Eigen::Vector3d u = side.unitOrthogonal(), v = side.cross(u);
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
    areas[component] += twiceArea.norm();
    for (const Eigen::Vector3d& corner : {a, b, c})
    {
      footprints[component].extend(Eigen::Vector2d(u.dot(corner), v.dot(corner)));
    }
    if (!components.isClosed[component])
    {
      area += twiceArea.norm();
      moment += twiceArea.norm() * side.dot(a + b + c) / 3;
    }
  }
  constexpr double rounding = 1e-9; // the order of triangles decides nothing
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const auto component = static_cast<std::size_t>(components.ofTriangle[i]);
    if (!components.isClosed[component] && along[component] > rounding * areas[component])
    {
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
  }
  Sheets sheets;
  sheets.height = side.dot(center) + (area > 0 ? moment / area / scale : 0);
  constexpr double leastShare = 0.05, leastOverlap = 0.5;
  constexpr std::size_t mostCompared = 1000; // pieces of one terrain are many, and lie apart
  std::vector<Eigen::AlignedBox2d> before;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    if (components.isClosed[i])
    {
      continue;
    }
    ++sheets.count;
    sheets.unclear += std::abs(along[i]) < leastShare * areas[i] ? 1 : 0;
    for (const Eigen::AlignedBox2d& other : before)
    {
      const Eigen::AlignedBox2d shared = footprints[i].intersection(other);
      const double least = std::min(footprints[i].volume(), other.volume());
      sheets.areStacked =
        sheets.areStacked || (!shared.isEmpty() && shared.volume() > leastOverlap * least);
    }
    if (before.size() < mostCompared)
    {
      before.push_back(footprints[i]);
    }
  }
  return sheets;
}

} // namespace winding
