#include "farfield/PointCells.h"

#include "base/CountingSort.h"
#include "base/Refusal.h"
#include "source/UnitScale.h"

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

/// Sorts by key, ten bits at a time; equal keys keep their order.
template <class Sample> void sortByKey(std::vector<Sample>& samples)
{
  CountingSort<Sample> byDigit;
  for (int shift = 0; shift < 30; shift += 10)
  {
    byDigit.sort(1024,
      [&](const auto& visit)
      {
        for (const Sample& sample : samples)
        {
          visit(sample.key >> shift & 1023u, sample);
        }
      });
    samples.swap(byDigit.items());
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
  const std::size_t blocks = (view.size() + samplesPerBlock - 1) / samplesPerBlock;
  std::vector<Eigen::AlignedBox3d> bounds(blocks);
  std::vector<std::vector<std::uint32_t>> others(blocks);
  runBlocks(
    view.size(), samplesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto number = static_cast<std::uint32_t>(i);
        const Eigen::Vector3d position = this->positionOf(number);
        if (position.allFinite() && region.contains(position))
        {
          bounds[block].extend(position);
        }
        else
        {
          others[block].push_back(number);
        }
      }
    },
    executor);
  Eigen::AlignedBox3d all;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    all.extend(bounds[block]);
    others_.insert(others_.end(), others[block].begin(), others[block].end());
  }

  samples_.reserve(view.size() - others_.size());
  auto other = others_.begin();
  for (std::size_t i = 0; i < view.size(); ++i)
  {
    const auto number = static_cast<std::uint32_t>(i);
    if (other != others_.end() && *other == number)
    {
      ++other;
      continue;
    }
    samples_.push_back({0, number});
  }
  const double side = samples_.empty() ? 0 : std::max(all.sizes().maxCoeff(), 1e-12);
  low_ = samples_.empty() ? Eigen::Vector3d(0, 0, 0)
                          : Eigen::Vector3d(all.center() - Eigen::Vector3d::Constant(0.5 * side));
  const double cubes = 1 << depth_;
  runBlocks(
    samples_.size(), samplesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        Sample& sample = samples_[i];
        const Eigen::Array3d cube =
          (this->positionOf(sample.number) - low_).array() * (cubes / side);
        const Eigen::Array3i index = cube.max(0.0).min(cubes - 1).cast<int>();
        sample.key = spread(static_cast<std::uint32_t>(index[0])) |
                     spread(static_cast<std::uint32_t>(index[1])) << 1 |
                     spread(static_cast<std::uint32_t>(index[2])) << 2;
      }
    },
    executor);
  if (samples_.size() > 1)
  {
    sortByKey(samples_);
  }

  levels_.resize(static_cast<std::size_t>(depth_) + 1);
  for (int number = depth_; number >= 0; --number)
  {
    TargetLevel& level = levels_[static_cast<std::size_t>(number)];
    level.side = std::ldexp(side, number - depth_);
    // The radius holds the whole cube, and samples that rounding may put beside it.
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
  cell.samples = cell.allSamples = samples_.size();
  return cell;
}

int PointCells::childrenOf(const TargetCell& cell, Child (&children)[8]) const
{
  if (cell.level == 0)
  {
    return 0;
  }
  const int shift = 3 * (cell.level - 1);
  const auto first = samples_.begin() + cell.index[0];
  const auto last = first + static_cast<std::ptrdiff_t>(cell.samples);
  const double quarter = 0.25 * this->level(cell.level).side;
  int count = 0;
  for (auto begin = first; begin != last;)
  {
    const std::uint32_t octant = begin->key >> shift & 7u;
    const auto end = std::partition_point(begin, last,
      [shift, octant](const Sample& sample) { return (sample.key >> shift & 7u) <= octant; });
    Child& child = children[count++];
    child.octant = static_cast<int>(octant);
    child.cell.level = cell.level - 1;
    child.cell.index = Eigen::Vector3i(static_cast<int>(begin - samples_.begin()), 0, 0);
    child.cell.center = cell.center + quarter * Eigen::Vector3d(octant & 1 ? 1 : -1,
                                                  octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
    child.cell.samples = child.cell.allSamples = static_cast<std::size_t>(end - begin);
    begin = end;
  }
  return count;
}

TargetSphere PointCells::sphereOf(const TargetCell& cell) const
{
  const Sample* const samples = &samples_[static_cast<std::size_t>(cell.index[0])];
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
  const Sample* const samples = &samples_[static_cast<std::size_t>(cell.index[0]) + first];
  const double inverse = 1 / this->level(cell.level).side;
  for (std::size_t n = 0; n < block.samples.count; ++n)
  {
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
  const Sample* const samples = &samples_[static_cast<std::size_t>(cell.index[0]) + first];
  for (std::size_t n = 0; n < count; ++n)
  {
    sink_->point(samples[n].number, values[n], isSuspect && isSuspect[n]);
  }
}

} // namespace winding
