// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Boundary.h"

#include "base/BucketSort.h"
#include "source/CompareCoordinates.h"
#include "surface/Edges.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace winding
{

namespace
{

constexpr std::size_t edgesPerBlock = 16384;

/// The number of uses that run along an edge from its low to its high vertex, minus the number of
/// uses that run the other way.
std::int32_t netOf(const EdgeUse* first, const EdgeUse* last)
{
  std::int32_t net = 0;
  for (; first != last; ++first)
  {
    net += first->sense();
  }
  return net;
}

} // namespace

BoundaryChain boundaryChain(const Surface& surface, Executor& executor)
{
  const EdgeUses uses(surface, executor);
  std::vector<BoundaryChain> parts(uses.ranges());
  runBlocks(
    parts.size(), 1,
    [&](std::size_t range, std::size_t, std::size_t)
    {
      BoundaryChain& part = parts[range];
      const auto addEdge = [&part](std::int32_t low, const EdgeUse* first, const EdgeUse* last)
      {
        const std::int32_t high = first->high(), net = netOf(first, last);
        part.edgesOfOneTriangle += last - first == 1;
        if (last - first == 2 && net != 0)
        {
          part.contradictions.push_back(
            {low, high, {first[0].triangle(), first[1].triangle()}});
        }
        if (last - first > 2 || net == 2 || net == -2)
        {
          part.crowdedVertices.insert(part.crowdedVertices.end(), {low, high});
        }
        if (net > 0)
        {
          part.edges.push_back({low, high, net});
        }
        else if (net < 0)
        {
          part.edges.push_back({high, low, -net});
        }
      };
      uses.forEachVertex(range,
        [&addEdge](std::int32_t low, EdgeUse* first, EdgeUse* last)
        {
          // All uses pair up at nearly every vertex, which is found out faster than they are
          // sorted.
          if (!pairUp(first, last))
          {
            EdgeUses::forEachEdge(low, first, last, addEdge);
          }
        });
    },
    executor);

  BoundaryChain chain;
  std::vector<std::size_t> starts(1, 0);
  for (const BoundaryChain& part : parts)
  {
    chain.edgesOfOneTriangle += part.edgesOfOneTriangle;
    chain.contradictions.insert(
      chain.contradictions.end(), part.contradictions.begin(), part.contradictions.end());
    chain.crowdedVertices.insert(
      chain.crowdedVertices.end(), part.crowdedVertices.begin(), part.crowdedVertices.end());
    starts.push_back(starts.back() + part.edges.size());
  }
  chain.edges.resize(starts.back());
  runBlocks(
    parts.size(), 1,
    [&](std::size_t range, std::size_t, std::size_t)
    {
      // The move frees a part's memory as soon as it is copied.
      const BoundaryEdges edges = std::move(parts[range].edges);
      std::copy(edges.begin(), edges.end(),
        chain.edges.begin() + static_cast<std::ptrdiff_t>(starts[range]));
    },
    executor);
  return chain;
}

BoundaryEdges sortedByCoordinates(
  const BoundaryEdges& edges, const std::vector<Eigen::Vector3d>& vertices, Executor& executor)
{
  // Nearly all comparisons end with the first coordinate, which is therefore stored with the edge.
  struct Keyed
  {
    double x;
    std::int32_t lower, higher;
    BoundaryEdge edge;
  };
  const auto isBefore = [&vertices](std::int32_t a, std::int32_t b)
  {
    return compareCoordinates(vertices[a], vertices[b]) < 0;
  };
  const auto keyedOf = [&](const BoundaryEdge& edge) -> Keyed
  {
    const auto [lower, higher] =
      isBefore(edge.from, edge.to) ? std::pair(edge.from, edge.to) : std::pair(edge.to, edge.from);
    return {vertices[lower][0], lower, higher, edge};
  };
  // Vertices lie anywhere in memory, and are asked for before they are needed.
  const auto forEachKeyed = [&](std::size_t first, std::size_t last, const auto& work)
  {
    constexpr std::size_t ahead = 16;
    for (std::size_t i = first; i < last; ++i)
    {
      const BoundaryEdge& later = edges[std::min(i + ahead, last - 1)];
      hwy::Prefetch(&vertices[later.from]);
      hwy::Prefetch(&vertices[later.to]);
      work(keyedOf(edges[i]));
    }
  };
  double least = std::numeric_limits<double>::infinity(), most = -least;
  std::mutex mutex;
  runBlocks(
    edges.size(), edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      double leastOfBlock = std::numeric_limits<double>::infinity(), mostOfBlock = -leastOfBlock;
      forEachKeyed(first, last,
        [&](const Keyed& item)
        {
          leastOfBlock = std::min(leastOfBlock, item.x);
          mostOfBlock = std::max(mostOfBlock, item.x);
        });
      const std::lock_guard<std::mutex> lock(mutex);
      least = std::min(least, leastOfBlock);
      most = std::max(most, mostOfBlock);
    },
    executor);
  // Slices of x follow each other, so that each may be sorted by itself. Rounding is monotone: it
  // puts no edge into a slice before one with an edge of smaller x.
  constexpr std::size_t wantedInSlice = 4096;
  const std::size_t slices = std::clamp<std::size_t>(edges.size() / wantedInSlice, 1, mostBuckets);
  const double slicesPerUnit = static_cast<double>(slices) / (most - least);
  const double perUnit = most > least && std::isfinite(slicesPerUnit) ? slicesPerUnit : 0;
  const auto sliceOf = [&](double x)
  {
    return std::min(static_cast<std::size_t>((x - least) * perUnit), slices - 1);
  };
  Buckets<Keyed> keyed = distribute<Keyed>(
    edges.size(), slices,
    [&](std::size_t first, std::size_t last, const auto& put)
    { forEachKeyed(first, last, [&](const Keyed& item) { put(sliceOf(item.x), item); }); },
    executor);
  runBlocks(
    slices, 1,
    [&](std::size_t slice, std::size_t, std::size_t)
    {
      std::sort(keyed.begin(slice), keyed.end(slice),
        [&isBefore](const Keyed& a, const Keyed& b)
        {
          if (a.x != b.x || a.lower == b.lower)
          {
            return a.x != b.x ? a.x < b.x : isBefore(a.higher, b.higher);
          }
          return isBefore(a.lower, b.lower);
        });
    },
    executor);
  BoundaryEdges sorted(edges.size());
  runBlocks(
    slices, 1,
    [&](std::size_t slice, std::size_t, std::size_t)
    {
      std::transform(keyed.begin(slice), keyed.end(slice),
        sorted.begin() + (keyed.begin(slice) - keyed.begin(0)),
        [](const Keyed& item) { return item.edge; });
    },
    executor);
  return sorted;
}

} // namespace winding
