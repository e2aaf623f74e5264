// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BucketSort.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "farfield/TargetCells.h"

#include <Eigen/Geometry>

#include <cstdint>

namespace winding
{

/// Takes the values of scattered samples, from several threads at once.
class PointSink
{
public:
  virtual ~PointSink() = default;

  /// Asks memory for what point() will read and write for a sample soon.
  virtual void askFor(std::size_t sample) const = 0;

  /// Takes the value of a sample, each once. `isSuspect` says whether the sample lies on a source;
  /// it is false unless the evaluation watches out for that.
  virtual void point(std::size_t sample, double value, bool isSuspect) const = 0;
};

/**
 * Scattered samples as an octree of cubes, sorted along a Morton curve. Samples that are not
 * finite, or lie outside the given region, are left out; others() lists them. A single sample is
 * one cell of no size, so that cells cost little compared with the sources that act on it.
 */
class PointCells final : public TargetCells
{
public:
  /// Positions are the samples' times scale. Keeps references to the samples and to the
  /// sink, which may be null where nothing is stored. Throws Interrupted when the executor was
  /// interrupted, and Refusal for more than 2³¹ − 1 samples.
  PointCells(const VectorsView& samples, const Eigen::AlignedBox3d& region, double scale, int order,
    const PointSink* sink, Executor& executor);

  const std::vector<std::uint32_t>& others() const { return others_; }
  bool empty() const { return this->size() == 0; }

  /// The number of a cell's n-th sample.
  std::size_t numberOf(const TargetCell& cell, std::size_t n) const
  {
    return this->samplesOf(cell)[n].number;
  }

  /// The level whose cells make good tasks.
  int taskLevel() const;

  TargetCell root() const override;
  int childrenOf(const TargetCell& cell, Child (&children)[8]) const override;
  bool isRegular() const override { return false; }
  TargetSphere sphereOf(const TargetCell& cell) const override;
  void fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const override;
  void store(const TargetCell& cell, std::size_t first, std::size_t count, const float* values,
    const bool* isSuspect) const override;

private:
  /// A sample's place on the curve, behind its end for those that are left out, and its number.
  struct Sample
  {
    std::uint32_t key, number;
  };

  /// The number of levels below the root if there are several samples: as many as 32 bits of a key
  /// hold.
  static constexpr int deepest = 10;
  static constexpr int bitsOfKey = 3 * deepest;

  Eigen::Vector3d positionOf(std::uint32_t number) const;
  std::size_t size() const { return view_.size() - others_.size(); }
  const Sample* samplesOf(const TargetCell& cell) const
  {
    return samples_.begin(0) + cell.index[0];
  }

  const VectorsView& view_;
  double scale_;
  const PointSink* sink_;
  int depth_;               ///< levels below the root
  Eigen::Vector3d low_;     ///< corner of the root's cube
  Buckets<Sample> samples_; ///< along the curve, those that are left out behind the others
  std::vector<std::uint32_t> others_;
};

} // namespace winding
