// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/LargePages.h"

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace winding
{

/// Gives memory whose items are not set to anything before they are written, in large pages if it
/// is much.
template <class Item> class UninitializedAllocator : public std::allocator<Item>
{
  static_assert(std::is_trivially_destructible_v<Item>);

public:
  UninitializedAllocator() = default;
  template <class Other> UninitializedAllocator(const UninitializedAllocator<Other>&) noexcept {}

  template <class Other> struct rebind // NOLINT: the standard names it, and what is in it
  {
    using other = UninitializedAllocator<Other>; // NOLINT
  };

  Item* allocate(std::size_t count)
  {
    Item* const items = std::allocator<Item>::allocate(count);
    adviseLargePages(items, count * sizeof(Item));
    return items;
  }

  template <class Other> void construct(Other* place) noexcept { ::new (place) Other; }
  template <class Other, class... Arguments> void construct(Other* place, Arguments&&... arguments)
  {
    ::new (place) Other(std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose new items resize() leaves unwritten, if their constructor does. The first write
/// to fresh memory takes longer than those after it, and the threads that fill the vector share it.
template <class Item> using UninitializedVector = std::vector<Item, UninitializedAllocator<Item>>;

} // namespace winding
