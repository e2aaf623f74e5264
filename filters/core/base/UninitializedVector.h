#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace winding
{

/// Gives memory whose trivial items are not set to anything before they are written.
template <class Item> class UninitializedAllocator : public std::allocator<Item>
{
  static_assert(std::is_trivially_copyable_v<Item> && std::is_trivially_destructible_v<Item>);

public:
  UninitializedAllocator() = default;
  template <class Other> UninitializedAllocator(const UninitializedAllocator<Other>&) noexcept {}

  template <class Other> struct rebind
  {
    using other = UninitializedAllocator<Other>;
  };

  template <class Other> void construct(Other* place) noexcept { ::new (place) Other; }
  template <class Other, class... Arguments> void construct(Other* place, Arguments&&... arguments)
  {
    ::new (place) Other(std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose new items resize() leaves unwritten. The first write to fresh memory takes longer
/// than those after it, and the threads that fill the vector share it.
template <class Item> using UninitializedVector = std::vector<Item, UninitializedAllocator<Item>>;

} // namespace winding
