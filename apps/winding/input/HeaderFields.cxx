// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/HeaderFields.h"

#include "files/Text.h"
#include "input/ImagePlace.h"

#include <algorithm>
#include <cmath>
#include <limits>

double numberOf(std::string_view word, const std::string& key)
{
  double value = 0;
  if (!parseNumber(word, value) || !std::isfinite(value))
  {
    throw HeaderFault("its header has no number in '" + key + "'");
  }
  return value;
}

void checkCount(std::size_t found, const std::string& key, std::size_t wanted)
{
  if (found != wanted)
  {
    throw HeaderFault("its header has " + std::to_string(found) + " numbers in '" + key +
                      "', not " + std::to_string(wanted));
  }
}

std::vector<double> numbersOf(std::string_view text, const std::string& key, std::size_t count)
{
  std::vector<double> numbers;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
  {
    numbers.push_back(numberOf(word, key));
  }
  checkCount(numbers.size(), key, count);
  return numbers;
}

int sizeOf(double value, const std::string& key)
{
  if (!(value >= 1 && value <= std::numeric_limits<int>::max() && value == std::floor(value)))
  {
    throw HeaderFault("its header has no number of voxels in '" + key + "'");
  }
  return static_cast<int>(value);
}

const std::string* findAny(const HeaderFields& fields, const std::vector<const char*>& keys)
{
  for (const char* key : keys)
  {
    if (const auto found = fields.find(key); found != fields.end())
    {
      return &found->second;
    }
  }
  return nullptr;
}

std::string_view takeHeaderLine(const std::string& head, std::size_t& start)
{
  if (start >= head.size())
  {
    throw HeaderFault("its header has no end");
  }
  return trimmed(takeLine(head, start));
}

std::size_t axesOf(const HeaderFields& fields, const char* key)
{
  const std::string* const text = findAny(fields, {key});
  if (!text)
  {
    throw HeaderFault(std::string("its header has no '") + key + "'");
  }
  constexpr double most = 16; // of NRRD
  const double axes = numberOf(*text, key);
  if (!(axes >= 2 && axes <= most && axes == std::floor(axes)))
  {
    throw HeaderFault(
      std::string("its header has another number of axes in '") + key + "' than 2 to 16");
  }
  return static_cast<std::size_t>(axes);
}

void checkStep(const std::vector<double>& step)
{
  if (std::any_of(
        step.begin() + std::min<std::ptrdiff_t>(3, static_cast<std::ptrdiff_t>(step.size())),
        step.end(), [](double number) { return number != 0; }))
  {
    throw HeaderFault("its axes of space and time are mixed");
  }
}
