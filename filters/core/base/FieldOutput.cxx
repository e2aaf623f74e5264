// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/FieldOutput.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// A value as an array of the type stores it: what it cannot hold becomes its largest number.
template <class To, class Real> To stored(Real value)
{
  constexpr To largest = std::numeric_limits<To>::max();
  const auto most = static_cast<Real>(std::min<double>(largest, std::numeric_limits<Real>::max()));
  return static_cast<To>(std::clamp(value, -most, most)); // NaN stays
}

/// A distance with its sign, in a type with perhaps a smaller range than double: only 0 becomes 0,
/// and nothing becomes infinite.
template <class Real> Real signedDistance(double distance, bool isInside)
{
  using Limits = std::numeric_limits<Real>;
  const double least = distance > 0 ? Limits::min() : 0;
  const double held = std::clamp<double>(distance, least, Limits::max()); // NaN stays
  return static_cast<Real>(isInside && held > 0 ? -held : held);
}

} // namespace

/// Returns a value as the array of w would store it.
double FieldOutput::kept(double value) const
{
  return this->doubleValues ? value : stored<float>(value);
}

template <InsideRule Rule, class Real>
SideCounts FieldOutput::countSides(const Real* from, std::size_t count) const
{
  SideCounts counts;
  std::for_each(from, from + count,
    [&](Real value) {
      counts.add(this->kept(value), {Rule, this->isInside.threshold});
    });
  return counts;
}

template <class Real>
void FieldOutput::write(const Real* from, std::size_t first, std::size_t count) const
{
  if (this->added == 0)
  {
    this->writeSummed(from, first, count);
    return;
  }
  constexpr std::size_t valuesPerBlock = 256;
  Real sums[valuesPerBlock];
  for (std::size_t done = 0; done < count; done += valuesPerBlock)
  {
    const std::size_t block = std::min(valuesPerBlock, count - done);
    std::transform(from + done, from + done + block, sums,
      [this](Real value) { return static_cast<Real>(value + this->added); });
    this->writeSummed(sums, first + done, block);
  }
}

/// Writes values to which nothing needs to be added.
template <class Real>
void FieldOutput::writeSummed(const Real* from, std::size_t first, std::size_t count) const
{
  if (this->values)
  {
    std::transform(
      from, from + count, this->values + first, [](Real value) { return stored<float>(value); });
  }
  if (this->doubleValues)
  {
    std::transform(from, from + count, this->doubleValues + first,
      [](Real value) { return stored<double>(value); });
  }
  if (this->inside)
  {
    std::transform(from, from + count, this->inside + first,
      [this](Real value) { return static_cast<unsigned char>(this->isInside(this->kept(value))); });
  }
  if (this->sides)
  {
    this->sides->add(this->isInside.rule == InsideRule::signedThreshold
                       ? this->countSides<InsideRule::signedThreshold>(from, count)
                     : this->isInside.rule == InsideRule::absoluteThreshold
                       ? this->countSides<InsideRule::absoluteThreshold>(from, count)
                       : this->countSides<InsideRule::odd>(from, count));
  }
}

template void FieldOutput::write(const float*, std::size_t, std::size_t) const;
template void FieldOutput::write(const double*, std::size_t, std::size_t) const;

void FieldOutput::fill(double sum, std::size_t first, std::size_t count) const
{
  const double value = sum + this->added;
  if (this->values)
  {
    std::fill_n(this->values + first, count, stored<float>(value));
  }
  if (this->doubleValues)
  {
    std::fill_n(this->doubleValues + first, count, value);
  }
  if (this->inside)
  {
    std::fill_n(
      this->inside + first, count, static_cast<unsigned char>(this->isInside(this->kept(value))));
  }
  if (this->sides)
  {
    SideCounts counts;
    counts.add(this->kept(value), this->isInside, count);
    this->sides->add(counts);
  }
}

void FieldOutput::askFor(std::size_t sample) const
{
  if (this->values)
  {
    hwy::Prefetch(this->values + sample);
  }
  if (this->doubleValues)
  {
    hwy::Prefetch(this->doubleValues + sample);
  }
  if (this->inside)
  {
    hwy::Prefetch(this->inside + sample);
  }
}

bool FieldOutput::isInsideAt(std::size_t sample) const
{
  if (this->inside)
  {
    return this->inside[sample] != 0;
  }
  const double kept = this->doubleValues ? this->doubleValues[sample] : this->values[sample];
  return this->isInside(kept);
}

void FieldOutput::writeDistance(double distance, std::size_t sample) const
{
  const bool isNegative = this->isInsideAt(sample);
  const double limited = distance > this->distanceLimit ? this->distanceLimit : distance;
  if (this->distances)
  {
    this->distances[sample] = signedDistance<float>(limited, isNegative);
  }
  if (this->doubleDistances)
  {
    this->doubleDistances[sample] = signedDistance<double>(limited, isNegative);
  }
}

} // namespace winding
