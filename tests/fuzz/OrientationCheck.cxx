// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "report/SurfaceReport.h"
#include "source/Sanitize.h"
#include "surface/Orientation.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>

/**
 * @file
 * Orientation of random surfaces: the same for every executor and consistent with the edges that it
 * leaves; that of solids whose faces were turned at random is outward again.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;

Surface turned(Surface surface, const std::vector<char>& isTurned)
{
  for (std::size_t i = 0; i < isTurned.size(); ++i)
  {
    if (isTurned[i])
    {
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
  }
  return surface;
}

std::size_t disagreements(const SurfaceEdges& edges)
{
  return static_cast<std::size_t>(std::count_if(edges.pairs.begin(), edges.pairs.end(),
    [](const SurfaceEdges::Pair& pair) { return !pair.agrees; }));
}

/// Checks that faces which are left out are there once more, and that the rest agrees.
std::string checkOnce(
  const Surface& surface, const Orientation& found, const PolygonParts& parts, Executor& executor)
{
  const RepeatedFaces faces = repeatedFaces(surface, parts);
  Surface rest = surface;
  apply(found, rest);
  const auto leftOut =
    static_cast<std::size_t>(std::count(found.isLeftOut.begin(), found.isLeftOut.end(), char(1)));
  if (rest.triangles.size() + leftOut != surface.triangles.size())
  {
    return "apply() leaves out other triangles than orientation does";
  }
  for (std::size_t i = 0; i < faces.kinds.size(); ++i)
  {
    if (found.isLeftOut[i] && faces.kinds[i] == FaceKind::single)
    {
      return "a face that is there once is left out";
    }
  }
  const SurfaceEdges edges = edgesOf(rest, executor);
  return !parts.empty() || contradictionsOf(rest, edges).edges == 0
           ? std::string()
           : "triangles disagree once faces are left out";
}

std::string checkAny(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, 40);
  Surface surface;
  try
  {
    surface = shapes::clean(mesh);
  }
  catch (const Refusal&)
  {
    return {};
  }
  PolygonParts parts;
  const bool hasPolygons = choices.oneIn(3);
  for (std::size_t i = 0; hasPolygons && i < surface.triangles.size(); ++i)
  {
    parts.push_back(i > 0 && choices.oneIn(3));
  }
  SerialExecutor serial;
  BackwardExecutor backward;
  const SurfaceEdges edges = edgesOf(surface, serial);
  const Orientation found = orient(surface, edges, parts, serial);
  const Orientation again = orient(surface, edgesOf(surface, backward), parts, backward);
  if (found.isTurned != again.isTurned || found.isLeftOut != again.isLeftOut ||
      found.triangles != again.triangles || found.components != again.components)
  {
    return "orientation depends on the executor";
  }
  const auto count =
    static_cast<std::size_t>(std::count(found.isTurned.begin(), found.isTurned.end(), char(1)));
  if (found.isTurned.size() != surface.triangles.size() || found.triangles != count)
  {
    return "orientation counts other triangles than it turns";
  }
  if (!found.isLeftOut.empty())
  {
    return checkOnce(surface, found, parts, serial);
  }
  const Surface result = turned(surface, found.isTurned);
  const SurfaceEdges left = edgesOf(result, serial), expected = edges.withTurned(found.isTurned);
  if (left.size() != expected.size() || disagreements(left) != disagreements(expected))
  {
    return "the edges of a turned surface are not those that are promised";
  }
  // Polygons may tie triangles together that disagree; without them one-sided parts alone may.
  if (parts.empty() && disagreements(left) > 0 && contradictionsOf(surface, edges).oneSided == 0)
  {
    return "triangles disagree though no part is one-sided";
  }
  const SurfaceReport before = reportOn(surface, edges, serial);
  const SurfaceReport after = reportOn(result, left, backward);
  if (before.edges.edges != after.edges.edges || before.edges.boundary != after.edges.boundary ||
      before.orientation.oneSided != after.orientation.oneSided)
  {
    return "orientation changes counts that do not depend on it";
  }
  return {};
}

std::string checkSolid(Choices& choices)
{
  const Surface solid = shapes::clean(randomSolid(choices));
  SerialExecutor serial;
  if (!edgesOf(solid, serial).crowds.empty())
  {
    return {};
  }
  std::vector<char> flips;
  const int rarity = 1 + choices.below(5);
  for (std::size_t i = 0; i < solid.triangles.size(); ++i)
  {
    flips.push_back(choices.oneIn(rarity));
  }
  const Surface shuffled = turned(solid, flips);
  const Orientation found = orient(shuffled, edgesOf(shuffled, serial), {}, serial);
  return found.isTurned == flips ? std::string() : "a solid is not turned outward again";
}

} // namespace

std::string checkOrientation(Choices& choices)
{
  return choices.oneIn(3) ? checkSolid(choices) : checkAny(choices);
}

} // namespace fuzz
