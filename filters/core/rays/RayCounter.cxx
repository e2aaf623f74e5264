// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayCounter.h"

#include <algorithm>
#include <numeric>

namespace winding
{

RaysInColumns RayCounter::sort(Ray* first, Ray* last, const Columns& columns)
{
  if (columns.count() == 1)
  {
    return {columns, {first, last}};
  }
  const std::vector<Ray> rays(first, last);
  std::vector<std::size_t> counts(columns.count() + 1, 0);
  for (const Ray& ray : rays)
  {
    ++counts[columns.of(ray.start()) + 1];
  }
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  std::vector<Ray*> starts(counts.size());
  std::transform(counts.begin(), counts.end(), starts.begin(),
    [first](std::size_t count) { return first + count; });
  for (const Ray& ray : rays)
  {
    first[counts[columns.of(ray.start())]++] = ray;
  }
  return {columns, std::move(starts)};
}

bool RayCounter::count(
  Ray* first, Ray* last, const TriangleIds& triangles, std::ptrdiff_t& steps) const
{
  constexpr std::size_t fewPairs = 2048; // fewer pairs are not worth dividing
  constexpr std::size_t raysPerColumn = 4;
  constexpr std::size_t fullColumn = 64; // columns with more rays are divided again

  const RayBox box(first, last);
  if (box.isLine())
  {
    this->countOnLine(first, last, triangles, box);
    return true;
  }
  const auto rays = static_cast<std::size_t>(last - first);
  steps -= static_cast<std::ptrdiff_t>(rays + triangles.size());
  if (steps < 0)
  {
    return false;
  }
  const bool isDivided = rays * triangles.size() > fewPairs;
  const RaysInColumns inColumns =
    sort(first, last, Columns(box, isDivided ? std::max<std::size_t>(1, rays / raysPerColumn) : 1));
  const Columns& columns = inColumns.columns;
  const std::vector<Ray*>& starts = inColumns.starts;
  std::vector<TriangleIds> ofFull(columns.count()); // triangles by column, in full columns only
  for (const std::uint32_t id : triangles)
  {
    const TriangleBox ours = this->box(id);
    if (!box.isReachedBy(ours))
    {
      continue;
    }
    const RayTriangle triangle = this->triangle(id);
    const int multiplicity = chain_.multiplicity(id);
    const auto meet = [&](std::size_t column)
    {
      if (columns.count() > 1 && inColumns.size(column) > fullColumn)
      {
        ofFull[column].push_back(id);
        --steps;
        return;
      }
      steps -= starts[column + 1] - starts[column];
      for (Ray* ray = starts[column]; ray != starts[column + 1]; ++ray)
      {
        ray->crossings += multiplicity * triangle.crossing(ray->start());
      }
    };
    const ColumnRange range = columns.of(ours);
    if (range.isNarrow())
    {
      for (int z = range.firstZ; z <= range.lastZ; ++z)
      {
        for (int y = range.firstY; y <= range.lastY; ++y)
        {
          meet(columns.number(y, z));
        }
      }
    }
    else
    {
      this->footprint(id, columns, range).forEach(meet);
    }
    if (steps < 0)
    {
      return false;
    }
  }
  for (std::size_t column = 0; column < columns.count(); ++column)
  {
    if (!ofFull[column].empty() &&
        !this->count(starts[column], starts[column + 1], ofFull[column], steps))
    {
      return false;
    }
  }
  return true;
}

/// Adds the crossings of rays on one line. A ray crosses a triangle that the line crosses if it
/// starts before a place on the line that depends on the line and the triangle only, the
/// infinitesimal steps included: so the rays that cross it are the first ones.
void RayCounter::countOnLine(
  Ray* first, Ray* last, const TriangleIds& triangles, const RayBox& box) const
{
  std::sort(first, last, [](const Ray& a, const Ray& b) { return a.x < b.x; });
  std::vector<int> endingAt(static_cast<std::size_t>(last - first), 0);
  for (const std::uint32_t id : triangles)
  {
    if (!box.isReachedBy(this->box(id)))
    {
      continue;
    }
    const RayTriangle triangle = this->triangle(id);
    if (const int sign = triangle.crossing(first->start()))
    {
      const Ray* behind = std::partition_point(
        first + 1, last, [&](const Ray& ray) { return triangle.crossing(ray.start()) != 0; });
      endingAt[static_cast<std::size_t>(behind - first) - 1] += chain_.multiplicity(id) * sign;
    }
  }
  int ahead = 0;
  for (std::size_t i = endingAt.size(); i-- > 0;)
  {
    ahead += endingAt[i];
    first[i].crossings += ahead;
  }
}

} // namespace winding
