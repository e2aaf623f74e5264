#include "private/pipeline/PropertyChecks.h"

#include "base/Refusal.h"

#include <cmath>
#include <sstream>
#include <string>

namespace winding
{

namespace
{

[[noreturn]] void refuse(const char* property, double value, const std::string& range)
{
  std::ostringstream line;
  line.precision(10); // enough for every int
  line << property << " is " << value << "; it must be " << range;
  throw Refusal(line.str());
}

} // namespace

void checkRange(const char* property, double value, double low, double high)
{
  if (value >= low && value <= high && std::isfinite(value))
  {
    return;
  }
  std::ostringstream range;
  range << (std::isfinite(value) ? "" : "a finite number, ") << low;
  if (std::isfinite(high))
  {
    range << " to " << high;
  }
  else
  {
    range << " or more";
  }
  refuse(property, value, range.str());
}

void checkFinite(const char* property, double value)
{
  if (!std::isfinite(value))
  {
    refuse(property, value, "a finite number");
  }
}

void checkChoice(
  const char* property, int value, std::initializer_list<const char*> names, int first)
{
  const auto count = static_cast<int>(names.size());
  if (value >= first && value - first < count)
  {
    return;
  }
  std::string choices;
  int number = first;
  for (const char* name : names)
  {
    if (number > first)
    {
      choices += number == first + count - 1 ? " or " : ", ";
    }
    choices += std::string(name) + " (" + std::to_string(number) + ")";
    ++number;
  }
  refuse(property, value, choices);
}

} // namespace winding
