#pragma once

#include "base/InsideRule.h"

#include <cstddef>
#include <limits>

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

  /// Distances from the source, in its unit of length: negative inside, as `inside` has it, or would.
  /// 0 stays 0; what a type cannot hold otherwise becomes its smallest or largest number.
  float* distances = nullptr;
  double* doubleDistances = nullptr;
  /// More than 0; farther samples get this, with their sign.
  double distanceLimit = std::numeric_limits<double>::infinity();

  bool hasDistances() const { return this->distances || this->doubleDistances; }

  /// Writes the values of samples first … first + count − 1.
  template <class Real> void write(const Real* from, std::size_t first, std::size_t count) const;

  /// Writes one value to all of samples first … first + count − 1.
  void fill(double value, std::size_t first, std::size_t count) const;

  /// Writes the distance of a sample, whose value or side has been written.
  void writeDistance(double distance, std::size_t sample) const;

private:
  bool isInsideAt(std::size_t sample) const;
};

} // namespace winding
