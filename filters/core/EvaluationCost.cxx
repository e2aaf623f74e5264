#include "EvaluationCost.h"

#include "DistanceTree.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Of coordinates and ids, and of welding them.
constexpr std::size_t bytesPerPrimitive = 80;

double secondsPerPair(Primitive kind)
{
  return kind == Primitive::triangle ? 0.9e-9 : 0.36e-9;
}

/// What expansions of an order cost, in those of order 5.
double orderFactor(int order)
{
  return order <= 3 ? 0.6 : order <= 5 ? 1 : order <= 7 ? 2.5 : 5;
}

/// Writing a value to memory that the program has not touched yet.
constexpr double secondsPerValue = 1e-9;

} // namespace

EvaluationCost& EvaluationCost::operator+=(const EvaluationCost& other)
{
  seconds += other.seconds;
  bytes += other.bytes;
  return *this;
}

EvaluationCost costOfRows(std::size_t triangles, std::size_t samples)
{
  const auto count = static_cast<double>(triangles);
  return {150e-9 * count + secondsPerValue * static_cast<double>(samples),
    (bytesPerPrimitive + 20) * triangles};
}

EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays)
{
  // A triangle is tested by the samples within it, and by those in the columns along it: as many as
  // are on a line across all of them, by its width.
  const auto count = static_cast<double>(samples);
  const double perSample = 60e-9 + 15e-9 * rays.layers;
  return {150e-9 * static_cast<double>(triangles) + perSample * count +
            80e-9 * rays.widths * std::sqrt(count),
    (bytesPerPrimitive + 140) * triangles + 42 * samples};
}

EvaluationCost costOfDirectSum(Primitive kind, std::size_t primitives, std::size_t samples)
{
  const auto count = static_cast<double>(primitives);
  const double perSample = secondsPerPair(kind) * count + secondsPerValue;
  return {80e-9 * count + perSample * static_cast<double>(samples), bytesPerPrimitive * primitives};
}

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

EvaluationCost costOfDistances(Primitive kind, std::size_t primitives, std::size_t samples)
{
  const bool areTriangles = kind == Primitive::triangle;
  return {0.3e-6 * static_cast<double>(primitives) + 0.3e-6 * static_cast<double>(samples),
    DistanceTree::bytesFor(areTriangles, primitives)};
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
