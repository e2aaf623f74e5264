// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace winding
{

/// The items of several views, one view after the other, under one range of numbers.
class Concatenation
{
public:
  /// sizeOf(view) is the number of a view's items.
  template <class View, class SizeOf>
  Concatenation(const std::vector<View>& views, const SizeOf& sizeOf)
  {
    for (const View& view : views)
    {
      starts_.push_back(starts_.back() + sizeOf(view));
    }
  }

  std::size_t size() const { return starts_.back(); }

  /// The number of a view's first item.
  std::size_t start(std::size_t view) const { return starts_[view]; }

  /// The view that an item belongs to.
  std::size_t viewOf(std::size_t item) const
  {
    const auto next = std::upper_bound(starts_.begin() + 1, starts_.end(), item);
    return static_cast<std::size_t>(next - starts_.begin()) - 1;
  }

  /// Calls work(view, begin, end, number) for each view that has some of the items
  /// first … last − 1: they are begin … end − 1 in the view, and `number` is the number of `begin`.
  template <class Work>
  void forEachPart(std::size_t first, std::size_t last, const Work& work) const
  {
    for (std::size_t view = this->viewOf(first); first < last; ++view)
    {
      const std::size_t start = starts_[view], end = std::min(last, starts_[view + 1]);
      if (first < end) // views may be empty
      {
        work(view, first - start, end - start, first);
        first = end;
      }
    }
  }

private:
  std::vector<std::size_t> starts_{0};
};

} // namespace winding
