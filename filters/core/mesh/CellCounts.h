// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// Counts of cells whose part in a source may differ from what their owner expects.
struct CellCounts
{
  std::size_t turned = 0;  ///< cells with volume at the outer surface, ordered the other way round
  std::size_t leftOut = 0; ///< cells of two dimensions where there are three, or the latter
  std::size_t loose = 0;   ///< lines and single points, where there are faces or cells with volume
  std::size_t flat = 0;    ///< cells with curved faces that no division brings near their shape
};

/// Returns what a user should know of cells that were counted.
std::vector<Message> notesOn(const CellCounts& counts);

/// Counts the lines and single points among cells of some types.
void countLoose(const std::vector<std::uint8_t>& types, CellCounts& counts);

/// Bits of VTK's ghost arrays: cells of another piece, refined and hidden ones.
constexpr std::uint8_t ghostCellBits = 1 | 8 | 32;

/**
 * Returns by cell whether it makes the surface of a mesh. Ghosts, by their flags, do not, if
 * `ghosts` is not null. Where there are cells of two and of three dimensions, cells with volume are
 * taken, or faces if `takesFaces`; the others are counted.
 */
std::vector<char> ownCellsOf(const std::vector<std::uint8_t>& types, const std::uint8_t* ghosts,
  bool takesFaces, CellCounts& counts);

} // namespace winding
