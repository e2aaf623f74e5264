#include "cloud/CloudCost.h"

#include <algorithm>

namespace winding
{

double secondsToPrepareCloud(std::size_t points, int neighbors, bool needsAreas, NormalWork normals)
{
  const auto count = static_cast<double>(points);
  const double around = std::min<double>(neighbors, count);
  // Neighbours are sorted as they are found, and cells are clipped by each of them.
  const double areas = 0.9e-6 + 45e-9 * around + 0.7e-9 * around * around;
  const double tree = 2.3e-6 + 30e-9 * around;
  // Many sums over all points take most of the time of patches, and planes the rest: 48 to 56
  // microseconds for 20 neighbours of 100 000 to a million points.
  const double patches = normals == NormalWork::patches ? 36e-6 + 0.9e-6 * around : 0;
  constexpr double start = 20e-6;
  return start + count * (0.1e-6 + (needsAreas ? areas : 0) +
                           (normals == NormalWork::none ? 0 : tree) + patches);
}

} // namespace winding
