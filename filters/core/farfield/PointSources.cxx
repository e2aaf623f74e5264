// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldSources.h"

#include "base/Pi.h"
#include "farfield/BulkBounds.h"
#include "farfield/SourceItems.h"
#include "source/CoordinateOrder.h"
#include "source/UnitScale.h"
#include "sums/DirectSumKernels.h"
#include "sums/RegularizedKernels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace winding
{

namespace
{

using Vector = Eigen::Map<const Eigen::Vector3d>;

double largestOf(const std::vector<double>& values)
{
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// The scale that suits a cloud, the areas of its points and the lengths over which they are
/// spread: these may be much larger than a cloud of few points. Samples many units away are then
/// beyond all spreading.
double scaleOf(const PointCloud& cloud, const std::vector<double>& areas, Executor& executor)
{
  const double largest =
    std::max(std::sqrt(largestOf(areas)), largestOf(cloud.regularizationLengths));
  Bounds bounds = bulkBounds(cloud.positions, cloud.bounds, executor);
  if (largest > 0)
  {
    bounds.extend(bounds.min() + Eigen::Vector3d::Constant(largest));
  }
  return unitScale(bounds);
}

class PointSources final : public FarFieldSources
{
public:
  PointSources(const PointCloud& cloud, const std::vector<double>& areas, Executor& executor)
    : FarFieldSources(scaleOf(cloud, areas, executor))
    , items_(cloud.positions.size())
    , inverseLengths_(cloud.regularizationLengths.size())
  {
    forEachItem(
      items_.size(),
      [&](std::size_t i)
      {
        // The scale is multiplied in twice, since its square alone may leave the range.
        items_[i] = kernelDipole(cloud.positions[i] * scale(),
          cloud.normals[i] * (areas[i] * scale() * scale() / (4 * pi)));
        if (this->isSpread())
        {
          inverseLengths_[i] = inverseOfLength(cloud.regularizationLengths[i] * scale());
        }
      },
      executor);
  }

  std::vector<Eigen::Vector3d> centers(Executor& executor) const override
  {
    std::vector<Eigen::Vector3d> centers(items_.size());
    forEachItem(
      items_.size(), [&](std::size_t i) { centers[i] = Vector(items_[i].position); }, executor);
    return centers;
  }

  bool isBefore(std::uint32_t item, std::uint32_t other) const override
  {
    const int byMoment =
      compareCoordinates(Vector(items_[item].moment), Vector(items_[other].moment));
    return byMoment != 0 ? byMoment < 0
                         : this->isSpread() && inverseLengths_[item] < inverseLengths_[other];
  }

  void arrange(const std::vector<std::uint32_t>& order, bool inSingle, Executor& executor) override
  {
    rearrange(items_, order, executor);
    if (this->isSpread())
    {
      rearrange(inverseLengths_, order, executor);
    }
    this->setWhole({{0, static_cast<std::uint32_t>(items_.size())}});
    inSingle_ = inSingle;
    singleMoments_.resize(inSingle_ ? items_.size() : 0);
    forEachItem(
      singleMoments_.size(),
      [&](std::size_t i)
      {
        std::transform(items_[i].moment, items_[i].moment + 3, singleMoments_[i].begin(),
          [](double moment) { return static_cast<float>(moment); });
      },
      executor);
  }

  void appendDipoles(ItemRange items, int, std::vector<Dipole>& dipoles) const override
  {
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      dipoles.push_back({Vector(items_[i].position), Vector(items_[i].moment)});
    }
  }

  double reach(ItemRange items, const Eigen::Vector3d& center) const override
  {
    double squared = 0;
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      squared = std::max(squared, (Vector(items_[i].position) - center).squaredNorm());
    }
    return std::sqrt(squared);
  }

  double spread(ItemRange items) const override
  {
    if (!this->isSpread())
    {
      return 0;
    }
    const double* const first = &inverseLengths_[items.begin];
    return 1 / *std::min_element(first, first + (items.end - items.begin));
  }

  bool sum(const std::vector<ItemRange>& items, const SampleBlock& samples, double* values,
    bool*) const override
  {
    KernelSums sums;
    for (const ItemRange& range : items)
    {
      const KernelDipole* const first = &items_[range.begin];
      const std::size_t count = range.end - range.begin;
      if (this->isSpread() && inSingle_)
      {
        addRegularizedDipolesInSingle(
          first, &singleMoments_[range.begin], &inverseLengths_[range.begin], count, samples, sums);
      }
      else if (this->isSpread())
      {
        addRegularizedDipoles(first, &inverseLengths_[range.begin], count, samples, sums);
      }
      else if (inSingle_)
      {
        addDipolesInSingle(first, &singleMoments_[range.begin], count, samples, sums);
      }
      else
      {
        addDipoles(first, count, samples, sums);
      }
    }
    std::copy_n(sums.sum, samples.count, values);
    return false;
  }

  void addGradients(const std::vector<ItemRange>& items, const SampleBlock& samples,
    GradientSums& sums) const override
  {
    for (const ItemRange& range : items)
    {
      const KernelDipole* const first = &items_[range.begin];
      const std::size_t count = range.end - range.begin;
      if (this->isSpread())
      {
        addRegularizedDipoleGradients(first, &inverseLengths_[range.begin], count, samples, sums);
      }
      else
      {
        addDipoleGradients(first, count, samples, sums);
      }
    }
  }

  double secondsPerPair() const override
  {
    // The figures for spread points lie between the costs of points near enough to feel their
    // spreading, 1.1 ns in single and 2 ns in double precision, and of points farther away.
    return this->isSpread() ? (inSingle_ ? 0.6e-9 : 1.5e-9) : (inSingle_ ? 0.25e-9 : 0.4e-9);
  }
  double secondsPerCutAndCoefficient() const override { return 0.7e-6; }
  std::size_t leafSize() const override { return 8; }

private:
  bool isSpread() const { return !inverseLengths_.empty(); }

  UninitializedVector<KernelDipole> items_;
  UninitializedVector<double> inverseLengths_; ///< by item; empty if items are not spread
  bool inSingle_ = false;
  UninitializedVector<std::array<float, 3>> singleMoments_; ///< by item; empty if summed in double
};

} // namespace

std::unique_ptr<FarFieldSources> farFieldSources(
  const PointCloud& cloud, const std::vector<double>& areas, Executor& executor)
{
  return std::make_unique<PointSources>(cloud, areas, executor);
}

} // namespace winding
