// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/OpenParts.h"

#include "base/DisjointSets.h"
#include "base/FieldOutput.h"
#include "base/Progress.h"
#include "rays/PointCrossings.h"
#include "surface/CanonicalOrder.h"
#include "surface/Components.h"
#include "surface/NearlyClosed.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <map>
#include <utility>

namespace winding
{

namespace
{

/// The sets of triangles that could be sheets by their edges.
class SheetsByEdges
{
public:
  SheetsByEdges(const Surface& surface, const SurfaceEdges& edges)
    : surface_(surface)
    , edges_(edges)
    , sets_(surface.triangles.size())
    , states_(surface.triangles.size())
  {
    for (const SurfaceEdges::Pair& pair : edges.pairs)
    {
      sets_.unite(pair.triangles[0], pair.triangles[1]);
    }
    for (const SurfaceEdges::Rim& rim : edges.rims)
    {
      states_[sets_.find(rim.triangle)].hasRim = true;
    }
    for (const SurfaceEdges::Crowd& crowd : edges.crowds)
    {
      const std::int32_t net = edges.net(crowd);
      edges.forEachSet(crowd, sets_,
        [&](std::int32_t set, std::int32_t own)
        {
          states_[set].isWall |= own != net;
          states_[set].hasNet |= own != 0;
        });
    }
  }

  /// Chooses the partitions: sheets without a rim. Where one meets the solid, the part of the solid
  /// on either side of it could be left out instead. The set of the smallest area is the partition.
  void choosePartitions()
  {
    for (State& state : states_)
    {
      state.isPartition = false;
    }
    std::map<std::int32_t, double> areas;
    for (std::size_t i = 0; i < states_.size(); ++i)
    {
      const std::int32_t set = sets_.find(static_cast<std::int32_t>(i));
      const State& state = states_[set];
      if (state.hasNet && !state.hasRim && !state.isWall)
      {
        const Triangle& t = surface_.triangles[i];
        const Eigen::Vector3d& a = surface_.vertices[t[0]];
        const Eigen::Vector3d u = surface_.vertices[t[1]] - a, v = surface_.vertices[t[2]] - a;
        areas[set] += u.cross(v).norm();
      }
    }
    if (areas.empty())
    {
      return;
    }
    std::map<std::int32_t, std::vector<std::size_t>> crowds;
    std::vector<char> isTaken(edges_.crowds.size(), 0);
    for (std::size_t i = 0; i < isTaken.size(); ++i)
    {
      edges_.forEachSet(edges_.crowds[i], sets_,
        [&](std::int32_t set, std::int32_t)
        {
          isTaken[i] |= static_cast<char>(states_[set].isSheet());
          if (areas.count(set) > 0)
          {
            crowds[set].push_back(i);
          }
        });
    }
    std::vector<std::pair<double, std::int32_t>> byArea;
    for (const auto& [set, area] : areas)
    {
      byArea.emplace_back(area, set);
    }
    std::sort(byArea.begin(), byArea.end());
    for (const auto& [area, set] : byArea)
    {
      const std::vector<std::size_t>& own = crowds[set];
      if (std::none_of(own.begin(), own.end(), [&](std::size_t i) { return isTaken[i] != 0; }))
      {
        states_[set].isPartition = true;
        for (const std::size_t i : own)
        {
          isTaken[i] = 1;
        }
      }
    }
  }

  bool isSheet(std::size_t triangle) { return this->stateOf(triangle).isSheet(); }

  /// Takes the set of a triangle for a wall if it was chosen as a partition. Returns whether so.
  bool reject(std::size_t triangle)
  {
    State& state = this->stateOf(triangle);
    state.isWall |= state.isPartition;
    return std::exchange(state.isPartition, false);
  }

private:
  struct State
  {
    bool hasRim = false;
    bool isWall = false; ///< whether the others are not closed without it
    bool hasNet = false; ///< whether it meets others at an edge at which it does not cancel
    bool isPartition = false;

    bool isSheet() const { return isPartition || (hasRim && !isWall); }
  };

  State& stateOf(std::size_t triangle)
  {
    return states_[sets_.find(static_cast<std::int32_t>(triangle))];
  }

  const Surface& surface_;
  const SurfaceEdges& edges_;
  DisjointSets sets_;
  std::vector<State> states_; ///< by the first triangle of a set
};

Components nearlyClosedComponents(Surface& chain, Executor& executor)
{
  const SurfaceEdges edges = edgesOf(chain, executor);
  Components components = componentsOf(chain, edges);
  capNearlyClosed(chain, edges, components);
  return components;
}

/// Finds by triangle of `sheets` whether it lies inside of the closed components of `walls`, by its
/// middle and by its corners that are not on walls.
std::vector<char> trianglesInside(
  const Surface& sheets, const Surface& walls, const Components& components, Executor& executor)
{
  Surface closed;
  closed.vertices = walls.vertices;
  closed.bounds = walls.bounds;
  std::vector<char> isOnWall(walls.vertices.size(), 0);
  for (std::size_t i = 0; i < walls.triangles.size(); ++i)
  {
    for (const std::int32_t vertex : walls.triangles[i])
    {
      isOnWall[vertex] = 1;
    }
    if (components.isClosed[components.ofTriangle[i]])
    {
      closed.triangles.push_back(walls.triangles[i]);
    }
  }
  std::vector<double> places;
  std::vector<std::size_t> triangles; // by place
  const auto add = [&](const Eigen::Vector3d& place, std::size_t triangle)
  {
    places.insert(places.end(), place.data(), place.data() + 3);
    triangles.push_back(triangle);
  };
  for (std::size_t i = 0; i < sheets.triangles.size(); ++i)
  {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::int32_t vertex : sheets.triangles[i])
    {
      middle += sheets.vertices[vertex] / 3;
    }
    for (const std::int32_t vertex : sheets.triangles[i])
    {
      // Corners that touch a wall without a vertex of it are rounded to either side.
      constexpr double towardsMiddle = 0.01;
      if (!isOnWall[vertex])
      {
        add(sheets.vertices[vertex] + towardsMiddle * (middle - sheets.vertices[vertex]), i);
      }
    }
    add(middle, i);
  }
  std::vector<float> values(triangles.size(), 0);
  if (!closed.triangles.empty())
  {
    FieldOutput output;
    output.values = values.data();
    BriefExecutor brief(executor);
    PointCrossings(closed).evaluate(VectorsView(places.data(), values.size()), output, brief);
  }
  std::vector<char> isInside(sheets.triangles.size(), 1);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    isInside[triangles[n]] &= static_cast<char>(values[n] != 0);
  }
  return isInside;
}

/// The sheets of a surface, and which of their triangles are of parts inside of the rest.
struct FoundSheets
{
  std::vector<std::size_t> numbers; ///< of their triangles
  std::vector<char> isInside;       ///< by triangle of `numbers`
  std::size_t count = 0;            ///< of parts inside
};

FoundSheets lookInside(const Surface& surface, std::vector<char> isSheet, Executor& executor)
{
  FoundSheets found;
  {
    // Parts that are nearly closed by themselves are walls.
    SurfacePart candidates(surface, isSheet, true);
    const Components components = nearlyClosedComponents(candidates.chain, executor);
    for (std::size_t i = 0; i < candidates.numbers.size(); ++i)
    {
      isSheet[candidates.numbers[i]] = !components.isClosed[components.ofTriangle[i]];
    }
  }
  SurfacePart sheets(surface, isSheet, true), walls(surface, isSheet, false);
  if (sheets.numbers.empty() || walls.numbers.empty())
  {
    return found;
  }
  const Components ofWalls = nearlyClosedComponents(walls.chain, executor);
  found.isInside = trianglesInside(sheets.chain, walls.chain, ofWalls, executor);
  const Components parts = componentsOf(sheets.chain, edgesOf(sheets.chain, executor));
  std::vector<char> isAllInside(parts.size(), 1);
  for (std::size_t i = 0; i < found.isInside.size(); ++i)
  {
    isAllInside[parts.ofTriangle[i]] &= found.isInside[i];
  }
  for (std::size_t i = 0; i < found.isInside.size(); ++i)
  {
    found.isInside[i] = isAllInside[parts.ofTriangle[i]];
  }
  found.count =
    static_cast<std::size_t>(std::count(isAllInside.begin(), isAllInside.end(), char(1)));
  found.numbers = std::move(sheets.numbers);
  return found;
}

/// Finds the open parts of a surface in canonical order.
OpenParts openPartsInOrder(const Surface& surface, Executor& executor)
{
  OpenParts result;
  const SurfaceEdges edges = edgesOf(surface, executor);
  SheetsByEdges byEdges(surface, edges);
  FoundSheets found;
  // A set that was chosen as a partition and is not inside is rejected; others get its place.
  constexpr int mostRounds = 8;
  bool isRejected = true;
  for (int round = 0; isRejected && round < mostRounds; ++round)
  {
    byEdges.choosePartitions();
    std::vector<char> isSheet(surface.triangles.size());
    for (std::size_t i = 0; i < isSheet.size(); ++i)
    {
      isSheet[i] = static_cast<char>(byEdges.isSheet(i));
    }
    if (std::find(isSheet.begin(), isSheet.end(), 1) == isSheet.end())
    {
      return result;
    }
    found = lookInside(surface, std::move(isSheet), executor);
    isRejected = false;
    for (std::size_t i = 0; i < found.numbers.size(); ++i)
    {
      isRejected |= !found.isInside[i] && byEdges.reject(found.numbers[i]);
    }
  }
  result.count = found.count;
  if (found.count > 0)
  {
    result.isInside.resize(surface.triangles.size(), 0);
    for (std::size_t i = 0; i < found.numbers.size(); ++i)
    {
      result.isInside[found.numbers[i]] = found.isInside[i];
    }
  }
  return result;
}

} // namespace

OpenParts openPartsInside(const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  const bool isClosed = edges.rims.empty() && std::all_of(edges.crowds.begin(), edges.crowds.end(),
                                                [&edges](const SurfaceEdges::Crowd& crowd)
                                                { return edges.net(crowd) == 0; });
  if (isClosed)
  {
    return {};
  }
  const CanonicalOrder ordered = inCanonicalOrder(surface, {});
  OpenParts result = openPartsInOrder(ordered.surface, executor);
  result.isInside = ordered.given(result.isInside);
  return result;
}

} // namespace winding
