// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/SurfaceSamples.h"

#include "source/CompareCoordinates.h"
#include "source/CoordinateOrder.h"
#include "source/CornersAhead.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace winding
{

namespace
{

std::uint64_t mixed(std::uint64_t bits)
{
  bits ^= bits >> 32;
  bits *= 0xd6e8feb86659fd93u;
  bits ^= bits >> 32;
  bits *= 0xd6e8feb86659fd93u;
  return bits ^ bits >> 32;
}

/// Returns the bits of a number, low ones among them that differ also where it is round.
std::uint64_t bitsOf(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return bits ^ bits >> 32;
}

std::uint64_t hashOf(const Eigen::Vector3d& place)
{
  const std::uint64_t sum = bitsOf(place[0]) * 0x9e3779b97f4a7c15u +
                            bitsOf(place[1]) * 0xbf58476d1ce4e5b9u +
                            bitsOf(place[2]) * 0x94d049bb133111ebu;
  return (sum ^ sum >> 32) * 0xd6e8feb86659fd93u;
}

/// Returns a hash of the corners of a triangle, whatever their order.
std::uint64_t hashOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return mixed(hashOf(a) + hashOf(b) + hashOf(c));
}

std::uint64_t hashOf(const Surface& surface, const Triangle& t)
{
  return hashOf(surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]);
}

/// Returns a number between 0 and 1.
double unitOf(std::uint64_t hash)
{
  return (static_cast<double>(hash >> 12) + 0.5) * 0x1p-52;
}

/// A triangle and its key. Lower keys are chosen first.
struct Keyed
{
  double key;
  std::int32_t triangle;

  bool operator<(const Keyed& other) const { return key < other.key; }
};

/// Keeps the lowest keys of those that it is given.
class Lowest
{
public:
  explicit Lowest(std::size_t count)
    : count_(count)
  {
  }

  /// Returns a key that is not kept any more, nor are higher ones.
  double limit() const { return limit_; }

  void limitTo(double limit) { limit_ = std::min(limit_, limit); }

  void add(double key, std::size_t triangle)
  {
    if (key < limit_)
    {
      kept_.push_back({key, static_cast<std::int32_t>(triangle)});
      if (kept_.size() == 2 * count_)
      {
        this->take();
      }
    }
  }

  void add(const Lowest& others)
  {
    for (const Keyed& other : others.kept_)
    {
      this->add(other.key, static_cast<std::size_t>(other.triangle));
    }
  }

  /// Returns the lowest, in any order.
  const std::vector<Keyed>& take()
  {
    if (kept_.size() > count_)
    {
      const auto last = kept_.begin() + static_cast<std::ptrdiff_t>(count_) - 1;
      std::nth_element(kept_.begin(), last, kept_.end());
      kept_.resize(count_);
      limit_ = std::min(limit_, std::nextafter(kept_.back().key, HUGE_VAL));
    }
    return kept_;
  }

private:
  std::size_t count_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<Keyed> kept_;
};

/// Returns half the cross product of two sides, whose bits do not depend on the first corner.
Eigen::Vector3d areaVectorOf(const Surface& surface, const Triangle& triangle, double scale)
{
  const Triangle t = lowestFirst(surface.vertices, triangle);
  const Eigen::Vector3d& a = surface.vertices[t[0]];
  return (scale * (surface.vertices[t[1]] - a)).cross(scale * (surface.vertices[t[2]] - a)) / 2;
}

/// Adds `count` points of a triangle with the weight `weight` together.
void addPoints(const Surface& surface, std::size_t triangle, std::size_t count, double weight,
  std::vector<SurfaceSample>& points)
{
  const Triangle& t = surface.triangles[triangle];
  Eigen::Vector3d corners[3] = {
    surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
  std::sort(corners, corners + 3, [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return compareCoordinates(a, b) < 0; });
  const Eigen::Vector3d normal = unitNormalOf(surface, t);
  const std::uint64_t hash = mixed(hashOf(surface, t));
  const double first[2] = {unitOf(hash), unitOf(mixed(hash + 1))};
  for (std::size_t i = 0; i < count; ++i)
  {
    // A sequence of low discrepancy (Roberts 2018), folded into the triangle.
    const auto number = static_cast<double>(i);
    double u = std::fmod(first[0] + 0.7548776662466927 * number, 1);
    double v = std::fmod(first[1] + 0.5698402909980532 * number, 1);
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    points.push_back({static_cast<std::int32_t>(triangle), weight / static_cast<double>(count),
      (1 - u - v) * corners[0] + u * corners[1] + v * corners[2], normal});
  }
}

Eigen::Vector3d extentsOf(const Surface& surface, const Triangle& t)
{
  const Eigen::Vector3d &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                        &c = surface.vertices[t[2]];
  return a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
}

} // namespace

Eigen::Vector3d unitNormalOf(const Surface& surface, const Triangle& t)
{
  return areaVectorOf(surface, t, unitScale(surface.bounds)).stableNormalized();
}

/// Returns the triangles with a corner that a hash chooses, each with the probability `share`.
static std::vector<std::int32_t> trianglesAtChosenVertices(
  const Surface& surface, double share, Executor& executor)
{
  const double shareOfVertices = 1 - std::cbrt(1 - share);
  const auto limit = static_cast<std::uint64_t>(0x1p64 * shareOfVertices);
  UninitializedVector<char> isChosen(surface.vertices.size());
  forEachItem(
    isChosen.size(),
    [&](std::size_t i)
    {
      isChosen[i] = static_cast<char>(hashOf(surface.vertices[i]) < limit);
    },
    executor);
  constexpr std::size_t perBlock = 16384;
  const std::size_t triangles = surface.triangles.size();
  std::vector<UninitializedVector<std::int32_t>> ofBlocks((triangles + perBlock - 1) / perBlock);
  runBlocks(
    triangles, perBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      UninitializedVector<std::int32_t>& listed = ofBlocks[block];
      listed.resize(last - first);
      std::size_t count = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        const Triangle& t = surface.triangles[i];
        listed[count] = static_cast<std::int32_t>(i);
        count += (isChosen[t[0]] | isChosen[t[1]] | isChosen[t[2]]) != 0;
      }
      listed.resize(count);
    },
    executor);
  std::vector<std::int32_t> result;
  for (const UninitializedVector<std::int32_t>& listed : ofBlocks)
  {
    result.insert(result.end(), listed.begin(), listed.end());
  }
  return result;
}

SurfaceSamples sampleSurface(const Surface& surface, std::size_t most, Executor& executor)
{
  SurfaceSamples result;
  const std::size_t all = surface.triangles.size();
  const std::size_t wanted = std::min(most, 64 + 16 * all);
  constexpr std::size_t ordinary = 256; // triangles that sizes are taken from
  constexpr std::size_t perBlock = 16384;
  const double scale = unitScale(surface.bounds);
  // These are enough to meet the other sides of walls.
  const double enough = 0x1p13 + static_cast<double>(all) / 16;
  if (enough < static_cast<double>(all))
  {
    result.shareOfSome = enough / static_cast<double>(all);
    result.some = trianglesAtChosenVertices(surface, result.shareOfSome, executor);
  }
  constexpr std::size_t large = 1 << 17;
  const bool areSome = all > large;
  const std::size_t triangles = areSome ? result.some.size() : all;
  struct Block
  {
    Lowest lowest, ordinary;
  };
  std::vector<Block> blocks(
    (triangles + perBlock - 1) / perBlock, Block{Lowest(wanted), Lowest(ordinary)});
  // Keys that one block drops are dropped by all.
  std::atomic<double> limit{std::numeric_limits<double>::infinity()};
  std::atomic<double> ordinaryLimit{std::numeric_limits<double>::infinity()};
  runBlocks(
    triangles, perBlock,
    [&](std::size_t number, std::size_t first, std::size_t last)
    {
      Block& block = blocks[number];
      block.lowest.limitTo(limit);
      block.ordinary.limitTo(ordinaryLimit);
      for (std::size_t n = first; n < last; ++n)
      {
        const std::size_t i = areSome ? static_cast<std::size_t>(result.some[n]) : n;
        askForCornersAhead(surface.vertices.data(), surface.triangles, i);
        const Triangle& t = surface.triangles[i];
        const Eigen::Vector3d &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                              &c = surface.vertices[t[2]];
        const double random = unitOf(hashOf(a, b, c));
        const double square = (scale * (b - a)).cross(scale * (c - a)).squaredNorm() / 4;
        const double highest = block.lowest.limit();
        if (random * random < highest * highest * square && square > 0)
        {
          block.lowest.add(random / areaVectorOf(surface, t, scale).norm(), i);
        }
        if (random < block.ordinary.limit())
        {
          block.ordinary.add(random, i);
        }
      }
      block.lowest.take();
      block.ordinary.take();
      limit = std::min(limit.load(), block.lowest.limit());
      ordinaryLimit = std::min(ordinaryLimit.load(), block.ordinary.limit());
    },
    executor);
  Lowest lowest(wanted), lowestOrdinary(ordinary);
  for (const Block& block : blocks)
  {
    lowest.add(block.lowest);
    lowestOrdinary.add(block.ordinary);
  }
  std::vector<Keyed> chosen = lowest.take();
  std::sort(chosen.begin(), chosen.end());
  // Small triangles represent others of their size, which were not chosen.
  const double least = chosen.size() < wanted ? 0 : 1 / chosen.back().key;
  const auto weightOf = [&](const Keyed& keyed)
  {
    const Triangle& t = surface.triangles[keyed.triangle];
    return std::max(areaVectorOf(surface, t, scale).norm(), least);
  };
  double sum = 0;
  for (const Keyed& keyed : chosen)
  {
    sum += weightOf(keyed);
  }
  for (const Keyed& keyed : chosen)
  {
    const double weight = weightOf(keyed);
    const double points = std::round(static_cast<double>(wanted) * weight / sum);
    addPoints(surface, static_cast<std::size_t>(keyed.triangle),
      static_cast<std::size_t>(std::max(1.0, points)), weight, result.points);
  }
  std::vector<Keyed> ordinaries = lowestOrdinary.take();
  std::sort(ordinaries.begin(), ordinaries.end());
  for (const Keyed& keyed : ordinaries)
  {
    result.extents += extentsOf(surface, surface.triangles[keyed.triangle]) /
                      static_cast<double>(ordinaries.size());
  }
  return result;
}

std::vector<SurfaceSample> sampleTriangles(
  const Surface& surface, const std::vector<std::int32_t>& triangles)
{
  const double scale = unitScale(surface.bounds);
  std::vector<SurfaceSample> points;
  for (const std::int32_t triangle : triangles)
  {
    const double area = areaVectorOf(surface, surface.triangles[triangle], scale).norm();
    if (area > 0)
    {
      addPoints(surface, static_cast<std::size_t>(triangle), 1, area, points);
    }
  }
  return points;
}

std::vector<std::int32_t> chooseTriangles(
  const Surface& surface, std::vector<std::int32_t> triangles, std::size_t most)
{
  Lowest lowest(most);
  for (const std::int32_t triangle : triangles)
  {
    lowest.add(unitOf(hashOf(surface, surface.triangles[triangle])),
      static_cast<std::size_t>(triangle));
  }
  triangles.clear();
  for (const Keyed& keyed : lowest.take())
  {
    triangles.push_back(keyed.triangle);
  }
  return triangles;
}

} // namespace winding
