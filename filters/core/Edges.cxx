#include "Edges.h"

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

/// By value and without branches: nobody could predict how the vertices of a triangle are ordered.
SortedTriangle sorted(const Triangle& triangle)
{
  const auto [a, b, c] = triangle;
  const std::int32_t lower = a < b ? a : b, higher = a < b ? b : a;
  const std::int32_t rest = higher < c ? higher : c;
  // Around an even triangle two of three steps lead upward, around an odd one one of them.
  return {lower < c ? lower : c, lower < rest ? rest : lower, higher < c ? c : higher,
    ((a < b) ^ (b < c) ^ (c < a)) == 0};
}

/// Sorts uses of edges with the same low vertex; no two are equal.
void sortUses(EdgeUse* first, EdgeUse* last)
{
  constexpr std::size_t few = 16;
  const auto count = static_cast<std::size_t>(last - first);
  if (count > few)
  {
    std::sort(first, last);
    return;
  }
  // Each goes to its rank, found by comparing it with all others: many comparisons, but no branch
  // depends on them as in a usual sort, and the vertices around a vertex come in any order.
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

} // namespace

EdgeUses::EdgeUses(const Surface& surface, Executor& executor)
  : triangles_(surface.triangles)
  , vertices_(surface.vertices.size())
{
  // About 6 uses per vertex: those of a range stay in a core's cache while they are sorted.
  constexpr std::size_t wantedVertices = 2048;
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

EdgeUses::SortedRange EdgeUses::sortedRange(std::size_t range) const
{
  const std::size_t firstLow = range << shift_;
  SortedRange result;
  result.firstLow = static_cast<std::int32_t>(firstLow);
  result.ends.assign(std::min(vertices_ - firstLow, std::size_t(1) << shift_), 0);
  std::size_t* const places = result.ends.data() - firstLow;

  const auto forEachNumber = [this](std::size_t bucket, const auto& work)
  {
    for (const std::uint32_t* number = numbers_.begin(bucket); number != numbers_.end(bucket);
         ++number)
    {
      work(*number, sorted(triangles_[*number]));
    }
  };
  const std::size_t ofLowest = 2 * range, ofMiddle = 2 * range + 1;
  forEachNumber(
    ofLowest, [&](std::size_t, const SortedTriangle& triangle) { places[triangle.lowest] += 2; });
  forEachNumber(
    ofMiddle, [&](std::size_t, const SortedTriangle& triangle) { places[triangle.middle] += 1; });

  // Counts become starts, and by filling ends.
  std::size_t start = 0;
  for (std::size_t& place : result.ends)
  {
    const std::size_t uses = place;
    place = start;
    start += uses;
  }
  result.uses.resize(start);
  forEachNumber(ofLowest,
    [&](std::size_t number, const SortedTriangle& triangle)
    {
      result.uses[places[triangle.lowest]++] = {triangle.middle, number, triangle.isEven};
      result.uses[places[triangle.lowest]++] = {triangle.highest, number, !triangle.isEven};
    });
  forEachNumber(ofMiddle,
    [&](std::size_t number, const SortedTriangle& triangle) {
      result.uses[places[triangle.middle]++] = {triangle.highest, number, triangle.isEven};
    });

  EdgeUse* first = result.uses.data();
  for (const std::size_t end : result.ends)
  {
    EdgeUse* const last = result.uses.data() + end;
    sortUses(first, last);
    first = last;
  }
  return result;
}

} // namespace winding
