// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/InputUnits.h"

#include "base/Digits.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Sizes that differ by more than this ratio do not fit each other.
constexpr double mostRatio = 20;
/// Planes of sides that are nearer than this share of a size are one.
constexpr double samePlane = 1e-3;

double sizeOf(const Bounds& bounds)
{
  return bounds.isEmpty() ? 0 : bounds.diagonal().norm();
}

/// Sides of a box that lie in sides of another one.
struct CommonSides
{
  int count = 0;
  bool areFlat = false; ///< whether one of them is all that the box has along its axis
};

CommonSides commonSides(const Bounds& box, const Bounds& other, double tolerance)
{
  // A plane nearer to the origin might be anywhere in another unit.
  const double nearOrigin = mostRatio * tolerance;
  CommonSides found;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto isCommon = [&](double plane)
    {
      return std::abs(plane) > nearOrigin && (std::abs(plane - other.min()[axis]) <= tolerance ||
                                               std::abs(plane - other.max()[axis]) <= tolerance);
    };
    const bool isFlat = box.sizes()[axis] <= tolerance;
    const bool isLowCommon = isCommon(box.min()[axis]);
    found.count += static_cast<int>(isLowCommon);
    found.count += static_cast<int>(!isFlat && isCommon(box.max()[axis]));
    found.areFlat = found.areFlat || (isFlat && isLowCommon);
  }
  return found;
}

Bounds grown(const Bounds& box, double length)
{
  return {box.min().array() - length, box.max().array() + length};
}

/// The inputs that one is compared with.
struct Others
{
  Bounds bounds;
  std::size_t count = 0;
};

/// Returns the box around all inputs except one, and except inputs that are tiny next to others.
Others othersOf(const std::vector<NamedBounds>& inputs, std::size_t input)
{
  double largest = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    largest = i == input ? largest : std::max(largest, sizeOf(inputs[i].bounds));
  }
  Others others;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    if (i != input && !inputs[i].bounds.isEmpty() &&
        mostRatio * sizeOf(inputs[i].bounds) >= largest)
    {
      others.bounds.extend(inputs[i].bounds);
      ++others.count;
    }
  }
  return others;
}

/// Whether a box fits another one times a factor, and does not as it is.
bool fitsTimes(double factor, const Bounds& box, const Bounds& others)
{
  const double size = sizeOf(box), otherSize = sizeOf(others);
  const bool isFarOff = factor > 1 ? mostRatio * size < otherSize : size > mostRatio * otherSize;
  const bool isComparable =
    factor * size <= mostRatio * otherSize && otherSize <= mostRatio * factor * size;
  if (size == 0 || otherSize == 0 || !isFarOff || !isComparable)
  {
    return false;
  }
  const double generous = samePlane * std::max(size, otherSize);
  if (commonSides(box, others, generous).count > 0)
  {
    return false;
  }
  const Bounds scaled(factor * box.min(), factor * box.max());
  const double tolerance = samePlane * std::min(factor * size, otherSize);
  const CommonSides common = commonSides(scaled, others, tolerance);
  const Bounds reach = grown(others, tolerance);
  return (common.count >= 2 && reach.intersects(scaled)) ||
         (common.areFlat && reach.contains(scaled));
}

/// Inputs that may be in another unit, and how many others the first of them is compared with.
struct Suspects
{
  std::vector<std::size_t> inputs;
  std::size_t support = 0;
};

Suspects suspectsOf(
  double factor, const std::vector<NamedBounds>& inputs, const std::vector<Others>& others)
{
  Suspects found;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    if (!inputs[i].bounds.isEmpty() && others[i].count > 0 &&
        fitsTimes(factor, inputs[i].bounds, others[i].bounds))
    {
      found.support = found.inputs.empty() ? others[i].count : found.support;
      found.inputs.push_back(i);
    }
  }
  return found;
}

/// Whether suspects of smaller size are named rather than suspects of larger size.
bool areNamed(const Suspects& small, const Suspects& large)
{
  if (small.inputs.empty() || large.inputs.empty())
  {
    return large.inputs.empty();
  }
  return small.support != large.support ? small.support > large.support
                                        : small.inputs.size() <= large.inputs.size();
}

Message adviceOn(const std::vector<std::size_t>& found, const std::string& scale,
  const std::vector<NamedBounds>& inputs, const std::vector<Others>& others)
{
  constexpr std::size_t mostNames = 2;
  std::string names;
  for (std::size_t i = 0; i < std::min(found.size(), mostNames); ++i)
  {
    names += (i == 0 ? "'" : ", '") + inputs[found[i]].name + "'";
  }
  names += found.size() > mostNames ? ", ..." : "";
  const bool isOne = found.size() == 1;
  const std::size_t first = found.front();
  return {names + (isOne ? " seems" : " seem") + " to be in another unit",
    {{(isOne ? "scale it by " : "scale them by ") + scale, {}}},
    "then the sides of " + std::string(isOne ? "its" : "their") +
      " bounds fit the others; the diagonal of '" + inputs[first].name + "' is " +
      inDigits(sizeOf(inputs[first].bounds), 3) + ", and the others' is " +
      inDigits(sizeOf(others[first].bounds), 3)};
}

} // namespace

std::optional<Message> unitAdvice(const std::vector<NamedBounds>& inputs)
{
  // The boxes of others take a time that grows with the square of the number of inputs.
  constexpr std::size_t mostInputs = 5000;
  if (inputs.size() < 2 || inputs.size() > mostInputs)
  {
    return std::nullopt;
  }
  std::vector<Others> others;
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    others.push_back(othersOf(inputs, i));
  }
  struct Unit
  {
    double factor;
    const char *times, *over;
  };
  for (const Unit& unit : {Unit{1000, "1000", "0.001"}, Unit{25.4, "25.4", "1/25.4"}})
  {
    const Suspects small = suspectsOf(unit.factor, inputs, others);
    const Suspects large = suspectsOf(1 / unit.factor, inputs, others);
    if (!small.inputs.empty() || !large.inputs.empty())
    {
      return areNamed(small, large) ? adviceOn(small.inputs, unit.times, inputs, others)
                                    : adviceOn(large.inputs, unit.over, inputs, others);
    }
  }
  return std::nullopt;
}

} // namespace winding
