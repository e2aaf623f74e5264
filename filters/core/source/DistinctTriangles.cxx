// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/DistinctTriangles.h"

#include <algorithm>
#include <cstdint>

namespace winding
{

namespace
{

/// A triangle's vertices in ascending order, and whether it runs round in the sense of that order.
struct Candidate
{
  explicit Candidate(const Triangle& triangle, std::uint32_t place)
    : vertices(triangle)
    , number(place)
  {
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
    {
      if (vertices[j] < vertices[i])
      {
        std::swap(vertices[i], vertices[j]);
        sense = -sense;
      }
    }
  }

  Triangle vertices;
  std::uint32_t number;
  std::int32_t sense = 1;
};

bool isBefore(const Candidate& a, const Candidate& b)
{
  return a.vertices != b.vertices ? a.vertices < b.vertices : a.number < b.number;
}

/// The triangle that runs round the other way.
Triangle reversed(const Triangle& triangle)
{
  return {triangle[0], triangle[2], triangle[1]};
}

} // namespace

std::optional<DistinctTriangles> distinctTriangles(
  const TriangleList& triangles, const std::vector<char>& mayRepeat)
{
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& t = triangles[i];
    if (mayRepeat[t[0]] && mayRepeat[t[1]] && mayRepeat[t[2]])
    {
      candidates.emplace_back(t, static_cast<std::uint32_t>(i));
    }
  }
  std::sort(candidates.begin(), candidates.end(), isBefore);

  // The first of equal triangles stands for all, the others are taken out; `net` counts all in the
  // sense of the first.
  constexpr std::int32_t takenOut = -1;
  std::vector<std::int32_t> counts(triangles.size(), 1);
  std::vector<char> isTurned(triangles.size(), 0);
  bool isAnyEqual = false;
  for (std::size_t first = 0; first < candidates.size();)
  {
    const Candidate& standsForAll = candidates[first];
    std::int32_t net = 1;
    std::size_t next = first + 1;
    for (; next < candidates.size() && candidates[next].vertices == standsForAll.vertices; ++next)
    {
      net += candidates[next].sense * standsForAll.sense;
      counts[candidates[next].number] = takenOut;
      isAnyEqual = true;
    }
    counts[standsForAll.number] = std::abs(net);
    isTurned[standsForAll.number] = net < 0;
    first = next;
  }
  if (!isAnyEqual)
  {
    return std::nullopt;
  }

  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (counts[i] != takenOut)
    {
      order.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&counts](std::uint32_t a, std::uint32_t b) { return counts[a] < counts[b]; });
  DistinctTriangles distinct;
  distinct.triangles.reserve(order.size());
  distinct.multiplicities.reserve(order.size());
  for (const std::uint32_t i : order)
  {
    distinct.triangles.push_back(isTurned[i] ? reversed(triangles[i]) : triangles[i]);
    distinct.multiplicities.push_back(counts[i]);
  }
  return distinct;
}

} // namespace winding
