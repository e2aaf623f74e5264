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

/// How far a winding number is beyond what the rule asks for: continuous in it, more than 0 inside and
/// less than 0 outside. Where it is 0, isInside() decides.
inline double levelOf(double windingNumber, InsideRule rule, double threshold)
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

} // namespace winding
