// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BucketSort.h"
#include "base/Executor.h"
#include "base/Views.h"

#include <Eigen/Core>

#include <cstddef>

namespace winding
{

/// A sample in the tree's coordinates, and its number.
struct Place
{
  Eigen::Vector3d position;
  std::size_t sample;
};

/**
 * Scattered samples in a tree's coordinates, sorted into buckets by a k-d tree that is balanced for
 * some of them: of about `perBucket` samples each, but samples at one place share a bucket, and
 * there are no more than mostBuckets. The last bucket has the samples that are NaN or infinite.
 * Throws Interrupted.
 */
Buckets<Place> sortIntoBuckets(
  const VectorsView& samples, double scale, std::size_t perBucket, Executor& executor);

} // namespace winding
