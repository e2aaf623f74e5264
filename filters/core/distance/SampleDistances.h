#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "distance/DistanceTree.h"

namespace winding
{

/// Distances of scattered samples, each searched for by itself: so its bits depend on nothing else. NaN at
/// samples that are NaN or infinite. False when the executor was interrupted.
bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor);

} // namespace winding
