#pragma once

#include <memory>
#include <new>
#include <vector>

namespace winding
{

/// Gives memory whose trivial items are not set to anything before they are written.
template <class Item> class UninitializedAllocator : public std::allocator<Item>
{
public:
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

/// A vector that resize() leaves unwritten, so that the threads that fill it are the first to touch
/// its memory, which takes longer than what they write mostly. Items must be trivial.
template <class Item> using UninitializedVector = std::vector<Item, UninitializedAllocator<Item>>;

} // namespace winding
