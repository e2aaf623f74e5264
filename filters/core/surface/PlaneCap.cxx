// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/PlaneCap.h"

#include "base/Bounds.h"
#include "source/UnitScale.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

using Position = Eigen::Vector2d;

/// A corner of a rim, in coordinates of the plane.
struct Corner
{
  std::int32_t vertex;
  Position at;
};

using Polygon = std::vector<Corner>;

double cross(const Position& a, const Position& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Returns twice the signed area of a triangle.
double areaOf(const Position& a, const Position& b, const Position& c)
{
  return cross(b - a, c - a);
}

double areaOf(const Polygon& polygon)
{
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    area += areaOf(polygon[0].at, polygon[i].at, polygon[i + 1].at);
  }
  return area;
}

/// Returns whether a position is in a triangle that runs counter-clockwise, or on its sides.
bool isIn(const Position& p, const Position& a, const Position& b, const Position& c)
{
  return areaOf(a, b, p) >= 0 && areaOf(b, c, p) >= 0 && areaOf(c, a, p) >= 0;
}

/// Returns whether a position is in a polygon, by the crossings of a ray along +x.
bool isIn(const Position& p, const Polygon& polygon)
{
  bool isInside = false;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++)
  {
    const Position &a = polygon[before].at, &b = polygon[i].at;
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      isInside = !isInside;
    }
  }
  return isInside;
}

/// Returns whether a position lies within the angle of a polygon at a corner.
bool looksAt(const Polygon& polygon, std::size_t corner, const Position& position)
{
  const std::size_t n = polygon.size();
  const Position &a = polygon[(corner + n - 1) % n].at, &b = polygon[corner].at,
                 &c = polygon[(corner + 1) % n].at;
  const bool isLeftOfFirst = areaOf(a, b, position) >= 0;
  const bool isLeftOfSecond = areaOf(b, c, position) >= 0;
  return areaOf(a, b, c) >= 0 ? isLeftOfFirst && isLeftOfSecond : isLeftOfFirst || isLeftOfSecond;
}

/// Returns the number of the corner of a polygon that a hole's corner of the largest x sees along
/// +x, or near that ray; the polygon's size where it sees none.
std::size_t visibleCorner(const Polygon& polygon, const Position& from)
{
  const std::size_t none = polygon.size();
  std::size_t visible = none;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, before = none - 1; i < none; before = i++)
  {
    const Position &a = polygon[before].at, &b = polygon[i].at;
    const bool isAcross = std::min(a[1], b[1]) <= from[1] && from[1] <= std::max(a[1], b[1]);
    if (!isAcross)
    {
      continue;
    }
    const double x =
      a[1] == b[1] ? std::min(a[0], b[0]) : a[0] + (from[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    if (x >= from[0] && x < nearest)
    {
      nearest = x;
      visible = a[0] > b[0] ? before : i;
    }
  }
  if (visible == none)
  {
    return none;
  }
  // A corner in between would be in the triangle of both and the crossing. Of equal corners, which
  // bridges have made, one sees the position.
  const Position crossing(nearest, from[1]), end = polygon[visible].at;
  const bool isAbove = end[1] > from[1];
  std::pair<double, double> best(std::numeric_limits<double>::infinity(), 0);
  std::size_t result = visible;
  for (std::size_t i = 0; i < none; ++i)
  {
    const Position& p = polygon[i].at;
    const bool isBetween =
      p[0] >= from[0] && (isAbove ? isIn(p, from, crossing, end) : isIn(p, from, end, crossing));
    if ((p == end || isBetween) && looksAt(polygon, i, from))
    {
      const std::pair<double, double> place(
        std::atan2(std::abs(p[1] - from[1]), p[0] - from[0]), p[0] - from[0]);
      if (place < best)
      {
        best = place;
        result = i;
      }
    }
  }
  return result;
}

/// Joins a hole to the polygon around it by a bridge, along which the polygon runs both ways.
void joinHole(const Polygon& hole, Polygon& polygon)
{
  const auto rightmost = std::max_element(
    hole.begin(), hole.end(), [](const Corner& a, const Corner& b) { return a.at[0] < b.at[0]; });
  std::size_t at = visibleCorner(polygon, rightmost->at);
  at = at == polygon.size() ? 0 : at;
  Polygon detour(rightmost, hole.end());
  detour.insert(detour.end(), hole.begin(), rightmost + 1);
  detour.push_back(polygon[at]);
  polygon.insert(
    polygon.begin() + static_cast<std::ptrdiff_t>(at) + 1, detour.begin(), detour.end());
}

/// Cuts ears off a polygon until nothing is left.
class EarCutter
{
public:
  explicit EarCutter(const Polygon& polygon)
    : polygon_(polygon)
    , next_(polygon.size())
    , before_(polygon.size())
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      next_[i] = (i + 1) % polygon.size();
      before_[next_[i]] = i;
    }
  }

  void cutInto(TriangleList& triangles)
  {
    std::size_t left = polygon_.size(), here = 0, failures = 0;
    while (left >= 3)
    {
      // Corners on a line are cut off where no ear is left, and any corner where the rim crosses
      // itself.
      if (failures < 2 * left && !this->isEar(here, failures >= left))
      {
        ++failures;
        here = next_[here];
        continue;
      }
      const std::size_t before = before_[here], next = next_[here];
      triangles.push_back({polygon_[before].vertex, polygon_[here].vertex, polygon_[next].vertex});
      next_[before] = next;
      before_[next] = before;
      --left;
      failures = 0;
      here = next_[next]; // fans would have needles
    }
  }

private:
  bool isEar(std::size_t corner, bool takesLines) const
  {
    const Position a = polygon_[before_[corner]].at, b = polygon_[corner].at,
                   c = polygon_[next_[corner]].at;
    const double area = areaOf(a, b, c);
    if (area == 0 && takesLines)
    {
      return true;
    }
    if (!(area > 0))
    {
      return false;
    }
    const Position low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (std::size_t i = next_[next_[corner]]; i != before_[corner]; i = next_[i])
    {
      const Position& p = polygon_[i].at;
      if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all() && p != a &&
          p != b && p != c && isIn(p, a, b, c))
      {
        return false;
      }
    }
    return true;
  }

  const Polygon& polygon_;
  std::vector<std::size_t> next_, before_;
};

} // namespace

TriangleList planeCapOf(
  const Rims& rims, const std::vector<Eigen::Vector3d>& vertices, const Eigen::Vector3d& normal)
{
  Bounds bounds;
  for (const std::vector<std::int32_t>& rim : rims)
  {
    for (const std::int32_t vertex : rim)
    {
      bounds.extend(vertices[vertex]);
    }
  }
  const double scale = unitScale(bounds);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Polygon> polygons;
  double sum = 0;
  for (const std::vector<std::int32_t>& rim : rims)
  {
    Polygon& polygon = polygons.emplace_back();
    for (const std::int32_t vertex : rim)
    {
      const Eigen::Vector3d p = (vertices[vertex] - bounds.center()) * scale;
      polygon.push_back({vertex, {u.dot(p), v.dot(p)}});
    }
    sum += areaOf(polygon);
  }
  std::vector<std::size_t> outer, holes;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    if (sum < 0)
    {
      for (Corner& corner : polygons[i])
      {
        corner.at[0] = -corner.at[0]; // seen from the other side
      }
    }
    (areaOf(polygons[i]) >= 0 ? outer : holes).push_back(i);
  }
  // Bridges that are made from the right to the left do not cross.
  const auto rightOf = [&polygons](std::size_t i)
  {
    double most = -std::numeric_limits<double>::infinity();
    for (const Corner& corner : polygons[i])
    {
      most = std::max(most, corner.at[0]);
    }
    return most;
  };
  std::stable_sort(holes.begin(), holes.end(),
    [&rightOf](std::size_t a, std::size_t b) { return rightOf(a) > rightOf(b); });
  std::vector<Polygon> whole;
  for (const std::size_t i : outer)
  {
    whole.push_back(polygons[i]);
  }
  for (const std::size_t hole : holes)
  {
    std::size_t around = outer.size();
    for (std::size_t i = 0; i < outer.size(); ++i)
    {
      const bool isAround = isIn(polygons[hole][0].at, polygons[outer[i]]);
      if (isAround &&
          (around == outer.size() || areaOf(polygons[outer[i]]) < areaOf(polygons[outer[around]])))
      {
        around = i;
      }
    }
    if (around == outer.size())
    {
      whole.push_back(polygons[hole]); // it is around nothing: its triangles have its own sense
    }
    else
    {
      joinHole(polygons[hole], whole[around]);
    }
  }
  TriangleList triangles;
  for (const Polygon& polygon : whole)
  {
    EarCutter(polygon).cutInto(triangles);
  }
  return triangles;
}

} // namespace winding
