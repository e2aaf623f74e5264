// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/BucketSort.h"
#include "base/Executor.h"
#include "rays/RayCounter.h"

#include <cstdint>
#include <optional>

namespace winding
{

/**
 * The triangles of a chain in the columns that they reach, a thousand over the box of the chain. It
 * is kept where few rays at a time are asked for again and again. Otherwise each call walks over
 * all triangles.
 *
 * The memory is 4 bytes for each column that a triangle reaches, and 64 bytes per triangle at most.
 */
class TriangleColumns
{
public:
  /// Sorts the triangles in. `scale` is the counter's, and `bounds` hold all vertices. Makes
  /// nothing, see isUsable(), where triangles reach 16 columns on average. Throws Interrupted.
  TriangleColumns(const RayCounter& counter, std::size_t triangles, const Bounds& bounds,
    double scale, Executor& executor);

  bool isUsable() const { return triangles_.count() > 0; }

  const Columns& columns() const { return columns_; }

  /// Returns the triangles of each column, ascending.
  const Buckets<std::uint32_t>& triangles() const { return triangles_; }

private:
  Columns columns_;
  Buckets<std::uint32_t> triangles_;
};

} // namespace winding
