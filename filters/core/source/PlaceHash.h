// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>

namespace winding
{

/// Hashes three numbers, for maps of places or cells. 0 and -0 are equal, and so are their hashes.
struct PlaceHash
{
  std::size_t operator()(const std::array<double, 3>& place) const
  {
    std::size_t hash = 0;
    for (const double number : place)
    {
      hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(number);
    }
    return hash;
  }
};

} // namespace winding
