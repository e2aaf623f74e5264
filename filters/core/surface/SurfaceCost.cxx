#include "surface/SurfaceCost.h"

#include "base/EvaluationCost.h"

namespace winding
{

double secondsToPrepareSurface(std::size_t triangles, std::size_t points)
{
  constexpr double start = 20e-6;
  return start + slowdownByCacheMisses(triangles) *
                   (70e-9 * static_cast<double>(triangles) + 40e-9 * static_cast<double>(points));
}

} // namespace winding
