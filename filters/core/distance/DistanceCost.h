#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of a tree of boxes, and of the nearest primitive of each sample.
EvaluationCost costOfDistances(Primitive kind, std::size_t primitives, std::size_t samples);

} // namespace winding
