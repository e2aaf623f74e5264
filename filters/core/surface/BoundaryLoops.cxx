// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/BoundaryLoops.h"

#include "base/BucketSort.h"
#include "base/UninitializedVector.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace winding
{

namespace
{

/// Vertices lie anywhere in memory, so that loops over edges prefetch the vertices of edges that
/// come so much later.
constexpr std::size_t edgesAhead = 16;

constexpr std::size_t edgesPerBlock = 16384;

/// The edges of a chain by the vertex that they leave. The edges that leave one vertex stand one
/// behind the other, in the order of the chain; the place of the first of them stands for the
/// vertex.
class LeavingEdges
{
public:
  LeavingEdges(const BoundaryEdges& chain, std::size_t vertices, Executor& executor)
    : edges_(chain.size())
    , places_(vertices)
  {
    constexpr std::size_t wantedInBucket = 4096;
    const int shift = bucketShift(vertices, wantedInBucket);
    const Buckets<BoundaryEdge> byVertex = distribute<BoundaryEdge>(
      chain.size(), bucketsFor(vertices, shift),
      [&](std::size_t first, std::size_t last, const auto& put)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          put(static_cast<std::size_t>(chain[i].from) >> shift, chain[i]);
        }
      },
      executor);
    runBlocks(
      byVertex.count(), 1,
      [&](std::size_t bucket, std::size_t, std::size_t)
      { this->fill(byVertex, bucket, bucket << shift, shift); },
      executor);
    runBlocks(
      edges_.size(), edgesPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          hwy::Prefetch(&places_[edges_[std::min(i + edgesAhead, last - 1)].to]);
          edges_[i].to = places_[edges_[i].to];
        }
      },
      executor);
  }

  struct Edge
  {
    std::int32_t from;
    std::uint32_t to;  ///< a vertex and, once all places are known, the place that stands for it
    std::int32_t left; ///< how often it has not been walked along yet
    /// The rest counts at the first edge that leaves a vertex only.
    std::int32_t placeInPath;
    std::uint32_t next; ///< the place of an edge before which none is left
  };

  /// The edge that stands for a vertex.
  Edge& first(std::uint32_t place) { return edges_[place]; }

  /// The next edge to walk along from a vertex; null where none is left.
  Edge* next(Edge& first)
  {
    const std::uint32_t end = static_cast<std::uint32_t>(edges_.size());
    for (; first.next < end && edges_[first.next].from == first.from; ++first.next)
    {
      if (edges_[first.next].left > 0)
      {
        return &edges_[first.next];
      }
    }
    return nullptr;
  }

  /// The place that stands for a vertex that edges leave.
  std::uint32_t placeOf(std::int32_t vertex) const { return places_[vertex]; }

  ///@{
  /// Ask memory for the place of a vertex and, when that has come, for its first edge.
  void askForPlace(std::int32_t vertex) const { hwy::Prefetch(&places_[vertex]); }
  void askForEdge(std::int32_t vertex) const { hwy::Prefetch(&edges_[places_[vertex]]); }
  ///@}

private:
  void fill(
    const Buckets<BoundaryEdge>& byVertex, std::size_t bucket, std::size_t firstVertex, int shift)
  {
    // Numbers of edges become places of the next ones. CountingSort would copy all edges once more:
    // loops and cap took 27 ns per edge with it, the least of four runs, instead of 22.
    std::vector<std::uint32_t> next((std::size_t(1) << shift) + 1, 0);
    for (const BoundaryEdge* edge = byVertex.begin(bucket); edge != byVertex.end(bucket); ++edge)
    {
      ++next[static_cast<std::size_t>(edge->from) - firstVertex + 1];
    }
    next[0] = static_cast<std::uint32_t>(byVertex.begin(bucket) - byVertex.begin(0));
    for (std::size_t i = 1; i < next.size(); ++i)
    {
      if (next[i] > 0)
      {
        places_[firstVertex + i - 1] = next[i - 1];
      }
      next[i] += next[i - 1];
    }
    for (const BoundaryEdge* edge = byVertex.begin(bucket); edge != byVertex.end(bucket); ++edge)
    {
      const std::uint32_t place = next[static_cast<std::size_t>(edge->from) - firstVertex]++;
      edges_[place] = {
        edge->from, static_cast<std::uint32_t>(edge->to), edge->multiplicity, -1, place};
    }
  }

  UninitializedVector<Edge> edges_;
  UninitializedVector<std::uint32_t> places_; ///< by vertex, of those that edges leave
};

} // namespace

BoundaryLoops boundaryLoops(const BoundaryEdges& edges, std::size_t vertices, Executor& executor)
{
  LeavingEdges leaving(edges, vertices, executor);
  // Each walk goes on until a vertex comes up again, cuts off the loop that this closes, and goes
  // on from there. As many edges leave each vertex as arrive, so a walk can only get stuck where it
  // began.
  BoundaryLoops loops;
  std::vector<std::uint32_t> path; // places of first edges
  std::vector<std::int32_t> loop;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    leaving.askForPlace(edges[std::min(i + 2 * edgesAhead, edges.size() - 1)].from);
    leaving.askForEdge(edges[std::min(i + edgesAhead, edges.size() - 1)].from);
    std::uint32_t here = leaving.placeOf(edges[i].from);
    while (true)
    {
      LeavingEdges::Edge& first = leaving.first(here);
      if (first.placeInPath >= 0)
      {
        const auto cut = path.begin() + first.placeInPath;
        loop.clear();
        for (auto visited = cut; visited != path.end(); ++visited)
        {
          LeavingEdges::Edge& edge = leaving.first(*visited);
          edge.placeInPath = -1;
          loop.push_back(edge.from);
        }
        loops.add({loop.data(), loop.data() + loop.size()});
        path.erase(cut, path.end());
      }
      LeavingEdges::Edge* const next = leaving.next(first);
      if (!next)
      {
        break;
      }
      first.placeInPath = static_cast<std::int32_t>(path.size());
      path.push_back(here);
      --next->left;
      here = next->to;
    }
  }
  return loops;
}

} // namespace winding
