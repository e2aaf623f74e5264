// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Sanitize.h"
#include "base/Digits.h"
#include "base/Executor.h"

#include "base/Concatenation.h"
#include "base/Refusal.h"
#include "source/PrefetchCorners.h"
#include "source/UnitNormal.h"
#include "source/Weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace winding
{

namespace
{

bool hasValidIds(const TrianglesView& view, std::size_t triangle)
{
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::int64_t id = view.triangles(triangle, corner);
    if (id < 0 || static_cast<std::uint64_t>(id) >= view.points.size())
    {
      return false;
    }
  }
  return true;
}

Eigen::Vector3d corner(const TrianglesView& view, std::size_t triangle, std::size_t index)
{
  return view.points[static_cast<std::size_t>(view.triangles(triangle, index))];
}

void askForNext(const TrianglesView& view, std::size_t triangle, std::size_t end)
{
  prefetch(view, triangle, end, [&](std::size_t id) { askForPoint(view, id); });
}

/// Points in their order need nothing: memory comes ahead by itself.
void askForNext(const OrientedPointsView&, std::size_t, std::size_t) {}

bool isInRange(const Eigen::Vector3d& position)
{
  return (position.array().abs() <= largestCoordinate).all(); // NaN is not
}

enum class TriangleFault
{
  none,
  invalidId,
  nonFinite,
  collapsed,
  outOfRange
};

TriangleFault faultOf(const TrianglesView& view, std::size_t i)
{
  if (!hasValidIds(view, i))
  {
    return TriangleFault::invalidId;
  }
  const Eigen::Vector3d a = corner(view, i, 0), b = corner(view, i, 1), c = corner(view, i, 2);
  if (!isInRange(a) || !isInRange(b) || !isInRange(c))
  {
    return a.allFinite() && b.allFinite() && c.allFinite() ? TriangleFault::outOfRange
                                                           : TriangleFault::nonFinite;
  }
  return a == b || b == c || c == a ? TriangleFault::collapsed : TriangleFault::none;
}

enum class PointFault
{
  none,
  nonFinite,
  zeroNormal,
  badArea,
  outOfRange
};

PointFault faultOf(const OrientedPointsView& view, std::size_t i)
{
  const Eigen::Vector3d normal = view.normals.empty() ? Eigen::Vector3d(0, 0, 1) : view.normals[i];
  const double area = view.areas.empty() ? 0 : view.areas[i];
  const Eigen::Vector3d position = view.positions[i];
  if (!isInRange(position))
  {
    // This comes first: normals and areas that were made from positions may have overflown.
    return position.allFinite() ? PointFault::outOfRange : PointFault::nonFinite;
  }
  if (!normal.allFinite() || !std::isfinite(area))
  {
    return PointFault::nonFinite;
  }
  if (normal == Eigen::Vector3d::Zero())
  {
    return PointFault::zeroNormal;
  }
  return area < 0 ? PointFault::badArea : PointFault::none;
}

/// The name of an item of a view for users, such as "point 7" or "point 7 of part 2".
template <class View>
std::string nameOf(const std::vector<View>& views, std::size_t view, std::size_t point)
{
  return "point " + std::to_string(point) +
         (views.size() > 1 ? " of part " + std::to_string(view) : "");
}

template <class... Parts> [[noreturn]] void refuse(const Parts&... parts)
{
  throw Refusal(joined(parts...));
}

[[noreturn]] void refusePosition(const std::string& name, const Eigen::Vector3d& position)
{
  refuse(name, " lies at ", position[0], " ", position[1], " ", position[2],
    "; coordinates may be up to ", largestCoordinate, ": leave it out or scale the source down");
}

[[noreturn]] void refuseOutOfRange(
  const std::vector<TrianglesView>& views, std::size_t view, std::size_t triangle)
{
  std::size_t i = 0;
  while (i < 2 && isInRange(corner(views[view], triangle, i)))
  {
    ++i;
  }
  const auto point = static_cast<std::size_t>(views[view].triangles(triangle, i));
  refusePosition(nameOf(views, view, point), corner(views[view], triangle, i));
}

[[noreturn]] void refuseOutOfRange(
  const std::vector<OrientedPointsView>& views, std::size_t view, std::size_t point)
{
  refusePosition(nameOf(views, view, point), views[view].positions[point]);
}

std::size_t sizeOf(const TrianglesView& view)
{
  return view.triangles.size();
}

std::size_t sizeOf(const OrientedPointsView& view)
{
  return view.positions.size();
}

/// Calls work(view, item) for the numbers of all items without a fault. Throws Refusal for the
/// first item that is out of range.
template <class View, class Work>
void forEachUsable(const std::vector<View>& views, const Work& work)
{
  for (std::size_t view = 0; view < views.size(); ++view)
  {
    for (std::size_t i = 0; i < sizeOf(views[view]); ++i)
    {
      const auto fault = faultOf(views[view], i);
      using Fault = decltype(faultOf(views[view], i));
      if (fault == Fault::outOfRange)
      {
        refuseOutOfRange(views, view, i);
      }
      if (fault == Fault::none)
      {
        work(view, i);
      }
    }
  }
}

constexpr std::size_t primitivesPerBlock = 16384;

std::size_t blocksOf(std::size_t primitives)
{
  return (primitives + primitivesPerBlock - 1) / primitivesPerBlock;
}

/// The bounds of all items without a fault; extend(view, item, box) extends a box by an item.
/// Throws Refusal for the first item that is out of range.
template <class View, class Extend>
Bounds boundsOfUsable(const std::vector<View>& views, const Extend& extend, Executor& executor)
{
  const Concatenation items(views, [](const View& view) { return sizeOf(view); });
  struct OfBlock
  {
    Bounds bounds;
    bool isOutOfRange = false;
  };
  std::vector<OfBlock> blocks(blocksOf(items.size()));
  runBlocks(
    items.size(), primitivesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      OfBlock found;
      items.forEachPart(first, last,
        [&](std::size_t number, std::size_t begin, std::size_t end, std::size_t)
        {
          const View& view = views[number];
          using Fault = decltype(faultOf(view, 0));
          for (std::size_t i = begin; i < end; ++i)
          {
            askForNext(view, i, end);
            const Fault fault = faultOf(view, i);
            found.isOutOfRange = found.isOutOfRange || fault == Fault::outOfRange;
            if (fault == Fault::none)
            {
              extend(view, i, found.bounds);
            }
          }
        });
      blocks[block] = found;
    },
    executor);
  Bounds bounds;
  for (const OfBlock& block : blocks)
  {
    if (block.isOutOfRange)
    {
      forEachUsable(views, [](std::size_t, std::size_t) {}); // throws for the first of them
    }
    bounds.extend(block.bounds);
  }
  return bounds;
}

double longestSide(const Bounds& bounds)
{
  return bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff();
}

/// Throws Refusal for a source that is too small, unless it is a single place.
void checkSize(const Bounds& bounds)
{
  const double longest = longestSide(bounds);
  if (longest > 0 && longest < smallestSize)
  {
    const Eigen::Vector3d& corner = bounds.min();
    refuse("the source at ", corner[0], " ", corner[1], " ", corner[2], " has a length of ",
      longest, " along its longest side; that must be ", smallestSize, " at least: scale it up");
  }
}

/// Throws Refusal for the first area that is too large for a cloud of these bounds.
void checkAreas(const std::vector<OrientedPointsView>& views, const Bounds& bounds)
{
  const double largest = largestArea(bounds);
  forEachUsable(views,
    [&](std::size_t view, std::size_t point)
    {
      const double area = views[view].areas[point];
      if (area > largest)
      {
        refuse(nameOf(views, view, point), " has the area ", area,
          "; areas in a cloud of this size may be up to ", largest, ": correct it");
      }
    });
}

/// Whether all parts of a cloud have some array. Throws Refusal if some have it and others do not.
template <class IsMissing>
bool allOrNone(
  const std::vector<OrientedPointsView>& views, const std::string& what, const IsMissing& isMissing)
{
  bool any = false, all = true;
  for (const OrientedPointsView& view : views)
  {
    any = any || !isMissing(view);
    all = all && (view.positions.empty() || !isMissing(view));
  }
  if (any && !all)
  {
    throw Refusal(
      "give " + what + " to all parts of the cloud: some have them and others have none");
  }
  return any;
}

/// The number of primitives of a block by their fault; the first number counts those without.
using FaultCounts = std::array<std::size_t, 5>;

template <class Fault> std::size_t sumOf(const std::vector<FaultCounts>& blocks, Fault fault)
{
  std::size_t sum = 0;
  for (const FaultCounts& block : blocks)
  {
    sum += block[static_cast<std::size_t>(fault)];
  }
  return sum;
}

/// The places where each block's primitives without a fault begin, and at last how many there are.
std::vector<std::size_t> startsOfKept(const std::vector<FaultCounts>& blocks)
{
  std::vector<std::size_t> starts(1, 0);
  for (const FaultCounts& block : blocks)
  {
    starts.push_back(starts.back() + block[0]);
  }
  return starts;
}

} // namespace

double largestArea(const Bounds& bounds)
{
  constexpr double largest = 1e210, largestShare = 1e30;
  const double longest = longestSide(bounds);
  return longest > 0 ? std::min(largestShare * longest * longest, largest) : largest;
}

void checkLengths(const OrientedPointsView& view)
{
  const std::size_t points = view.positions.size();
  if ((!view.normals.empty() && view.normals.size() != points) ||
      (!view.areas.empty() && view.areas.size() != points))
  {
    throw Refusal("give a normal and an area to every point: the cloud has " +
                  std::to_string(points) + " points but " + std::to_string(view.normals.size()) +
                  " normals and " + std::to_string(view.areas.size()) + " areas");
  }
}

Surface sanitize(const std::vector<TrianglesView>& views, Executor& executor)
{
  const Concatenation triangles(
    views, [](const TrianglesView& view) { return view.triangles.size(); });
  Surface surface;
  surface.inputTriangles = triangles.size();
  if (triangles.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Refusal("split the surface: it has more than 2147483647 triangles");
  }
  Weld weld(views);
  std::vector<FaultCounts> faults(blocksOf(triangles.size()));
  runBlocks(
    triangles.size(), primitivesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      FaultCounts counts{};
      triangles.forEachPart(first, last,
        [&](std::size_t number, std::size_t begin, std::size_t end, std::size_t)
        {
          const TrianglesView& view = views[number];
          const std::size_t firstPoint = weld.firstPoint(number);
          for (std::size_t i = begin; i < end; ++i)
          {
            prefetch(view, i, end,
              [&](std::size_t id)
              {
                askForPoint(view, id);
                weld.askForState(firstPoint + id);
              });
            const TriangleFault fault = faultOf(view, i);
            ++counts[static_cast<std::size_t>(fault)];
            if (fault == TriangleFault::none)
            {
              for (std::size_t corner = 0; corner < 3; ++corner)
              {
                weld.use(firstPoint + static_cast<std::size_t>(view.triangles(i, corner)));
              }
            }
          }
        });
      faults[block] = counts;
    },
    executor);
  if (sumOf(faults, TriangleFault::outOfRange) > 0)
  {
    boundsOf(views); // throws for the first of them
  }
  surface.nonFiniteTriangles = sumOf(faults, TriangleFault::nonFinite);
  surface.invalidIdTriangles = sumOf(faults, TriangleFault::invalidId);
  surface.collapsedTriangles = sumOf(faults, TriangleFault::collapsed);
  if (surface.inputTriangles > 0 && surface.dropped() == surface.inputTriangles)
  {
    throw Refusal("mend the surface: all " + std::to_string(surface.inputTriangles) +
                  " triangles are unusable, " + std::to_string(surface.nonFiniteTriangles) +
                  " with NaN or infinite coordinates, " +
                  std::to_string(surface.invalidIdTriangles) +
                  " with ids of points that do not exist");
  }

  weld.makeVertices(surface, executor);
  checkSize(surface.bounds);
  const std::vector<std::size_t> starts = startsOfKept(faults);
  surface.triangles.resize(starts.back());
  runBlocks(
    triangles.size(), primitivesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      const bool keepsAll = starts[block + 1] - starts[block] == last - first;
      Triangle* kept = surface.triangles.data() + starts[block];
      triangles.forEachPart(first, last,
        [&](std::size_t number, std::size_t begin, std::size_t end, std::size_t)
        {
          const TrianglesView& view = views[number];
          const std::size_t firstPoint = weld.firstPoint(number);
          const auto vertexOf = [&](std::size_t i, std::size_t corner)
          {
            return weld.vertexOf(firstPoint + static_cast<std::size_t>(view.triangles(i, corner)));
          };
          for (std::size_t i = begin; i < end; ++i)
          {
            prefetch(view, i, end, [&](std::size_t id) { weld.askForVertex(firstPoint + id); });
            if (keepsAll || faultOf(view, i) == TriangleFault::none)
            {
              *kept++ = {vertexOf(i, 0), vertexOf(i, 1), vertexOf(i, 2)};
            }
          }
        });
    },
    executor);
  return surface;
}

bool haveDirections(const VectorsView& normals)
{
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Eigen::Vector3d normal = normals[i];
    if (normal.allFinite() && normal != Eigen::Vector3d::Zero())
    {
      return true;
    }
  }
  return false;
}

void removeEmptyNormals(std::vector<OrientedPointsView>& views)
{
  const bool isAny = std::any_of(views.begin(), views.end(),
    [](const OrientedPointsView& view) { return haveDirections(view.normals); });
  for (OrientedPointsView& view : views)
  {
    view.normals = isAny ? view.normals : VectorsView();
  }
}

PointCloud sanitize(const std::vector<OrientedPointsView>& given, Executor& executor)
{
  for (const OrientedPointsView& view : given)
  {
    checkLengths(view);
  }
  std::vector<OrientedPointsView> views = given;
  removeEmptyNormals(views);
  const bool withNormals = allOrNone(
    views, "normals", [](const OrientedPointsView& view) { return view.normals.empty(); });
  const bool withAreas =
    allOrNone(views, "areas", [](const OrientedPointsView& view) { return view.areas.empty(); });
  const Concatenation points(
    views, [](const OrientedPointsView& view) { return view.positions.size(); });
  std::vector<FaultCounts> faults(blocksOf(points.size()));
  runBlocks(
    points.size(), primitivesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      FaultCounts counts{};
      points.forEachPart(first, last,
        [&](std::size_t view, std::size_t begin, std::size_t end, std::size_t)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            ++counts[static_cast<std::size_t>(faultOf(views[view], i))];
          }
        });
      faults[block] = counts;
    },
    executor);
  if (sumOf(faults, PointFault::outOfRange) > 0)
  {
    boundsOf(views); // throws for the first of them
  }
  PointCloud cloud;
  cloud.inputPoints = points.size();
  cloud.nonFinitePoints = sumOf(faults, PointFault::nonFinite);
  cloud.zeroNormalPoints = sumOf(faults, PointFault::zeroNormal);
  cloud.badAreaPoints = sumOf(faults, PointFault::badArea);
  if (cloud.inputPoints > 0 && cloud.dropped() == cloud.inputPoints)
  {
    throw Refusal(Message("all points are unusable", {{"give points with a place", {}}},
      "of " + std::to_string(cloud.inputPoints) + ", " + std::to_string(cloud.nonFinitePoints) +
        " have NaN or infinite values, " + std::to_string(cloud.zeroNormalPoints) +
        " normals of length 0, " + std::to_string(cloud.badAreaPoints) + " negative areas"));
  }

  const std::vector<std::size_t> starts = startsOfKept(faults);
  cloud.positions.resize(starts.back());
  cloud.normals.resize(withNormals ? starts.back() : 0);
  cloud.areas.resize(withAreas ? starts.back() : 0);
  std::vector<Bounds> bounds(faults.size());
  runBlocks(
    points.size(), primitivesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t kept = starts[block];
      Bounds ofBlock;
      points.forEachPart(first, last,
        [&](std::size_t number, std::size_t begin, std::size_t end, std::size_t)
        {
          const OrientedPointsView& view = views[number];
          for (std::size_t i = begin; i < end; ++i)
          {
            if (!isUsable(view, i))
            {
              continue;
            }
            // Adding 0 turns −0 into 0, which compares equal but has other bits.
            cloud.positions[kept] = view.positions[i].array() + 0.0;
            if (withNormals)
            {
              cloud.normals[kept] = unitNormal(view.normals[i]).array() + 0.0;
            }
            if (withAreas)
            {
              cloud.areas[kept] = view.areas[i] + 0.0;
            }
            ofBlock.extend(cloud.positions[kept]);
            ++kept;
          }
        });
      bounds[block] = ofBlock;
    },
    executor);
  for (const Bounds& ofBlock : bounds)
  {
    cloud.bounds.extend(ofBlock);
  }
  checkSize(cloud.bounds);
  if (withAreas)
  {
    checkAreas(views, cloud.bounds);
  }
  return cloud;
}

bool isUsable(const TrianglesView& view, std::size_t triangle)
{
  return faultOf(view, triangle) == TriangleFault::none;
}

PolygonParts polygonPartsOf(const std::vector<TrianglesView>& views)
{
  PolygonParts parts;
  if (std::none_of(views.begin(), views.end(),
        [](const TrianglesView& view) { return view.isContinued != nullptr; }))
  {
    return parts;
  }
  for (const TrianglesView& view : views)
  {
    bool isPolygonThere = false;
    for (std::size_t i = 0; i < view.triangles.size(); ++i)
    {
      isPolygonThere = isPolygonThere && view.isContinued && view.isContinued[i];
      if (isUsable(view, i))
      {
        parts.push_back(isPolygonThere);
        isPolygonThere = true;
      }
    }
  }
  return parts;
}

bool isUsable(const OrientedPointsView& view, std::size_t point)
{
  return faultOf(view, point) == PointFault::none;
}

Bounds boundsOf(const std::vector<TrianglesView>& views)
{
  SerialExecutor serial;
  return boundsOf(views, serial);
}

Bounds boundsOf(const std::vector<TrianglesView>& views, Executor& executor)
{
  const Bounds bounds = boundsOfUsable(
    views,
    [](const TrianglesView& view, std::size_t triangle, Bounds& box)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        box.extend(corner(view, triangle, i));
      }
    },
    executor);
  checkSize(bounds);
  return bounds;
}

Bounds boundsOf(const std::vector<OrientedPointsView>& views)
{
  SerialExecutor serial;
  return boundsOf(views, serial);
}

Bounds boundsOf(const std::vector<OrientedPointsView>& given, Executor& executor)
{
  for (const OrientedPointsView& view : given)
  {
    checkLengths(view);
  }
  std::vector<OrientedPointsView> views = given;
  removeEmptyNormals(views);
  const Bounds bounds = boundsOfUsable(
    views,
    [](const OrientedPointsView& view, std::size_t point, Bounds& box)
    { box.extend(view.positions[point]); },
    executor);
  checkSize(bounds);
  return bounds;
}

} // namespace winding
