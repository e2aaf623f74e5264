#include "surface/OpenParts.h"

#include "base/DisjointSets.h"
#include "base/FieldOutput.h"
#include "base/Progress.h"
#include "rays/PointCrossings.h"
#include "surface/Components.h"
#include "surface/NearlyClosed.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace winding
{

namespace
{

/// Returns the sum of the senses of all triangles at an edge.
std::int32_t netOf(const SurfaceEdges& edges, const SurfaceEdges::Crowd& crowd)
{
  return std::accumulate(edges.begin(crowd), edges.end(crowd), std::int32_t{0},
    [](std::int32_t sum, const SurfaceEdges::Use& use) { return sum + use.sense; });
}

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
      const std::int32_t net = netOf(edges, crowd);
      edges.forEachSet(crowd, sets_,
        [&](std::int32_t set, std::int32_t own)
        {
          states_[set].isWall |= own != net;
          states_[set].hasNet |= own != 0;
        });
    }
    this->choosePartitions();
  }

  bool isSheet(std::size_t triangle)
  {
    const State& state = states_[sets_.find(static_cast<std::int32_t>(triangle))];
    return state.hasRim && !state.isWall;
  }

private:
  struct State
  {
    bool hasRim = false; ///< or counts as if it had one
    bool isWall = false; ///< whether the others are not closed without it
    bool hasNet = false; ///< whether it meets others at an edge at which it does not cancel
  };

  /// Gives partitions a rim. Where one meets the solid, the part of the solid on either side of it
  /// could be left out instead. The set of the smallest area is the partition.
  void choosePartitions()
  {
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
          isTaken[i] |= static_cast<char>(states_[set].hasRim && !states_[set].isWall);
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
        states_[set].hasRim = true;
        for (const std::size_t i : own)
        {
          isTaken[i] = 1;
        }
      }
    }
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
  closeNearlyClosed(chain, edges, components);
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
      if (!isOnWall[vertex])
      {
        add(sheets.vertices[vertex], i);
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

} // namespace

OpenParts openPartsInside(const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  OpenParts result;
  const bool isClosed = edges.rims.empty() && std::all_of(edges.crowds.begin(), edges.crowds.end(),
                                                [&edges](const SurfaceEdges::Crowd& crowd)
                                                { return netOf(edges, crowd) == 0; });
  if (isClosed)
  {
    return result;
  }
  std::vector<char> isSheet(surface.triangles.size());
  SheetsByEdges byEdges(surface, edges);
  for (std::size_t i = 0; i < isSheet.size(); ++i)
  {
    isSheet[i] = static_cast<char>(byEdges.isSheet(i));
  }
  if (std::find(isSheet.begin(), isSheet.end(), 1) == isSheet.end())
  {
    return result;
  }
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
    return result;
  }
  const Components ofWalls = nearlyClosedComponents(walls.chain, executor);
  const std::vector<char> isInside = trianglesInside(sheets.chain, walls.chain, ofWalls, executor);
  const Components parts = componentsOf(sheets.chain, edgesOf(sheets.chain, executor));
  std::vector<char> isAllInside(parts.size(), 1);
  for (std::size_t i = 0; i < isInside.size(); ++i)
  {
    isAllInside[parts.ofTriangle[i]] &= isInside[i];
  }
  result.count =
    static_cast<std::size_t>(std::count(isAllInside.begin(), isAllInside.end(), char(1)));
  if (result.count > 0)
  {
    result.isInside.resize(surface.triangles.size(), 0);
    for (std::size_t i = 0; i < isInside.size(); ++i)
    {
      result.isInside[sheets.numbers[i]] = isAllInside[parts.ofTriangle[i]];
    }
  }
  return result;
}

} // namespace winding
