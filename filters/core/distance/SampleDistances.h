#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "distance/DistanceTree.h"

namespace winding
{

/// Writes the distances of scattered samples, each searched for by itself, so that its bits do not
/// depend on the other samples. NaN at samples that are NaN or infinite. Returns false when the
/// executor was interrupted.
bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor);

} // namespace winding
