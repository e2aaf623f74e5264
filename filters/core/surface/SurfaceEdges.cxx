// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/SurfaceEdges.h"

#include <utility>

namespace winding
{

namespace
{

void add(SurfaceEdges& edges, std::int32_t low, const EdgeUse* first, const EdgeUse* last)
{
  const std::int32_t high = first->high();
  switch (last - first)
  {
  case 1:
    edges.rims.push_back({low, high, first->triangle()});
    return;
  case 2:
    edges.pairs.push_back({low, high, {first[0].triangle(), first[1].triangle()},
      first[0].sense() != first[1].sense()});
    return;
  default:
    const std::size_t start = edges.crowdUses.size();
    for (; first != last; ++first)
    {
      edges.crowdUses.push_back({first->triangle(), first->sense()});
    }
    edges.crowds.push_back({low, high, start, edges.crowdUses.size()});
  }
}

template <class T> void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

} // namespace

SurfaceEdges edgesOf(const Surface& surface, Executor& executor)
{
  const EdgeUses uses(surface, executor);
  std::vector<SurfaceEdges> parts(uses.ranges());
  runBlocks(
    parts.size(), 1,
    [&](std::size_t range, std::size_t, std::size_t)
    {
      SurfaceEdges& part = parts[range];
      uses.forEachVertex(range,
        [&part](std::int32_t low, EdgeUse* first, EdgeUse* last)
        {
          EdgeUses::forEachEdge(low, first, last,
            [&part](std::int32_t from, const EdgeUse* begin, const EdgeUse* end)
            { add(part, from, begin, end); });
        });
    },
    executor);

  SurfaceEdges edges;
  std::size_t rims = 0, pairs = 0;
  for (const SurfaceEdges& part : parts)
  {
    rims += part.rims.size();
    pairs += part.pairs.size();
  }
  edges.rims.reserve(rims);
  edges.pairs.reserve(pairs);
  for (SurfaceEdges& from : parts)
  {
    const SurfaceEdges part = std::move(from); // frees the part's memory once it is appended
    const std::size_t shift = edges.crowdUses.size();
    append(edges.rims, part.rims);
    append(edges.pairs, part.pairs);
    append(edges.crowdUses, part.crowdUses);
    for (const SurfaceEdges::Crowd& crowd : part.crowds)
    {
      edges.crowds.push_back(
        {crowd.low, crowd.high, crowd.firstUse + shift, crowd.endOfUses + shift});
    }
  }
  return edges;
}

SurfaceEdges SurfaceEdges::withTurned(const std::vector<char>& isTurned) const
{
  SurfaceEdges result = *this;
  for (Pair& pair : result.pairs)
  {
    pair.agrees = pair.agrees == (isTurned[pair.triangles[0]] == isTurned[pair.triangles[1]]);
  }
  for (Use& use : result.crowdUses)
  {
    use.sense = isTurned[use.triangle] ? -use.sense : use.sense;
  }
  return result;
}

} // namespace winding
