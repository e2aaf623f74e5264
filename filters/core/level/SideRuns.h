// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays/RowCrossings.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace winding
{

/// Describes a row of `width` samples by their sides, 1 inside and 0 outside, as runs with these
/// values.
inline void describeSides(const std::uint8_t* row, int width, std::vector<RowRun>& runs)
{
  runs.clear();
  for (int begin = 0; begin < width;)
  {
    const int end = static_cast<int>(std::find(row + begin, row + width, !row[begin]) - row);
    runs.push_back({begin, end, row[begin]});
    begin = end;
  }
}

} // namespace winding
