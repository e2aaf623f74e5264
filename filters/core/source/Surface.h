// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/UninitializedVector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// Three vertex ids; positive orientation is counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/**
 * The triangles that are parts of one polygon: an entry per triangle says whether it belongs to the
 * polygon of the triangle before it. Without entries each triangle is a polygon of its own. The
 * triangles of a polygon are in one component, for they have their sense in common.
 */
using PolygonParts = std::vector<char>;

/// Triangles, which may be many millions.
using TriangleList = UninitializedVector<Triangle>;

/// How often each triangle of a list counts: numbers of at least 0 in ascending order, or none at
/// all where each counts once.
using Multiplicities = std::vector<std::int32_t>;

/// The multiplicities of triangles that all count once.
inline const Multiplicities& onceEach()
{
  static const Multiplicities none;
  return none;
}

/**
 * A clean triangle chain, as sanitize() makes it. Properties: (1) all coordinates are finite and −0
 * does not occur; (2) no two vertices are equal, every vertex belongs to a triangle, and vertices
 * stand in the order of the input's points, each in the place of the first point equal to it;
 * (3) the three ids of a triangle are valid and differ; (4) triangles keep their order.
 * Duplicate, opposite and zero-area triangles stay: the formulas give them their exact share. They
 * are taken together only where distinctTriangles() is asked to (DistinctTriangles.h).
 */
struct Surface
{
  std::vector<Eigen::Vector3d> vertices;
  TriangleList triangles;
  Multiplicities multiplicities; ///< none, unless equal triangles were taken together
  Bounds bounds;                 ///< box of the vertices; empty when there are none

  std::size_t inputTriangles = 0;
  std::size_t nonFiniteTriangles = 0; ///< dropped: a corner is NaN or infinite
  std::size_t invalidIdTriangles = 0; ///< dropped: a corner is no point of the input
  std::size_t collapsedTriangles = 0; ///< left out: two corners equal, so they bound nothing

  std::size_t dropped() const { return nonFiniteTriangles + invalidIdTriangles; }
};

/// References to triangles, over vertices that are kept elsewhere, and to how often each counts.
class ChainView
{
public:
  ChainView(const TriangleList& triangles, const Multiplicities& multiplicities = onceEach())
    : triangles_(triangles)
    , multiplicities_(multiplicities)
  {
  }

  ChainView(const Surface& surface)
    : ChainView(surface.triangles, surface.multiplicities)
  {
  }

  const TriangleList& triangles() const { return triangles_; }
  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t i) const { return triangles_[i]; }

  bool isOnceEach() const { return multiplicities_.empty(); }

  std::int32_t multiplicity(std::size_t i) const
  {
    return multiplicities_.empty() ? 1 : multiplicities_[i];
  }

  /// The number of the first triangle that counts at all; those behind it do, too.
  std::size_t firstThatCounts() const
  {
    return multiplicities_.empty() || multiplicities_.front() > 0 ? 0 : this->endOfRun(0);
  }

  /// Calls visit(first, last, multiplicity) for each run of triangles that count equally often,
  /// those that count 0 times excepted. There is one run where all count once.
  template <class Visit> void forEachRun(const Visit& visit) const
  {
    for (std::size_t first = 0; first < this->size();)
    {
      const std::int32_t multiplicity = this->multiplicity(first);
      const std::size_t last = multiplicities_.empty() ? this->size() : this->endOfRun(first);
      if (multiplicity > 0)
      {
        visit(first, last, multiplicity);
      }
      first = last;
    }
  }

private:
  std::size_t endOfRun(std::size_t first) const
  {
    const auto from = multiplicities_.begin() + static_cast<std::ptrdiff_t>(first);
    return static_cast<std::size_t>(
      std::upper_bound(from, multiplicities_.end(), *from) - multiplicities_.begin());
  }

  const TriangleList& triangles_;
  const Multiplicities& multiplicities_;
};

} // namespace winding
