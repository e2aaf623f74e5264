// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CellCounts.h"

#include "mesh/CellTypes.h"

#include <algorithm>

namespace winding
{

std::vector<Message> notesOn(const CellCounts& counts)
{
  std::vector<Message> notes;
  if (counts.leftOut > 0)
  {
    notes.push_back(
      {"cells with and without volume are mixed", {{"choose which", {Parameter::surfaceCells}}},
        std::to_string(counts.leftOut) + " cells of the other kind are left out"});
  }
  if (counts.loose > 0)
  {
    notes.push_back(
      {"lines and single points bound nothing", {{"make faces of them, if they are walls", {}}},
        std::to_string(counts.loose) + " are left out"});
  }
  if (counts.flat > 0)
  {
    notes.push_back({"curved cells are cut off", {{"divide them finer first", {}}},
      std::to_string(counts.flat) + " are farther than a thousandth of the mesh's diagonal from "
                                    "their triangles"});
  }
  return notes;
}

void countLoose(const std::vector<std::uint8_t>& types, CellCounts& counts)
{
  counts.loose += static_cast<std::size_t>(std::count_if(types.begin(), types.end(),
    [](std::uint8_t type) { return type > 0 && dimensionOf(type) >= 0 && dimensionOf(type) < 2; }));
}

std::vector<char> ownCellsOf(const std::vector<std::uint8_t>& types, const std::uint8_t* ghosts,
  bool takesFaces, CellCounts& counts)
{
  std::vector<char> isOwn(types.size(), 1);
  const auto has = [&types](int dimension)
  {
    return std::any_of(types.begin(), types.end(),
      [dimension](std::uint8_t type) { return dimensionOf(type) == dimension; });
  };
  const int unwanted = has(2) && has(3) ? takesFaces ? 3 : 2 : -2;
  for (std::size_t cell = 0; cell < types.size(); ++cell)
  {
    const bool isGhost = ghosts && (ghosts[cell] & ghostCellBits) != 0;
    const bool isOther = dimensionOf(types[cell]) == unwanted;
    isOwn[cell] = !isGhost && !isOther;
    counts.leftOut += !isGhost && isOther ? 1 : 0;
  }
  return isOwn;
}

} // namespace winding
