// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Edges.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace winding
{

namespace
{

struct SortedTriangle
{
  std::int32_t lowest, middle, highest;
  bool isEven; ///< whether the triangle runs lowest → middle → highest
};

/// Sorts the vertices of a triangle, without branches: nobody could predict how they are ordered.
SortedTriangle sorted(const Triangle& triangle)
{
  const auto [a, b, c] = triangle;
  const std::int32_t lower = a < b ? a : b, higher = a < b ? b : a;
  const std::int32_t rest = higher < c ? higher : c;
  // An even triangle has two steps upward out of three, an odd triangle one.
  return {lower < c ? lower : c, lower < rest ? rest : lower, higher < c ? c : higher,
    ((a < b) ^ (b < c) ^ (c < a)) == 0};
}

/// Returns whether no two of `most` or fewer uses are equal and each has one in the other
/// direction. All are compared with all, and the number of comparisons is fixed: so several of them
/// run at a time, and no branch depends on the uses.
template <std::size_t most> bool haveOpposites(const EdgeUse* uses, std::size_t count)
{
  // No use has the high vertex 0, the lowest of all: that number fills the room that is left.
  std::uint32_t codes[most];
  for (std::size_t i = 0; i < most; ++i)
  {
    codes[i] = i < count
                 ? static_cast<std::uint32_t>(uses[i].high()) << 1 | (uses[i].sense() > 0 ? 1u : 0u)
                 : 0;
  }
  std::uint32_t wrong = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint32_t equal = 0, opposite = 0;
    for (std::size_t j = 0; j < most; ++j)
    {
      equal += codes[j] == codes[i] ? 1 : 0;
      opposite += codes[j] == (codes[i] ^ 1u) ? 1 : 0;
    }
    wrong |= (equal ^ 1u) | (opposite ^ 1u);
  }
  return wrong == 0;
}

} // namespace

void sortUses(EdgeUse* first, EdgeUse* last)
{
  constexpr std::size_t few = 16;
  const auto count = static_cast<std::size_t>(last - first);
  if (count > few)
  {
    std::sort(first, last);
    return;
  }
  // Each use goes to its rank, found by comparing it with all others. The comparisons are many, but
  // no branch depends on them as in a usual sort, where the vertices around a vertex come in an
  // order that nobody could predict.
  EdgeUse byRank[few];
  for (std::size_t i = 0; i < count; ++i)
  {
    std::size_t rank = 0;
    for (std::size_t j = 0; j < count; ++j)
    {
      rank += first[j] < first[i] ? 1 : 0;
    }
    byRank[rank] = first[i];
  }
  std::copy_n(byRank, count, first);
}

bool pairUp(const EdgeUse* first, const EdgeUse* last)
{
  const auto count = static_cast<std::size_t>(last - first);
  return count <= 8 ? haveOpposites<8>(first, count)
                    : count <= 16 && haveOpposites<16>(first, count);
}

EdgeUses::EdgeUses(const Surface& surface, Executor& executor)
  : triangles_(surface.triangles)
  , vertices_(surface.vertices.size())
{
  // There are about 6 uses per vertex, so the uses of a range stay in a core's cache, and in memory
  // that the next range gets again, while larger pieces would come fresh from the system each time.
  constexpr std::size_t wantedVertices = 1024;
  shift_ = bucketShift(vertices_, wantedVertices, mostBuckets / 2);
  numbers_ = distribute<std::uint32_t>(
    triangles_.size(), 2 * bucketsFor(vertices_, shift_),
    [this](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t t = first; t < last; ++t)
      {
        const SortedTriangle triangle = sorted(triangles_[t]);
        const auto number = static_cast<std::uint32_t>(t);
        put(static_cast<std::size_t>(triangle.lowest) >> shift_ << 1, number);
        put(static_cast<std::size_t>(triangle.middle) >> shift_ << 1 | 1, number);
      }
    },
    executor);
}

EdgeUses::UsesOfRange EdgeUses::usesOf(std::size_t range) const
{
  const std::size_t firstLow = range << shift_;
  const std::size_t vertices = std::min(vertices_ - firstLow, std::size_t(1) << shift_);
  const std::size_t ofLowest = 2 * range, ofMiddle = 2 * range + 1;
  UsesOfRange result;
  result.firstLow = static_cast<std::int32_t>(firstLow);
  result.ends.assign(vertices, 0);
  result.uses.resize(2 * numbers_.size(ofLowest) + numbers_.size(ofMiddle));

  const auto forEachTriangle = [this](std::size_t bucket, const auto& work)
  {
    constexpr std::ptrdiff_t ahead = 16;
    const std::uint32_t* const end = numbers_.end(bucket);
    for (const std::uint32_t* number = numbers_.begin(bucket); number != end; ++number)
    {
      if (end - number > ahead)
      {
        hwy::Prefetch(&triangles_[number[ahead]]); // they lie anywhere in memory
      }
      work(*number, sorted(triangles_[*number]));
    }
  };
  const auto placeOf = [&](std::int32_t low) -> std::size_t&
  {
    return result.ends[static_cast<std::size_t>(low) - firstLow];
  };
  forEachTriangle(ofLowest, [&](std::size_t, const SortedTriangle& t) { placeOf(t.lowest) += 2; });
  forEachTriangle(ofMiddle, [&](std::size_t, const SortedTriangle& t) { placeOf(t.middle) += 1; });
  // Counts become starts here; filling in the uses makes the starts ends.
  std::size_t start = 0;
  for (std::size_t& place : result.ends)
  {
    const std::size_t count = place;
    place = start;
    start += count;
  }
  EdgeUse* const uses = result.uses.data();
  forEachTriangle(ofLowest,
    [&](std::size_t number, const SortedTriangle& t)
    {
      std::size_t& place = placeOf(t.lowest);
      uses[place] = {t.middle, number, t.isEven};
      uses[place + 1] = {t.highest, number, !t.isEven};
      place += 2;
    });
  forEachTriangle(ofMiddle,
    [&](std::size_t number, const SortedTriangle& t)
    {
      std::size_t& place = placeOf(t.middle);
      uses[place] = {t.highest, number, t.isEven};
      ++place;
    });
  return result;
}

} // namespace winding
