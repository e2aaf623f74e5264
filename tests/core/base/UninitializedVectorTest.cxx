// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/UninitializedVector.h"
#include "base/LargePages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

using winding::adviseLargePages;
using winding::UninitializedVector;

TEST(UninitializedVector, KeepsWhatIsWritten)
{
  // Sizes around the size of large pages, which are asked for inside of allocations.
  for (const std::size_t count : {0, 1, 1000, 262144, 524288, 3000001})
  {
    UninitializedVector<std::size_t> numbers(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      numbers[i] = i * i;
    }
    numbers.push_back(7); // moves them
    UninitializedVector<std::size_t> moved = std::move(numbers);
    ASSERT_EQ(moved.size(), count + 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      ASSERT_EQ(moved[i], i * i);
    }
    EXPECT_EQ(moved.back(), 7u);
    moved.resize(count / 2);
    moved.resize(count / 2 + 3, 5);
    EXPECT_EQ(moved.back(), 5u);
  }
}

TEST(UninitializedVector, SetsItemsWhoseConstructorDoes)
{
  struct Item
  {
    int number = 9;
  };
  UninitializedVector<Item> items(1000);
  for (const Item& item : items)
  {
    ASSERT_EQ(item.number, 9);
  }
}

TEST(LargePages, AdviceLeavesMemoryAsItIs)
{
  constexpr std::size_t bytes = 6 << 20;
  UninitializedVector<unsigned char> memory(bytes);
  for (std::size_t i = 0; i < bytes; ++i)
  {
    memory[i] = static_cast<unsigned char>(i % 251);
  }
  for (const std::size_t first : {0, 1, 4095, 4097, 2 << 20})
  {
    for (const std::size_t length : {std::size_t(0), std::size_t(1), bytes - first})
    {
      adviseLargePages(memory.data() + first, length);
    }
  }
  for (std::size_t i = 0; i < bytes; ++i)
  {
    ASSERT_EQ(memory[i], static_cast<unsigned char>(i % 251));
  }
}
