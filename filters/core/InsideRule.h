#pragma once

#include <cmath>

namespace winding
{

/// When a sample counts as inside.
enum class InsideRule
{
  signedThreshold,   ///< w ≥ threshold: outward oriented solids
  absoluteThreshold, ///< |w| ≥ threshold: solids of either orientation
  odd                ///< the integer nearest to w is odd: what parity would say
};

inline bool isInside(double windingNumber, InsideRule rule, double threshold)
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

} // namespace winding
