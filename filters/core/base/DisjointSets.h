// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace winding
{

/// Disjoint sets of 0 … n − 1. The representative of a set is its lowest item, in whatever order
/// the set was united.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  std::int32_t find(std::int32_t item)
  {
    while (parent_[item] != item)
    {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  /// Unites the sets of two items and returns whether they were two sets.
  bool unite(std::int32_t a, std::int32_t b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<std::int32_t> parent_;
};

/// Disjoint sets of 0 … n − 1 whose items have one of two senses each: within a set, it is known
/// which items have the same sense and which have opposite ones. The representative of a set is its
/// lowest item.
class SensedSets
{
public:
  explicit SensedSets(std::size_t count)
    : sets_(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      sets_[i] = {static_cast<std::int32_t>(i), false};
    }
  }

  struct Place
  {
    std::int32_t representative; ///< the lowest item of the set
    bool isOpposite;             ///< whether the item has the other sense than the representative
  };

  Place find(std::int32_t item)
  {
    Place place = {item, false};
    while (sets_[place.representative].representative != place.representative)
    {
      Place& here = sets_[place.representative];
      const Place& above = sets_[here.representative];
      here = {above.representative, here.isOpposite != above.isOpposite};
      place = {here.representative, place.isOpposite != here.isOpposite};
    }
    return place;
  }

  /// Notes that two items have the same sense, or opposite ones. Returns false, and changes
  /// nothing, where this contradicts what is known.
  bool unite(std::int32_t a, std::int32_t b, bool areOpposite)
  {
    const Place first = this->find(a), second = this->find(b);
    const bool rootsAreOpposite = areOpposite != (first.isOpposite != second.isOpposite);
    if (first.representative == second.representative)
    {
      return !rootsAreOpposite;
    }
    const auto [low, high] = std::minmax(first.representative, second.representative);
    sets_[high] = {low, rootsAreOpposite};
    return true;
  }

private:
  /// The parent of each item, by whose parents in turn one comes to the representative of the set.
  std::vector<Place> sets_;
};

} // namespace winding
