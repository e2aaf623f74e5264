// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/ClosedComponents.h"

#include "base/Bounds.h"
#include "rays/CrossingTree.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace winding
{

namespace
{

/// Six times the volume of a component, summed over its triangles, in units of the surface's size
/// (UnitScale.h).
struct Volume
{
  double sum = 0;
  double magnitude = 0; ///< sum of the sizes of all products, which bounds the rounding
  std::size_t triangles = 0;
  std::int32_t origin = -1; ///< a vertex of the component, which may be small and far from others

  void add(const Surface& surface, const Triangle& t, double scale)
  {
    origin = origin < 0 ? t[0] : origin;
    const Eigen::Vector3d& a = surface.vertices[t[0]];
    const Eigen::Vector3d offset = (a - surface.vertices[origin]) * scale;
    const Eigen::Vector3d u = (surface.vertices[t[1]] - a) * scale;
    const Eigen::Vector3d v = (surface.vertices[t[2]] - a) * scale;
    sum += offset.dot(u.cross(v));
    magnitude += offset.norm() * u.norm() * v.norm();
    ++triangles;
  }

  int sign() const
  {
    // A term takes about ten roundings, and each addition one more.
    const double bound =
      (10 + static_cast<double>(triangles)) * std::numeric_limits<double>::epsilon() * magnitude;
    return (sum > bound) - (sum < -bound);
  }
};

std::vector<int> sensesOf(const Surface& surface, const Components& components)
{
  const double scale = unitScale(surface.bounds);
  std::vector<Volume> volumes(components.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    volumes[components.ofTriangle[i]].add(surface, surface.triangles[i], scale);
  }
  std::vector<int> senses;
  senses.reserve(volumes.size());
  for (const Volume& volume : volumes)
  {
    senses.push_back(volume.sign());
  }
  return senses;
}

/// The boxes of all components, by component; empty for open ones.
std::vector<Bounds> boundsOf(const Surface& surface, const Components& components)
{
  std::vector<Bounds> bounds(components.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const std::int32_t component = components.ofTriangle[i];
    if (components.isClosed[component])
    {
      for (const std::int32_t vertex : surface.triangles[i])
      {
        bounds[component].extend(surface.vertices[vertex]);
      }
    }
  }
  return bounds;
}

/// Finds for each vertex which closed component alone has it, if there is one that has no middles.
class Owners
{
public:
  static constexpr std::int32_t nobody = -1, several = -2;

  Owners(const Surface& surface, const Components& components)
    : owners_(surface.vertices.size(), nobody)
  {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    {
      const std::int32_t component = components.ofTriangle[i];
      for (const std::int32_t vertex : surface.triangles[i])
      {
        std::int32_t& owner = owners_[vertex];
        owner = owner == nobody || owner == component ? component : several;
      }
    }
    std::vector<char> hasVertices = components.isClosed;
    for (const Components::Middle& middle : components.middles)
    {
      hasVertices[middle.component] = 0;
    }
    for (std::int32_t& owner : owners_)
    {
      owner = owner >= 0 && !hasVertices[owner] ? nobody : owner;
    }
  }

  const std::vector<std::int32_t>& ofVertices() const { return owners_; }

private:
  std::vector<std::int32_t> owners_;
};

/// Collects the crossings of a ray from a point, and finds which components wind round the point.
class WindingComponents
{
public:
  void add(std::int32_t component, int crossing) { crossings_.emplace_back(component, crossing); }

  /// The components that wind round the point, ascending; crossings are forgotten.
  const std::vector<std::int32_t>& take()
  {
    components_.clear();
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t first = 0, last; first < crossings_.size(); first = last)
    {
      const std::int32_t component = crossings_[first].first;
      int winding = 0;
      for (last = first; last < crossings_.size() && crossings_[last].first == component; ++last)
      {
        winding += crossings_[last].second;
      }
      if (winding != 0)
      {
        components_.push_back(component);
      }
    }
    crossings_.clear();
    return components_;
  }

private:
  std::vector<std::pair<std::int32_t, int>> crossings_;
  std::vector<std::int32_t> components_;
};

/// The closed components that a component lies inside of: how many, and the innermost.
struct Place
{
  int depth = 0;
  std::int32_t around = -1;
};

/// Finds which closed components lie inside which others.
class Nesting
{
public:
  Nesting(const Surface& surface, const Components& components)
    : surface_(surface)
    , ofTriangle_(components.ofTriangle)
    , middles_(components.middles)
    , bounds_(boundsOf(surface, components))
    , owners_(surface, components)
    , tree_(surface, components.ofTriangle, bounds_)
  {
  }

  /// The places of all components, by component.
  std::vector<Place> places(const Surface& surface, Executor& executor)
  {
    std::vector<std::vector<std::int32_t>> candidates = this->aroundMiddles(surface, executor);
    if (!this->findCandidates(surface, candidates, executor))
    {
      return this->placesInNextLarger(candidates, executor);
    }
    this->refute(executor);
    std::vector<Place> places(bounds_.size());
    this->forEachPair([&](std::size_t inner, std::int32_t) { ++places[inner].depth; });
    this->forEachPair(
      [&](std::size_t inner, std::int32_t outer)
      {
        // Components that cross each other may each lie inside of the other.
        std::int32_t& around = places[inner].around;
        const int depth = places[outer].depth;
        if (depth < places[inner].depth && (around < 0 || depth > places[around].depth))
        {
          around = outer;
        }
      });
    return places;
  }

private:
  /// Calls visit(inner, outer) for each component and each other that it lies inside of.
  template <class Visit> void forEachPair(const Visit& visit) const
  {
    for (std::size_t inner = 0; inner < bounds_.size(); ++inner)
    {
      for (std::size_t i = starts_[inner]; i < starts_[inner + 1]; ++i)
      {
        if (!isRefuted_[i])
        {
          visit(inner, candidates_[i]);
        }
      }
    }
  }

  const std::vector<std::int32_t>& around(std::int32_t vertex, WindingComponents& windings) const
  {
    tree_.forEachCrossing(vertex,
      [&windings](std::int32_t component, int crossing) { windings.add(component, crossing); });
    return windings.take();
  }

  /// Finds, for each component that has middles, the others that wind round most of its area: its
  /// ends may poke out of their caps.
  std::vector<std::vector<std::int32_t>> aroundMiddles(
    const Surface& surface, Executor& executor) const
  {
    const std::size_t before = surface.vertices.size() - middles_.size();
    std::vector<std::vector<std::int32_t>> outers(middles_.size());
    runBlocks(
      middles_.size(), 1024,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        WindingComponents windings;
        for (std::size_t n = first; n < last; ++n)
        {
          outers[n] = this->around(static_cast<std::int32_t>(before + n), windings);
        }
      },
      executor);
    std::vector<double> areas(bounds_.size(), 0);
    std::map<std::pair<std::int32_t, std::int32_t>, double> shared; // by inner and outer
    for (std::size_t n = 0; n < middles_.size(); ++n)
    {
      areas[middles_[n].component] += middles_[n].area;
      for (const std::int32_t outer : outers[n])
      {
        shared[{middles_[n].component, outer}] += middles_[n].area;
      }
    }
    std::vector<std::vector<std::int32_t>> most(bounds_.size());
    for (const auto& [pair, area] : shared)
    {
      if (pair.first != pair.second && area > 0.5 * areas[pair.first])
      {
        most[pair.first].push_back(pair.second);
      }
    }
    return most;
  }

  /// Finds, for each other component, those that wind round one of its vertices and have room for
  /// the whole of it. Returns false where components are nested so deeply that it would take too
  /// long to look at all that are around each of their vertices.
  bool findCandidates(
    const Surface& surface, std::vector<std::vector<std::int32_t>>& candidates, Executor& executor)
  {
    // Rays start at each component's vertex that is farthest along them, so they leave the
    // component at once.
    std::vector<std::int32_t> foremost(bounds_.size(), -1);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
      const std::int32_t owner = owners_.ofVertices()[v];
      if (owner >= 0 &&
          (foremost[owner] < 0 || surface.vertices[v][0] > surface.vertices[foremost[owner]][0]))
      {
        foremost[owner] = static_cast<std::int32_t>(v);
      }
    }
    const std::vector<std::size_t> counts = this->countsOfVertices();
    constexpr std::size_t deepest = 64; // of a vertex, on average
    const std::size_t most = deepest * surface.vertices.size();
    std::atomic<std::size_t> pairs{0}; // of vertices and components around them
    runBlocks(
      candidates.size(), 256,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        WindingComponents windings;
        for (std::size_t inner = first; inner < last; ++inner)
        {
          if (foremost[inner] < 0 || pairs > most)
          {
            continue;
          }
          const std::vector<std::int32_t>& outers = this->around(foremost[inner], windings);
          pairs += outers.size() * counts[inner];
          for (const std::int32_t outer : outers)
          {
            if (outer != static_cast<std::int32_t>(inner) &&
                bounds_[outer].contains(bounds_[inner]))
            {
              candidates[inner].push_back(outer);
            }
          }
        }
      },
      executor);
    if (pairs > most)
    {
      return false;
    }
    for (const std::vector<std::int32_t>& outers : candidates)
    {
      candidates_.insert(candidates_.end(), outers.begin(), outers.end());
      starts_.push_back(candidates_.size());
    }
    return true;
  }

  std::vector<std::size_t> countsOfVertices() const
  {
    std::vector<std::size_t> counts(bounds_.size(), 0);
    for (const std::int32_t owner : owners_.ofVertices())
    {
      if (owner >= 0)
      {
        ++counts[owner];
      }
    }
    return counts;
  }

  /// The places of components that do not cross each other: around each is the next larger one that
  /// winds round all of its vertices, with all that is around that. `aroundMiddles` has the others
  /// around each component that has middles.
  std::vector<Place> placesInNextLarger(
    const std::vector<std::vector<std::int32_t>>& aroundMiddles, Executor& executor) const
  {
    const double scale = unitScale(surface_.bounds);
    std::vector<Volume> volumes(bounds_.size());
    std::vector<std::vector<std::int32_t>> vertices(bounds_.size()), triangles(bounds_.size());
    for (std::size_t v = 0; v < owners_.ofVertices().size(); ++v)
    {
      if (owners_.ofVertices()[v] >= 0)
      {
        vertices[owners_.ofVertices()[v]].push_back(static_cast<std::int32_t>(v));
      }
    }
    for (std::size_t i = 0; i < ofTriangle_.size(); ++i)
    {
      triangles[ofTriangle_[i]].push_back(static_cast<std::int32_t>(i));
      volumes[ofTriangle_[i]].add(surface_, surface_.triangles[i], scale);
    }
    std::vector<std::size_t> bySize;
    std::vector<std::unique_ptr<const CrossingTree>> trees(bounds_.size());
    for (std::size_t i = 0; i < bounds_.size(); ++i)
    {
      if (!bounds_[i].isEmpty())
      {
        bySize.push_back(i);
        trees[i] =
          std::make_unique<const CrossingTree>(surface_, ofTriangle_, bounds_, triangles[i]);
      }
    }
    std::stable_sort(bySize.begin(), bySize.end(),
      [&volumes](std::size_t a, std::size_t b)
      { return std::abs(volumes[a].sum) < std::abs(volumes[b].sum); });
    const auto windsRound = [&](std::size_t outer, std::size_t inner)
    {
      return bounds_[outer].contains(bounds_[inner]) &&
             std::all_of(vertices[inner].begin(), vertices[inner].end(),
               [&](std::int32_t vertex)
               {
                 int winding = 0;
                 trees[outer]->forEachCrossing(
                   vertex, [&winding](std::int32_t, int crossing) { winding += crossing; });
                 return winding != 0;
               });
    };
    std::vector<Place> places(bounds_.size());
    runBlocks(
      bySize.size(), 256,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t n = first; n < last; ++n)
        {
          const std::size_t inner = bySize[n];
          const auto outer = std::find_if(
            vertices[inner].empty() ? bySize.end() : bySize.begin() + std::ptrdiff_t(n) + 1,
            bySize.end(), [&](std::size_t other) { return windsRound(other, inner); });
          places[inner].around = outer == bySize.end() ? -1 : static_cast<std::int32_t>(*outer);
        }
      },
      executor);
    for (auto inner = bySize.rbegin(); inner != bySize.rend(); ++inner)
    {
      Place& place = places[*inner];
      place.depth = place.around < 0 ? 0 : places[place.around].depth + 1;
    }
    for (std::size_t inner = 0; inner < bounds_.size(); ++inner)
    {
      const bool hasMiddles = vertices[inner].empty();
      for (const std::int32_t outer :
        hasMiddles ? aroundMiddles[inner] : std::vector<std::int32_t>())
      {
        const std::int32_t before = places[inner].around;
        ++places[inner].depth;
        places[inner].around =
          before < 0 || places[outer].depth > places[before].depth ? outer : before;
      }
    }
    return places;
  }

  /// Refutes candidates that do not wind round all vertices of the component inside them.
  void refute(Executor& executor)
  {
    isRefuted_ = std::make_unique<std::atomic<bool>[]>(candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i)
    {
      isRefuted_[i] = false;
    }
    std::vector<std::int32_t> vertices;
    for (std::size_t v = 0; v < owners_.ofVertices().size(); ++v)
    {
      const std::int32_t owner = owners_.ofVertices()[v];
      if (owner >= 0 && starts_[owner] < starts_[owner + 1])
      {
        vertices.push_back(static_cast<std::int32_t>(v));
      }
    }
    runBlocks(
      vertices.size(), 1024,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        WindingComponents windings;
        for (std::size_t i = first; i < last; ++i)
        {
          const std::vector<std::int32_t>& outers = this->around(vertices[i], windings);
          const std::int32_t inner = owners_.ofVertices()[vertices[i]];
          for (std::size_t c = starts_[inner]; c < starts_[inner + 1]; ++c)
          {
            if (!std::binary_search(outers.begin(), outers.end(), candidates_[c]))
            {
              isRefuted_[c] = true;
            }
          }
        }
      },
      executor);
  }

  const Surface& surface_;
  const std::vector<std::int32_t>& ofTriangle_;
  const std::vector<Components::Middle>& middles_;
  std::vector<Bounds> bounds_;
  Owners owners_;
  CrossingTree tree_;
  std::vector<std::int32_t> candidates_;           ///< components that may be around each component
  std::vector<std::size_t> starts_ = {0};          ///< start of each component's candidates
  std::unique_ptr<std::atomic<bool>[]> isRefuted_; ///< by candidate
};

/// Returns which closed components share all of their vertices with others, by component.
std::vector<char> haveNoVertexAlone(const Surface& surface, const Components& components)
{
  std::vector<char> result = components.isClosed;
  const Owners owners(surface, components);
  for (const std::int32_t owner : owners.ofVertices())
  {
    if (owner >= 0)
    {
      result[owner] = 0;
    }
  }
  for (const Components::Middle& middle : components.middles)
  {
    result[middle.component] = 0;
  }
  return result;
}

std::vector<Place> placesOf(
  const Surface& surface, const Components& components, Executor& executor)
{
  const std::vector<char> isShared = haveNoVertexAlone(surface, components);
  if (std::find(isShared.begin(), isShared.end(), char(1)) == isShared.end())
  {
    return Nesting(surface, components).places(surface, executor);
  }
  Surface withMiddles = surface;
  Components named = components;
  addMiddles(withMiddles, named, isShared, surface.triangles.size());
  return Nesting(withMiddles, named).places(withMiddles, executor);
}

} // namespace

std::vector<ClosedComponent> closedComponents(
  const Surface& surface, const Components& components, Executor& executor)
{
  const auto count = std::count(components.isClosed.begin(), components.isClosed.end(), char(1));
  if (count == 0)
  {
    return {};
  }
  const std::vector<int> senses = sensesOf(surface, components);
  const std::vector<Place> places =
    count > 1 ? placesOf(surface, components, executor) : std::vector<Place>(components.size());
  std::vector<ClosedComponent> result;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    if (components.isClosed[i])
    {
      result.push_back(
        {static_cast<std::int32_t>(i), senses[i], places[i].depth, places[i].around});
    }
  }
  return result;
}

} // namespace winding
