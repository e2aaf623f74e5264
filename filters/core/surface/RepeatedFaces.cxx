// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/RepeatedFaces.h"

#include "base/DisjointSets.h"
#include "surface/ClosedComponents.h"
#include "surface/FacesByCorners.h"
#include "surface/OddCaps.h"
#include "surface/Shells.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace winding
{

namespace
{

/// Notes the kinds of equal faces, whose numbers are from `first` up to, without, `last`.
template <class Number>
void takeEqual(const FacesByCorners& faces, Number first, Number last, RepeatedFaces& result)
{
  const auto count = static_cast<std::size_t>(last - first);
  const auto forward = static_cast<std::size_t>(
    std::count_if(first, last, [&faces](std::size_t face) { return faces.isForward(face); }));
  const bool isPair = 2 * forward == count;
  const bool isForward = isPair ? faces.isForward(*first) : 2 * forward > count;
  bool isFirstThere = false, isOppositeThere = !isPair;
  for (Number face = first; face != last; ++face)
  {
    const bool runsAsFirst = faces.isForward(*face) == isForward;
    const bool isThere = std::exchange(runsAsFirst ? isFirstThere : isOppositeThere, true);
    const FaceKind kind = isThere        ? FaceKind::repeated
                          : !runsAsFirst ? FaceKind::opposite
                          : isPair       ? FaceKind::facing
                                         : FaceKind::first;
    result.repeated += kind == FaceKind::repeated;
    for (const std::int32_t triangle : faces.triangles(*face))
    {
      result.kinds[triangle] = kind;
      result.copies[triangle] = static_cast<std::int32_t>(count);
      result.groups[triangle] = faces.firstTriangle(*first);
    }
  }
  result.pairs += isPair;
  result.single += !isPair;
}

/// The place of a face between two regions.
enum class Place : char
{
  unclear,
  skin, ///< of a solid
  wall  ///< between two solids, or a fin: it has the same on both sides
};

/// Returns the place of each of the first `own` triangles, unclear where the faces equal to it are
/// in several. The other triangles are caps: those that are equal to faces count as their copies.
std::vector<Place> placesOf(
  const Surface& capped, std::size_t own, const RepeatedFaces& faces, Executor& executor)
{
  std::vector<char> isFirst;
  std::vector<std::int32_t> counts;
  for (std::size_t i = 0; i < faces.kinds.size(); ++i)
  {
    const bool isAgain =
      faces.kinds[i] == FaceKind::repeated || faces.kinds[i] == FaceKind::opposite;
    isFirst.push_back(static_cast<char>(!isAgain));
    if (!isAgain)
    {
      counts.push_back(i < own ? faces.copies[i] : 0);
    }
  }
  const SurfacePart once(capped, isFirst, true);
  const Shells shells(once.chain, edgesOf(once.chain, executor));
  const std::vector<Shells::Region> regions = shells.regions(counts);
  std::vector<std::optional<Place>> ofGroups(isFirst.size());
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    const std::int32_t group = faces.groups[once.numbers[i]];
    if (group >= 0)
    {
      const Shells::Region before = regions[2 * i], behind = regions[2 * i + 1];
      const bool isClear = before != Shells::Region::unclear && behind != Shells::Region::unclear;
      const Place place = !isClear ? Place::unclear : before == behind ? Place::wall : Place::skin;
      ofGroups[group] = ofGroups[group].value_or(place) == place ? place : Place::unclear;
    }
  }
  std::vector<Place> places(own, Place::unclear);
  for (std::size_t i = 0; i < own; ++i)
  {
    places[i] = faces.groups[i] < 0 ? Place::unclear : *ofGroups[faces.groups[i]];
  }
  return places;
}

/// The state of a set of triangles that are connected through edges.
struct Connected
{
  bool hasSingle = false; ///< whether any of them is there once
  bool isClosed = true;   ///< whether they cancel at all edges
};

/// Returns for each triangle the state of its connected set.
std::vector<Connected> connectedWith(const SurfaceEdges& edges, const RepeatedFaces& faces)
{
  const std::size_t count = faces.kinds.size();
  DisjointSets sets(count);
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    sets.unite(pair.triangles[0], pair.triangles[1]);
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      sets.unite(edges.begin(crowd)->triangle, use->triangle);
    }
  }
  std::vector<Connected> bySet(count), result;
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    bySet[sets.find(rim.triangle)].isClosed = false;
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    bySet[sets.find(pair.triangles[0])].isClosed &= pair.agrees;
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    bySet[sets.find(edges.begin(crowd)->triangle)].isClosed &= edges.net(crowd) == 0;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    bySet[sets.find(static_cast<std::int32_t>(i))].hasSingle |= faces.kinds[i] == FaceKind::single;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    result.push_back(bySet[sets.find(static_cast<std::int32_t>(i))]);
  }
  return result;
}

/// Returns which triangles to turn so that faces of pairs agree, where they are connected with no
/// others: either face of a pair may have been kept.
std::vector<char> turnedToAgree(
  const SurfacePart& once, const SurfaceEdges& edges, const RepeatedFaces& faces)
{
  SensedSets sets(once.numbers.size());
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    sets.unite(pair.triangles[0], pair.triangles[1], !pair.agrees);
  }
  std::vector<SensedSets::Place> places;
  std::vector<char> hasOthers(once.numbers.size(), 0), isTurned; // by set, and by triangle
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    places.push_back(sets.find(static_cast<std::int32_t>(i)));
    hasOthers[places[i].representative] |=
      static_cast<char>(faces.kinds[once.numbers[i]] != FaceKind::facing);
  }
  for (const SensedSets::Place& place : places)
  {
    isTurned.push_back(place.isOpposite && !hasOthers[place.representative]);
  }
  return isTurned;
}

/// Keeps the pairs of closed sets inside of a solid, by the number of solids around that are not
/// made of pairs.
void keepFilledCavities(const Surface& surface, const RepeatedFaces& faces,
  const PolygonParts& parts, std::vector<char>& isLeftOut, Executor& executor)
{
  const auto isOpposite = [&](std::size_t i)
  {
    return isLeftOut[i] && faces.kinds[i] == FaceKind::opposite;
  };
  bool areAny = false;
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    areAny |= isOpposite(i);
  }
  if (!areAny || faces.single == 0)
  {
    return;
  }
  SurfacePart once(surface, isLeftOut, false);
  const SurfaceEdges edges = edgesOf(once.chain, executor);
  const std::vector<char> isTurned = turnedToAgree(once, edges, faces);
  turn(once.chain, isTurned);
  const Components components =
    componentsOf(once.chain, edges.withTurned(isTurned), once.partsOf(parts));
  std::vector<char> arePairs(components.size(), 1);
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    arePairs[components.ofTriangle[i]] &=
      static_cast<char>(faces.kinds[once.numbers[i]] == FaceKind::facing);
  }
  std::vector<std::int32_t> around(components.size(), -1);
  for (const ClosedComponent& closed : closedComponents(once.chain, components, executor))
  {
    around[closed.component] = closed.around;
  }
  std::vector<char> areKept(isLeftOut.size(), 0); // by group
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    const std::int32_t component = components.ofTriangle[i];
    bool isFilled = false;
    for (std::int32_t outer = around[component]; outer >= 0; outer = around[outer])
    {
      isFilled = isFilled != (arePairs[outer] == 0);
    }
    if (arePairs[component] && isFilled)
    {
      areKept[faces.groups[once.numbers[i]]] = 1;
    }
  }
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    isLeftOut[i] = isLeftOut[i] && !(isOpposite(i) && areKept[faces.groups[i]]);
  }
}

} // namespace

RepeatedFaces repeatedFaces(const Surface& surface, const PolygonParts& parts)
{
  const FacesByCorners faces = facesOf(surface, parts);
  RepeatedFaces result;
  result.kinds.resize(surface.triangles.size(), FaceKind::single);
  result.copies.resize(surface.triangles.size(), 1);
  result.groups.resize(surface.triangles.size(), -1);
  std::vector<char> isTaken(surface.triangles.size(), 0);
  const FaceGroups groups = faces.groups();
  const CutPolygons polygons = polygonsOf(surface, faces, groups);
  polygons.faces.groups().forEach(
    [&](auto first, auto last)
    {
      // Copies that are cut alike are found by the corners of their faces.
      const bool areCutAlike = std::all_of(first, last,
        [&](std::size_t polygon) { return polygons.cuts[polygon] == polygons.cuts[*first]; });
      if (!areCutAlike)
      {
        for (auto polygon = first; polygon != last; ++polygon)
        {
          for (const std::int32_t triangle : polygons.faces.triangles(*polygon))
          {
            isTaken[triangle] = 1;
          }
        }
        // The first copy is the one that was drawn first, as for faces with the same corners.
        std::vector<std::size_t> inOrder(first, last);
        std::sort(inOrder.begin(), inOrder.end(),
          [&polygons](std::size_t a, std::size_t b)
          { return polygons.faces.firstTriangle(a) < polygons.faces.firstTriangle(b); });
        takeEqual(polygons.faces, inOrder.begin(), inOrder.end(), result);
      }
    });
  groups.forEach(
    [&](auto first, auto last)
    {
      if (isTaken[faces.firstTriangle(*first)])
      {
        return;
      }
      if (last - first == 1)
      {
        ++result.single;
        return;
      }
      takeEqual(faces, first, last, result);
    });
  return result;
}

std::vector<char> facesToLeaveOut(const Surface& surface, const SurfaceEdges& edges,
  const RepeatedFaces& faces, const PolygonParts& parts, Executor& executor)
{
  const std::size_t own = surface.triangles.size();
  std::vector<Place> places = placesOf(surface, own, faces, executor);
  const Surface capped = withOddCaps(surface, edges);
  if (capped.triangles.size() > own)
  {
    PolygonParts cappedParts = parts;
    cappedParts.resize(parts.empty() ? 0 : capped.triangles.size(), 0);
    const std::vector<Place> ofCapped =
      placesOf(capped, own, repeatedFaces(capped, cappedParts), executor);
    // Where caps lie on faces, places are clear without them only.
    for (std::size_t i = 0; i < own; ++i)
    {
      places[i] = ofCapped[i] == Place::unclear ? places[i] : ofCapped[i];
    }
  }
  const std::vector<Connected> connected = connectedWith(edges, faces);
  std::vector<char> isLeftOut;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const FaceKind kind = faces.kinds[i];
    const bool isOfPair = kind == FaceKind::facing || kind == FaceKind::opposite;
    switch (kind == FaceKind::single ? Place::unclear : places[i])
    {
    case Place::skin:
      isLeftOut.push_back(kind == FaceKind::repeated || kind == FaceKind::opposite);
      break;
    case Place::wall:
      isLeftOut.push_back(!isOfPair);
      break;
    case Place::unclear:
      // Solids that overlap may have faces in common.
      isLeftOut.push_back(
        (kind == FaceKind::repeated && !(connected[i].isClosed && connected[i].hasSingle)) ||
        (kind == FaceKind::opposite && !connected[i].hasSingle));
      break;
    }
  }
  keepFilledCavities(surface, faces, parts, isLeftOut, executor);
  return isLeftOut;
}

std::vector<char> withWalls(std::vector<char> isLeftOut, const RepeatedFaces& faces)
{
  std::vector<char> hasOpposite(isLeftOut.size(), 0); // by group
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    if (faces.kinds[i] == FaceKind::opposite && !isLeftOut[i])
    {
      hasOpposite[faces.groups[i]] = 1;
    }
  }
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    isLeftOut[i] |= static_cast<char>(faces.groups[i] >= 0 && hasOpposite[faces.groups[i]]);
  }
  return isLeftOut;
}

SurfacePart::SurfacePart(const Surface& surface, const std::vector<char>& isChosen, bool choice)
{
  chain.vertices = surface.vertices;
  chain.bounds = surface.bounds;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if ((isChosen[i] != 0) == choice)
    {
      chain.triangles.push_back(surface.triangles[i]);
      numbers.push_back(i);
    }
  }
}

PolygonParts SurfacePart::partsOf(const PolygonParts& parts) const
{
  PolygonParts result;
  for (const std::size_t number : numbers)
  {
    if (!parts.empty())
    {
      result.push_back(parts[number]);
    }
  }
  return result;
}

void turn(Surface& surface, const std::vector<char>& isTurned)
{
  for (std::size_t i = 0; i < isTurned.size(); ++i)
  {
    if (isTurned[i])
    {
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
  }
}

void leaveOut(Surface& surface, const std::vector<char>& isLeftOut)
{
  if (isLeftOut.empty())
  {
    return;
  }
  constexpr std::int32_t unused = -1;
  std::vector<std::int32_t> numbers(surface.vertices.size(), unused);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      surface.triangles[kept] = surface.triangles[i];
      for (const std::int32_t vertex : surface.triangles[kept])
      {
        numbers[vertex] = 0;
      }
      ++kept;
    }
  }
  surface.triangles.resize(kept);
  std::int32_t vertices = 0;
  surface.bounds = Bounds();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != unused)
    {
      numbers[i] = vertices++;
      surface.vertices[numbers[i]] = surface.vertices[i];
      surface.bounds.extend(surface.vertices[i]);
    }
  }
  surface.vertices.resize(vertices);
  for (Triangle& triangle : surface.triangles)
  {
    for (std::int32_t& vertex : triangle)
    {
      vertex = numbers[vertex];
    }
  }
}

} // namespace winding
