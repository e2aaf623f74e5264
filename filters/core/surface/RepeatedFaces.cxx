// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/RepeatedFaces.h"

#include "base/DisjointSets.h"
#include "surface/FacesByCorners.h"
#include "surface/Shells.h"

#include <algorithm>
#include <utility>

namespace winding
{

namespace
{

/// The uses of an edge by faces of two kinds.
struct UsesOfEdge
{
  std::size_t counted = 0;
  std::vector<std::int32_t> listed; ///< triangles
};

/// Calls visit(uses) for each edge with listed faces. `add` puts a triangle into the uses.
template <class Add, class Visit>
void forEachEdgeOfListed(const SurfaceEdges& edges, const Add& add, const Visit& visit)
{
  UsesOfEdge uses;
  const auto visitIfUsed = [&]
  {
    if (!uses.listed.empty())
    {
      visit(uses);
    }
    uses = UsesOfEdge();
  };
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    add(rim.triangle, uses);
    visitIfUsed();
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    add(pair.triangles[0], uses);
    add(pair.triangles[1], uses);
    visitIfUsed();
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      add(use->triangle, uses);
    }
    visitIfUsed();
  }
}

/// Connected sets of listed faces, and how other faces meet their edges.
class ListedSets
{
public:
  /// Sets go on through edges that other faces meet only if `areOnePastOthers`.
  template <class Add>
  ListedSets(
    const SurfaceEdges& edges, const RepeatedFaces& faces, const Add& add, bool areOnePastOthers)
    : sets_(faces.kinds.size())
    , meetsOdd_(faces.kinds.size(), 0)
    , meetsEven_(faces.kinds.size(), 0)
  {
    forEachEdgeOfListed(edges, add,
      [&](const UsesOfEdge& uses)
      {
        for (const std::int32_t triangle : uses.listed)
        {
          if (uses.counted == 0 || areOnePastOthers)
          {
            sets_.unite(uses.listed.front(), triangle);
          }
        }
      });
    std::vector<std::pair<std::int32_t, std::int32_t>> groups; // at an edge, by set
    forEachEdgeOfListed(edges, add,
      [&](const UsesOfEdge& uses)
      {
        groups.clear();
        for (const std::int32_t triangle : uses.listed)
        {
          groups.emplace_back(sets_.find(triangle), faces.groups[triangle]);
        }
        std::sort(groups.begin(), groups.end());
        groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
        for (std::size_t first = 0, last; first < groups.size(); first = last)
        {
          const std::int32_t set = groups[first].first;
          for (last = first; last < groups.size() && groups[last].first == set; ++last)
          {
          }
          const bool isRim = (last - first) % 2 == 1;
          meetsOdd_[set] |= static_cast<char>(uses.counted % 2 == 1);
          meetsEven_[set] |= static_cast<char>(isRim && uses.counted > 0 && uses.counted % 2 == 0);
        }
      });
  }

  /// Returns whether a triangle is of a wall: even numbers of other faces meet the set's edges, and
  /// its rim at some. A solid that touches others has no rim.
  bool isOfWall(std::size_t triangle)
  {
    const std::int32_t set = sets_.find(static_cast<std::int32_t>(triangle));
    return meetsEven_[set] && !meetsOdd_[set];
  }

private:
  DisjointSets sets_;
  std::vector<char> meetsOdd_, meetsEven_; ///< by the first triangle of a set
};

/// Leaves out the walls between solids that touch, of the faces that `mayBeOfWall` is true for.
/// Returns whether there are any.
template <class MayBeOfWall>
bool leaveOutWalls(const SurfaceEdges& edges, const RepeatedFaces& faces,
  const MayBeOfWall& mayBeOfWall, std::vector<char>& isLeftOut)
{
  const auto add = [&](std::int32_t triangle, UsesOfEdge& uses)
  {
    if (!isLeftOut[triangle] && mayBeOfWall(static_cast<std::size_t>(triangle)))
    {
      uses.listed.push_back(triangle);
    }
    else
    {
      uses.counted += !isLeftOut[triangle];
    }
  };
  ListedSets kept(edges, faces, add, true);
  bool areAny = false;
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    const bool isOfWall = !isLeftOut[i] && mayBeOfWall(i) && kept.isOfWall(i);
    isLeftOut[i] |= static_cast<char>(isOfWall);
    areAny |= isOfWall;
  }
  return areAny;
}

/// Leaves out all walls if the faces of one do not cancel: one of its solids was drawn from both
/// sides, or looks inward. The senses of the others' faces say nothing then.
void leaveOutUnclearWalls(
  const SurfaceEdges& edges, const RepeatedFaces& faces, std::vector<char>& isLeftOut)
{
  // Skins of solids that are there twice are no walls: walls of three faces or more come first.
  const bool areOfMany = leaveOutWalls(
    edges, faces, [&faces](std::size_t i) { return faces.copies[i] > 2; }, isLeftOut);
  const auto isUnclear = [&faces](std::size_t triangle)
  {
    const FaceKind kind = faces.kinds[triangle];
    return faces.copies[triangle] > 2 || kind == FaceKind::first || kind == FaceKind::repeated;
  };
  if (leaveOutWalls(edges, faces, isUnclear, isLeftOut) || areOfMany)
  {
    leaveOutWalls(
      edges, faces, [&faces](std::size_t i) { return faces.kinds[i] != FaceKind::single; },
      isLeftOut);
  }
}

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
    bool& isThere = faces.isForward(*face) == isForward ? isFirstThere : isOppositeThere;
    const FaceKind kind = isThere                     ? FaceKind::repeated
                          : &isThere != &isFirstThere ? FaceKind::opposite
                          : isPair                    ? FaceKind::facing
                                                      : FaceKind::first;
    isThere = true;
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
  unknown,
  unclear,
  skin, ///< of a solid
  wall  ///< between two solids
};

/// Returns the place of each group of equal faces, unclear where its triangles are in several.
std::vector<Place> placesOf(const Surface& surface, const RepeatedFaces& faces, Executor& executor)
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
      counts.push_back(faces.copies[i]);
    }
  }
  const SurfacePart once(surface, isFirst, true);
  const Shells shells(once.chain, edgesOf(once.chain, executor));
  const std::vector<Shells::Region> regions = shells.regions(counts);
  std::vector<Place> places(isFirst.size(), Place::unknown);
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    const std::int32_t group = faces.groups[once.numbers[i]];
    if (group >= 0)
    {
      const Shells::Region before = regions[2 * i], behind = regions[2 * i + 1];
      const bool areSolid = before == Shells::Region::solid && behind == Shells::Region::solid;
      const bool isClear = before != Shells::Region::unclear && behind != Shells::Region::unclear;
      const Place place = areSolid                      ? Place::wall
                          : isClear && before != behind ? Place::skin
                                                        : Place::unclear;
      places[group] =
        places[group] == Place::unknown || places[group] == place ? place : Place::unclear;
    }
  }
  return places;
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

std::vector<char> facesToLeaveOut(
  const Surface& surface, const SurfaceEdges& edges, const RepeatedFaces& faces, Executor& executor)
{
  const auto isThereBefore = [&faces](std::size_t triangle)
  {
    const FaceKind kind = faces.kinds[triangle];
    return kind == FaceKind::repeated || kind == FaceKind::opposite;
  };
  const auto add = [&](std::int32_t triangle, UsesOfEdge& uses)
  {
    uses.counted += faces.kinds[triangle] == FaceKind::single;
    if (isThereBefore(static_cast<std::size_t>(triangle)))
    {
      uses.listed.push_back(triangle);
    }
  };
  const std::size_t count = surface.triangles.size();
  ListedSets others(edges, faces, add, false);
  std::vector<char> isLeftOut(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    isLeftOut[i] = isThereBefore(i) && !others.isOfWall(i);
  }
  leaveOutUnclearWalls(edges, faces, isLeftOut);
  const std::vector<Place> places = placesOf(surface, faces, executor);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t group = faces.groups[i];
    const Place place = group < 0 ? Place::unclear : places[group];
    const FaceKind kind = faces.kinds[i];
    if (place == Place::skin)
    {
      isLeftOut[i] = isThereBefore(i);
    }
    else if (place == Place::wall)
    {
      isLeftOut[i] = kind != FaceKind::facing && kind != FaceKind::opposite;
    }
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
