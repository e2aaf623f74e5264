// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Directions.h"

#include "base/Digits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>
#include <utility>

namespace winding
{

std::vector<double> numbersIn(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0;
  while (words >> number)
  {
    numbers.push_back(number);
  }
  const bool isRight = words.eof() && std::all_of(numbers.begin(), numbers.end(),
                                        [](double value) { return std::isfinite(value); });
  return isRight ? numbers : std::vector<double>();
}

Eigen::Vector3d directionIn(const std::string& text)
{
  const std::string word = trimmed(text);
  const std::pair<const char*, Eigen::Vector3d> words[] = {{"up", {0, 0, 1}}, {"down", {0, 0, -1}},
    {"+x", {1, 0, 0}}, {"-x", {-1, 0, 0}}, {"+y", {0, 1, 0}}, {"-y", {0, -1, 0}}, {"+z", {0, 0, 1}},
    {"-z", {0, 0, -1}}};
  const auto* const found = std::find_if(std::begin(words), std::end(words),
    [&word](const auto& candidate) { return candidate.first == word; });
  if (found != std::end(words))
  {
    return found->second;
  }
  const std::string direction = "direction ";
  if (word.rfind(direction, 0) != 0)
  {
    return {0, 0, 0};
  }
  const std::vector<double> numbers = numbersIn(word.substr(direction.size()));
  return numbers.size() == 3 ? unitOrZero({numbers[0], numbers[1], numbers[2]})
                             : Eigen::Vector3d(0, 0, 0);
}

Eigen::Vector3d unitOrZero(const Eigen::Vector3d& vector)
{
  const double length = vector.stableNorm();
  return length > 0 && std::isfinite(length) ? Eigen::Vector3d(vector / length)
                                             : Eigen::Vector3d(0, 0, 0);
}

std::string trimmed(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string textOf(const Eigen::Vector3d& vector)
{
  constexpr int exact = 17;
  return joined(
    inDigits(vector[0], exact), ' ', inDigits(vector[1], exact), ' ', inDigits(vector[2], exact));
}

} // namespace winding
