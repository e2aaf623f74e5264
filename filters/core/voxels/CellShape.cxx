#include "voxels/CellShape.h"

#include <array>

namespace winding
{

namespace
{

/// Numbers of corners, face after face; −1 ends a face.
using FaceTable = std::vector<int>;

constexpr int firstLinearType = 10, linearTypes = 7;
constexpr std::array<std::size_t, linearTypes> cornersOfTypes = {4, 8, 8, 6, 5, 10, 12};

/// The faces by type, from tetrahedra on.
const std::array<FaceTable, linearTypes>& faceTables()
{
  static const std::array<FaceTable, linearTypes> tables = {{
    {0, 1, 3, -1, 1, 2, 3, -1, 2, 0, 3, -1, 0, 2, 1, -1},
    {0, 4, 6, 2, -1, 1, 3, 7, 5, -1, 0, 1, 5, 4, -1, 2, 6, 7, 3, -1, 0, 2, 3, 1, -1, 4, 5, 7, 6,
      -1},
    {0, 4, 7, 3, -1, 1, 2, 6, 5, -1, 0, 1, 5, 4, -1, 3, 7, 6, 2, -1, 0, 3, 2, 1, -1, 4, 5, 6, 7,
      -1},
    {0, 1, 2, -1, 3, 5, 4, -1, 0, 3, 4, 1, -1, 1, 4, 5, 2, -1, 2, 5, 3, 0, -1},
    {0, 3, 2, 1, -1, 0, 1, 4, -1, 1, 2, 4, -1, 2, 3, 4, -1, 3, 0, 4, -1},
    {0, 4, 3, 2, 1, -1, 5, 6, 7, 8, 9, -1, 0, 1, 6, 5, -1, 1, 2, 7, 6, -1, 2, 3, 8, 7, -1, 3, 4, 9,
      8, -1, 4, 0, 5, 9, -1},
    {0, 5, 4, 3, 2, 1, -1, 6, 7, 8, 9, 10, 11, -1, 0, 1, 7, 6, -1, 1, 2, 8, 7, -1, 2, 3, 9, 8, -1,
      3, 4, 10, 9, -1, 4, 5, 11, 10, -1, 5, 0, 6, 11, -1},
  }};
  return tables;
}

} // namespace

void CellShape::clear()
{
  points.clear();
  faceCorners.clear();
  faceEnds.assign(1, 0);
}

void CellShape::addFace(const int* corners, int count)
{
  faceCorners.insert(faceCorners.end(), corners, corners + count);
  faceEnds.push_back(static_cast<int>(faceCorners.size()));
}

bool CellShape::addLinearFaces(int type)
{
  const int kind = type - firstLinearType;
  if (kind < 0 || kind >= linearTypes || points.size() < cornersOfTypes[std::size_t(kind)])
  {
    return false;
  }
  for (const int corner : faceTables()[std::size_t(kind)])
  {
    if (corner >= 0)
    {
      faceCorners.push_back(corner);
    }
    else
    {
      faceEnds.push_back(static_cast<int>(faceCorners.size()));
    }
  }
  return true;
}

} // namespace winding
