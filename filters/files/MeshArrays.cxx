#include "files/MeshArrays.h"

#include <numeric>

namespace winding
{

CellArrays oneCellOf(std::size_t points)
{
  CellArrays cells;
  if (points > 0)
  {
    cells.offsets = PlainArray<std::int64_t>(2);
    cells.offsets[0] = 0;
    cells.offsets[1] = static_cast<std::int64_t>(points);
    cells.connectivity = PlainArray<std::int64_t>(points);
    std::iota(cells.connectivity.begin(), cells.connectivity.end(), std::int64_t(0));
  }
  return cells;
}

} // namespace winding
