#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of a sum over all primitives at each sample.
EvaluationCost costOfDirectSum(Primitive kind, std::size_t primitives, std::size_t samples);

} // namespace winding
