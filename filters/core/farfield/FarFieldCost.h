#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of a tree and its moments, and of expansions for the samples.
EvaluationCost costOfFarField(const SampledSource& source, int order);

/// Whether a far field stands already, or is to be built for the samples in question.
enum class FarFieldState
{
  toBuild,
  built
};

///@{
/**
 * Whether the direct sum is taken to be faster than a far field of an order, on grids of usual
 * sizes, or for so many samples. The rule has figures of
 * its own, measured on one processor: values differ within the tolerance with the method taken, so
 * that better estimates of seconds must not move the choice.
 */
bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order);
bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order,
  FarFieldState state = FarFieldState::toBuild);
///@}

} // namespace winding
