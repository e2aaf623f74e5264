// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace winding
{

/// The rule by which a sample with winding number w counts as inside.
enum class InsideRule
{
  signedThreshold,   ///< w ≥ threshold: for outward oriented solids
  absoluteThreshold, ///< |w| ≥ threshold: for solids of either orientation
  odd                ///< the integer nearest to w is odd, like a parity of crossings
};

/// A test that decides by a rule and its threshold whether samples are inside.
struct InsideTest
{
  InsideRule rule = InsideRule::signedThreshold;
  double threshold = 0.5;

  /// Returns whether a sample of this winding number is inside.
  bool operator()(double windingNumber) const
  {
    switch (rule)
    {
    case InsideRule::signedThreshold:
      return windingNumber >= threshold;
    case InsideRule::absoluteThreshold:
      return std::abs(windingNumber) >= threshold;
    case InsideRule::odd:
      return std::fmod(std::abs(std::round(windingNumber)), 2.0) == 1.0;
    }
    return false;
  }

  /// Returns the amount by which a winding number exceeds the rule's limit: a continuous function
  /// of the number, more than 0 inside and less than 0 outside. Where it is 0, the test decides.
  double levelOf(double windingNumber) const
  {
    switch (rule)
    {
    case InsideRule::signedThreshold:
      return windingNumber - threshold;
    case InsideRule::absoluteThreshold:
      return std::abs(windingNumber) - threshold;
    case InsideRule::odd:
      return 0.5 - std::abs(std::fmod(std::abs(windingNumber), 2.0) - 1);
    }
    return 0;
  }

  /// Returns whether a sample that is half inside does not count, so that a lower threshold may
  /// help.
  bool hasHighThreshold() const { return rule != InsideRule::odd && threshold > 0.5; }
};

} // namespace winding
