// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/TriangleFarField.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace winding
{

namespace
{

/// The longest side of triangles that are not cut, in voxels: about the side of a block of samples.
constexpr double voxelsPerSide = 8;

/// Sides shorter than this, in units of the surface, are not cut any further: where all samples are
/// in one place, everything is large compared with their distances.
constexpr double shortestSide = 1e-4;

/// The box of the samples that lie in another one, and their number.
std::pair<Bounds, std::size_t> samplesWithin(
  const Bounds& around, const VectorsView& samples, Executor& executor)
{
  constexpr std::size_t samplesPerBlock = 1 << 14;
  std::pair<Bounds, std::size_t> result;
  std::mutex mutex;
  runBlocks(
    samples.size(), samplesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Bounds box;
      std::size_t count = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d sample = samples[i];
        if (around.contains(sample))
        {
          box.extend(sample);
          ++count;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      result.first.extend(box);
      result.second += count;
    },
    executor);
  return result;
}

} // namespace

TriangleFarField::TriangleFarField(const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const Bounds& bounds, const FarFieldAccuracy& accuracy)
  : vertices_(vertices)
  , triangles_(triangles)
  , bounds_(bounds)
  , accuracy_(accuracy)
{
}

std::shared_ptr<const FarField> TriangleFarField::suiting(
  const Grid& grid, Executor& executor) const
{
  const Eigen::Vector3i last = grid.dimensions - Eigen::Vector3i::Ones();
  SplitRule rule;
  rule.region = Bounds(grid.firstSample, grid.sample(last));
  // The voxel's side is the geometric mean of the spacings, axes with one sample excepted.
  double logarithms = 0;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    logarithms += grid.dimensions[axis] > 1 ? std::log(grid.spacing[axis]) : 0;
    axes += grid.dimensions[axis] > 1;
  }
  rule.longestSide = axes > 0 ? voxelsPerSide * std::exp(logarithms / axes) : 0;
  return this->suiting(rule, sampleCount(grid.wholeExtent()), executor);
}

std::shared_ptr<const FarField> TriangleFarField::suiting(
  const VectorsView& samples, Executor& executor) const
{
  if (samples.size() == 1)
  {
    return this->whole(executor);
  }
  // Samples far away do not count for what is near, and the others count as if evenly distributed.
  const Bounds around(bounds_.center() - bounds_.sizes(), bounds_.center() + bounds_.sizes());
  SplitRule rule;
  std::size_t count = 0;
  std::tie(rule.region, count) = samplesWithin(around, samples, executor);
  if (count > 0)
  {
    rule.longestSide =
      voxelsPerSide * rule.region.sizes().maxCoeff() / std::cbrt(static_cast<double>(count));
  }
  return this->suiting(rule, count, executor);
}

std::shared_ptr<const FarField> TriangleFarField::suiting(
  SplitRule rule, std::size_t samples, Executor& executor) const
{
  rule.mostPieces = mostPieces(triangles_.size(), samples, accuracy_.order);
  if (!bounds_.isEmpty())
  {
    rule.longestSide = std::max(rule.longestSide, shortestSide * bounds_.sizes().maxCoeff());
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (last_ && rule == rule_)
    {
      return last_; // without a look at all triangles
    }
  }
  if (leavesWhole(rule, vertices_, triangles_.triangles(), executor))
  {
    return this->whole(executor);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!last_ || !(rule == rule_))
  {
    last_ = nullptr; // so that the old and the new one need not fit into memory together
    last_ = this->build(rule, executor);
    rule_ = rule;
  }
  return last_;
}

std::shared_ptr<const FarField> TriangleFarField::whole(Executor& executor) const
{
  return whole_.get([&] { return this->build(SplitRule(), executor); });
}

std::shared_ptr<const FarField> TriangleFarField::build(
  const SplitRule& rule, Executor& executor) const
{
  return std::make_shared<const FarField>(
    farFieldSources(vertices_, triangles_, bounds_, rule, executor), accuracy_, executor);
}

} // namespace winding
