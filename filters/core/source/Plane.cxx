// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Plane.h"

#include "base/Digits.h"
#include "base/Directions.h"
#include "base/Refusal.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace winding
{

namespace
{

[[noreturn]] void refuse(Parameter subject, const std::string& what)
{
  Message message(subject, "is no " + what);
  message.remedies = {{(what == "plane" ? "give a plane" : "give down, up, +x to -z or a plane") +
                         std::string(" as y=0, or as A B C=D for Ax + By + Cz = D"),
    {}}};
  throw Refusal(std::move(message));
}

/// Returns the words of a text, with each sign of equality as one.
std::vector<std::string> wordsOf(const std::string& text)
{
  std::string spaced;
  for (const char letter : text)
  {
    spaced += letter == '=' ? " = " : letter == ',' || letter == ';' ? " " : std::string(1, letter);
  }
  std::istringstream stream(spaced);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

} // namespace

Eigen::Vector3d Plane::projected(const Eigen::Vector3d& position) const
{
  Eigen::Vector3d result = position - this->height(position) * normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(normal[axis]) == 1)
    {
      result[axis] = offset * normal[axis] + 0.0; // no −0
    }
  }
  return result;
}

std::vector<Eigen::Vector3d> cornersOf(const Bounds& bounds)
{
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8 && !bounds.isEmpty(); ++i)
  {
    corners.push_back(bounds.corner(static_cast<Bounds::CornerType>(i)));
  }
  return corners;
}

std::vector<Plane> planesIn(const std::string& text, Parameter subject, const std::string& what)
{
  const std::vector<std::string> words = wordsOf(text);
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < words.size();)
  {
    const bool isAxis = words[i] == "x" || words[i] == "y" || words[i] == "z";
    const std::size_t equals = i + (isAxis ? 1 : 3);
    if (equals + 1 >= words.size() || words[equals] != "=")
    {
      refuse(subject, what);
    }
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (isAxis)
    {
      normal[words[i][0] - 'x'] = 1;
    }
    else if (const auto numbers = numbersIn(words[i] + ' ' + words[i + 1] + ' ' + words[i + 2]);
             numbers.size() == 3)
    {
      normal = {numbers[0], numbers[1], numbers[2]};
    }
    const std::vector<double> offset = numbersIn(words[equals + 1]);
    const double length = normal.stableNorm();
    if (offset.size() != 1 || !(length > 0) || !std::isfinite(length) ||
        !std::isfinite(offset[0] / length))
    {
      refuse(subject, what);
    }
    planes.push_back({normal / length, offset[0] / length});
    i = equals + 2;
  }
  return planes;
}

std::string textAlong(const std::vector<Plane>& planes, const Eigen::Matrix3d& inverseAxes,
  const Eigen::Vector3d& origin)
{
  std::string text;
  for (const Plane& plane : planes)
  {
    constexpr int exact = 17;
    text += joined(text.empty() ? "" : "; ", textOf(inverseAxes * plane.normal), " = ",
      inDigits(-plane.height(origin), exact));
  }
  return text;
}

} // namespace winding
