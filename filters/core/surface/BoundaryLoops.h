// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "surface/Boundary.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// A closed walk v₀ → v₁ → … → v₀ along boundary edges that visits at least three vertices, none of
/// them twice. It refers to vertices that are kept elsewhere.
class BoundaryLoop
{
public:
  BoundaryLoop(const std::int32_t* begin, const std::int32_t* end)
    : begin_(begin)
    , end_(end)
  {
  }

  const std::int32_t* begin() const { return begin_; }
  const std::int32_t* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  std::int32_t operator[](std::size_t i) const { return begin_[i]; }

private:
  const std::int32_t *begin_, *end_;
};

/// Loops, whose vertices stand one behind the other: most loops of damaged meshes go around one
/// missing triangle, millions of them.
class BoundaryLoops
{
public:
  std::size_t size() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  bool empty() const { return this->size() == 0; }
  BoundaryLoop operator[](std::size_t i) const
  {
    return {vertices_.data() + starts_[i], vertices_.data() + starts_[i + 1]};
  }

  /// The number of vertices of all loops together.
  std::size_t vertices() const { return vertices_.size(); }

  void add(const BoundaryLoop& loop)
  {
    vertices_.insert(vertices_.end(), loop.begin(), loop.end());
    starts_.push_back(vertices_.size());
  }

private:
  std::vector<std::int32_t> vertices_;
  std::vector<std::size_t> starts_{0};
};

/// Splits a chain into loops, which together run along each edge as often as its multiplicity says.
/// Nothing but the order of its edges decides which loops these are, and where they begin.
/// `vertices` is the number of vertices of the surface. At each of them as many edges must leave as
/// arrive, counted with multiplicity. Throws Interrupted.
BoundaryLoops boundaryLoops(const BoundaryEdges& edges, std::size_t vertices, Executor& executor);

} // namespace winding
