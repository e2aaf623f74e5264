// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/SampleLines.h"

#include "rays/Bins.h"
#include "source/CompareCoordinates.h"
#include "source/PrefetchCorners.h"

#include <cmath>
#include <utility>

namespace winding
{

namespace
{

/// A triangle as lines along an axis see it: u and v are the axes after it.
class ProjectedTriangle
{
public:
  ProjectedTriangle(const Surface& surface, const Triangle& ids, int axis)
    : corners_{&surface.vertices[ids[0]], &surface.vertices[ids[1]], &surface.vertices[ids[2]]}
    , axis_(axis)
    , u_((axis + 1) % 3)
    , v_((axis + 2) % 3)
  {
  }

  /// Returns how often the triangle winds round a line: 1 if it looks along the axis, −1 if it
  /// looks the other way, 0 for a miss. Edges that cross a half line count, each by a sign that
  /// depends on its ends alone.
  int windingRound(const Eigen::Vector3d& place) const
  {
    const double u = place[u_], v = place[v_];
    const bool areLow[3] = {
      (*corners_[0])[v_] <= v, (*corners_[1])[v_] <= v, (*corners_[2])[v_] <= v};
    if (areLow[0] == areLow[1] && areLow[1] == areLow[2])
    {
      return 0;
    }
    int sum = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if (areLow[i] != areLow[j])
      {
        const bool isForward = compareCoordinates(*corners_[i], *corners_[j]) < 0;
        const Eigen::Vector3d &from = *corners_[isForward ? i : j],
                              &to = *corners_[isForward ? j : i];
        const double side = (from[u_] - u) * (to[v_] - v) - (to[u_] - u) * (from[v_] - v);
        const bool isBeyond = areLow[isForward ? i : j] ? side > 0 : side < 0;
        sum += isBeyond ? (areLow[i] ? 1 : -1) : 0;
      }
    }
    return sum;
  }

  /// Returns where a line crosses the plane of the triangle, within its extent.
  double placeOn(const Eigen::Vector3d& line) const
  {
    const Eigen::Vector3d &a = *corners_[0], &b = *corners_[1], &c = *corners_[2];
    const Eigen::Vector3d across = (b - a).cross(c - a);
    const double low = std::min({a[axis_], b[axis_], c[axis_]});
    const double high = std::max({a[axis_], b[axis_], c[axis_]});
    const double rise = across[u_] * (line[u_] - a[u_]) + across[v_] * (line[v_] - a[v_]);
    return across[axis_] == 0 ? low : std::clamp(a[axis_] - rise / across[axis_], low, high);
  }

  /// Returns the range of u where v is from `low` to `high`, which is empty for a miss.
  std::pair<double, double> rangeOfU(double low, double high) const
  {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (int i = 0; i < 3; ++i)
    {
      const Eigen::Vector3d &a = *corners_[i], &b = *corners_[(i + 1) % 3];
      const double from = std::max(std::min(a[v_], b[v_]), low);
      const double to = std::min(std::max(a[v_], b[v_]), high);
      if (from <= to)
      {
        // An edge along u, or nearly so, may be anywhere in its range.
        const double slope = (b[u_] - a[u_]) / (b[v_] - a[v_]);
        const bool isSteep = std::isfinite(slope);
        const double atFrom = isSteep ? a[u_] + (from - a[v_]) * slope : a[u_];
        const double atTo = isSteep ? a[u_] + (to - a[v_]) * slope : b[u_];
        first = std::min({first, atFrom, atTo});
        last = std::max({last, atFrom, atTo});
      }
    }
    return {first, last};
  }

private:
  const Eigen::Vector3d* corners_[3];
  int axis_, u_, v_;
};

/// Lines along the axes in the bins that they pass.
class BinnedLines
{
public:
  BinnedLines(const Surface& surface, const std::vector<SurfaceSample>& samples, const Bins& bins)
    : surface_(surface)
    , samples_(samples)
    , chain_(surface)
    , bins_(bins)
    , ofAxis_(3, BinnedItems(samples.size()))
  {
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const int axis = axisOf(samples[i]), u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Eigen::Vector3d& place = samples[i].position;
      const auto isBeyond = [&](int across)
      {
        return place[across] < surface.bounds.min()[across] ||
               place[across] > surface.bounds.max()[across];
      };
      if (isBeyond(u) || isBeyond(v))
      {
        continue;
      }
      ofAxis_[static_cast<std::size_t>(axis)].add(
        bins.bin(v, place[v]), bins.bin(u, place[u]), static_cast<std::int32_t>(i));
    }
  }

  /// Calls visit(line, projected) for each line that may meet a triangle, whose corners are in
  /// a range of bins.
  template <class Visit>
  void forEachNear(std::size_t triangle, const BinBox& box, const Visit& visit) const
  {
    const int level = box.level();
    const int x = box.first(0), y = box.first(1), z = box.first(2);
    const std::uint64_t areNear[3] = {ofAxis_[0].areNear(z, y, level),
      ofAxis_[1].areNear(x, z, level), ofAxis_[2].areNear(y, x, level)};
    if ((areNear[0] | areNear[1] | areNear[2]) == 0)
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (areNear[axis] != 0)
      {
        this->forEachNear(triangle, box, axis, visit);
      }
    }
  }

  /// Adds the lines that meet a triangle, whose corners are in a range of bins.
  void addHits(std::size_t triangle, const BinBox& box, std::vector<LineHit>& hits) const
  {
    this->forEachNear(triangle, box,
      [&](std::int32_t line, const ProjectedTriangle& projected)
      {
        const Eigen::Vector3d& place = samples_[static_cast<std::size_t>(line)].position;
        const int winding = projected.windingRound(place);
        if (winding != 0)
        {
          hits.push_back({line, static_cast<std::int32_t>(triangle),
            winding * chain_.multiplicity(triangle), projected.placeOn(place)});
        }
      });
  }

private:
  template <class Visit>
  void forEachNear(std::size_t triangle, const BinBox& box, int axis, const Visit& visit) const
  {
    const BinnedItems& lines = ofAxis_[static_cast<std::size_t>(axis)];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const ProjectedTriangle projected(surface_, surface_.triangles[triangle], axis);
    constexpr int few = 3; // bins that need no closer look
    const bool isNarrow = box.last(u) - box.first(u) < few || box.last(v) - box.first(v) < few;
    for (int row = box.first(v); row <= box.last(v); ++row)
    {
      int first = box.first(u), last = box.last(u);
      if (!isNarrow)
      {
        constexpr double margin = 1e-3; // bins, which is more than rounding
        const auto [low, high] =
          projected.rangeOfU(bins_.start(v, row - margin), bins_.start(v, row + 1 + margin));
        first = low <= high ? std::max(first, bins_.bin(u, low) - 1) : last + 1;
        last = std::min(last, bins_.bin(u, high) + 1);
      }
      if (first <= last)
      {
        lines.forEach(row, first, last, [&](std::int32_t line) { visit(line, projected); });
      }
    }
  }

  const Surface& surface_;
  const std::vector<SurfaceSample>& samples_;
  ChainView chain_;
  const Bins& bins_;
  std::vector<BinnedItems> ofAxis_;
};

std::ptrdiff_t sharedCorners(const Triangle& a, const Triangle& b)
{
  return std::count_if(a.begin(), a.end(),
    [&b](std::int32_t corner) { return std::find(b.begin(), b.end(), corner) != b.end(); });
}

/// Returns the thickness of a wall whose other side, with a unit normal, a line along an axis meets
/// after `distance`; infinity where that side does not look the other way. It is right for parallel
/// sides, and at least 0.7 times as thick as a round rod.
double thicknessOf(
  const Eigen::Vector3d& normal, const Eigen::Vector3d& otherNormal, int axis, double distance)
{
  constexpr double sideways = -0.1; // sides at right angles to each other are no wall
  const double cosine = normal.dot(otherNormal);
  const double slants = (std::abs(normal[axis]) + std::abs(otherNormal[axis])) / 2;
  return cosine < sideways ? distance * slants / std::sqrt((1 - cosine) / 2)
                           : std::numeric_limits<double>::infinity();
}

/// Returns the bins of a triangle.
BinBox boxOf(const Bins& bins, const Surface& surface, std::size_t triangle)
{
  const Triangle& t = surface.triangles[triangle];
  return Bins::boxOf(bins.binsOf(surface.vertices[t[0]]), bins.binsOf(surface.vertices[t[1]]),
    bins.binsOf(surface.vertices[t[2]]));
}

} // namespace

int axisOf(const SurfaceSample& sample)
{
  int axis = 0;
  sample.normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

double affordableShare(const Surface& surface, const std::vector<SurfaceSample>& samples,
  const SurfaceSamples& all, double more)
{
  const Bins bins(all.box, all.extents);
  const BinnedLines lines(surface, samples, bins);
  double tests = 0;
  for (const std::int32_t triangle : all.ordinary)
  {
    const auto i = static_cast<std::size_t>(triangle);
    lines.forEachNear(
      i, boxOf(bins, surface, i), [&](std::int32_t, const ProjectedTriangle&) { ++tests; });
  }
  const auto triangles = static_cast<double>(surface.triangles.size());
  tests *= triangles / static_cast<double>(std::max<std::size_t>(all.ordinary.size(), 1));
  const double most = 0x1p15 + triangles / 4 + more;
  return tests > most ? most / tests : 1;
}

std::vector<LineHit> hitsOfLines(const Surface& surface, const std::vector<SurfaceSample>& samples,
  const SurfaceSamples& all, Executor& executor, const std::vector<std::int32_t>* some)
{
  if (samples.empty())
  {
    return {};
  }
  const Bins bins(all.box, all.extents);
  const BinnedLines lines(surface, samples, bins);
  UninitializedVector<std::uint32_t> ofVertex(some ? 0 : surface.vertices.size());
  forEachItem(
    ofVertex.size(), [&](std::size_t i) { ofVertex[i] = bins.binsOf(surface.vertices[i]); },
    executor);
  constexpr std::size_t perBlock = 16384;
  const std::size_t triangles = some ? some->size() : surface.triangles.size();
  std::vector<std::vector<LineHit>> ofBlocks((triangles + perBlock - 1) / perBlock);
  runBlocks(
    triangles, perBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        if (some)
        {
          const auto number = static_cast<std::size_t>((*some)[i]);
          lines.addHits(number, boxOf(bins, surface, number), ofBlocks[block]);
          continue;
        }
        prefetchCorners(ofVertex.data(), surface.triangles, i);
        const Triangle& t = surface.triangles[i];
        lines.addHits(
          i, Bins::boxOf(ofVertex[t[0]], ofVertex[t[1]], ofVertex[t[2]]), ofBlocks[block]);
      }
    },
    executor);
  std::vector<LineHit> hits;
  for (const std::vector<LineHit>& ofBlock : ofBlocks)
  {
    hits.insert(hits.end(), ofBlock.begin(), ofBlock.end());
  }
  return hits;
}

std::vector<SampleLine> linesThrough(const Surface& surface,
  const std::vector<SurfaceSample>& samples, const SurfaceSamples& all, Executor& executor,
  const std::vector<std::int32_t>* some)
{
  std::vector<SampleLine> result(samples.size());
  const double atPoint = 0x1p-20 * surface.bounds.sizes().maxCoeff();
  std::vector<double> nearest(samples.size(), std::numeric_limits<double>::infinity());
  for (const LineHit& hit : hitsOfLines(surface, samples, all, executor, some))
  {
    const auto number = static_cast<std::size_t>(hit.sample);
    const SurfaceSample& sample = samples[number];
    const int axis = axisOf(sample), along = sample.normal[axis] > 0 ? 1 : -1;
    const int times = along * hit.times;
    const double ahead = along * (hit.place - sample.position[axis]);
    SampleLine& line = result[number];
    const bool isAtPoint = hit.triangle == sample.triangle || std::abs(ahead) <= atPoint;
    line.times += isAtPoint ? 0 : std::abs(times);
    if (isAtPoint)
    {
      line.step += times;
      line.isRepeated |=
        hit.triangle != sample.triangle && sample.triangle >= 0 &&
        sharedCorners(surface.triangles[hit.triangle], surface.triangles[sample.triangle]) > 1;
    }
    else if (ahead > 0)
    {
      line.before += times;
      ++line.facesBefore;
    }
    else
    {
      line.behind -= times;
      ++line.facesBehind;
      if (-ahead > nearest[number] + atPoint)
      {
        continue;
      }
      // Where faces coincide, one that looks the other way ends the wall.
      const Eigen::Vector3d normal = unitNormalOf(surface, surface.triangles[hit.triangle]);
      const double wall = thicknessOf(sample.normal, normal, axis, -ahead);
      if (-ahead < nearest[number] - atPoint || wall < line.wall)
      {
        line.wall = wall;
        line.entry = thicknessOf(sample.normal, -normal, axis, -ahead);
        line.wallTriangle = hit.triangle;
      }
      nearest[number] = std::min(nearest[number], -ahead);
    }
  }
  return result;
}

} // namespace winding
