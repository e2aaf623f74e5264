// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/UninitializedVector.h"

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

/**
 * @file
 * Loops over the items of a far field's sources, on all threads, for there may be many millions.
 */
namespace winding
{

/// Puts item order[i] at place i. Throws Interrupted, and then all items stand as they did.
template <class Item>
void rearrange(
  UninitializedVector<Item>& items, const std::vector<std::uint32_t>& order, Executor& executor)
{
  UninitializedVector<Item> arranged(items.size());
  forEachItem(
    items.size(), [&](std::size_t i) { arranged[i] = items[order[i]]; }, executor);
  items = std::move(arranged);
}

} // namespace winding
