// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace winding
{

/**
 * An array of numbers that are not set at first: threads that fill parts of it touch their own
 * memory first. The memory comes from std::malloc(), so that whoever gives memory back with
 * std::free() can take it over without a copy.
 */
template <class Number> class PlainArray
{
  static_assert(std::is_trivial<Number>::value, "the numbers are neither made nor destroyed");

public:
  PlainArray() = default;

  /// Throws std::bad_alloc, also where the size in bytes is beyond std::size_t.
  explicit PlainArray(std::size_t size)
    : size_(size)
  {
    if (size > 0)
    {
      numbers_.reset(size > std::size_t(-1) / sizeof(Number)
                       ? nullptr
                       : static_cast<Number*>(std::malloc(size * sizeof(Number))));
      if (!numbers_)
      {
        throw std::bad_alloc();
      }
    }
  }

  /// Keeps the numbers that fit. Throws std::bad_alloc as the constructor does.
  void resize(std::size_t size)
  {
    if (size == 0 || size > std::size_t(-1) / sizeof(Number))
    {
      *this = PlainArray(size);
      return;
    }
    void* const moved = std::realloc(numbers_.get(), size * sizeof(Number));
    if (!moved)
    {
      throw std::bad_alloc();
    }
    (void)numbers_.release();
    numbers_.reset(static_cast<Number*>(moved));
    size_ = size;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Number* data() { return numbers_.get(); }
  const Number* data() const { return numbers_.get(); }
  Number& operator[](std::size_t index) { return numbers_.get()[index]; }
  const Number& operator[](std::size_t index) const { return numbers_.get()[index]; }
  Number* begin() { return this->data(); }
  Number* end() { return this->data() + size_; }
  const Number* begin() const { return this->data(); }
  const Number* end() const { return this->data() + size_; }

  /// Leaves the array empty and gives its memory to the caller, who owes it std::free(). Null where
  /// the array is empty.
  Number* release()
  {
    size_ = 0;
    return numbers_.release();
  }

private:
  struct Free
  {
    void operator()(Number* numbers) const { std::free(numbers); }
  };

  std::size_t size_ = 0;
  std::unique_ptr<Number[], Free> numbers_;
};

} // namespace winding
