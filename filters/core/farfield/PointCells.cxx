// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/PointCells.h"

#include "base/CountingSort.h"
#include "base/Refusal.h"
#include "base/UninitializedVector.h"
#include "source/UnitScale.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// Spreads ten bits three apart.
std::uint32_t spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000FFu;
  bits = (bits | bits << 8) & 0x0300F00Fu;
  bits = (bits | bits << 4) & 0x030C30C3u;
  return (bits | bits << 2) & 0x09249249u;
}

constexpr int digit = 10; ///< bits of a key that one pass of a sort looks at
constexpr std::size_t digits = std::size_t(1) << digit;

/// Sorts by the lowest bits of the keys; equal keys keep their order, which is the order of the
/// numbers.
template <class Sample> void sortByKey(Sample* first, Sample* last, int bits)
{
  // A pass takes as long for fewer samples.
  constexpr std::ptrdiff_t few = digits / 4;
  if (last - first < few)
  {
    std::sort(first, last,
      [](const Sample& a, const Sample& b)
      { return a.key != b.key ? a.key < b.key : a.number < b.number; });
    return;
  }
  CountingSort<Sample> byDigit;
  for (int shift = 0; shift < bits; shift += digit)
  {
    byDigit.sort(digits,
      [&](const auto& visit)
      {
        for (const Sample* sample = first; sample != last; ++sample)
        {
          visit(sample->key >> shift & (digits - 1), *sample);
        }
      });
    std::copy(byDigit.items().begin(), byDigit.items().end(), first);
  }
}

} // namespace

PointCells::PointCells(const VectorsView& view, const Eigen::AlignedBox3d& region, double scale,
  int order, const PointSink* sink, Executor& executor)
  : view_(view)
  , scale_(scale)
  , sink_(sink)
  , depth_(view.size() > 1 ? deepest : 0)
{
  if (view.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw Refusal("evaluate the samples in parts: there are more than 2147483647");
  }
  constexpr std::size_t samplesPerBlock = 1 << 14;
  const auto isIn = [&](const Eigen::Vector3d& position)
  {
    return position.allFinite() && region.contains(position);
  };
  std::vector<Eigen::AlignedBox3d> bounds((view.size() + samplesPerBlock - 1) / samplesPerBlock);
  runBlocks(
    view.size(), samplesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Eigen::AlignedBox3d ours;
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d position = this->positionOf(static_cast<std::uint32_t>(i));
        if (isIn(position))
        {
          ours.extend(position);
        }
      }
      bounds[block] = ours;
    },
    executor);
  Eigen::AlignedBox3d all;
  for (const Eigen::AlignedBox3d& ofBlock : bounds)
  {
    all.extend(ofBlock);
  }
  const double side = all.isEmpty() ? 0 : std::max(all.sizes().maxCoeff(), 1e-12);
  low_ = all.isEmpty() ? Eigen::Vector3d(0, 0, 0)
                       : Eigen::Vector3d(all.center() - Eigen::Vector3d::Constant(0.5 * side));

  // The keys are found once, and written down for the two passes that distribute samples.
  constexpr std::uint32_t keyOfOthers = std::uint32_t(1) << bitsOfKey;
  const double cubes = 1 << depth_;
  UninitializedVector<Sample> keyed(view.size());
  forEachItem(
    view.size(),
    [&](std::size_t i)
    {
      const auto number = static_cast<std::uint32_t>(i);
      const Eigen::Vector3d position = this->positionOf(number);
      if (!isIn(position))
      {
        keyed[i] = {keyOfOthers, number};
        return;
      }
      const Eigen::Array3i index =
        ((position - low_).array() * (cubes / side)).max(0.0).min(cubes - 1).template cast<int>();
      const std::uint32_t key = spread(static_cast<std::uint32_t>(index[0])) |
                                spread(static_cast<std::uint32_t>(index[1])) << 1 |
                                spread(static_cast<std::uint32_t>(index[2])) << 2;
      keyed[i] = {key, number};
    },
    executor);

  // Many samples are distributed by the highest digit of their keys first, and the others come
  // last.
  const int shift = view.size() > samplesPerBlock ? bitsOfKey - digit : bitsOfKey;
  const std::size_t bucketOfOthers = keyOfOthers >> shift;
  samples_ = distribute<Sample>(
    keyed.size(), bucketOfOthers + 1,
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        put(keyed[i].key >> shift, keyed[i]);
      }
    },
    executor, samplesPerBlock);
  keyed = UninitializedVector<Sample>();
  runBlocks(
    bucketOfOthers, 1,
    [&](std::size_t bucket, std::size_t, std::size_t)
    { sortByKey(samples_.begin(bucket), samples_.end(bucket), shift); },
    executor);
  for (const Sample* other = samples_.begin(bucketOfOthers); other != samples_.end(bucketOfOthers);
       ++other)
  {
    others_.push_back(other->number);
  }

  levels_.resize(static_cast<std::size_t>(depth_) + 1);
  for (int number = depth_; number >= 0; --number)
  {
    TargetLevel& level = levels_[static_cast<std::size_t>(number)];
    level.side = std::ldexp(side, number - depth_);
    // The radius holds the whole cube, and samples that rounding may put outside it.
    level.radius = 0.5 * std::sqrt(3.0) * level.side * (1 + 1e-9);
    if (number < depth_)
    {
      this->setShifts(order, number, Eigen::Vector3d::Constant(0.5 * level.side));
    }
  }
}

Eigen::Vector3d PointCells::positionOf(std::uint32_t number) const
{
  return view_[number] * scale_;
}

int PointCells::taskLevel() const
{
  constexpr int belowRoot = 3;
  return std::max(depth_ - belowRoot, 0);
}

TargetCell PointCells::root() const
{
  TargetCell cell;
  cell.level = depth_;
  cell.index = Eigen::Vector3i::Zero(); // index[0] is the place of a cell's first sample
  cell.center = low_ + Eigen::Vector3d::Constant(0.5 * levels_.back().side);
  cell.samples = cell.allSamples = this->size();
  return cell;
}

int PointCells::childrenOf(const TargetCell& cell, Child (&children)[8]) const
{
  if (cell.level == 0)
  {
    return 0;
  }
  const int shift = 3 * (cell.level - 1);
  const Sample* const first = this->samplesOf(cell);
  const Sample* const last = first + cell.samples;
  const double quarter = 0.25 * this->level(cell.level).side;
  int count = 0;
  for (const Sample* begin = first; begin != last;)
  {
    const std::uint32_t octant = begin->key >> shift & 7u;
    const Sample* const end = std::partition_point(begin, last,
      [shift, octant](const Sample& sample) { return (sample.key >> shift & 7u) <= octant; });
    Child& child = children[count++];
    child.octant = static_cast<int>(octant);
    child.cell.level = cell.level - 1;
    child.cell.index = Eigen::Vector3i(cell.index[0] + static_cast<int>(begin - first), 0, 0);
    child.cell.center = cell.center + quarter * Eigen::Vector3d(octant & 1 ? 1 : -1,
                                                  octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
    child.cell.samples = child.cell.allSamples = static_cast<std::size_t>(end - begin);
    begin = end;
  }
  return count;
}

TargetSphere PointCells::sphereOf(const TargetCell& cell) const
{
  const Sample* const samples = this->samplesOf(cell);
  Eigen::AlignedBox3d box;
  for (std::size_t n = 0; n < cell.samples; ++n)
  {
    box.extend(this->positionOf(samples[n].number));
  }
  return {box.center(), 0.5 * box.diagonal().norm()};
}

void PointCells::fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const
{
  block.samples.count = std::min(SampleBlock::capacity, cell.samples - first);
  const Sample* const samples = this->samplesOf(cell) + first;
  // The samples behind this cell's come next, so that they are prefetched, too.
  constexpr std::ptrdiff_t ahead = 24;
  const Sample* const end = samples_.begin(0) + this->size();
  const double inverse = 1 / this->level(cell.level).side;
  for (std::size_t n = 0; n < block.samples.count; ++n)
  {
    if (end - (samples + n) > ahead)
    {
      hwy::Prefetch(static_cast<const char*>(view_.address(samples[n + ahead].number)));
    }
    if (sink_)
    {
      sink_->askFor(samples[n].number);
    }
    const Eigen::Vector3d position = this->positionOf(samples[n].number);
    block.samples.set(n, position);
    const Eigen::Vector3f offset = (inverse * (position - cell.center)).cast<float>();
    block.u[n] = offset[0];
    block.v[n] = offset[1];
    block.w[n] = offset[2];
  }
}

void PointCells::store(const TargetCell& cell, std::size_t first, std::size_t count,
  const float* values, const bool* isSuspect) const
{
  const Sample* const samples = this->samplesOf(cell) + first;
  for (std::size_t n = 0; n < count; ++n)
  {
    sink_->point(samples[n].number, values[n], isSuspect && isSuspect[n]);
  }
}

} // namespace winding
