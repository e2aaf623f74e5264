// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "distance/PrimitivesNear.h"
#include "source/CoordinateOrder.h"
#include "source/SnappedPoints.h"
#include "sums/ReferenceSum.h"
#include "support/Serial.h"
#include "surface/Boundary.h"
#include "surface/CompletedSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

/**
 * @file
 * Mirrors, bases and welding of random surfaces: the same for every executor; images add the
 * winding numbers of mirrored samples, bases close the rims that they say, and welded points are
 * apart.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::serial;

/// A plane across an axis, mostly through a vertex, or any plane.
std::string randomPlane(Choices& choices, const Surface& surface)
{
  std::ostringstream text;
  text.precision(17);
  const shapes::Point& vertex = surface.vertices[choices.below(surface.vertices.size())];
  if (choices.oneIn(4))
  {
    const shapes::Point normal = choices.point(-1, 1);
    text << normal.transpose() << " = " << normal.dot(vertex);
    return text.str();
  }
  const int axis = choices.below(3);
  text << "xyz"[axis] << '=' << vertex[axis];
  return text.str();
}

bool areEqual(const Surface& a, const Surface& b)
{
  return a.vertices == b.vertices &&
         std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end());
}

/// The corners of all triangles, from the lowest on, in an order that depends on the set alone.
std::vector<std::array<double, 9>> writtenOut(const Surface& surface)
{
  std::vector<std::array<double, 9>> result;
  for (const Triangle& ids : surface.triangles)
  {
    const Triangle t = lowestFirst(surface.vertices, ids);
    std::array<double, 9>& corners = result.emplace_back();
    for (std::size_t i = 0; i < 9; ++i)
    {
      corners[i] = surface.vertices[t[i / 3]][static_cast<int>(i % 3)];
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The mesh with its points and triangles in reverse order. Corners that are no points stay.
Mesh reversedOrder(Mesh mesh)
{
  const auto last = static_cast<std::int32_t>(mesh.points.size()) - 1;
  std::reverse(mesh.points.begin(), mesh.points.end());
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (auto& triangle : mesh.triangles)
  {
    for (std::int32_t& corner : triangle)
    {
      corner = corner >= 0 && corner <= last ? last - corner : corner;
    }
  }
  return mesh;
}

/// Whether all coordinates are so near to 1 in size that tolerances of a test mean something.
bool isOrdinary(const Surface& surface)
{
  const double size = surface.bounds.sizes().maxCoeff();
  return size > 1e-3 && size < 1e3 && surface.bounds.min().cwiseAbs().maxCoeff() < 1e3 &&
         surface.bounds.max().cwiseAbs().maxCoeff() < 1e3;
}

std::string checkMirror(Choices& choices, const Surface& surface)
{
  const Mirror mirror(randomPlane(choices, surface));
  const Plane& plane = mirror.planes().front();
  Surface whole = surface;
  PolygonParts parts;
  mirror.addTo(whole, parts);
  if (!whole.bounds.contains(surface.bounds) ||
      mirror.completed(surface.bounds).min() != whole.bounds.min())
  {
    return "the bounds of a mirrored surface are others";
  }
  if (!isOrdinary(surface))
  {
    return {};
  }
  // Vertices near the plane are moved by up to a millionth of the size.
  const double reach = 1e-3 * surface.bounds.sizes().maxCoeff();
  for (const shapes::Point& sample : randomSamples(choices, surface.vertices, 8))
  {
    const shapes::Point image = plane.mirrored(sample);
    if (trianglesNear(surface, sample, reach) > 0 || trianglesNear(surface, image, reach) > 0)
    {
      continue;
    }
    const double expected =
      referenceSum<double>(surface, sample) + referenceSum<double>(surface, image);
    if (std::abs(referenceSum<double>(whole, sample) - expected) > 1e-3)
    {
      return "a mirrored surface has other winding numbers than both halves";
    }
  }
  return {};
}

std::string checkBase(Choices& choices, const Surface& surface, Executor& executor)
{
  const char* const sides[] = {"down", "+x", "-y"};
  const FlatBase base(choices.oneIn(2) ? randomPlane(choices, surface) : choices.oneOf(sides));
  Surface closed = surface;
  const BasedOpenings openings = base.addTo(closed, executor);
  if (closed.triangles.size() < surface.triangles.size() ||
      !std::equal(surface.triangles.begin(), surface.triangles.end(), closed.triangles.begin()))
  {
    return "a base changes the triangles that were there";
  }
  if (openings.left == 0 && !boundaryChain(closed, executor).edges.empty())
  {
    return "a base that leaves no opening leaves a boundary";
  }
  if (openings.closed == 0 && closed.triangles.size() != surface.triangles.size())
  {
    return "a base that closes nothing adds triangles";
  }
  for (const Triangle& t : closed.triangles)
  {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      return "a base adds triangles without an area";
    }
  }
  return {};
}

std::string checkWeld(Choices& choices, const Surface& surface)
{
  const double size = surface.bounds.sizes().maxCoeff();
  const double tolerance = size * std::pow(10, choices.between(-8, 0));
  const VectorsView view(surface.vertices.front().data(), surface.vertices.size());
  const std::vector<double> moved = snappedPoints({view}, tolerance, serial).front();
  BackwardExecutor backward;
  if (moved != snappedPoints({view}, tolerance, backward).front())
  {
    return "welding depends on the executor";
  }
  const auto isLess = [](const shapes::Point& a, const shapes::Point& b)
  {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::set<shapes::Point, decltype(isLess)> stayed(isLess);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
  {
    const shapes::Point place(moved.data() + 3 * i);
    if (!((place - surface.vertices[i]).norm() <= tolerance * (1 + 1e-12)))
    {
      return "a point is welded to one that is too far away";
    }
    stayed.insert(place);
  }
  for (auto a = stayed.begin(); a != stayed.end(); ++a)
  {
    for (auto b = std::next(a); b != stayed.end(); ++b)
    {
      if ((*a - *b).norm() < tolerance * (1 - 1e-12))
      {
        return "points that are near stay apart";
      }
    }
  }
  return {};
}

} // namespace

std::string checkCompletion(Choices& choices)
{
  const Mesh mesh = choices.oneIn(3) ? randomSolid(choices) : randomMesh(choices, 30);
  BackwardExecutor backward;
  Surface surface;
  try
  {
    surface = shapes::clean(mesh);
  }
  catch (const Refusal&)
  {
    return {};
  }
  if (surface.triangles.empty() || !(surface.bounds.sizes().maxCoeff() > 0))
  {
    return {};
  }
  const std::vector<TrianglesView> views = viewsOf(mesh);
  const Mirror mirror(choices.oneIn(2) ? randomPlane(choices, surface) : "");
  const FlatBase base(choices.oneIn(2) ? "down" : "");
  if (!areEqual(completedSurface(views, mirror, base, serial).surface,
        completedSurface(views, mirror, base, backward).surface))
  {
    return "a completed surface depends on the executor";
  }
  // Where a source reaches across its mirror plane, equal points of both halves stay apart.
  const Mesh other = reversedOrder(mesh);
  if (!mirror.cuts(surface.vertices, surface.bounds) &&
      writtenOut(completedSurface(views, mirror, base, serial).surface) !=
        writtenOut(completedSurface(viewsOf(other), mirror, base, serial).surface))
  {
    return "a completed surface depends on the order of vertices or triangles";
  }
  switch (choices.below(3))
  {
  case 0:
    return checkMirror(choices, surface);
  case 1:
    return checkBase(choices, surface, serial);
  default:
    return checkWeld(choices, surface);
  }
}

} // namespace fuzz
