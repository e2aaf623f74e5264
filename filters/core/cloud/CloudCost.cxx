#include "cloud/CloudCost.h"

#include <algorithm>

namespace winding
{

double secondsToPrepareCloud(std::size_t points, int neighbors, bool needsAreas, bool needsNormals)
{
  const auto count = static_cast<double>(points);
  const double around = std::min<double>(neighbors, count);
  // Neighbours are sorted as they are found, and cells are clipped by each of them.
  const double areas = 0.9e-6 + 45e-9 * around + 0.7e-9 * around * around;
  const double normals = 2.3e-6 + 30e-9 * around;
  constexpr double start = 20e-6;
  return start + count * (0.1e-6 + (needsAreas ? areas : 0) + (needsNormals ? normals : 0));
}

} // namespace winding
