// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/SplitTriangles.h"

#include "farfield/Expansions.h"
#include "source/CoordinateOrder.h"
#include "source/PrefetchCorners.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace winding
{

namespace
{

/// The length of a vector of any size. stableNorm() is ten times slower, and needed only where
/// squares leave the range.
double lengthOf(const Eigen::Vector3d& vector)
{
  const double squared = vector.squaredNorm();
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : vector.stableNorm();
}

/// The triangle turned so that its longest side is a → b.
struct Longest
{
  Eigen::Vector3d a, b, c;
  double length;

  Longest(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r)
  {
    const double pq = lengthOf(q - p), qr = lengthOf(r - q), rp = lengthOf(p - r);
    length = std::max({pq, qr, rp});
    const bool first = pq == length, second = !first && qr == length;
    a = first ? p : second ? q : r;
    b = first ? q : second ? r : p;
    c = first ? r : second ? p : q;
  }
};

template <class Visit>
void visitPieces(const SplitRule& rule, double relaxed, const Longest& triangle, std::size_t number,
  bool isCut, const Visit& visit)
{
  if (!visit.goesOn())
  {
    return;
  }
  const double allowed = relaxed * rule.allowedFor(triangle.a, triangle.b, triangle.c);
  const Eigen::Vector3d middle = 0.5 * triangle.a + 0.5 * triangle.b;
  // There is no middle between neighbouring numbers, and a triangle whose length is no number is
  // left alone.
  if (!(triangle.length > allowed) || middle == triangle.a || middle == triangle.b)
  {
    visit({triangle.a, triangle.b, triangle.c, number, isCut});
    return;
  }
  visitPieces(rule, relaxed, Longest(triangle.a, middle, triangle.c), number, true, visit);
  visitPieces(rule, relaxed, Longest(middle, triangle.b, triangle.c), number, true, visit);
}

/// Counts pieces up to a limit.
struct Counter
{
  std::size_t limit;
  mutable std::size_t count = 0;

  bool goesOn() const { return count <= limit; }
  void operator()(const TrianglePiece&) const { ++count; }
};

struct Caller
{
  const std::function<void(const TrianglePiece&)>& visit;

  bool goesOn() const { return true; }
  void operator()(const TrianglePiece& piece) const { visit(piece); }
};

} // namespace

double SplitRule::allowedFor(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const
{
  const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const Eigen::Vector3d gap =
    (region.min() - high).cwiseMax(low - region.max()).cwiseMax(Eigen::Vector3d::Zero());
  return std::max(longestSide, 0.5 * lengthOf(gap));
}

std::size_t mostPieces(std::size_t triangles, std::size_t samples, int order)
{
  constexpr double pairsPerCoefficient = 4 * 28;
  const double pairsPerPiece = pairsPerCoefficient * coefficientCount(order);
  const double affordable =
    static_cast<double>(triangles) * (1 + static_cast<double>(samples) / pairsPerPiece);
  const double enough = 2 * static_cast<double>(triangles) + 100'000;
  return static_cast<std::size_t>(std::min(affordable, enough));
}

bool leavesWhole(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const TriangleList& triangles, Executor& executor)
{
  const auto isLeft = [&](const Triangle& t)
  {
    const Longest triangle(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return triangle.length <= rule.longestSide ||
           triangle.length <= rule.allowedFor(triangle.a, triangle.b, triangle.c);
  };
  std::atomic<bool> areAllLeft = true;
  constexpr std::size_t trianglesPerBlock = 16384;
  runBlocks(
    triangles.size(), trianglesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (; first < last && areAllLeft.load(std::memory_order_relaxed); ++first)
      {
        prefetchCorners(vertices.data(), triangles, first);
        if (!isLeft(triangles[first]))
        {
          areAllLeft = false;
        }
      }
    },
    executor);
  return areAllLeft;
}

void forEachPiece(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const std::function<void(const TrianglePiece& piece)>& visit)
{
  const auto visitAll = [&](double relaxed, const auto& call)
  {
    for (std::size_t i = 0; i < triangles.size() && call.goesOn(); ++i)
    {
      if (triangles.multiplicity(i) > 0)
      {
        const Triangle t = lowestFirst(vertices, triangles[i]);
        const Longest triangle(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
        visitPieces(rule, relaxed, triangle, i, false, call);
      }
    }
  };
  double relaxed = 1;
  for (bool fits = false; !fits; relaxed *= fits ? 1 : 2)
  {
    const Counter counter{std::max(rule.mostPieces, triangles.size())};
    visitAll(relaxed, counter);
    fits = counter.goesOn();
  }
  visitAll(relaxed, Caller{visit});
}

} // namespace winding
