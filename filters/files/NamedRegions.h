// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/PlainArray.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace winding
{

/// The polygons of a file in regions that it names: objects, groups, materials or solids.
struct NamedRegions
{
  const char* kind = "";              ///< Object, Group, Material or Solid
  PlainArray<std::int32_t> ofPolygon; ///< the region of each polygon, by its place in `names`
  std::vector<std::string> names;     ///< in the order of the file; empty for what has no name
};

/// A statement of a file by which a region begins.
struct RegionStart
{
  std::size_t polygon; ///< the first that is in it
  std::string name;    ///< empty for none
};

/// Moves the starts of a part of a file, counted from its first polygon, behind others. `before` is
/// the number of polygons before that part.
void append(std::vector<RegionStart>& starts, std::vector<RegionStart>& more, std::size_t before);

/// Whether equal names mean the same region.
enum class EqualNames
{
  sameRegion,
  otherRegions
};

/// Returns the text of a statement without blanks around it.
std::string_view regionName(std::string_view text);

/// Appends the regions of one kind, which begin in the order of the polygons, to `all`. There has
/// to be more than one region, of `polygons` polygons.
void addRegions(const char* kind, const std::vector<RegionStart>& starts, EqualNames equalNames,
  std::size_t polygons, std::vector<NamedRegions>& all);

} // namespace winding
