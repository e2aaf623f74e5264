// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/MeshVertices.h"

#include "base/Executor.h"
#include "source/CoordinateOrder.h"
#include "source/PrefetchCorners.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace winding
{

namespace
{

using Ids = std::array<std::size_t, 3>;

/// A triangle's area vector, and its area.
struct Share
{
  Eigen::Vector3d areaVector;
  double area;
};

std::optional<Ids> validIds(const TrianglesView& view, std::size_t triangle, std::size_t points)
{
  Ids ids;
  for (std::size_t i = 0; i < 3; ++i)
  {
    ids[i] = static_cast<std::size_t>(view.triangles(triangle, i));
    if (ids[i] >= view.points.size() || ids[i] >= points)
    {
      return std::nullopt;
    }
  }
  return ids;
}

/// The length of a vector of any size. The bits of Eigen's stableNorm() depend on where in memory
/// the vector stands.
double lengthOf(const Eigen::Vector3d& vector)
{
  const double squared = vector.squaredNorm();
  if (squared > 1e-280 && squared < 1e280)
  {
    return std::sqrt(squared);
  }
  const double largest = vector.cwiseAbs().maxCoeff();
  return largest > 0 ? largest * (vector / largest).norm() : 0;
}

/// The share of a triangle, whichever of its corners it begins with; an area that is not finite
/// where the area vector or a side is not.
Share shareOf(const TrianglesView& view, const Ids& ids)
{
  Eigen::Vector3d corners[3] = {view.points[ids[0]], view.points[ids[1]], view.points[ids[2]]};
  const double x = corners[0][0], y = corners[1][0], z = corners[2][0];
  if (x == y || y == z || z == x)
  {
    turnToFirstOrder(corners);
  }
  const bool areApart = x != y && y != z && z != x;
  const int first = !areApart ? 0 : y < x ? (z < y ? 2 : 1) : (z < x ? 2 : 0);
  const Eigen::Vector3d& a = corners[first];
  const Eigen::Vector3d u = corners[first < 2 ? first + 1 : 0] - a;
  const Eigen::Vector3d v = corners[first > 0 ? first - 1 : 2] - a;
  Share share;
  share.areaVector = 0.5 * u.cross(v);
  const bool isFinite =
    share.areaVector.allFinite() && std::isfinite(u.lpNorm<1>() + v.lpNorm<1>());
  share.area = isFinite ? lengthOf(share.areaVector) : std::numeric_limits<double>::infinity();
  return share;
}

/// 2^exponent, for exponents from −1022 to 1023; std::ldexp() is a call.
double powerOfTwo(int exponent)
{
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/// The exponent of a number without a sign: −1023 below the normal numbers, 1024 where it is not
/// finite.
int exponentOf(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return static_cast<int>(bits >> 52 & 0x7ff) - 1023;
}

/// A bound of the exponent of a triangle's area, from its two shortest sides, which takes less time
/// than the area. It is far too large for nearly parallel sides only, whose area has lost those
/// digits to rounding anyway. Nothing for triangles with a side that is not finite.
std::optional<int> largestExponent(const TrianglesView& view, const Ids& ids)
{
  const Eigen::Vector3d a = view.points[ids[0]], b = view.points[ids[1]], c = view.points[ids[2]];
  const int ab = exponentOf((b - a).lpNorm<1>()), bc = exponentOf((c - b).lpNorm<1>());
  const int ca = exponentOf((a - c).lpNorm<1>());
  constexpr int largest = 900; // sums of these areas are finite, too
  const int larger = std::max(ab, bc);
  return std::max(larger, ca) > 1023
           ? std::nullopt
           // Two sides are less than 2^(e + 1) each, and the area is half of their product.
           : std::optional<int>(std::min(std::min(ab, bc) + std::min(larger, ca), largest));
}

/// The area vector and the area of a triangle, or sums of both.
using Sum = Eigen::Array4d;

/**
 * The unit of the shares around a point: they are rounded to multiples of it, so that their sums
 * are exact, and their order does not matter. It is a power of two, so large that sums have no more
 * digits than a double, and so small that rounding a share is 2⁻⁴⁸ of the product of two sides at
 * most, times the number of shares.
 */
class Unit
{
public:
  void announce(int exponent)
  {
    exponent_ = std::max(exponent_, exponent);
    ++count_;
  }

  void announce(const Unit& other)
  {
    exponent_ = std::max(exponent_, other.exponent_);
    count_ += other.count_;
  }

  void choose()
  {
    constexpr int digits = 52;
    int digitsOfCount = 0;
    while (count_ >> digitsOfCount != 0)
    {
      ++digitsOfCount;
    }
    exponent_ = std::max(exponent_ + 1 + digitsOfCount - digits, lowest);
  }

  /// The sum with a number whose last digit is the unit rounds all others away.
  Sum rounded(const Sum& share) const
  {
    const double rounder = 1.5 * powerOfTwo(exponent_ + 52);
    return (share + rounder) - rounder;
  }

private:
  static constexpr int lowest = -1000;

  int exponent_ = lowest; ///< the largest that an area may have, until the unit is chosen
  std::uint32_t count_ = 0;
};

/// Calls visit(view, ids) for the triangles from `first` to `last` − 1 that have valid ids; numbers
/// go on from view to view. Calls ask(id) for the corners of triangles ahead, with ids below
/// `points`.
template <class Ask, class Visit>
void forEachTriangle(const std::vector<TrianglesView>& views, std::size_t points, std::size_t first,
  std::size_t last, const Ask& ask, const Visit& visit)
{
  std::size_t start = 0;
  for (const TrianglesView& view : views)
  {
    const std::size_t end = start + view.triangles.size();
    for (std::size_t t = std::max(first, start); t < std::min(last, end); ++t)
    {
      prefetch(view, t - start, view.triangles.size(),
        [&](std::size_t id)
        {
          askForPoint(view, id);
          if (id < points)
          {
            ask(id);
          }
        });
      if (const std::optional<Ids> ids = validIds(view, t - start, points))
      {
        visit(view, *ids);
      }
    }
    start = end;
  }
}

/// Numbers by point that a thread adds up over the triangles that it takes.
struct Part
{
  std::vector<Unit> units;
  std::vector<Sum> sums;
};

} // namespace

MeshVertices meshVertices(
  const std::vector<TrianglesView>& views, std::size_t points, Executor& executor)
{
  std::size_t triangles = 0;
  for (const TrianglesView& view : views)
  {
    triangles += view.triangles.size();
  }
  // Each part has numbers for all points, so there are two at most.
  constexpr std::size_t enoughForTwo = 20'000;
  std::vector<Part> parts(triangles < enoughForTwo ? 1 : 2);
  const std::size_t perPart = std::max<std::size_t>(1, (triangles + 1) / parts.size());
  // The shares are computed twice, roughly and in full: storing them takes longer, since the system
  // fills fresh memory with zeros first.
  runBlocks(
    triangles, perPart,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::vector<Unit>& units = parts[block].units;
      units.resize(points);
      forEachTriangle(
        views, points, first, last, [&](std::size_t id) { hwy::Prefetch(&units[id]); },
        [&](const TrianglesView& view, const Ids& ids)
        {
          if (const std::optional<int> exponent = largestExponent(view, ids))
          {
            for (const std::size_t id : ids)
            {
              units[id].announce(*exponent);
            }
          }
        });
    },
    executor);
  std::vector<Unit>& units = parts.front().units;
  units.resize(points);
  forEachItem(
    points,
    [&](std::size_t point)
    {
      if (parts.size() > 1)
      {
        units[point].announce(parts[1].units[point]);
      }
      units[point].choose();
    },
    executor);
  runBlocks(
    triangles, perPart,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::vector<Sum>& sums = parts[block].sums;
      sums.resize(points, Sum::Zero());
      forEachTriangle(
        views, points, first, last,
        [&](std::size_t id)
        {
          hwy::Prefetch(&units[id]);
          hwy::Prefetch(&sums[id]);
        },
        [&](const TrianglesView& view, const Ids& ids)
        {
          const Share share = shareOf(view, ids);
          if (std::isfinite(share.area))
          {
            const Sum both(
              share.areaVector[0], share.areaVector[1], share.areaVector[2], share.area);
            for (const std::size_t id : ids)
            {
              sums[id] += units[id].rounded(both);
            }
          }
        });
    },
    executor);
  std::vector<Sum>& sums = parts.front().sums;
  sums.resize(points, Sum::Zero());
  forEachItem(
    points,
    [&](std::size_t point)
    {
      if (parts.size() > 1)
      {
        sums[point] += parts[1].sums[point];
      }
      sums[point][3] /= 3;
    },
    executor);
  return MeshVertices(std::move(sums));
}

} // namespace winding
