// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "report/SurfaceReport.h"
#include "source/CoordinateOrder.h"
#include "source/Sanitize.h"
#include "sums/ReferenceSum.h"
#include "support/Serial.h"
#include "surface/CanonicalOrder.h"
#include "surface/Orientation.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <numeric>
#include <sstream>

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
using shapes::serial;

Surface turned(Surface surface, const std::vector<char>& isTurned)
{
  turn(surface, isTurned);
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
  // The flat polygons that faces make may depend on their order.
  const CanonicalOrder ordered = inCanonicalOrder(surface, parts);
  const RepeatedFaces faces = repeatedFaces(ordered.surface, ordered.parts);
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
    if (found.isLeftOut[ordered.numbers[i]] && faces.kinds[i] == FaceKind::single)
    {
      return "a face that is there once is left out";
    }
  }
  const SurfaceEdges edges = edgesOf(rest, executor);
  return !parts.empty() || contradictionsOf(rest, edges).edges == 0
           ? std::string()
           : "triangles disagree once faces are left out";
}

/// Checks that orientation depends on the set of triangles, not on their order.
std::string checkOrder(const Surface& surface, const Orientation& found, Choices& choices)
{
  std::vector<std::size_t> numbers(surface.triangles.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  for (std::size_t i = numbers.size(); i > 1; --i)
  {
    std::swap(
      numbers[i - 1], numbers[static_cast<std::size_t>(choices.below(static_cast<int>(i)))]);
  }
  Surface ordered = surface;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    ordered.triangles[i] = surface.triangles[numbers[i]];
  }
  const Orientation again = orient(ordered, {}, serial);
  Surface expected = surface, result = ordered;
  apply(found, expected);
  apply(again, result);
  const OrderedTriangles a = inCoordinateOrder(expected.vertices, expected);
  const OrderedTriangles b = inCoordinateOrder(result.vertices, result);
  const auto isSame = [&](const Triangle& s, const Triangle& t)
  {
    return expected.vertices[s[0]] == result.vertices[t[0]] &&
           expected.vertices[s[1]] == result.vertices[t[1]] &&
           expected.vertices[s[2]] == result.vertices[t[2]];
  };
  return std::equal(
           a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(), isSame)
           ? std::string()
           : "orientation depends on the order of triangles";
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
  BackwardExecutor backward;
  const SurfaceEdges edges = edgesOf(surface, serial);
  const Orientation found = orient(surface, parts, serial);
  const Orientation again = orient(surface, parts, backward);
  if (found.isTurned != again.isTurned || found.isLeftOut != again.isLeftOut ||
      found.triangles != again.triangles || found.components != again.components)
  {
    return "orientation depends on the executor";
  }
  if (std::string fault; parts.empty() && !(fault = checkOrder(surface, found, choices)).empty())
  {
    return fault;
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
  const Orientation found = orient(shuffled, {}, serial);
  return found.isTurned == flips ? std::string() : "a solid is not turned outward again";
}

/// Checks that boxes that touch stay as they are where triangles of them are missing.
std::string checkHoles(Choices& choices)
{
  Mesh mesh;
  const int counts[3] = {1 + choices.below(3), 1 + choices.below(3), 1 + choices.below(3)};
  for (int n = 0; n < counts[0] * counts[1] * counts[2]; ++n)
  {
    const shapes::Point low(n % counts[0], n / counts[0] % counts[1], n / counts[0] / counts[1]);
    mesh = choices.oneIn(8) ? mesh : mesh.with(shapes::cube(low, low + shapes::Point(1, 1, 1)));
  }
  // Holes of which no two touch: what lies between those that do may belong to either.
  std::vector<shapes::Point> rims;
  for (int missing = choices.below(6); missing > 0 && mesh.triangles.size() > 1; --missing)
  {
    const auto hole =
      mesh.triangles.begin() + choices.below(static_cast<int>(mesh.triangles.size()));
    const auto isFree = [&](std::int32_t corner)
    {
      return std::find(rims.begin(), rims.end(), mesh.points[corner]) == rims.end();
    };
    if (std::all_of(hole->begin(), hole->end(), isFree))
    {
      for (const std::int32_t corner : *hole)
      {
        rims.push_back(mesh.points[corner]);
      }
      mesh.triangles.erase(hole);
    }
  }
  if (mesh.triangles.empty())
  {
    return {};
  }
  const Surface surface = shapes::clean(mesh);
  const Orientation found = orient(surface, {}, serial);
  const bool isAnyLeftOut =
    std::find(found.isLeftOut.begin(), found.isLeftOut.end(), char(1)) != found.isLeftOut.end();
  return found.triangles == 0 && !isAnyLeftOut ? checkOrder(surface, found, choices)
                                               : "boxes with holes do not stay as they are";
}

/// Checks that boxes which overlap and share faces keep their inside, also where one fills a cavity
/// of another. A box inside of another is a nested solid, which Orientation.h makes a cavity.
std::string checkUnion(Choices& choices)
{
  constexpr int size = 5;
  std::vector<Bounds> boxes;
  Mesh mesh;
  for (int n = 2 + choices.below(3); n > 0; --n)
  {
    Bounds box;
    for (int corner = 0; corner < 2; ++corner)
    {
      const int x = choices.below(size + 1), y = choices.below(size + 1);
      box.extend(shapes::Point(x, y, choices.below(size + 1)));
    }
    if ((box.sizes().array() == 0).any())
    {
      continue;
    }
    for (const Bounds& other : boxes)
    {
      if (other.contains(box) || box.contains(other))
      {
        return {};
      }
    }
    boxes.push_back(box);
    mesh = mesh.with(shapes::cube(box.min(), box.max()));
  }
  if (choices.oneIn(2))
  {
    const shapes::Point low(10, 0, 0), one(1, 1, 1);
    const Mesh core = shapes::cube(low + one, low + 2 * one);
    mesh = mesh.with(shapes::cube(low, low + 3 * one)).with(core.reversed()).with(core);
  }
  if (mesh.triangles.empty())
  {
    return {};
  }
  const Surface surface = shapes::clean(mesh);
  const Orientation found = orient(surface, {}, serial);
  Surface result = surface;
  apply(found, result);
  for (int n = 0; n < 14 * size * size; ++n)
  {
    const shapes::Point place(n % 14 + 0.5, n / 14 % size + 0.5, n / 14 / size + 0.5);
    const bool isInside = referenceSum<double>(surface, place) > 0.5;
    if ((referenceSum<double>(result, place) > 0.5) != isInside)
    {
      std::ostringstream text;
      text << "boxes that share faces do not keep their inside at " << place.transpose() << ":";
      for (const Bounds& box : boxes)
      {
        text << " (" << box.min().transpose() << ") to (" << box.max().transpose() << ")";
      }
      return text.str();
    }
  }
  return checkOrder(surface, found, choices);
}

} // namespace

std::string checkOrientation(Choices& choices)
{
  return choices.oneIn(3)   ? checkSolid(choices)
         : choices.oneIn(3) ? checkHoles(choices)
         : choices.oneIn(3) ? checkUnion(choices)
                            : checkAny(choices);
}

} // namespace fuzz
