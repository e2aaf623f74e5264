// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/FlatBase.h"

#include "base/Directions.h"
#include "base/Refusal.h"
#include "source/CompareCoordinates.h"
#include "source/UnitScale.h"
#include "surface/Boundary.h"
#include "surface/BoundaryLoops.h"
#include "surface/Cap.h"
#include "surface/Openings.h"
#include "surface/PlaneCap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace winding
{

namespace
{

/// Returns the vector area of what closes a rim, whose sides run the other way.
Eigen::Vector3d areaOfLid(const BoundaryLoop& rim, const Surface& surface, double scale)
{
  const Eigen::Vector3d center = surface.bounds.center();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    const Eigen::Vector3d p = (surface.vertices[rim[i]] - center) * scale;
    const Eigen::Vector3d q = (surface.vertices[rim[(i + 1) % rim.size()]] - center) * scale;
    sum -= p.cross(q) / 2;
  }
  return sum;
}

constexpr double shareOfBounds = 1e-6; ///< of distances from the base that do not count

/// Returns by rim whether the base closes it. Faces look outward where `side` is 1, inward where it
/// is −1, and either way where it is 0.
std::vector<char> rimsToClose(
  const BoundaryLoops& rims, const Surface& surface, const Plane& base, int side)
{
  constexpr double leastCosine = 0.5, leastShare = 0.1;
  const double reach = shareOfBounds * surface.bounds.sizes().maxCoeff();
  const double scale = unitScale(surface.bounds);
  std::vector<Eigen::Vector3d> areas;
  double most = 0; // with its sign, which is less than 0 where faces look inward
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    areas.push_back(areaOfLid(rims[i], surface, scale));
    const double along = areas[i].dot(base.normal);
    most = std::abs(along) > std::abs(most) ? along : most;
  }
  std::vector<char> isClosed;
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    const double along = areas[i].dot(base.normal) * (side != 0 ? side : most < 0 ? -1 : 1);
    const bool facesBase =
      along > 0 && along >= leastCosine * areas[i].norm() && along >= leastShare * std::abs(most);
    const bool isInBase = std::all_of(rims[i].begin(), rims[i].end(),
      [&](std::int32_t vertex)
      { return std::abs(base.height(surface.vertices[vertex])) <= reach; });
    isClosed.push_back(static_cast<char>(facesBase || isInBase));
  }
  return isClosed;
}

} // namespace

std::vector<Message> notesOn(const BasedOpenings& openings)
{
  std::vector<Message> notes;
  const bool isOne = openings.left == 1;
  const std::string left = std::to_string(openings.left) + (isOne ? " opening" : " openings");
  if (openings.closed == 0)
  {
    notes.emplace_back(Message(Parameter::flatBase, "closes nothing: no opening faces it"));
    notes.back().facts =
      openings.left == 0 ? "the surface has none" : left + (isOne ? " does not" : " do not");
  }
  else if (openings.left > 0)
  {
    notes.emplace_back(
      Message(Parameter::flatBase, "leaves " + left + (isOne ? " as it is" : " as they are")));
    notes.back().facts =
      isOne ? "it faces another side, or is small" : "these face another side, or are small";
  }
  if (openings.closed > 0 && openings.cutsSurface)
  {
    notes.emplace_back(Message(Parameter::flatBase, "cuts the surface"));
    notes.back().remedies = {{"choose a plane that all of it lies on one side of", {}}};
  }
  return notes;
}

FlatBase::FlatBase(const std::string& text)
  : direction_(directionIn(text))
{
  if (!direction_.isZero())
  {
    return;
  }
  const std::vector<Plane> planes = planesIn(text, Parameter::flatBase, "side and no plane");
  if (planes.size() > 1)
  {
    throw Refusal(Message(Parameter::flatBase, "has more than one plane"));
  }
  if (!planes.empty())
  {
    plane_ = planes[0];
  }
}

/// Returns the plane of the base, whose normal looks away from most of the positions.
Plane FlatBase::planeBelow(const std::vector<Eigen::Vector3d>& positions) const
{
  if (!plane_)
  {
    double most = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& position : positions)
    {
      most = std::max(most, direction_.dot(position));
    }
    return {direction_, most};
  }
  Bounds heights;
  for (const Eigen::Vector3d& position : positions)
  {
    heights.extend(Eigen::Vector3d::Constant(plane_->height(position)));
  }
  const bool isBelow = heights.isEmpty() || heights.center()[0] >= 0;
  return isBelow ? Plane{-plane_->normal, -plane_->offset} : *plane_;
}

Bounds FlatBase::completed(const Bounds& bounds) const
{
  Bounds result = bounds;
  if (!this->isNone() && !bounds.isEmpty())
  {
    const std::vector<Eigen::Vector3d> corners = cornersOf(bounds);
    const Plane base = this->planeBelow(corners);
    for (const Eigen::Vector3d& corner : corners)
    {
      result.extend(base.projected(corner));
    }
  }
  return result;
}

BasedOpenings FlatBase::addTo(Surface& surface, Executor& executor) const
{
  BasedOpenings found;
  if (this->isNone() || surface.triangles.empty())
  {
    return found;
  }
  const BoundaryEdges chain = boundaryChain(surface, executor).edges;
  const BoundaryLoops rims = boundaryLoops(chain, surface.vertices.size(), executor);
  const Plane base = this->planeBelow(surface.vertices);
  const std::vector<char> isClosed =
    rimsToClose(rims, surface, base, sideBehindLids(chain, surface));
  const double reach = shareOfBounds * surface.bounds.sizes().maxCoeff();
  found.cutsSurface = std::any_of(surface.vertices.begin(), surface.vertices.end(),
    [&](const Eigen::Vector3d& vertex) { return base.height(vertex) > reach; });
  const auto isLess = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q)
  {
    return compareCoordinates(p, q) < 0;
  };
  std::map<Eigen::Vector3d, std::int32_t, decltype(isLess)> inBase(isLess);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
  {
    if (base.projected(surface.vertices[i]) == surface.vertices[i])
    {
      inBase.emplace(surface.vertices[i], static_cast<std::int32_t>(i));
    }
  }
  const auto footOf = [&](std::int32_t vertex)
  {
    const auto [foot, isNew] = inBase.emplace(
      base.projected(surface.vertices[vertex]), static_cast<std::int32_t>(surface.vertices.size()));
    if (isNew)
    {
      surface.vertices.push_back(foot->first);
    }
    return foot->second;
  };
  const auto add = [&surface](const Triangle& t)
  {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      surface.triangles.push_back(t);
    }
  };
  Rims soles;
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    found.closed += isClosed[i];
    found.left += !isClosed[i];
    if (!isClosed[i])
    {
      continue;
    }
    std::vector<std::int32_t>& sole = soles.emplace_back();
    for (std::size_t n = 0; n < rims[i].size(); ++n)
    {
      const std::int32_t a = rims[i][n], b = rims[i][(n + 1) % rims[i].size()];
      const std::int32_t footOfA = footOf(a), footOfB = footOf(b);
      add({b, a, footOfA});
      add({b, footOfA, footOfB});
      sole.push_back(footOfA);
    }
    std::reverse(sole.begin(), sole.end());
  }
  // Polygons take O(n²) time. Beyond a second any cap must do, which may cover more than they do.
  constexpr std::size_t mostCorners = 20'000;
  std::size_t corners = 0;
  for (const std::vector<std::int32_t>& sole : soles)
  {
    corners += sole.size();
  }
  TriangleList cap;
  if (corners <= mostCorners)
  {
    cap = planeCapOf(soles, surface.vertices, base.normal);
  }
  else
  {
    for (const std::vector<std::int32_t>& sole : soles)
    {
      for (const Triangle& t : capOf(BoundaryLoop(sole.data(), sole.data() + sole.size())))
      {
        cap.push_back({t[0], t[2], t[1]});
      }
    }
  }
  for (const Triangle& t : cap)
  {
    add(t);
  }
  surface.bounds = this->completed(surface.bounds);
  return found;
}

std::string FlatBase::along(const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const
{
  return plane_                ? textAlong({*plane_}, inverseAxes, origin)
         : direction_.isZero() ? std::string()
                               : "direction " + textOf(inverseAxes * direction_);
}

} // namespace winding
