#include "surface/SurfaceCost.h"

#include "base/EvaluationCost.h"

namespace winding
{

double secondsToPrepareSurface(std::size_t triangles, std::size_t points, std::size_t capTriangles)
{
  constexpr double start = 200e-6;
  // The edges of a boundary are sorted and chained on one thread.
  return start + 2e-6 * static_cast<double>(capTriangles) +
         slowdownByCacheMisses(triangles) *
           (85e-9 * static_cast<double>(triangles) + 40e-9 * static_cast<double>(points));
}

} // namespace winding
