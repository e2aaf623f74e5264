// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/SurfaceSamples.h"

#include "source/CompareCoordinates.h"
#include "source/CoordinateOrder.h"
#include "source/PrefetchCorners.h"
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
  // The first number keeps the origin from a hash of 0, which would always be chosen.
  const std::uint64_t sum = 0x632be59bd9b4e019u + bitsOf(place[0]) * 0x9e3779b97f4a7c15u +
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
  std::sort(corners, corners + 3,
    [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
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

namespace
{

/// Returns whether a triangle reaches over an eighth of the surface's bounds along any axis.
bool isLong(const Surface& surface, const Triangle& t)
{
  return (8 * extentsOf(surface, t).array() > surface.bounds.sizes().array()).any();
}

/// Chooses triangles with a corner that a hash chooses, each with the probability `shareOfSome`,
/// and all long triangles if these are few.
void chooseSome(const Surface& surface, SurfaceSamples& samples, Executor& executor)
{
  const double shareOfVertices = 1 - std::cbrt(1 - samples.shareOfSome);
  const auto limit = static_cast<std::uint64_t>(0x1p64 * shareOfVertices);
  // A bit for the choice, and a coarse bin along each axis.
  constexpr std::uint16_t chosenBit = 1u << 15;
  constexpr int bins = 32, mostSteps = 3; // a long triangle spans more
  const Eigen::Vector3d sizes = surface.bounds.sizes();
  Eigen::Vector3d perLength;
  for (int axis = 0; axis < 3; ++axis)
  {
    perLength[axis] = sizes[axis] > 0 ? (1 - 1e-9) * bins / sizes[axis] : 0;
  }
  UninitializedVector<std::uint16_t> ofVertex(surface.vertices.size());
  forEachItem(
    ofVertex.size(),
    [&](std::size_t i)
    {
      const Eigen::Vector3d& place = surface.vertices[i];
      const Eigen::Vector3d at = (place - surface.bounds.min()).cwiseProduct(perLength);
      ofVertex[i] = static_cast<std::uint16_t>(
        static_cast<int>(at[0]) | static_cast<int>(at[1]) << 5 | static_cast<int>(at[2]) << 10 |
        (hashOf(place) < limit ? chosenBit : 0));
    },
    executor);
  const auto spansMuch = [](std::uint16_t a, std::uint16_t b, std::uint16_t c)
  {
    for (int shift = 0; shift < 15; shift += 5)
    {
      const int x = a >> shift & 31, y = b >> shift & 31, z = c >> shift & 31;
      if (std::max({x, y, z}) - std::min({x, y, z}) > mostSteps)
      {
        return true;
      }
    }
    return false;
  };
  constexpr std::size_t perBlock = 16384;
  const std::size_t triangles = surface.triangles.size();
  struct Block
  {
    std::vector<std::int32_t> chosen, longAndChosen, longOnly;
  };
  std::vector<Block> blocks((triangles + perBlock - 1) / perBlock);
  runBlocks(
    triangles, perBlock,
    [&](std::size_t number, std::size_t first, std::size_t last)
    {
      Block& block = blocks[number];
      for (std::size_t i = first; i < last; ++i)
      {
        const Triangle& t = surface.triangles[i];
        const std::uint16_t a = ofVertex[t[0]], b = ofVertex[t[1]], c = ofVertex[t[2]];
        const bool isChosen = ((a | b | c) & chosenBit) != 0;
        const bool maySpan = ((a ^ b) & 0x7fff) != 0 || ((a ^ c) & 0x7fff) != 0;
        if (maySpan && spansMuch(a, b, c) && isLong(surface, t))
        {
          (isChosen ? block.longAndChosen : block.longOnly).push_back(static_cast<std::int32_t>(i));
        }
        else if (isChosen)
        {
          block.chosen.push_back(static_cast<std::int32_t>(i));
        }
      }
    },
    executor);
  std::size_t longTriangles = 0;
  for (const Block& block : blocks)
  {
    longTriangles += block.longAndChosen.size() + block.longOnly.size();
  }
  constexpr std::size_t few = 4096;
  samples.hasAllLong = longTriangles <= few;
  const auto add = [&samples](const std::vector<std::int32_t>& listed)
  {
    samples.some.insert(samples.some.end(), listed.begin(), listed.end());
  };
  for (const Block& block : blocks)
  {
    add(block.chosen);
    add(block.longAndChosen);
    if (samples.hasAllLong)
    {
      add(block.longOnly);
    }
  }
}

} // namespace

double SurfaceSamples::shareOf(const Surface& surface, std::int32_t triangle) const
{
  return hasAllLong && isLong(surface, surface.triangles[triangle]) ? 1 : shareOfSome;
}

SurfaceSamples sampleSurface(const Surface& surface, std::size_t most, Executor& executor)
{
  SurfaceSamples result;
  const std::size_t all = surface.triangles.size();
  const std::size_t wanted = std::min(most, 64 + 16 * all);
  constexpr std::size_t ordinary = 256;
  constexpr std::size_t perBlock = 16384;
  const double scale = unitScale(surface.bounds);
  // These are enough to meet the other sides of walls.
  const double enough = 0x1p13 + static_cast<double>(all) / 32;
  if (enough < static_cast<double>(all))
  {
    result.shareOfSome = enough / static_cast<double>(all);
    chooseSome(surface, result, executor);
  }
  constexpr std::size_t large = 1 << 17;
  const bool areSome = all > large;
  const std::size_t triangles = areSome ? result.some.size() : all;
  // Triangles that are not chosen with certainty represent others, too.
  const auto timesOf = [&](const Triangle& t)
  {
    return areSome && !(result.hasAllLong && isLong(surface, t)) ? 1 / result.shareOfSome : 1;
  };
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
        if (!areSome)
        {
          prefetchCorners(surface.vertices.data(), surface.triangles, i);
        }
        const Triangle& t = surface.triangles[i];
        const Eigen::Vector3d &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                              &c = surface.vertices[t[2]];
        const double random = unitOf(hashOf(a, b, c));
        const double square = (scale * (b - a)).cross(scale * (c - a)).squaredNorm() / 4;
        const double highest = block.lowest.limit() * timesOf(t);
        if (random * random < highest * highest * square && square > 0)
        {
          block.lowest.add(random / (timesOf(t) * areaVectorOf(surface, t, scale).norm()), i);
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
  std::vector<double> weights;
  double sum = 0;
  for (const Keyed& keyed : chosen)
  {
    const Triangle& t = surface.triangles[keyed.triangle];
    weights.push_back(std::max(timesOf(t) * areaVectorOf(surface, t, scale).norm(), least));
    sum += weights.back();
  }
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const double points = std::round(static_cast<double>(wanted) * weights[i] / sum);
    addPoints(surface, static_cast<std::size_t>(chosen[i].triangle),
      static_cast<std::size_t>(std::max(1.0, points)), weights[i], result.points);
  }
  std::vector<Keyed> ordinaries = lowestOrdinary.take();
  std::sort(ordinaries.begin(), ordinaries.end());
  for (const Keyed& keyed : ordinaries)
  {
    const Triangle& t = surface.triangles[keyed.triangle];
    result.ordinary.push_back(keyed.triangle);
    result.extents += extentsOf(surface, t) / static_cast<double>(ordinaries.size());
    for (const std::int32_t corner : t)
    {
      result.box.extend(surface.vertices[corner]);
    }
  }
  if (result.box.isEmpty())
  {
    result.box = surface.bounds;
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
    lowest.add(
      unitOf(hashOf(surface, surface.triangles[triangle])), static_cast<std::size_t>(triangle));
  }
  std::vector<Keyed> chosen = lowest.take();
  std::sort(chosen.begin(), chosen.end());
  triangles.clear();
  for (const Keyed& keyed : chosen)
  {
    triangles.push_back(keyed.triangle);
  }
  return triangles;
}

} // namespace winding
