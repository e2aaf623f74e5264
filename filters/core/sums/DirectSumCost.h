#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of a sum over all primitives at each sample.
EvaluationCost costOfDirectSum(const SampledSource& source);

} // namespace winding
