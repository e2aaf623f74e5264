// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/CountingSort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <utility>

using winding::CountingSort;

namespace
{

using KeyAndNumber = std::pair<std::size_t, int>;

/// Sorts the items by their first numbers.
void sortByKey(
  const std::vector<KeyAndNumber>& items, std::size_t keys, CountingSort<KeyAndNumber>& to)
{
  to.sort(keys,
    [&](const auto& visit)
    {
      for (const KeyAndNumber& item : items)
      {
        visit(item.first, item);
      }
    });
}

} // namespace

TEST(CountingSort, GroupsByKeyAndKeepsTheOrderOfEqualKeys)
{
  const unsigned seed = 20261122;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  CountingSort<KeyAndNumber> groups; // used again and again: nothing may be left of what was before
  for (const std::size_t keys : {1, 2, 7, 1000, 3})
  {
    std::vector<KeyAndNumber> items(500);
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      items[i] = {random() % keys, static_cast<int>(i)};
    }
    sortByKey(items, keys, groups);

    std::vector<KeyAndNumber> expected = items;
    std::stable_sort(expected.begin(), expected.end(),
      [](const KeyAndNumber& a, const KeyAndNumber& b) { return a.first < b.first; });
    std::vector<KeyAndNumber> found;
    for (std::size_t key = 0; key < keys; ++key)
    {
      EXPECT_TRUE(std::all_of(groups.begin(key), groups.end(key),
        [key](const KeyAndNumber& item) { return item.first == key; }));
      found.insert(found.end(), groups.begin(key), groups.end(key));
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(groups.items(), expected);
  }
}

TEST(CountingSort, MayHaveNoItemsOrNoKeys)
{
  CountingSort<KeyAndNumber> groups;
  sortByKey({}, 0, groups);
  EXPECT_TRUE(groups.items().empty());
  sortByKey({}, 3, groups);
  for (const std::size_t key : {0, 1, 2})
  {
    EXPECT_EQ(groups.begin(key), groups.end(key));
  }
}
