#pragma once

#include "base/EvaluationCost.h"

#include <limits>

namespace winding
{

/// The expected cost of a tree of boxes, and of the nearest primitive of each sample. band: up to
/// where distances are wanted, in distances between samples.
EvaluationCost costOfDistances(
  const SampledSource& source, double band = std::numeric_limits<double>::infinity());

} // namespace winding
