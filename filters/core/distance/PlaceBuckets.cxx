// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/PlaceBuckets.h"

#include "base/Bounds.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <vector>

namespace winding
{

namespace
{

Eigen::Vector3d scaled(const Eigen::Vector3d& sample, double scale)
{
  return {scaledCoordinate(sample[0], scale), scaledCoordinate(sample[1], scale),
    scaledCoordinate(sample[2], scale)};
}

/// The k-d tree, whose leaves are the buckets.
class PlaceCuts
{
public:
  PlaceCuts(const VectorsView& samples, double scale, std::size_t perBucket)
  {
    while (this->count() < mostBuckets && samples.size() / this->count() > perBucket)
    {
      ++depth_;
    }
    constexpr std::size_t looked = 16; // at for each bucket
    std::vector<Eigen::Vector3d> some;
    const std::size_t step = std::max<std::size_t>(1, samples.size() / (looked * this->count()));
    for (std::size_t i = 0; i < samples.size(); i += step)
    {
      if (samples[i].allFinite())
      {
        some.push_back(scaled(samples[i], scale));
      }
    }
    cuts_.resize(this->count());
    this->cut(some.data(), some.data() + some.size(), 1);
  }

  std::size_t count() const { return std::size_t{1} << depth_; }

  std::size_t of(const Eigen::Vector3d& position) const
  {
    std::size_t node = 1;
    for (int i = 0; i < depth_; ++i)
    {
      node = 2 * node + (position[cuts_[node].axis] >= cuts_[node].at);
    }
    return node - this->count();
  }

private:
  /// Positions whose coordinate is less than `at` are on the lower side.
  struct Cut
  {
    double at = 0;
    int axis = 0;
  };

  void cut(Eigen::Vector3d* first, Eigen::Vector3d* last, std::size_t node)
  {
    if (node >= cuts_.size() || first == last)
    {
      return;
    }
    Bounds box;
    std::for_each(first, last, [&box](const Eigen::Vector3d& position) { box.extend(position); });
    int axis;
    box.sizes().maxCoeff(&axis);
    Eigen::Vector3d* const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
      [axis](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[axis] < b[axis]; });
    cuts_[node] = {(*middle)[axis], axis};
    this->cut(first, middle, 2 * node);
    this->cut(middle, last, 2 * node + 1);
  }

  int depth_ = 0;
  std::vector<Cut> cuts_; ///< from 1 on: the children of node n are 2n and 2n + 1
};

} // namespace

Buckets<Place> sortIntoBuckets(
  const VectorsView& samples, double scale, std::size_t perBucket, Executor& executor)
{
  const PlaceCuts cuts(samples, scale, perBucket);
  return distribute<Place>(
    samples.size(), cuts.count() + 1,
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t n = first; n < last; ++n)
      {
        const Eigen::Vector3d sample = samples[n];
        const Eigen::Vector3d position = scaled(sample, scale);
        put(sample.allFinite() ? cuts.of(position) : cuts.count(), Place{position, n});
      }
    },
    executor);
}

} // namespace winding
