// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Orientation.h"

#include "base/DisjointSets.h"
#include "source/UnitScale.h"
#include "surface/Boundary.h"
#include "surface/CanonicalOrder.h"
#include "surface/NearlyClosed.h"
#include "surface/OddCaps.h"
#include "surface/OpenParts.h"
#include "surface/Openings.h"
#include "surface/RepeatedFaces.h"
#include "surface/Shells.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

namespace winding
{

namespace
{

/// Sets of triangles that must be turned together, because they share edges with no third one or
/// are of one polygon.
class Patches
{
public:
  Patches(const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts)
    : places_(surface.triangles.size())
    , isOneSided_(surface.triangles.size(), 0)
  {
    SensedSets sets(surface.triangles.size());
    std::vector<std::int32_t> contradictions;
    for (const SurfaceEdges::Pair& pair : edges.pairs)
    {
      if (!sets.unite(pair.triangles[0], pair.triangles[1], !pair.agrees))
      {
        contradictions.push_back(pair.triangles[0]);
      }
    }
    for (std::size_t i = 1; i < parts.size(); ++i)
    {
      const auto triangle = static_cast<std::int32_t>(i);
      if (parts[i] && !sets.unite(triangle - 1, triangle, false))
      {
        contradictions.push_back(triangle);
      }
    }
    for (const std::int32_t triangle : contradictions)
    {
      isOneSided_[sets.find(triangle).representative] = 1;
    }
    for (std::size_t i = 0; i < places_.size(); ++i)
    {
      places_[i] = sets.find(static_cast<std::int32_t>(i));
    }
  }

  /// The number of a patch: its first triangle.
  std::int32_t of(std::size_t triangle) const { return places_[triangle].representative; }

  /// Whether a triangle must be turned if its patch's first triangle is not.
  bool isOpposite(std::size_t triangle) const
  {
    return places_[triangle].isOpposite && !this->isOneSided(this->of(triangle));
  }

  bool isOneSided(std::int32_t patch) const { return isOneSided_[patch] != 0; }

  std::size_t oneSided() const
  {
    return static_cast<std::size_t>(std::count(isOneSided_.begin(), isOneSided_.end(), char(1)));
  }

private:
  std::vector<SensedSets::Place> places_;
  std::vector<char> isOneSided_; ///< by patch
};

/// Twice the areas of all triangles, in units of the surface's size.
std::vector<double> areasOf(const Surface& surface)
{
  const double scale = unitScale(surface.bounds);
  std::vector<double> areas;
  areas.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles)
  {
    areas.push_back(areaOf(surface, t, scale));
  }
  return areas;
}

/// The parts of an area that are turned and that are not.
struct TurnedArea
{
  double turned = 0, kept = 0;

  void add(double area, bool isTurned)
  {
    double& part = isTurned ? turned : kept;
    part += area;
  }
  bool isMostlyTurned() const
  {
    constexpr double rounding = 1e-9;
    return turned - kept > rounding * kept;
  }
};

/// Decides which patches steps 1 and 2 turn; a patch counts as turned if its first triangle is.
class PatchSenses
{
public:
  PatchSenses(
    const Surface& surface, const SurfaceEdges& edges, const Patches& patches, Executor& executor)
    : edges_(edges)
    , patches_(patches)
    , isTurned_(surface.triangles.size(), 0)
    , areas_(areasOf(surface))
  {
    std::vector<TurnedArea> areas(isTurned_.size());
    for (std::size_t i = 0; i < isTurned_.size(); ++i)
    {
      areas[patches.of(i)].add(areas_[i], patches.isOpposite(i));
    }
    for (std::size_t patch = 0; patch < areas.size(); ++patch)
    {
      isTurned_[patch] =
        areas[patch].isMostlyTurned() && !patches.isOneSided(static_cast<std::int32_t>(patch));
    }
    if (!edges_.crowds.empty())
    {
      this->separateRegions(surface, executor);
      this->cancelAtCrowds(areas);
    }
  }

  bool isTurned(std::size_t triangle) const
  {
    return (isTurned_[patches_.of(triangle)] != 0) != patches_.isOpposite(triangle);
  }

  const std::vector<double>& areas() const { return areas_; }

private:
  /// Returns for each triangle whether the senses of all that are connected with it contradict each
  /// other once holes are capped.
  std::vector<char> contradict(const Surface& surface, Executor& executor) const
  {
    const Surface capped = withOddCaps(surface, edges_);
    std::vector<char> isTurned;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    {
      isTurned.push_back(this->isTurned(i));
    }
    std::vector<std::int32_t> counts(surface.triangles.size(), 1);
    isTurned.resize(capped.triangles.size(), 0);
    counts.resize(capped.triangles.size(), 0);
    return Shells(capped, edgesOf(capped, executor)).contradict(isTurned, counts);
  }

  /// Turns the patches that do not cancel where they meet, and all that are connected with them, so
  /// that solids and what is empty alternate (Shells.h), where their senses contradict each other.
  void separateRegions(const Surface& surface, Executor& executor)
  {
    const std::vector<char> contradicts = this->contradict(surface, executor);
    DisjointSets sets(isTurned_.size());
    std::vector<std::int32_t> open;
    for (const SurfaceEdges::Crowd& edge : edges_.crowds)
    {
      std::int32_t net = 0;
      for (const SurfaceEdges::Use* use = edges_.begin(edge); use != edges_.end(edge); ++use)
      {
        const auto triangle = static_cast<std::size_t>(use->triangle);
        net += this->isTurned(triangle) ? -use->sense : use->sense;
        sets.unite(patches_.of(edges_.begin(edge)->triangle), patches_.of(triangle));
      }
      if (net != 0 && contradicts[edges_.begin(edge)->triangle])
      {
        open.push_back(patches_.of(edges_.begin(edge)->triangle));
      }
    }
    if (open.empty())
    {
      return;
    }
    std::vector<char> isOpen(isTurned_.size(), 0);
    for (const std::int32_t patch : open)
    {
      isOpen[sets.find(patch)] = 1;
    }
    const std::vector<std::int32_t> once(surface.triangles.size(), 1);
    const std::vector<Shells::Region> regions = Shells(surface, edges_).regions(once);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    {
      const std::int32_t patch = patches_.of(i);
      const Shells::Region before = regions[2 * i];
      if (isOpen[sets.find(patch)] && before != Shells::Region::unclear &&
          !patches_.isOneSided(patch))
      {
        isTurned_[patch] = (before == Shells::Region::solid) != patches_.isOpposite(i);
      }
    }
  }

  /// The use that a patch makes of an edge that more than two triangles share.
  struct CrowdUse
  {
    std::int32_t patch;
    std::size_t crowd;
    std::int32_t net; ///< sum of the senses of the patch's triangles, as the patch is turned now
  };

  std::vector<CrowdUse> netUses() const
  {
    std::vector<CrowdUse> uses;
    for (std::size_t crowd = 0; crowd < edges_.crowds.size(); ++crowd)
    {
      const SurfaceEdges::Crowd& edge = edges_.crowds[crowd];
      for (const SurfaceEdges::Use* use = edges_.begin(edge); use != edges_.end(edge); ++use)
      {
        uses.push_back({patches_.of(static_cast<std::size_t>(use->triangle)), crowd,
          this->isTurned(static_cast<std::size_t>(use->triangle)) ? -use->sense : use->sense});
      }
    }
    std::sort(uses.begin(), uses.end(),
      [](const CrowdUse& a, const CrowdUse& b)
      { return std::tie(a.patch, a.crowd, a.net) < std::tie(b.patch, b.crowd, b.net); });
    // The result has one use for each patch and edge, and none where the patch cancels itself.
    std::vector<CrowdUse> result;
    for (const CrowdUse& use : uses)
    {
      if (!result.empty() && result.back().patch == use.patch && result.back().crowd == use.crowd)
      {
        result.back().net += use.net;
      }
      else
      {
        result.push_back(use);
      }
    }
    const auto cancels = [](const CrowdUse& use)
    {
      return use.net == 0;
    };
    result.erase(std::remove_if(result.begin(), result.end(), cancels), result.end());
    return result;
  }

  /// The range of the uses of one patch.
  struct PatchUses
  {
    double area;
    std::size_t first, last;
  };

  std::vector<PatchUses> byPatch(
    const std::vector<CrowdUse>& uses, const std::vector<TurnedArea>& areas) const
  {
    std::vector<PatchUses> result;
    for (std::size_t first = 0, last; first < uses.size(); first = last)
    {
      const std::int32_t patch = uses[first].patch;
      for (last = first; last < uses.size() && uses[last].patch == patch; ++last)
      {
      }
      if (!patches_.isOneSided(patch))
      {
        result.push_back({areas[patch].turned + areas[patch].kept, first, last});
      }
    }
    // The sort is stable, so that patches of equal area stay in their order.
    std::stable_sort(result.begin(), result.end(),
      [](const PatchUses& a, const PatchUses& b) { return a.area < b.area; });
    return result;
  }

  void cancelAtCrowds(const std::vector<TurnedArea>& areas)
  {
    std::vector<CrowdUse> uses = this->netUses();
    const std::vector<PatchUses> patches = this->byPatch(uses, areas);
    std::vector<std::int32_t> nets(edges_.crowds.size(), 0);
    for (const CrowdUse& use : uses)
    {
      nets[use.crowd] += use.net;
    }
    std::vector<std::vector<std::size_t>> patchesAt(nets.size());
    std::deque<std::size_t> queue;
    std::vector<char> isQueued(patches.size(), 1);
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
      queue.push_back(patch);
      for (std::size_t i = patches[patch].first; i < patches[patch].last; ++i)
      {
        patchesAt[uses[i].crowd].push_back(patch);
      }
    }
    // Every turn makes the sum of all |net| smaller, so this ends.
    for (; !queue.empty(); queue.pop_front())
    {
      const PatchUses& patch = patches[queue.front()];
      isQueued[queue.front()] = 0;
      std::int64_t gain = 0;
      for (std::size_t i = patch.first; i < patch.last; ++i)
      {
        const std::int32_t net = nets[uses[i].crowd];
        gain += std::abs(net) - std::abs(net - 2 * uses[i].net);
      }
      if (gain <= 0)
      {
        continue;
      }
      char& isTurned = isTurned_[uses[patch.first].patch];
      isTurned = !isTurned;
      for (std::size_t i = patch.first; i < patch.last; ++i)
      {
        std::int32_t& net = nets[uses[i].crowd];
        const std::int32_t before = std::exchange(net, net - 2 * uses[i].net);
        uses[i].net = -uses[i].net;
        const bool keepsSign = net == 0 || (before < 0) == (net < 0);
        if (keepsSign && std::abs(net) < std::abs(before))
        {
          continue; // others gain no more by their turn than before
        }
        for (const std::size_t neighbor : patchesAt[uses[i].crowd])
        {
          if (!isQueued[neighbor])
          {
            isQueued[neighbor] = 1;
            queue.push_back(neighbor);
          }
        }
      }
    }
  }

  const SurfaceEdges& edges_;
  const Patches& patches_;
  std::vector<char> isTurned_; ///< by patch
  std::vector<double> areas_;
};

/// Decides for each component that stays open whether to turn it, where flat lids would close it.
void decideByLids(const Surface& surface, const Components& components,
  const std::vector<char>& isCapped, std::vector<char>& isTurned, Executor& executor)
{
  for (const OpenComponent& open : openComponents(surface, components, executor))
  {
    const int side = isCapped[open.component] ? 0 : sideBehindLids(open.edges, open.surface);
    if (side != 0)
    {
      isTurned[open.component] = side < 0;
    }
  }
}

/// Finds for each component whether step 3 turns it. `areas` are what steps 1 and 2 turn of it.
std::vector<char> componentsToTurn(const Surface& turned, const SurfaceEdges& edges,
  const Components& components, const std::vector<TurnedArea>& areas,
  const std::vector<char>& isFixed, Executor& executor)
{
  std::vector<char> result(components.size()), isCapped;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = areas[i].isMostlyTurned();
  }
  for (const JudgedComponent& judged :
    judgedComponents(turned, edges, components, isCapped, executor))
  {
    const std::int32_t component = judged.lies.component;
    const bool isAsGiven = areas[component].turned == 0;
    if (judged.lies.sense != 0)
    {
      result[component] = judged.isWrong() && !(judged.isUnclear && isAsGiven);
    }
  }
  decideByLids(turned, components, isCapped, result, executor);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = result[i] && !isFixed[i];
  }
  return result;
}

/// Orients a surface whose faces are there once each.
Orientation orientOnce(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts, Executor& executor)
{
  const Patches patches(surface, edges, parts);
  const PatchSenses senses(surface, edges, patches, executor);
  const std::size_t count = surface.triangles.size();
  Orientation result;
  result.isTurned.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    result.isTurned[i] = senses.isTurned(i);
  }
  Surface turned = surface;
  turn(turned, result.isTurned);
  const SurfaceEdges turnedEdges = edges.withTurned(result.isTurned);
  const Components components = componentsOf(turned, turnedEdges, parts);
  std::vector<TurnedArea> areas(components.size());
  std::vector<char> isFixed(components.size(), 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t component = components.ofTriangle[i];
    areas[component].add(senses.areas()[i], result.isTurned[i]);
    isFixed[component] |= static_cast<char>(patches.isOneSided(patches.of(i)));
  }
  const std::vector<char> turnsWhole =
    componentsToTurn(turned, turnedEdges, components, areas, isFixed, executor);
  std::vector<char> hasTurned(components.size(), 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t component = components.ofTriangle[i];
    result.isTurned[i] = (result.isTurned[i] != 0) != (turnsWhole[component] != 0);
    result.triangles += result.isTurned[i] != 0;
    hasTurned[component] |= result.isTurned[i];
  }
  result.components =
    static_cast<std::size_t>(std::count(hasTurned.begin(), hasTurned.end(), char(1)));
  return result;
}

/// Keeps the earlier face of each pair that has lost one: users expect the data of that face.
/// `numbers` says by triangle when it came. Flat pairs of triangles that are cut
/// otherwise stay, for the set of triangles would depend on their order.
void keepEarlierOfPairs(const Surface& surface, const PolygonParts& parts,
  const RepeatedFaces& faces, const std::vector<std::size_t>& numbers, Orientation& orientation)
{
  struct Face
  {
    std::vector<Triangle> corners; ///< of its triangles, ascending
    std::size_t triangle;          ///< the last of them
  };
  std::map<std::int32_t, std::array<Face, 2>> pairs; // facing and opposite, by group
  for (std::size_t i = 0; i < faces.kinds.size(); ++i)
  {
    if (faces.kinds[i] == FaceKind::facing || faces.kinds[i] == FaceKind::opposite)
    {
      Face& face = pairs[faces.groups[i]][faces.kinds[i] == FaceKind::opposite];
      face.corners.push_back(surface.triangles[i]);
      std::sort(face.corners.back().begin(), face.corners.back().end());
      face.triangle = i;
    }
  }
  const Orientation found = orientation;
  std::vector<char> isExchanged(faces.kinds.size(), 0); // by group
  for (auto& [group, pair] : pairs)
  {
    auto& [facing, opposite] = pair;
    std::sort(facing.corners.begin(), facing.corners.end());
    std::sort(opposite.corners.begin(), opposite.corners.end());
    isExchanged[group] = !found.isLeftOut[facing.triangle] && found.isLeftOut[opposite.triangle] &&
                         numbers[opposite.triangle] < numbers[facing.triangle] &&
                         (!parts.empty() || facing.corners == opposite.corners);
  }
  for (std::size_t i = 0; i < faces.kinds.size(); ++i)
  {
    const std::int32_t group = faces.groups[i];
    if (group >= 0 && isExchanged[group] && faces.kinds[i] != FaceKind::repeated)
    {
      const bool isKept = faces.kinds[i] == FaceKind::opposite;
      orientation.isLeftOut[i] = !isKept;
      orientation.isTurned[i] = isKept && !found.isTurned[pairs.at(group)[0].triangle];
    }
  }
  orientation.triangles = static_cast<std::size_t>(
    std::count(orientation.isTurned.begin(), orientation.isTurned.end(), char(1)));
}

/// Orients a surface in canonical order. `numbers` says by triangle when it came.
Orientation orientInOrder(const Surface& surface, const PolygonParts& parts,
  const std::vector<std::size_t>& numbers, Executor& executor)
{
  const SurfaceEdges edges = edgesOf(surface, executor);
  const RepeatedFaces faces = repeatedFaces(surface, parts);
  if (!faces.areAny())
  {
    return orientOnce(surface, edges, parts, executor);
  }
  Orientation result;
  result.isLeftOut = facesToLeaveOut(surface, edges, faces, parts, executor);
  // Both faces of a wall cancel, so that nothing depends on them.
  SurfacePart once(surface, withWalls(result.isLeftOut, faces), false);
  SurfaceEdges edgesOfOnce = edgesOf(once.chain, executor);
  if (contradictionsOf(once.chain, edgesOfOnce).oneSided > 0)
  {
    // Walls may be all that keeps parts from having one side only.
    once = SurfacePart(surface, result.isLeftOut, false);
    edgesOfOnce = edgesOf(once.chain, executor);
  }
  const Orientation found = orientOnce(once.chain, edgesOfOnce, once.partsOf(parts), executor);
  result.triangles = found.triangles;
  result.components = found.components;
  result.isTurned.resize(surface.triangles.size(), 0);
  for (std::size_t i = 0; i < once.numbers.size(); ++i)
  {
    result.isTurned[once.numbers[i]] = found.isTurned[i];
  }
  turn(once.chain, found.isTurned);
  const OpenParts sheets =
    openPartsInside(once.chain, edgesOfOnce.withTurned(found.isTurned), executor);
  for (std::size_t i = 0; i < sheets.isInside.size(); ++i)
  {
    const bool isOfPair = faces.kinds[once.numbers[i]] == FaceKind::facing;
    result.isLeftOut[once.numbers[i]] = sheets.isInside[i] && isOfPair;
  }
  keepEarlierOfPairs(surface, parts, faces, numbers, result);
  return result;
}

} // namespace

Orientation orient(const Surface& surface, const PolygonParts& parts, Executor& executor)
{
  const CanonicalOrder ordered = inCanonicalOrder(surface, parts);
  Orientation result = orientInOrder(ordered.surface, ordered.parts, ordered.numbers, executor);
  result.isTurned = ordered.given(result.isTurned);
  result.isLeftOut = ordered.given(result.isLeftOut);
  return result;
}

void apply(const Orientation& orientation, Surface& surface)
{
  turn(surface, orientation.isTurned);
  leaveOut(surface, orientation.isLeftOut);
}

Contradictions contradictionsOf(const Surface& surface, const SurfaceEdges& edges)
{
  Contradictions found;
  const bool allAgree = std::all_of(edges.pairs.begin(), edges.pairs.end(),
    [](const SurfaceEdges::Pair& pair) { return pair.agrees; });
  if (!allAgree)
  {
    const Patches patches(surface, edges, {});
    found.oneSided = patches.oneSided();
    for (std::size_t i = 0; found.oneSided > 0 && i < surface.triangles.size(); ++i)
    {
      found.oneSidedTriangles += patches.isOneSided(patches.of(i));
    }
    for (const SurfaceEdges::Pair& pair : edges.pairs)
    {
      const auto triangle = static_cast<std::size_t>(pair.triangles[0]);
      found.edges += !pair.agrees && !patches.isOneSided(patches.of(triangle));
    }
  }
  return found;
}

} // namespace winding
