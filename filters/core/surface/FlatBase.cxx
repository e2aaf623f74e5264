// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/FlatBase.h"

#include "base/Directions.h"
#include "base/Refusal.h"
#include "source/CompareCoordinates.h"
#include "source/UnitScale.h"
#include "surface/Boundary.h"
#include "surface/BoundaryLoops.h"
#include "surface/Cap.h"
#include "surface/Components.h"
#include "surface/PlaneCap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace winding
{

namespace
{

constexpr double shareOfBounds = 1e-6; ///< of distances from the base that do not count
constexpr double leastShare = 0.1;     ///< of the largest rim that a rim must have
constexpr double nextToBase = 0.1;     ///< share of the surface's height
constexpr double steepest = 0.7071;    ///< cosine to the way up from which on a wall is upright

/// Gives places of their own to rims that meet at a vertex, by numbers from the surface's vertices
/// on: a rim goes on across the gap between two fans of triangles, the narrowest first. So no order
/// decides. Returns the vertices of these numbers.
std::vector<std::int32_t> separateRims(BoundaryEdges& chain, const Surface& surface)
{
  const std::size_t vertices = surface.vertices.size();
  struct Meeting
  {
    std::vector<std::size_t> arriving, leaving; ///< edges of the chain
    std::map<std::int32_t, std::int32_t> next;  ///< across a triangle, around the vertex
  };
  std::vector<std::uint8_t> leaving(vertices, 0);
  std::map<std::int32_t, Meeting> meetings;
  for (const BoundaryEdge& edge : chain)
  {
    std::uint8_t& count = leaving[std::size_t(edge.from)];
    count = static_cast<std::uint8_t>(std::min(2, count + 1));
    if (count == 2)
    {
      meetings[edge.from];
    }
  }
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    if (leaving[std::size_t(chain[i].from)] == 2)
    {
      meetings[chain[i].from].leaving.push_back(i);
    }
    if (leaving[std::size_t(chain[i].to)] == 2)
    {
      meetings[chain[i].to].arriving.push_back(i);
    }
  }
  for (const Triangle& t : surface.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (leaving[std::size_t(t[i])] == 2)
      {
        const std::int32_t on = t[(i + 1) % 3];
        const auto [next, isNew] = meetings[t[i]].next.emplace(t[(i + 2) % 3], on);
        next->second = isNew ? on : -1; // triangles on each other
      }
    }
  }
  std::vector<std::int32_t> places;
  const BoundaryEdges before = chain;
  for (const auto& [vertex, meeting] : meetings)
  {
    constexpr std::size_t most = 16; // pairs take time
    const auto isOnce = [&before](std::size_t edge)
    {
      return before[edge].multiplicity == 1;
    };
    if (meeting.leaving.size() > most ||
        !std::all_of(meeting.arriving.begin(), meeting.arriving.end(), isOnce) ||
        !std::all_of(meeting.leaving.begin(), meeting.leaving.end(), isOnce))
    {
      continue;
    }
    struct Gap
    {
      bool isFan;
      double cosine;
      std::size_t arriving, leaving;
    };
    std::vector<Gap> gaps;
    const Eigen::Vector3d at = surface.vertices[std::size_t(vertex)];
    for (const std::size_t a : meeting.arriving)
    {
      const Eigen::Vector3d back = surface.vertices[std::size_t(before[a].from)] - at;
      std::int32_t end = before[a].from;
      for (std::size_t steps = 0; steps < meeting.next.size() && meeting.next.count(end); ++steps)
      {
        end = meeting.next.at(end);
      }
      for (const std::size_t b : meeting.leaving)
      {
        const Eigen::Vector3d on = surface.vertices[std::size_t(before[b].to)] - at;
        gaps.push_back(
          {before[b].to == end, back.stableNormalized().dot(on.stableNormalized()), a, b});
      }
    }
    std::stable_sort(gaps.begin(), gaps.end(),
      [](const Gap& a, const Gap& b)
      { return a.isFan != b.isFan ? b.isFan : a.cosine > b.cosine; });
    std::vector<std::size_t> taken;
    const auto isTaken = [&taken](std::size_t edge)
    {
      return std::find(taken.begin(), taken.end(), edge) != taken.end();
    };
    for (const Gap& gap : gaps)
    {
      if (!isTaken(2 * gap.arriving) && !isTaken(2 * gap.leaving + 1))
      {
        taken.push_back(2 * gap.arriving);
        taken.push_back(2 * gap.leaving + 1);
        const auto place = static_cast<std::int32_t>(vertices + places.size());
        chain[gap.arriving].to = place;
        chain[gap.leaving].from = place;
        places.push_back(vertex);
      }
    }
  }
  return places;
}

/// Returns the rims of a surface, in an order of coordinates: they make the same base whatever the
/// order of vertices.
BoundaryLoops rimsOf(const Surface& surface, Executor& executor)
{
  const std::size_t vertices = surface.vertices.size();
  BoundaryEdges chain =
    sortedByCoordinates(boundaryChain(surface, executor).edges, surface.vertices, executor);
  const std::vector<std::int32_t> places = separateRims(chain, surface);
  const BoundaryLoops walks = boundaryLoops(chain, vertices + places.size(), executor);
  if (places.empty())
  {
    return walks;
  }
  BoundaryLoops rims;
  std::vector<std::int32_t> path, placeInPath(vertices, -1);
  for (std::size_t i = 0; i < walks.size(); ++i)
  {
    path.clear();
    for (const std::int32_t place : walks[i])
    {
      const std::int32_t vertex =
        std::size_t(place) < vertices ? place : places[std::size_t(place) - vertices];
      if (std::int32_t& first = placeInPath[std::size_t(vertex)]; first >= 0)
      {
        const auto start = static_cast<std::size_t>(first);
        rims.add({path.data() + start, path.data() + path.size()});
        for (std::size_t n = start; n < path.size(); ++n)
        {
          placeInPath[std::size_t(path[n])] = -1;
        }
        path.resize(start);
      }
      placeInPath[std::size_t(vertex)] = static_cast<std::int32_t>(path.size());
      path.push_back(vertex);
    }
    for (const std::int32_t vertex : path)
    {
      placeInPath[std::size_t(vertex)] = -1;
    }
    rims.add({path.data(), path.data() + path.size()});
  }
  return rims;
}

/// A lid that closes a rim: a fan from the middle of its vertices. Lengths are scaled.
struct Lid
{
  Eigen::Vector3d area = Eigen::Vector3d::Zero(); ///< its vector area, outward as the faces are
  double volume = 0;                              ///< of the cones from the origin over it
  double volumeToBase = 0;                        ///< between them, less than 0 if it faces away
  double depth = 0;                               ///< distance of its middle from the base
  double rise = 0; ///< mean cosine between the faces that leave its rim and the way up
  std::size_t piece = 0;
  bool isInBase = true;

  double along(const Plane& base) const { return area.dot(base.normal); }

  bool facesBase(const Plane& base, double side) const
  {
    constexpr double leastCosine = 0.5;
    return side * this->along(base) > 0 && side * this->along(base) >= leastCosine * area.norm();
  }
};

Lid lidOf(const BoundaryLoop& rim, const Surface& surface, const Plane& base, double scale)
{
  const Eigen::Vector3d origin = surface.bounds.center();
  const double reach = shareOfBounds * surface.bounds.sizes().maxCoeff() * scale;
  const auto depthOf = [&](const Eigen::Vector3d& p)
  {
    return -base.height(p / scale + origin) * scale;
  };
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::int32_t vertex : rim)
  {
    corners.emplace_back((surface.vertices[vertex] - origin) * scale);
    middle += corners.back() / static_cast<double>(rim.size());
  }
  Lid lid;
  lid.depth = depthOf(middle);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Eigen::Vector3d &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const Eigen::Vector3d area = (q - middle).cross(p - middle) / 2;
    const double depth = -base.height(surface.vertices[rim[i]]) * scale;
    lid.area += area;
    lid.volume += middle.dot(area) / 3;
    lid.volumeToBase += area.dot(base.normal) * (lid.depth + depth + depthOf(q)) / 3;
    lid.isInBase = lid.isInBase && std::abs(depth) <= reach;
  }
  return lid;
}

/// The sums that say whether a surface, or a piece of it, looks inward. Lengths are scaled.
struct Faces
{
  double volume = 0; ///< of the cones from the origin over them
  double area = 0;
  Bounds depths;
  std::vector<Lid> lids;

  /// Returns whether the faces look inward: the lids next to the base say so, and walls from them
  /// make a larger solid than walls from others would. If there are no others, a surface that looks
  /// outward is a cup. Walls end at the lowest vertex here, wherever the base is.
  bool lookInward(const Plane& base) const;

  /// Returns whether the rims make walls: another one is of the size of the largest, nearly.
  bool areWalls() const
  {
    double largest = 0;
    for (const Lid& lid : lids)
    {
      largest = std::max(largest, lid.area.norm());
    }
    return std::count_if(lids.begin(), lids.end(),
             [largest](const Lid& lid) { return lid.area.norm() >= leastShare * largest; }) > 1;
  }
};

bool Faces::lookInward(const Plane& base) const
{
  constexpr double leastLid = 0.01, leastVolume = 0.04;
  constexpr double rounding = 1e-9; // orders of triangles decide nothing
  double closed = volume, largest = 0, nearest = std::numeric_limits<double>::infinity();
  for (const Lid& lid : lids)
  {
    closed += lid.volume;
    largest = std::max(largest, std::abs(lid.along(base)));
  }
  const auto isLarge = [&](const Lid& lid)
  {
    return std::abs(lid.along(base)) >= leastLid * largest;
  };
  for (const Lid& lid : lids)
  {
    nearest = isLarge(lid) ? std::min(nearest, lid.depth) : nearest;
  }
  double along = 0, most = 0, ofOutward = closed, ofInward = -closed;
  bool isOutwardOpen = false;
  for (const Lid& lid : lids)
  {
    const bool isNext = isLarge(lid) && lid.depth <= nearest + nextToBase * depths.sizes()[0];
    along += isNext ? lid.along(base) : 0;
    most += isNext ? lid.area.norm() : 0;
    const double below = lid.volumeToBase - lid.along(base) * depths.min()[0];
    ofOutward += lid.facesBase(base, 1) ? below : 0;
    ofInward -= lid.facesBase(base, -1) ? below : 0;
    isOutwardOpen = isOutwardOpen || lid.facesBase(base, 1);
  }
  const double size = area * std::sqrt(area);
  const double least = isOutwardOpen ? ofInward : leastVolume * size;
  return along < -rounding * most && ofOutward < least - rounding * size;
}

/// Returns by rim the mean cosine between the faces that leave it and the way up.
std::vector<double> risesOf(const BoundaryLoops& rims, const Surface& surface, const Plane& base)
{
  struct Edge
  {
    std::array<std::int32_t, 2> ends;
    double rise = 1;
    bool operator<(const Edge& other) const { return ends < other.ends; }
  };
  std::vector<Edge> edges;
  std::vector<char> isOnRim(surface.vertices.size(), 0);
  const auto endsOf = [](const BoundaryLoop& rim, std::size_t i)
  {
    return std::array<std::int32_t, 2>{rim[i], rim[i + 1 < rim.size() ? i + 1 : 0]};
  };
  for (std::size_t rim = 0; rim < rims.size(); ++rim)
  {
    for (std::size_t i = 0; i < rims[rim].size(); ++i)
    {
      edges.push_back({endsOf(rims[rim], i)});
      isOnRim[std::size_t(rims[rim][i])] = 1;
    }
  }
  std::sort(edges.begin(), edges.end());
  const double scale = unitScale(surface.bounds);
  for (const Triangle& t : surface.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t from = t[i], to = t[(i + 1) % 3];
      if (!isOnRim[std::size_t(from)] || !isOnRim[std::size_t(to)])
      {
        continue;
      }
      const auto edge = std::lower_bound(edges.begin(), edges.end(), Edge{{from, to}});
      if (edge != edges.end() && edge->ends == std::array<std::int32_t, 2>{from, to})
      {
        const Eigen::Vector3d &a = surface.vertices[from], &b = surface.vertices[to];
        const Eigen::Vector3d along = ((b - a) * scale).normalized();
        const Eigen::Vector3d side = (surface.vertices[t[(i + 2) % 3]] - a) * scale;
        const Eigen::Vector3d across = (side - side.dot(along) * along).normalized();
        edge->rise = std::min(edge->rise, -across.dot(base.normal)); // whatever the order
      }
    }
  }
  std::vector<double> rises;
  for (std::size_t rim = 0; rim < rims.size(); ++rim)
  {
    double sum = 0, length = 0;
    for (std::size_t i = 0; i < rims[rim].size(); ++i)
    {
      const std::array<std::int32_t, 2> ends = endsOf(rims[rim], i);
      const double ofEdge =
        ((surface.vertices[ends[1]] - surface.vertices[ends[0]]) * scale).norm();
      sum += ofEdge * std::lower_bound(edges.begin(), edges.end(), Edge{ends})->rise;
      length += ofEdge;
    }
    rises.push_back(sum / length);
  }
  return rises;
}

/// Returns by rim whether the base closes it.
std::vector<char> rimsToClose(const BoundaryLoops& rims, const Surface& surface, const Plane& base)
{
  const double scale = unitScale(surface.bounds);
  const Eigen::Vector3d origin = surface.bounds.center();
  VertexPieces connected(surface);
  std::vector<Faces> pieces;
  std::vector<std::int32_t> pieceOf(surface.vertices.size(), -1); // by root, of those with rims
  Faces all;
  const std::vector<double> rises = risesOf(rims, surface, base);
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    std::int32_t& piece = pieceOf[std::size_t(connected.sets.find(rims[i][0]))];
    if (piece < 0)
    {
      piece = static_cast<std::int32_t>(pieces.size());
      pieces.emplace_back();
    }
    Lid lid = lidOf(rims[i], surface, base, scale);
    lid.rise = rises[i];
    lid.piece = static_cast<std::size_t>(piece);
    all.lids.push_back(lid);
    pieces[lid.piece].lids.push_back(lid);
  }
  for (const Triangle& t : surface.triangles)
  {
    const Eigen::Vector3d a = (surface.vertices[t[0]] - origin) * scale;
    const Eigen::Vector3d b = (surface.vertices[t[1]] - origin) * scale - a;
    const Eigen::Vector3d c = (surface.vertices[t[2]] - origin) * scale - a;
    const std::int32_t piece = pieceOf[std::size_t(connected.sets.find(t[0]))];
    for (Faces* const faces : {&all, piece < 0 ? nullptr : &pieces[std::size_t(piece)]})
    {
      if (faces)
      {
        faces->volume += a.dot(b.cross(c)) / 6;
        faces->area += b.cross(c).norm() / 2;
        for (const std::int32_t vertex : t)
        {
          faces->depths.extend(
            Eigen::Vector3d::Constant(-base.height(surface.vertices[vertex]) * scale));
        }
      }
    }
  }
  const bool isInward = all.lookInward(base);
  std::vector<double> sides;
  std::vector<char> areWalls;
  for (const Faces& piece : pieces)
  {
    areWalls.push_back(static_cast<char>(piece.areWalls()));
    sides.push_back((areWalls.back() ? piece.lookInward(base) : isInward) ? -1 : 1);
  }
  const auto facesBase = [&](const Lid& lid)
  {
    const bool hangs = lid.rise <= -steepest && areWalls[lid.piece];
    return lid.facesBase(base, sides[lid.piece]) && !hangs;
  };
  double most = 0;
  for (const Lid& lid : all.lids)
  {
    most = std::max(most, facesBase(lid) ? std::abs(lid.along(base)) : 0);
  }
  const double low = all.depths.min()[0] + nextToBase * all.depths.sizes()[0];
  std::vector<char> isClosed;
  for (const Lid& lid : all.lids)
  {
    const bool isLarge = std::abs(lid.along(base)) >= leastShare * most;
    const bool endsBore = lid.rise >= steepest && lid.facesBase(base, -sides[lid.piece]) &&
                          (isLarge || lid.depth <= low);
    isClosed.push_back(static_cast<char>((facesBase(lid) && isLarge) || endsBore || lid.isInBase));
  }
  return isClosed;
}

} // namespace

std::vector<Message> notesOn(const BasedOpenings& openings)
{
  std::vector<Message> notes;
  const bool isOne = openings.left == 1;
  const std::string left = std::to_string(openings.left) + (isOne ? " opening" : " openings");
  if (openings.closed == 0)
  {
    notes.emplace_back(Message(Parameter::flatBase, "closes nothing: no opening faces it"));
    notes.back().facts =
      openings.left == 0 ? "the surface has none" : left + (isOne ? " does not" : " do not");
  }
  else if (openings.left > 0)
  {
    notes.emplace_back(
      Message(Parameter::flatBase, "leaves " + left + (isOne ? " as it is" : " as they are")));
    notes.back().facts =
      isOne ? "it faces another side, or is small" : "these face another side, or are small";
  }
  if (openings.closed > 0 && openings.cutsSurface)
  {
    notes.emplace_back(Message(Parameter::flatBase, "cuts the surface"));
    notes.back().remedies = {{"choose a plane that all of it lies on one side of", {}}};
  }
  return notes;
}

FlatBase::FlatBase(const std::string& text)
  : direction_(directionIn(text))
{
  const std::string words = trimmed(text);
  const std::size_t last = words.find_last_of(" \t") + 1; // 0 for a single word
  const std::vector<double> depth = numbersIn(words.substr(last));
  if (direction_.isZero() && depth.size() == 1 && depth[0] >= 0)
  {
    direction_ = directionIn(words.substr(0, last));
    depth_ = depth[0];
  }
  if (!direction_.isZero())
  {
    return;
  }
  const std::vector<Plane> planes = planesIn(text, Parameter::flatBase, "side and no plane");
  if (planes.size() > 1)
  {
    throw Refusal(Message(Parameter::flatBase, "has more than one plane"));
  }
  if (!planes.empty())
  {
    plane_ = planes[0];
  }
}

/// Returns the plane of the base, whose normal looks away from most of the positions.
Plane FlatBase::planeBelow(const std::vector<Eigen::Vector3d>& positions) const
{
  if (!plane_)
  {
    double most = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& position : positions)
    {
      most = std::max(most, direction_.dot(position));
    }
    return {direction_, most + depth_};
  }
  Bounds heights;
  for (const Eigen::Vector3d& position : positions)
  {
    heights.extend(Eigen::Vector3d::Constant(plane_->height(position)));
  }
  const bool isBelow = heights.isEmpty() || heights.center()[0] >= 0;
  return isBelow ? Plane{-plane_->normal, -plane_->offset} : *plane_;
}

Bounds FlatBase::completed(const Bounds& bounds) const
{
  Bounds result = bounds;
  if (!this->isNone() && !bounds.isEmpty())
  {
    const std::vector<Eigen::Vector3d> corners = cornersOf(bounds);
    const Plane base = this->planeBelow(corners);
    for (const Eigen::Vector3d& corner : corners)
    {
      result.extend(base.projected(corner));
    }
  }
  return result;
}

BasedOpenings FlatBase::addTo(Surface& surface, Executor& executor) const
{
  BasedOpenings found;
  if (this->isNone() || surface.triangles.empty())
  {
    return found;
  }
  const BoundaryLoops rims = rimsOf(surface, executor);
  const Plane base = this->planeBelow(surface.vertices);
  const std::vector<char> isClosed = rimsToClose(rims, surface, base);
  const double reach = shareOfBounds * surface.bounds.sizes().maxCoeff();
  found.cutsSurface = std::any_of(surface.vertices.begin(), surface.vertices.end(),
    [&](const Eigen::Vector3d& vertex) { return base.height(vertex) > reach; });
  const auto isLess = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q)
  {
    return compareCoordinates(p, q) < 0;
  };
  std::map<Eigen::Vector3d, std::int32_t, decltype(isLess)> inBase(isLess);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
  {
    if (base.projected(surface.vertices[i]) == surface.vertices[i])
    {
      inBase.emplace(surface.vertices[i], static_cast<std::int32_t>(i));
    }
  }
  const auto footOf = [&](std::int32_t vertex)
  {
    const auto [foot, isNew] = inBase.emplace(
      base.projected(surface.vertices[vertex]), static_cast<std::int32_t>(surface.vertices.size()));
    if (isNew)
    {
      surface.vertices.push_back(foot->first);
    }
    return foot->second;
  };
  const auto add = [&surface](const Triangle& t)
  {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      surface.triangles.push_back(t);
    }
  };
  Rims soles;
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    found.closed += isClosed[i];
    found.left += !isClosed[i];
    if (!isClosed[i])
    {
      continue;
    }
    std::vector<std::int32_t>& sole = soles.emplace_back();
    for (std::size_t n = 0; n < rims[i].size(); ++n)
    {
      const std::int32_t a = rims[i][n], b = rims[i][(n + 1) % rims[i].size()];
      const std::int32_t footOfA = footOf(a), footOfB = footOf(b);
      add({b, a, footOfA});
      add({b, footOfA, footOfB});
      sole.push_back(footOfA);
    }
    std::reverse(sole.begin(), sole.end());
  }
  // Polygons take O(n²) time. Beyond a second any cap must do, which may cover more than they do.
  constexpr std::size_t mostCorners = 20'000;
  std::size_t corners = 0;
  for (const std::vector<std::int32_t>& sole : soles)
  {
    corners += sole.size();
  }
  TriangleList cap;
  if (corners <= mostCorners)
  {
    cap = planeCapOf(soles, surface.vertices, base.normal);
  }
  else
  {
    for (const std::vector<std::int32_t>& sole : soles)
    {
      for (const Triangle& t : capOf(BoundaryLoop(sole.data(), sole.data() + sole.size())))
      {
        cap.push_back({t[0], t[2], t[1]});
      }
    }
  }
  for (const Triangle& t : cap)
  {
    add(t);
  }
  surface.bounds = this->completed(surface.bounds);
  return found;
}

std::string FlatBase::along(const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const
{
  if (plane_ || direction_.isZero())
  {
    return plane_ ? textAlong({*plane_}, inverseAxes, origin) : std::string();
  }
  const Eigen::Vector3d direction = inverseAxes * direction_;
  constexpr int exact = 17;
  return joined(
    "direction ", textOf(direction), ' ', inDigits(depth_ * direction.stableNorm(), exact));
}

} // namespace winding
