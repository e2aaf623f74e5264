#pragma once

#include <initializer_list>
#include <limits>

/**
 * @file
 * The ranges of properties. All checks throw Refusal, with one line that has the property's name,
 * its value and what it may be, for values out of range; none of them is a number that is NaN or
 * infinite.
 */
namespace winding
{

/// Throws unless low ≤ value ≤ high. Without `high` any finite number from `low` on will do.
void checkRange(const char* property, double value, double low,
  double high = std::numeric_limits<double>::infinity());

/// Throws unless the value is finite.
void checkFinite(const char* property, double value);

/// Throws unless the value is the number of a choice. The choices, with these names,
/// have the numbers from `first` on.
void checkChoice(
  const char* property, int value, std::initializer_list<const char*> names, int first = 0);

} // namespace winding
