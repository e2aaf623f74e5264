// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/CanonicalOrder.h"

#include "source/CoordinateOrder.h"

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

int compareNumbers(std::int32_t i, std::int32_t j)
{
  return (i > j) - (i < j);
}

} // namespace

CanonicalOrder inCanonicalOrder(const Surface& surface, const PolygonParts& parts)
{
  std::vector<std::int32_t> vertices(surface.vertices.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::sort(vertices.begin(), vertices.end(),
    [&surface](std::int32_t i, std::int32_t j)
    { return compareCoordinates(surface.vertices[i], surface.vertices[j]) < 0; });
  CanonicalOrder result;
  result.surface.bounds = surface.bounds;
  std::vector<std::int32_t> places(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    places[vertices[i]] = static_cast<std::int32_t>(i);
    result.surface.vertices.push_back(surface.vertices[vertices[i]]);
  }
  // Polygons by their lowest triangles, and the index of the first of their triangles.
  std::vector<std::pair<Triangle, std::size_t>> polygons;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const auto [a, b, c] = surface.triangles[i];
    const Triangle triangle = lowestFirst({places[a], places[b], places[c]}, compareNumbers);
    if (i == 0 || parts.empty() || !parts[i])
    {
      polygons.emplace_back(triangle, i);
    }
    else if (compareTriangles(triangle, polygons.back().first, compareNumbers) < 0)
    {
      polygons.back().first = triangle;
    }
  }
  std::stable_sort(polygons.begin(), polygons.end(),
    [](const auto& a, const auto& b)
    { return compareTriangles(a.first, b.first, compareNumbers) < 0; });
  result.numbers.reserve(surface.triangles.size());
  const auto isContinued = [&](std::size_t i)
  {
    return !parts.empty() && i < surface.triangles.size() && parts[i] != 0;
  };
  for (const auto& [lowest, first] : polygons)
  {
    const bool isAlone = !isContinued(first + 1);
    std::size_t i = first;
    do
    {
      const auto [a, b, c] = surface.triangles[i];
      // Corners of fans say how their polygons go round.
      result.surface.triangles.push_back(
        isAlone ? lowest : Triangle{places[a], places[b], places[c]});
      result.numbers.push_back(i);
      if (!parts.empty())
      {
        result.parts.push_back(static_cast<char>(i != first));
      }
      ++i;
    } while (isContinued(i));
  }
  return result;
}

} // namespace winding
