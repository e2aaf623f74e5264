#include "surface/RepeatedLoops.h"

#include <algorithm>
#include <utility>

namespace winding
{

RepeatedLoops::RepeatedLoops(std::vector<BoundaryLoop> all)
{
  std::vector<std::pair<std::int32_t, std::size_t>> runs; // lengths and first loops
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (i > 0 && all[i] == all[i - 1])
    {
      ++runs.back().first;
    }
    else
    {
      runs.emplace_back(1, i);
    }
  }
  if (runs.size() == all.size())
  {
    loops = std::move(all);
    return;
  }
  std::sort(runs.begin(), runs.end());
  for (const auto& [count, first] : runs)
  {
    counts.push_back(count);
    loops.push_back(std::move(all[first]));
  }
}

} // namespace winding
