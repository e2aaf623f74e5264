// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BucketSort.h"
#include "base/Executor.h"
#include "base/UninitializedVector.h"
#include "rays/RayCounter.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// All triangles of a surface, or some of them.
class CandidateTriangles
{
public:
  explicit CandidateTriangles(std::size_t count)
    : count_(count)
  {
  }
  explicit CandidateTriangles(const TriangleIds& ids)
    : ids_(ids.data())
    , count_(ids.size())
  {
  }

  std::size_t size() const { return count_; }
  std::uint32_t operator[](std::size_t i) const
  {
    return ids_ ? ids_[i] : static_cast<std::uint32_t>(i);
  }

private:
  const std::uint32_t* ids_ = nullptr;
  std::size_t count_;
};

/// Finds which of some triangles reach which columns of rays.
class ReachOfTriangles
{
public:
  /// Keeps references. Throws Interrupted.
  ReachOfTriangles(const RayCounter& counter, const CandidateTriangles& triangles,
    const RaysInColumns& rays, Executor& executor);

  /// The first column of each round, and at last the number of columns. A round is a run of columns
  /// whose lists of triangles are made at one time, so that they take limited memory.
  const std::vector<std::size_t>& rounds() const { return rounds_; }

  /// The triangles that reach the columns first … last − 1. Throws Interrupted.
  Buckets<std::uint32_t> inColumns(std::size_t first, std::size_t last) const;

private:
  struct Window;

  ColumnRange rangeOf(std::uint32_t id, const RayBox& all, const std::vector<RayBox>& boxes) const;
  template <class Visit>
  void forEachColumn(std::size_t i, const Window& window, const Visit& visit) const;
  void makeRounds(std::size_t inBoxes);

  const RayCounter& counter_;
  const CandidateTriangles& triangles_;
  const Columns& columns_;
  Executor& executor_;
  UninitializedVector<ColumnRange> ranges_;
  std::vector<std::size_t> rounds_;
};

} // namespace winding
