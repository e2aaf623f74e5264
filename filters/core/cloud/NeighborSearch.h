// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/Neighbor.h"
#include "source/DistinctPoints.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

class PlacesInBall;

/**
 * Finds the nearest other places of a place by k-d trees (nanoflann), each of which holds places
 * that follow each other. Building them takes O(n log n) time. Searches may run on several threads.
 */
class NeighborSearch
{
public:
  /// Keeps a reference to the places, which must outlive this. Throws Interrupted.
  NeighborSearch(const DistinctPoints& places, Executor& executor);
  ~NeighborSearch();

  /// A search leaves this to the next one of its thread: the places around, and how far it had to
  /// go. It changes no result, and makes searches for places near to each other fast.
  class Last
  {
  public:
    Last();
    ~Last();

  private:
    friend class NeighborSearch;
    struct Memory;
    std::unique_ptr<Memory> memory_;
  };

  /// Finds the `count` nearest other places, or all others where there are fewer, in the order of
  /// isNearer(), which also decides where several places are equally far.
  void find(
    std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors, Last& last) const;

private:
  class Tree;

  bool findInBall(std::size_t place, std::size_t count, double atMost,
    std::vector<Neighbor>& neighbors, Last::Memory& last) const;
  void findInTrees(
    std::size_t place, std::size_t count, double atMost, std::vector<Neighbor>& neighbors) const;
  void fill(PlacesInBall& ball, std::size_t place, std::size_t count, double distance) const;

  const DistinctPoints& places_;
  std::vector<std::unique_ptr<const Tree>> trees_;
};

} // namespace winding
