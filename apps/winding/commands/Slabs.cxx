#include "commands/Slabs.h"

#include <algorithm>

std::vector<SlabExtent> slabsOf(
  const int (&samples)[3], bool asCells, bool overlap, std::size_t slabs)
{
  // An image of n cells has n + 1 points, and n layers of points have n - 1 steps between them.
  const int more = asCells ? 1 : 0;
  const int units = std::max(1, samples[2] - (!asCells && overlap ? 1 : 0));
  const std::size_t count = std::min(slabs, static_cast<std::size_t>(units));
  std::vector<SlabExtent> extents;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto at = [&](std::size_t i)
    {
      return static_cast<int>(static_cast<std::size_t>(units) * i / count);
    };
    const int last = at(n + 1) - (asCells || overlap ? 0 : 1);
    extents.push_back({0, samples[0] - 1 + more, 0, samples[1] - 1 + more, at(n),
      std::min(last, samples[2] - 1 + more)});
  }
  return extents;
}
