// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sums/DirectSumKernels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace winding
{

/// The sum of products of angles, each of which counts several times. The sum of a single product
/// that counts once equals sumAngles() to the bit.
class MultipleAngles
{
public:
  /// Sets `count` values to 0 and, unless it is null, isSuspect to false: both take what is added.
  MultipleAngles(std::size_t count, double* values, bool* isSuspect)
    : count_(count)
    , values_(values)
    , isSuspect_(isSuspect)
  {
    std::fill_n(values, count, 0.0);
    if (isSuspect)
    {
      std::fill_n(isSuspect, count, false);
    }
  }

  /// Adds the angles of a product `multiplicity` times, and marks the samples that it found to lie
  /// on a triangle.
  void add(const AngleProducts& products, std::int32_t multiplicity)
  {
    double angles[SampleBlock::capacity];
    sumAngles(products, count_, isFirst_ ? values_ : angles);
    for (std::size_t i = 0; isFirst_ && multiplicity != 1 && i < count_; ++i)
    {
      values_[i] *= multiplicity;
    }
    for (std::size_t i = 0; !isFirst_ && i < count_; ++i)
    {
      values_[i] += multiplicity * angles[i];
    }
    for (std::size_t i = 0; isSuspect_ && i < count_; ++i)
    {
      isSuspect_[i] = isSuspect_[i] || products.suspect[i] != 0;
    }
    isFirst_ = false;
  }

private:
  std::size_t count_;
  double* values_;
  bool* isSuspect_;
  bool isFirst_ = true;
};

} // namespace winding
