#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of a tree and its moments, and of expansions for the samples.
EvaluationCost costOfFarField(
  Primitive kind, std::size_t primitives, std::size_t samples, int order);

/// Whether the direct sum is expected to be faster than a far field on grids of usual sizes.
bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order);

/// The same for so many scattered samples, which have to pay for the tree.
bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order);

} // namespace winding
