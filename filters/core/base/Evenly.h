// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace winding
{

/// Returns `count` items of a list, evenly chosen, or all where there are fewer.
template <class Item> std::vector<Item> evenly(const std::vector<Item>& items, std::size_t count)
{
  std::vector<Item> chosen;
  count = std::min(count, items.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    chosen.push_back(items[i * items.size() / count]);
  }
  return chosen;
}

} // namespace winding
