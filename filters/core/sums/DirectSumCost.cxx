#include "sums/DirectSumCost.h"

namespace winding
{

EvaluationCost costOfDirectSum(Primitive kind, std::size_t primitives, std::size_t samples)
{
  const double secondsPerPair = kind == Primitive::triangle ? 0.9e-9 : 0.36e-9;
  const auto count = static_cast<double>(primitives);
  const double perSample = secondsPerPair * count + secondsPerValue;
  return {80e-9 * count + perSample * static_cast<double>(samples), bytesPerPrimitive * primitives};
}

} // namespace winding
