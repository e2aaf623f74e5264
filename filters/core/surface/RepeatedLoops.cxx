// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/RepeatedLoops.h"

#include <algorithm>
#include <utility>

namespace winding
{

namespace
{

bool areEqual(const BoundaryLoop& a, const BoundaryLoop& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

} // namespace

RepeatedLoops::RepeatedLoops(BoundaryLoops all)
{
  std::vector<std::pair<std::int32_t, std::size_t>> runs; // lengths and first loops
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (i > 0 && areEqual(all[i], all[i - 1]))
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
    loops.add(all[first]);
  }
}

} // namespace winding
