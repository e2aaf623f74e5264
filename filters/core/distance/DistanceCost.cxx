#include "distance/DistanceCost.h"

#include "distance/DistanceTree.h"

namespace winding
{

EvaluationCost costOfDistances(Primitive kind, std::size_t primitives, std::size_t samples)
{
  const bool areTriangles = kind == Primitive::triangle;
  return {0.3e-6 * static_cast<double>(primitives) + 0.3e-6 * static_cast<double>(samples),
    DistanceTree::bytesFor(areTriangles, primitives)};
}

} // namespace winding
