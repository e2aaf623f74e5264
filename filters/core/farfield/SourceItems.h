#pragma once

#include "base/Executor.h"
#include "base/UninitializedVector.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

/**
 * @file
 * Loops over the items of a far field's sources, on all threads, for there may be many millions.
 */
namespace winding
{

constexpr std::size_t itemsPerBlock = 16384;

/// Calls work(i) for the items begin … end − 1. Throws Interrupted.
template <class Work>
void forEachItem(std::size_t begin, std::size_t end, const Work& work, Executor& executor)
{
  runBlocks(
    end - begin, itemsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = begin + first; i < begin + last; ++i)
      {
        work(i);
      }
    },
    executor);
}

/// Puts item order[i] at place i. Throws Interrupted, and then all items stand as they did.
template <class Item>
void rearrange(
  UninitializedVector<Item>& items, const std::vector<std::uint32_t>& order, Executor& executor)
{
  UninitializedVector<Item> arranged(items.size());
  forEachItem(
    0, items.size(), [&](std::size_t i) { arranged[i] = items[order[i]]; }, executor);
  items = std::move(arranged);
}

inline void store(const Eigen::Vector3d& from, double (&to)[3])
{
  std::copy_n(from.data(), 3, to);
}

} // namespace winding
