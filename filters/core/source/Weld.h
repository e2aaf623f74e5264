// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Concatenation.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "source/Surface.h"

#include <hwy/cache_control.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

/**
 * Makes one vertex of all points that are used and have the same coordinates. −0 is +0 here, and in
 * the vertices.
 *
 * Points with equal coordinates have equal hashes, so used points are distributed into buckets by
 * their hashes and each bucket finds the first of equal points by itself. Points of a bucket lie
 * anywhere in memory, but where triangles have points of their own, as in .stl files, equal points
 * mostly stand close to each other: there each block of successive points is welded by itself
 * first. Nothing depends on the executor.
 */
class Weld
{
public:
  /// Keeps a reference to the views, which must outlive this. Throws Refusal for more than 2³² − 1
  /// points.
  explicit Weld(const std::vector<TrianglesView>& views);

  /// The number of a view's first point; the points of all views are numbered one after the other.
  std::size_t firstPoint(std::size_t view) const { return points_.start(view); }

  /// Asks memory for what use() reads and writes.
  void askForState(std::size_t point) const { hwy::Prefetch(&states_[point]); }

  /// Marks a point, which must have finite coordinates, as used. May be called from any thread, and
  /// as often as one likes.
  void use(std::size_t point)
  {
    // Most points are marked already: reading first leaves the cache line to other threads as well.
    if (states_[point].load(std::memory_order_relaxed) == unused)
    {
      states_[point].store(used, std::memory_order_relaxed);
    }
  }

  /// Welds the marked points and gives surface its vertices, in the order of the points, and its
  /// bounds. To be called once. Throws Interrupted, and Refusal for more than 2³¹ − 1 vertices.
  void makeVertices(Surface& surface, Executor& executor);

  /// Asks memory for what vertexOf() reads.
  void askForVertex(std::size_t point) const
  {
    hwy::Prefetch(&states_[point]);
    hwy::Prefetch(&targets_[point]);
  }

  /// The vertex that a marked point has become; to be called after makeVertices().
  std::int32_t vertexOf(std::size_t point) const
  {
    // The loop runs twice at most: to the first of equal points in a block, and to the first of
    // all.
    while (states_[point].load(std::memory_order_relaxed) == repeated)
    {
      point = targets_[point];
    }
    return static_cast<std::int32_t>(targets_[point]);
  }

private:
  enum State : unsigned char
  {
    unused,
    used,
    repeated ///< equal to a used point before it
  };

  /// A used point in its bucket.
  struct Item
  {
    std::uint32_t point;
    std::uint32_t hash; ///< the low half of the hash; the high half chooses the bucket
  };
  class Table;

  Eigen::Vector3d position(std::size_t point) const;
  template <class Work>
  void forEachUsed(std::size_t first, std::size_t last, const Work& work) const;
  void weldBlocks(Executor& executor);
  void weldBuckets(Executor& executor);

  const std::vector<TrianglesView>& views_;
  Concatenation points_;
  std::unique_ptr<std::atomic<unsigned char>[]> states_;

  /// Targets by point: an equal point before it for a repeated point, the vertex for the first of
  /// equal points.
  std::unique_ptr<std::uint32_t[]> targets_;
};

} // namespace winding
