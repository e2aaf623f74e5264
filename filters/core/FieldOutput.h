#pragma once

#include "InsideRule.h"

#include <cstddef>

namespace winding
{

/// Where values go, one per sample in the samples' order; null pointers are left out.
struct FieldOutput
{
  float* values = nullptr;
  double* doubleValues = nullptr;
  /// 1 inside, 0 outside, decided on the value as the array stores it: rounded to float unless
  /// doubleValues is set.
  unsigned char* inside = nullptr;
  InsideRule rule = InsideRule::signedThreshold;
  double threshold = 0.5;

  /// Writes the values of samples first … first + count − 1.
  template <class Real> void write(const Real* from, std::size_t first, std::size_t count) const;

  /// Writes one value to all of samples first … first + count − 1.
  void fill(double value, std::size_t first, std::size_t count) const;
};

} // namespace winding
