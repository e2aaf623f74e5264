#include "farfield/FarFieldCost.h"

#include "sums/DirectSumCost.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// What expansions of an order cost, in those of order 5.
double orderFactor(int order)
{
  return order <= 3 ? 0.6 : order <= 5 ? 1 : order <= 7 ? 2.5 : 5;
}

} // namespace

EvaluationCost costOfFarField(
  Primitive kind, std::size_t primitives, std::size_t samples, int order)
{
  // The number of cells that sources are near to grows as that of voxels on a surface does, with the
  // power 2/3; few sources are near to few cells.
  const bool isTriangle = kind == Primitive::triangle;
  const double tree = (isTriangle ? 0.5e-6 : 0.2e-6) * std::sqrt(orderFactor(order));
  const double cells = (isTriangle ? 11e-6 : 5.5e-6) * orderFactor(order) *
                       std::min(1.0, std::cbrt(static_cast<double>(primitives) / 10'000));
  const auto count = static_cast<double>(samples);
  const std::size_t bytesPerSource = (isTriangle ? 120 : 90) + (order + 1) * (order + 1) * 2;
  return {tree * static_cast<double>(primitives) + cells * std::pow(count, 2.0 / 3) +
            secondsPerValue * count,
    (bytesPerPrimitive + bytesPerSource) * primitives};
}

bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order)
{
  constexpr std::size_t usual = 64 * 64 * 64;
  return isCheaperDirectly(kind, primitives, usual, order);
}

bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order)
{
  return costOfDirectSum(kind, primitives, samples).seconds <
         costOfFarField(kind, primitives, samples, order).seconds;
}

} // namespace winding
