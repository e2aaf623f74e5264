// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/NamedRegions.h"

#include <algorithm>
#include <map>
#include <utility>

namespace winding
{

std::string_view regionName(std::string_view text)
{
  constexpr const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
           ? std::string_view()
           : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

void append(std::vector<RegionStart>& starts, std::vector<RegionStart>& more, std::size_t before)
{
  for (RegionStart& start : more)
  {
    start.polygon += before;
    starts.push_back(std::move(start));
  }
}

void addRegions(const char* kind, const std::vector<RegionStart>& starts, EqualNames equalNames,
  std::size_t polygons, std::vector<NamedRegions>& all)
{
  NamedRegions regions;
  regions.kind = kind;
  std::map<std::string_view, std::int32_t> numbers;
  std::vector<std::pair<std::size_t, std::int32_t>> runs; // the ends of runs, and their regions
  const auto addRun = [&](std::size_t first, std::size_t last, const std::string& name)
  {
    if (first == last)
    {
      return;
    }
    const auto next = static_cast<std::int32_t>(regions.names.size());
    const auto [known, isNew] = numbers.emplace(name, next);
    if (isNew || equalNames == EqualNames::otherRegions)
    {
      regions.names.push_back(name);
      known->second = next;
    }
    runs.emplace_back(last, known->second);
  };
  const std::string none;
  addRun(0, starts.empty() ? polygons : starts[0].polygon, none);
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    const bool isLast = i + 1 == starts.size();
    addRun(starts[i].polygon, isLast ? polygons : starts[i + 1].polygon, starts[i].name);
  }
  if (regions.names.size() < 2)
  {
    return;
  }
  regions.ofPolygon = PlainArray<std::int32_t>(polygons);
  std::size_t first = 0;
  for (const auto& [last, region] : runs)
  {
    std::fill(regions.ofPolygon.begin() + first, regions.ofPolygon.begin() + last, region);
    first = last;
  }
  all.push_back(std::move(regions));
}

} // namespace winding
