// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/OddCaps.h"

#include "source/CompareCoordinates.h"
#include "surface/Cap.h"

#include <algorithm>
#include <array>

namespace winding
{

namespace
{

using Ends = std::array<std::int32_t, 2>;

/// Edges that even numbers of others meet at both ends, to walk along each once.
class EvenEdges
{
public:
  /// The ends are numbers from 0 up to, without, `vertices`.
  EvenEdges(std::vector<Ends> edges, std::size_t vertices)
    : next_(vertices + 1, 0)
    , isUsed_(edges.size(), 0)
  {
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto [low, high] = edges[i];
      leaving_.push_back({low, high, i});
      leaving_.push_back({high, low, i});
    }
    std::sort(leaving_.begin(), leaving_.end(),
      [](const Leaving& a, const Leaving& b)
      { return a.from < b.from || (a.from == b.from && a.to < b.to); });
    for (std::size_t vertex = 0, i = 0; vertex <= vertices; ++vertex)
    {
      for (; i < leaving_.size() && leaving_[i].from < static_cast<std::int32_t>(vertex); ++i)
      {
      }
      next_[vertex] = i;
    }
  }

  /// Takes an edge that leaves a vertex. Returns its other end, or −1 where none is left.
  std::int32_t takeFrom(std::int32_t vertex)
  {
    for (std::size_t& i = next_[vertex]; i < leaving_.size() && leaving_[i].from == vertex; ++i)
    {
      if (!isUsed_[leaving_[i].edge])
      {
        isUsed_[leaving_[i].edge] = 1;
        return leaving_[i].to;
      }
    }
    return -1;
  }

private:
  struct Leaving
  {
    std::int32_t from, to;
    std::size_t edge;
  };

  std::vector<Leaving> leaving_;
  std::vector<std::size_t> next_; ///< by vertex: the next of `leaving_` to try
  std::vector<char> isUsed_;
};

} // namespace

Surface withOddCaps(const Surface& surface, const SurfaceEdges& edges)
{
  std::vector<Ends> odd;
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    odd.push_back({rim.low, rim.high});
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    if ((crowd.endOfUses - crowd.firstUse) % 2 == 1)
    {
      odd.push_back({crowd.low, crowd.high});
    }
  }
  std::vector<std::int32_t> vertices;
  for (const auto& [low, high] : odd)
  {
    vertices.push_back(low);
    vertices.push_back(high);
  }
  const auto isLess = [&surface](std::int32_t i, std::int32_t j)
  {
    return compareCoordinates(surface.vertices[i], surface.vertices[j]) < 0;
  };
  std::sort(vertices.begin(), vertices.end(), isLess);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (Ends& ends : odd)
  {
    for (std::int32_t& end : ends)
    {
      end = static_cast<std::int32_t>(
        std::lower_bound(vertices.begin(), vertices.end(), end, isLess) - vertices.begin());
    }
    std::sort(ends.begin(), ends.end());
  }
  EvenEdges left(std::move(odd), vertices.size());
  // Each walk cuts off a loop where a vertex comes up again, and ends where it began: even numbers
  // of edges meet at every vertex.
  Surface capped = surface;
  std::vector<std::int32_t> path, placeInPath(vertices.size(), -1), loop;
  for (std::size_t start = 0; start < vertices.size(); ++start)
  {
    for (auto here = static_cast<std::int32_t>(start); here >= 0; here = left.takeFrom(here))
    {
      if (placeInPath[here] >= 0)
      {
        const auto cut = path.begin() + placeInPath[here];
        loop.clear();
        for (auto visited = cut; visited != path.end(); ++visited)
        {
          placeInPath[*visited] = -1;
          loop.push_back(vertices[*visited]);
        }
        path.erase(cut, path.end());
        const TriangleList cap = capOf(BoundaryLoop(loop.data(), loop.data() + loop.size()));
        capped.triangles.insert(capped.triangles.end(), cap.begin(), cap.end());
      }
      placeInPath[here] = static_cast<std::int32_t>(path.size());
      path.push_back(here);
    }
    placeInPath[path.back()] = -1;
    path.clear();
  }
  return capped;
}

} // namespace winding
