// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CellChecks.h"

#include "base/Refusal.h"
#include "mesh/CellTypes.h"

namespace winding
{

void CellChecks::refuse(const std::string& fault) const
{
  throw Refusal("mend the data set: " + name_ + " " + fault);
}

void CellChecks::refuseCell(std::int64_t cell, const std::string& fault) const
{
  throw Refusal("mend the data set: cell " + std::to_string(cell) + " of " + name_ + " " + fault);
}

void CellChecks::checkOffsets(bool areValid) const
{
  if (!areValid)
  {
    this->refuse("has cells whose offsets lead out of their list of ids");
  }
}

void CellChecks::checkTypes(std::int64_t cells, std::int64_t types) const
{
  if (types < cells)
  {
    this->refuse("has " + std::to_string(cells) + " cells but types for " + std::to_string(types));
  }
}

void CellChecks::refuseType(std::int64_t cell, int type) const
{
  throw Refusal(Message(
    "cell " + std::to_string(cell) + " of " + name_ + " has unknown type " + std::to_string(type),
    {{"use a VTK that knows it", {}}, {"leave these cells out", {}}}));
}

void CellChecks::checkType(
  std::int64_t cell, int type, std::int64_t points, const double* degrees) const
{
  if (dimensionOf(type) < 0)
  {
    this->refuseType(cell, type);
  }
  if (type != polyhedronType && !canHavePoints(type, points, degrees))
  {
    this->refuseCell(cell, "has " + std::to_string(points) + " points, which a cell of type " +
                             std::to_string(type) + " cannot have");
  }
}

void CellChecks::checkPolyhedron(
  std::int64_t cell, const std::vector<std::int64_t>& faces, std::vector<std::int64_t> own) const
{
  if (faces.empty() || faces[0] < 1)
  {
    throw Refusal(
      Message("cell " + std::to_string(cell) + " of " + name_ + " is a polyhedron without faces",
        {{"read it with a newer VTK, if one has written it", {}}, {"give it faces", {}}}));
  }
  std::sort(own.begin(), own.end());
  std::int64_t left = faces[0];
  auto at = faces.begin() + 1;
  for (; left > 0 && at != faces.end(); --left)
  {
    const std::int64_t size = *at++;
    if (size < 0 || size > faces.end() - at)
    {
      this->refuseCell(cell, "is a polyhedron with a face that does not end");
    }
    if (own.empty())
    {
      this->checkIds(cell, at, at + size);
    }
    const auto other = std::find_if(at, at + size,
      [&own](std::int64_t id)
      { return !own.empty() && !std::binary_search(own.begin(), own.end(), id); });
    if (other != at + size)
    {
      this->refuseCell(cell, "is a polyhedron with a face at point " + std::to_string(*other) +
                               ", which is none of its points");
    }
    at += size;
  }
  if (left != 0 || at != faces.end())
  {
    this->refuseCell(cell, "is a polyhedron with another number of faces than it says");
  }
}

} // namespace winding
