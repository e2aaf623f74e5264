#include "farfield/FarFieldCost.h"

#include "farfield/SplitTriangles.h"
#include "sums/DirectSumCost.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The cost of expansions of an order, in that of order 5.
double orderFactor(int order)
{
  return order <= 3 ? 0.6 : order <= 5 ? 1 : order <= 7 ? 2.5 : 5;
}

} // namespace

EvaluationCost costOfFarField(const SampledSource& source, int order)
{
  const bool isTriangle = source.kind == Primitive::triangle;
  const auto primitives = static_cast<double>(source.primitives);
  const auto samples = static_cast<double>(source.samples);
  // The samples near the source, which are as many as its area has squares between them, take most
  // of the time. Large triangles are cut for them; points that are fewer are near to fewer samples.
  const double sparse =
    isTriangle || source.area == 0 ? 1 : std::min(1.0, std::pow(primitives / source.area, 0.55));
  // Cells grow with their distance from the source, so that there are fewer of them about a small
  // source, such as a cap, than about a large one; but more than its area says, as it has a rim.
  const double cells = isTriangle && source.isGrid ? 0.22e-6 * std::sqrt(source.area * samples) +
                                                       60e-6 * std::sqrt(source.area)
                                                   : 0;
  const double near =
    orderFactor(order) * ((isTriangle ? 5.5e-6 : 3e-6) * sparse * source.area + cells);
  // A sample is near to no more than all triangles.
  const double nearAtMost = isTriangle ? costOfDirectSum(source).seconds : near;
  const double perSample = source.primitives == 0 ? 0
                           : !source.isGrid       ? 160e-9
                           : isTriangle           ? 1.5e-9
                                                  : 20e-9;
  // Triangles that are cut have pieces of 12 squares on average.
  const double items = isTriangle
                         ? std::clamp(source.area / 12, primitives,
                             static_cast<double>(mostPieces(source.primitives, source.samples)))
                         : primitives;
  const double tree = 0.5e-6 * items;
  const std::size_t bytesPerSource = (isTriangle ? 120 : 90) + (order + 1) * (order + 1) * 3;
  return {orderFactor(order) * (tree + perSample * samples) + std::min(near, nearAtMost) +
            secondsPerValue * samples,
    (bytesPerPrimitive + bytesPerSource) * source.primitives};
}

bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order)
{
  constexpr std::size_t usual = 64 * 64 * 64;
  return isCheaperDirectly(kind, primitives, usual, order);
}

bool isCheaperDirectly(
  Primitive kind, std::size_t primitives, std::size_t samples, int order, FarFieldState state)
{
  // All figures are nanoseconds on a processor of 2025. The tree's are those beyond what the direct
  // sum takes before its first sample. Sources are near to a number of cells that grows as that of
  // voxels on a surface does, with the power 2/3; few sources are near to few cells.
  const bool isTriangle = kind == Primitive::triangle;
  const auto count = static_cast<double>(primitives), places = static_cast<double>(samples);
  const double pairs = (isTriangle ? 0.9 : 0.36) * count * places;
  const double tree = state == FarFieldState::built
                        ? 0
                        : ((isTriangle ? 500 : 200) * std::sqrt(orderFactor(order)) - 80) * count;
  const double cells = (isTriangle ? 11'000 : 5'500) * orderFactor(order) *
                       std::min(1.0, std::cbrt(count / 10'000)) * std::pow(places, 2.0 / 3);
  // The matrices that shift expansions are made for every evaluation: 0.1 ms at order 3, 7 at 9.
  const double shifts = 1'000 * std::pow(order, 4);
  // A far field has to promise a gain, for soups it has none: their samples are near to everything.
  constexpr double margin = 1.3;
  return pairs < margin * (tree + cells + shifts);
}

} // namespace winding
