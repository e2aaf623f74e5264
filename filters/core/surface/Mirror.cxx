// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Mirror.h"

#include "base/Refusal.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

/// Returns bounds with their image at a plane.
Bounds withImage(Bounds bounds, const Plane& plane)
{
  for (const Eigen::Vector3d& corner : cornersOf(bounds))
  {
    bounds.extend(plane.mirrored(corner));
  }
  return bounds;
}

/// Returns whether two texts name the same plane: up to rounding, with either sign.
bool areEqual(const Plane& a, const Plane& b)
{
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const double sign = a.normal.dot(b.normal) < 0 ? -1 : 1;
  return (a.normal - sign * b.normal).norm() <= rounding &&
         std::abs(a.offset - sign * b.offset) <= rounding * std::abs(a.offset);
}

} // namespace

/// Returns the distance from a plane within which positions are their own images.
double Mirror::reachOf(const Bounds& bounds) const
{
  constexpr double share = 1e-6;
  return bounds.isEmpty() ? 0 : std::max(tolerance_, share * bounds.sizes().maxCoeff());
}

void Mirror::addImage(const Plane& plane, Surface& surface, PolygonParts& parts) const
{
  const double reach = this->reachOf(surface.bounds);
  const Bounds bounds = withImage(surface.bounds, plane);
  std::vector<char> isLeftOut;
  const std::size_t vertices = surface.vertices.size(), triangles = surface.triangles.size();
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (vertices > most / 2 || triangles > most / 2)
  {
    throw Refusal("the source has too many triangles to be mirrored: 2^31 - 1 at most");
  }
  std::vector<std::int32_t> images(vertices);
  for (std::size_t i = 0; i < vertices; ++i)
  {
    const Eigen::Vector3d vertex = surface.vertices[i];
    const bool isInPlane = std::abs(plane.height(vertex)) <= reach;
    images[i] = static_cast<std::int32_t>(isInPlane ? i : surface.vertices.size());
    if (!isInPlane)
    {
      surface.vertices.push_back(plane.mirrored(vertex));
    }
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const Triangle t = surface.triangles[i];
    const Triangle image = {images[t[0]], images[t[2]], images[t[1]]};
    isLeftOut.push_back(
      static_cast<char>(image[0] == t[0] && image[1] == t[2] && image[2] == t[1]));
    surface.triangles.push_back(image);
  }
  isLeftOut.insert(isLeftOut.end(), isLeftOut.begin(), isLeftOut.end());
  if (!parts.empty())
  {
    parts.insert(parts.end(), parts.begin(), parts.end());
    PolygonParts kept;
    std::size_t polygon = 0, lastKept = 0; // numbers from 1
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      polygon += parts[i] ? 0 : 1;
      if (!isLeftOut[i])
      {
        kept.push_back(static_cast<char>(polygon == lastKept));
        lastKept = polygon;
      }
    }
    parts = kept;
  }
  leaveOut(surface, isLeftOut);
  surface.bounds = bounds;
}

Mirror::Mirror(const std::string& text, double tolerance)
  : tolerance_(tolerance)
{
  for (const Plane& plane : planesIn(text, Parameter::mirror))
  {
    if (std::none_of(planes_.begin(), planes_.end(),
          [&plane](const Plane& other) { return areEqual(plane, other); }))
    {
      planes_.push_back(plane);
    }
  }
  constexpr std::size_t most = 3; // in a row each doubles the source
  if (planes_.size() > most)
  {
    throw Refusal(Message(Parameter::mirror, "has more than three planes"));
  }
  constexpr double mostSine = 1e-4; // normals may have five digits
  for (std::size_t i = 1; i < planes_.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Eigen::Vector3d &a = planes_[i].normal, &b = planes_[j].normal;
      if (!(std::abs(a.dot(b)) <= mostSine || a.cross(b).norm() <= mostSine))
      {
        Message message(Parameter::mirror, "has planes that are not at right angles");
        message.remedies = {{"give one of them, or mirror the source yourself", {}}};
        message.facts = "images at one plane would not be symmetric at the other";
        throw Refusal(std::move(message));
      }
    }
  }
}

std::vector<Plane> Mirror::planesFor(const Bounds& bounds) const
{
  const Eigen::Vector3d middle =
    bounds.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : bounds.center();
  std::vector<Plane> result;
  for (Plane plane : planes_)
  {
    const Eigen::Vector3d given = plane.normal, foot = plane.projected(middle);
    bool isNew = true;
    for (const Plane& other : result)
    {
      const double cosine = plane.normal.dot(other.normal);
      const bool isParallel = std::abs(cosine) > 0.5;
      plane.normal =
        isParallel ? other.normal : (plane.normal - cosine * other.normal).normalized();
      isNew = isNew && !(isParallel && std::abs(other.height(foot)) <= this->reachOf(bounds));
    }
    plane.offset = plane.normal == given ? plane.offset : plane.normal.dot(foot);
    if (isNew)
    {
      result.push_back(plane);
    }
  }
  return result;
}

Bounds Mirror::completed(const Bounds& bounds) const
{
  Bounds result = bounds;
  for (const Plane& plane : this->planesFor(bounds))
  {
    result = withImage(result, plane);
  }
  return result;
}

bool Mirror::cuts(const std::vector<Eigen::Vector3d>& positions, const Bounds& bounds) const
{
  const double reach = this->reachOf(bounds);
  const std::vector<Plane> planes = this->planesFor(bounds);
  return std::any_of(planes.begin(), planes.end(),
    [&](const Plane& plane)
    {
      bool isBefore = false, isBehind = false;
      for (const Eigen::Vector3d& position : positions)
      {
        isBefore = isBefore || plane.height(position) > reach;
        isBehind = isBehind || plane.height(position) < -reach;
      }
      return isBefore && isBehind;
    });
}

Message cutByMirror()
{
  return {"the source reaches across its mirror plane",
    {{"choose a plane that it ends at", {Parameter::mirror}}}, "it overlaps its own image there"};
}

void Mirror::addTo(Surface& surface, PolygonParts& parts) const
{
  for (const Plane& plane : this->planesFor(surface.bounds))
  {
    this->addImage(plane, surface, parts);
  }
}

void Mirror::addTo(PointCloud& cloud) const
{
  for (const Plane& plane : this->planesFor(cloud.bounds))
  {
    const std::size_t points = cloud.positions.size();
    const bool haveNormals = !cloud.normals.empty(), haveAreas = !cloud.areas.empty();
    const double reach = this->reachOf(cloud.bounds);
    const Plane across = {plane.normal, 0};
    for (std::size_t i = 0; i < points; ++i)
    {
      const Eigen::Vector3d position = cloud.positions[i];
      if (!haveAreas && std::abs(plane.height(position)) <= reach)
      {
        continue;
      }
      cloud.positions.push_back(plane.mirrored(position));
      if (haveNormals)
      {
        cloud.normals.push_back(across.mirrored(cloud.normals[i]));
      }
      if (haveAreas)
      {
        cloud.areas.push_back(cloud.areas[i]);
      }
    }
    cloud.bounds = withImage(cloud.bounds, plane);
  }
}

} // namespace winding
