// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "messages/PropertyChecks.h"

#include "base/Digits.h"
#include "base/Refusal.h"
#include "messages/Options.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace winding
{

namespace
{

[[noreturn]] void refuse(Parameter property, double value, const std::string& range)
{
  constexpr int digitsOfInt = 10;
  throw Refusal(Message(property, "is " + inDigits(value, digitsOfInt) + range));
}

/// Returns the name of a choice: the entry of ParaView's panel there, else its constant in C++.
std::string nameOf(const Choice& choice)
{
  return frontEnd() == FrontEnd::paraview ? choice.entry : choice.constant;
}

/// Returns the first `count` choices in words.
std::string wordsOf(const std::vector<Choice>& choices, std::size_t count)
{
  std::string words;
  for (std::size_t i = 0; i < count; ++i)
  {
    const char* before = i == 0 ? "" : i + 1 == count ? " or " : ", ";
    words += before + nameOf(choices[i]) + " (" + std::to_string(choices[i].number) + ")";
  }
  return words;
}

std::string rangeOf(const Option& option, double value)
{
  if (!std::isfinite(option.lowest))
  {
    return "a finite number";
  }
  return joined(std::isfinite(value) ? "" : "a finite number, ", option.lowest,
    std::isfinite(option.highest) ? joined(" to ", option.highest) : " or more");
}

} // namespace

void checkProperty(Parameter property, double value, int choices)
{
  const Option& option = *optionOf(property);
  const std::size_t count =
    std::min(option.choices.size(), static_cast<std::size_t>(std::max(choices, 0)));
  const double highest = count > 0 ? option.choices[count - 1].number : option.highest;
  if (!(value >= option.lowest && value <= highest && std::isfinite(value)))
  {
    refuse(property, value,
      "; it must be " + (count > 0 ? wordsOf(option.choices, count) : rangeOf(option, value)));
  }
}

void checkDimensions(const int dimensions[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions[axis] < 1)
    {
      refuse(Parameter::samplingDimensions, dimensions[axis],
        std::string(" along ") + "xyz"[axis] + "; it must be 1 or more");
    }
  }
}

} // namespace winding
