// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Progress.h"
#include "base/UninitializedVector.h"
#include "farfield/FarFieldChoice.h"
#include "farfield/PointCells.h"
#include "farfield/TriangleFarField.h"
#include "field/CappedSurface.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace winding
{

/// Takes the cap's values at scattered samples, and writes the differences χ − w_C; samples on the
/// cap wait until all others are done.
class CappedSurface::Differences final : public PointSink
{
public:
  /// integers: χ at each sample. References are kept.
  Differences(const VectorsView& samples, const UninitializedVector<float>& integers,
    const FieldOutput& output, const CappedSurface& surface)
    : samples_(samples)
    , integers_(integers)
    , output_(output)
    , surface_(surface)
  {
  }

  void askFor(std::size_t sample) const override
  {
    hwy::Prefetch(&integers_[sample]);
    output_.askFor(sample);
  }

  void point(std::size_t sample, double capValue, bool isSuspect) const override
  {
    if (isSuspect)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      onCap_.push_back({samples_[sample], sample, static_cast<int>(integers_[sample])});
      return;
    }
    output_.fill(integers_[sample] - capValue, sample, 1);
  }

  /// Writes the values of samples on the cap, which are resolved in the order of samples.
  void finish(Executor& executor) const
  {
    std::sort(onCap_.begin(), onCap_.end(),
      [](const PointOnCap& a, const PointOnCap& b) { return a.sample < b.sample; });
    if (onCap_.empty())
    {
      return;
    }
    std::vector<double> values;
    surface_.otherCap().resolve(
      onCap_, surface_.usesFarFieldAtPoints(onCap_.size()), values, executor);
    for (std::size_t n = 0; n < onCap_.size(); ++n)
    {
      output_.fill(values[n], onCap_[n].sample, 1);
    }
  }

private:
  const VectorsView& samples_;
  const UninitializedVector<float>& integers_;
  const FieldOutput& output_;
  const CappedSurface& surface_;
  mutable std::mutex mutex_;
  mutable std::vector<PointOnCap> onCap_;
};

bool CappedSurface::usesFarFieldAtPoints(std::size_t samples) const
{
  // Sorting samples into cells takes as long as the sum of fewer triangles.
  constexpr std::size_t fewTriangles = 64;
  return cap_.size() > fewTriangles && this->usesFarField(samples);
}

void CappedSurface::prepare(const VectorsView& samples, Executor& executor) const
{
  if (this->usesFarFieldAtPoints(samples.size()))
  {
    capFarField_->suiting(samples, executor);
  }
}

void CappedSurface::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  if (cap_.empty())
  {
    points_.evaluate(samples, output, executor);
    return;
  }
  Progress progress(executor);
  progress.set(0, 0.5);
  UninitializedVector<float> integers(samples.size());
  FieldOutput toIntegers;
  toIntegers.values = integers.data();
  points_.evaluate(samples, toIntegers, executor);
  progress.set(0.5, 0.9);
  const Differences differences(samples, integers, output, *this);
  if (this->usesFarFieldAtPoints(samples.size()))
  {
    capFarField_->suiting(samples, executor)->evaluate(samples, differences, true, executor);
  }
  else
  {
    this->subtractDirectly(samples, differences, executor);
  }
  progress.set(0.9, 1);
  differences.finish(executor);
}

void CappedSurface::subtractDirectly(
  const VectorsView& samples, const Differences& differences, Executor& executor) const
{
  capSum_.watch(
    samples.size(),
    [&](std::size_t n)
    {
      const Eigen::Vector3d position = samples[n];
      return position.allFinite() ? position : bounds_.center();
    },
    [&](std::size_t n, double value, bool isSuspect)
    {
      // χ of a sample that is not finite is NaN, and so is the difference.
      differences.point(n, value, isSuspect && samples[n].allFinite());
    },
    executor);
}

} // namespace winding
