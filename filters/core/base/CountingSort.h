// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace winding
{

/**
 * Items in groups, one group for each of the keys 0 … keys − 1, by a serial counting sort, which
 * takes time linear in the items and the keys. The parallel sort for many items in few groups is
 * the one of BucketSort.h.
 *
 * Guaranteed: stable, that is, the items of a group stand in the order in which they came.
 */
template <class Item> class CountingSort
{
public:
  /**
   * forEach(visit) calls visit(key, item) for each item, any number of times. It is called twice,
   * at first to count, and must visit the same both times. A sort forgets the items of the sort
   * before, but uses their memory again.
   */
  template <class ForEach> void sort(std::size_t keys, const ForEach& forEach)
  {
    // Each item is counted two places after its key. The sums are then the starts of the groups,
    // one place late, and the second pass moves every start on to the end of its group, where it
    // belongs.
    starts_.assign(keys + 2, 0);
    forEach([this](std::size_t key, const Item&) { ++starts_[key + 2]; });
    for (std::size_t i = 2; i < starts_.size(); ++i)
    {
      starts_[i] += starts_[i - 1];
    }
    items_.resize(starts_.back());
    forEach([this](std::size_t key, const Item& item) { items_[starts_[key + 1]++] = item; });
  }

  ///@{
  /// The items of a group.
  const Item* begin(std::size_t key) const { return items_.data() + starts_[key]; }
  const Item* end(std::size_t key) const { return items_.data() + starts_[key + 1]; }
  Item* begin(std::size_t key) { return items_.data() + starts_[key]; }
  Item* end(std::size_t key) { return items_.data() + starts_[key + 1]; }
  ///@}

  /// All items, group after group. The groups end if a caller takes the items.
  std::vector<Item>& items() { return items_; }

private:
  std::vector<std::size_t> starts_; ///< start of each group in items_, and the end of the last
  std::vector<Item> items_;
};

} // namespace winding
