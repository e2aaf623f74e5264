// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"
#include "base/SideCounts.h"

#include <cstddef>
#include <limits>

namespace winding
{

/// The arrays that values go to, one per sample in the samples' order; null pointers are left out.
struct FieldOutput
{
  /// Values beyond the range of a type, which occur near points of clouds, become its largest
  /// number.
  float* values = nullptr;
  double* doubleValues = nullptr;
  /// 1 inside, 0 outside, decided on the value as the array stores it: rounded to float unless
  /// doubleValues is set.
  unsigned char* inside = nullptr;
  InsideTest isInside;
  /// A number to be added to all values, before anything is decided on them.
  double added = 0;
  /// Adds up the samples that are written, by w as the array stores it, and by the rule.
  SideTally* sides = nullptr;

  /// Distances from the source, in its unit of length: negative inside, by the decision that goes
  /// into `inside`, also if that is null. 0 stays 0; other distances that are too small or too
  /// large for a type become its smallest or largest number.
  float* distances = nullptr;
  double* doubleDistances = nullptr;
  /// The largest distance that is written, more than 0; farther samples get it, with their sign.
  double distanceLimit = std::numeric_limits<double>::infinity();

  bool hasDistances() const { return this->distances || this->doubleDistances; }

  /// Writes the values of samples first … first + count − 1.
  template <class Real> void write(const Real* from, std::size_t first, std::size_t count) const;

  /// Asks memory for the places that fill() will write for a sample soon, which lie anywhere if
  /// samples do not come in their order.
  void askFor(std::size_t sample) const;

  /// Writes one value to all of samples first … first + count − 1.
  void fill(double sum, std::size_t first, std::size_t count) const;

  /// Writes the distance of a sample, whose value or side has been written.
  void writeDistance(double distance, std::size_t sample) const;

private:
  template <class Real>
  void writeSummed(const Real* from, std::size_t first, std::size_t count) const;
  template <InsideRule Rule, class Real>
  SideCounts countSides(const Real* from, std::size_t count) const;
  double kept(double value) const;
  bool isInsideAt(std::size_t sample) const;
};

} // namespace winding
