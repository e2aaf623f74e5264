// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays/RayColumns.h"
#include "rays/RayTriangle.h"
#include "source/Surface.h"

#include <cstdint>
#include <vector>

namespace winding
{

using TriangleIds = std::vector<std::uint32_t>;

/// Rays sorted by columns: starts[c] … starts[c + 1] − 1 are the rays of column c.
struct RaysInColumns
{
  Columns columns;
  std::vector<Ray*> starts;

  std::size_t size(std::size_t column) const
  {
    return static_cast<std::size_t>(starts[column + 1] - starts[column]);
  }
};

/// A chain of two lists of triangles over common vertices, such as a surface and its cap, numbered
/// through. References are kept.
class CrossedChain
{
public:
  CrossedChain(
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const ChainView& cap)
    : vertices_(vertices)
    , triangles_(triangles)
    , cap_(cap)
  {
  }

  std::size_t size() const { return triangles_.size() + cap_.size(); }

  const Triangle& operator[](std::size_t i) const
  {
    return i < triangles_.size() ? triangles_[i] : cap_[i - triangles_.size()];
  }

  std::int32_t multiplicity(std::size_t i) const
  {
    return i < triangles_.size() ? triangles_.multiplicity(i)
                                 : cap_.multiplicity(i - triangles_.size());
  }

  const Eigen::Vector3d& vertex(std::int32_t number) const { return vertices_[number]; }

private:
  const std::vector<Eigen::Vector3d>& vertices_;
  ChainView triangles_, cap_;
};

/// Finds the crossings of rays with the triangles of a chain, on one thread.
class RayCounter
{
public:
  /// Keeps a reference. `scale` turns the chain's coordinates into the rays'.
  RayCounter(const CrossedChain& chain, double scale)
    : chain_(chain)
    , scale_(scale)
  {
  }

  TriangleBox box(std::uint32_t id) const
  {
    const Triangle& ids = chain_[id];
    return {chain_.vertex(ids[0]), chain_.vertex(ids[1]), chain_.vertex(ids[2]), scale_};
  }

  Footprint footprint(std::uint32_t id, const Columns& columns, const ColumnRange& range) const
  {
    const Triangle& ids = chain_[id];
    return {columns, range, chain_.vertex(ids[0]) * scale_, chain_.vertex(ids[1]) * scale_,
      chain_.vertex(ids[2]) * scale_};
  }

  /// Sorts rays by the columns of a grid over them.
  static RaysInColumns sort(Ray* first, Ray* last, const Columns& columns);

  /// The most steps that count() takes before it gives up: steps of some 10 ns, 20 ms in all.
  static constexpr std::ptrdiff_t mostSteps = 1 << 21;

  /**
   * Adds the crossings of all rays with all triangles; puts the rays into another order. Returns
   * false, with some crossings added and others not, if there is too much to do. Rays on one line
   * are never too much: they are sorted along it, so that each triangle takes a search only.
   */
  bool count(Ray* first, Ray* last, const TriangleIds& triangles) const
  {
    std::ptrdiff_t steps = mostSteps;
    return this->count(first, last, triangles, steps);
  }

  /// Does what count() does, without giving up.
  void countAll(Ray* first, Ray* last, const TriangleIds& triangles) const
  {
    std::ptrdiff_t steps = std::numeric_limits<std::ptrdiff_t>::max();
    this->count(first, last, triangles, steps);
  }

private:
  bool count(Ray* first, Ray* last, const TriangleIds& triangles, std::ptrdiff_t& steps) const;
  void countOnLine(Ray* first, Ray* last, const TriangleIds& triangles, const RayBox& box) const;

  RayTriangle triangle(std::uint32_t id) const
  {
    const Triangle& ids = chain_[id];
    return {chain_.vertex(ids[0]) * scale_, chain_.vertex(ids[1]) * scale_,
      chain_.vertex(ids[2]) * scale_};
  }

  const CrossedChain& chain_;
  double scale_;
};

} // namespace winding
