// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/MeshArrays.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace winding
{

double intensityOf(double largest, bool areIntegers)
{
  constexpr double ofBytes = 255, ofWords = 65535;
  return largest > ofBytes ? ofWords : largest > 1 || areIntegers ? ofBytes : 1;
}

PlainArray<std::uint8_t> bytesOfColors(const PlainArray<float>& colors, bool areIntegers)
{
  constexpr float most = 255, half = 0.5F;
  const float largest = std::accumulate(colors.begin(), colors.end(), 0.0F,
    [](float one, float other) { return other > one ? other : one; }); // NaN is not larger
  const auto scale = static_cast<float>(most / intensityOf(largest, areIntegers));
  PlainArray<std::uint8_t> bytes(colors.size());
  std::transform(colors.begin(), colors.end(), bytes.begin(),
    [scale, most, areIntegers](float color)
    {
      const float value = areIntegers && color < 0 ? color + most + 1 : color; // of signed bytes
      return static_cast<std::uint8_t>(value > 0 ? std::min(scale * value + half, most) : 0);
    });
  return bytes;
}

CellArrays oneCellOf(std::size_t points)
{
  CellArrays cells;
  if (points > 0)
  {
    cells.offsets = PlainArray<std::int64_t>(2);
    cells.offsets[0] = 0;
    cells.offsets[1] = static_cast<std::int64_t>(points);
    cells.connectivity = PlainArray<std::int64_t>(points);
    std::iota(cells.connectivity.begin(), cells.connectivity.end(), std::int64_t(0));
  }
  return cells;
}

void append(CellArrays& cells, CellArrays more)
{
  if (cells.count() == 0 || more.count() == 0)
  {
    cells = cells.count() == 0 ? std::move(more) : std::move(cells);
    return;
  }
  const std::size_t before = cells.count(), corners = cells.connectivity.size();
  CellArrays all;
  all.offsets = PlainArray<std::int64_t>(before + more.offsets.size());
  all.connectivity = PlainArray<std::int64_t>(corners + more.connectivity.size());
  std::copy(cells.offsets.begin(), cells.offsets.end(), all.offsets.begin());
  std::transform(more.offsets.begin(), more.offsets.end(), all.offsets.begin() + before,
    [corners](std::int64_t offset) { return offset + static_cast<std::int64_t>(corners); });
  std::copy(cells.connectivity.begin(), cells.connectivity.end(), all.connectivity.begin());
  std::copy(more.connectivity.begin(), more.connectivity.end(), all.connectivity.begin() + corners);
  cells = std::move(all);
}

CellArrays trianglesOfStrips(const CellArrays& strips)
{
  const auto visit = [&strips](const auto& work)
  {
    for (std::size_t strip = 0; strip < strips.count(); ++strip)
    {
      const std::int64_t* const ids = strips.connectivity.data();
      const std::int64_t* const end = ids + strips.offsets[strip + 1];
      const std::int64_t* start = ids + strips.offsets[strip];
      for (const std::int64_t* id = start; id < end; ++id)
      {
        if (endsStrip(static_cast<double>(*id)))
        {
          start = id + 1;
        }
        else if (id - start >= 2 && id[-2] != id[-1] && id[-1] != id[0] && id[0] != id[-2])
        {
          const bool isTurned = (id - start) % 2 == 1;
          work(id[isTurned ? -1 : -2], id[isTurned ? -2 : -1], *id);
        }
      }
    }
  };
  std::size_t count = 0;
  visit([&count](std::int64_t, std::int64_t, std::int64_t) { ++count; });
  CellArrays triangles;
  if (count == 0)
  {
    return triangles;
  }
  triangles.offsets = PlainArray<std::int64_t>(count + 1);
  triangles.connectivity = PlainArray<std::int64_t>(3 * count);
  triangles.offsets[0] = 0;
  std::size_t next = 0;
  visit(
    [&](std::int64_t a, std::int64_t b, std::int64_t c)
    {
      std::int64_t* const into = triangles.connectivity.data() + 3 * next;
      into[0] = a;
      into[1] = b;
      into[2] = c;
      ++next;
      triangles.offsets[next] = static_cast<std::int64_t>(3 * next);
    });
  return triangles;
}

} // namespace winding
