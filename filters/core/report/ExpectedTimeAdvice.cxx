// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/ExpectedTimeAdvice.h"

#include "base/Digits.h"
#include "base/Refusal.h"
#include "farfield/FarFieldAccuracy.h"

namespace winding
{

namespace
{

/// Returns a number of two digits, or more before the point, and its unit, which has no s for 1.
std::string withUnit(double number, const std::string& unit)
{
  constexpr double ten = 9.95; // once it is rounded
  const std::string text = number < ten ? inDigits(number, 2) : inPlaces(number, 0);
  return text + ' ' + unit + (text == "1" ? "" : "s");
}

/// Returns a time in the unit in which people would say it.
std::string inWords(double seconds)
{
  constexpr double minute = 60, hour = 60 * minute, day = 24 * hour;
  struct Unit
  {
    double length;
    const char* name;
  };
  for (const Unit& unit : {Unit{day, "day"}, Unit{hour, "hour"}, Unit{minute, "minute"}})
  {
    if (seconds >= 2 * unit.length)
    {
      return withUnit(seconds / unit.length, unit.name);
    }
  }
  return withUnit(seconds, "second");
}

std::vector<Remedy> fasterThan(const FieldInfo& info)
{
  std::vector<Remedy> remedies;
  const bool sumsAll = info.method == Method::direct || info.method == Method::parity;
  if (sumsAll)
  {
    constexpr int automatic = static_cast<int>(Method::automatic);
    remedies.push_back({"", {{Parameter::method, automatic}}});
  }
  if (!sumsAll || info.tolerance < FarFieldAccuracy::finest)
  {
    remedies.push_back({"choose a larger tolerance", {Parameter::tolerance}});
  }
  remedies.push_back(info.isScattered ? Remedy{"choose fewer samples", {}} : largerVoxels());
  return remedies;
}

} // namespace

std::optional<Message> expectedTimeAdvice(const FieldInfo& info, const ExpectedWork& work)
{
  constexpr double longEnoughToSay = 60;
  const bool isRefused = work.limit > 0 && work.seconds > work.limit;
  if (!isRefused && work.seconds <= longEnoughToSay)
  {
    return std::nullopt;
  }
  Message advice{"this takes about " + inWords(work.seconds), fasterThan(info),
    std::to_string(work.samples) + " samples of " + std::to_string(info.primitives) +
      (info.isSurface ? " triangles" : " points") + " by the method " + nameOf(info.method)};
  if (isRefused)
  {
    advice.remedies.push_back(
      {"allow more than " + inDigits(work.limit, 4) + " s", {Parameter::longestExpectedTime}});
    throw Refusal(advice);
  }
  return advice;
}

} // namespace winding
