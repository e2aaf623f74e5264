#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "distance/DistanceTree.h"

namespace winding
{

/**
 * Writes the distances of scattered samples; NaN at samples that are NaN or infinite. Returns false
 * when the executor was interrupted.
 *
 * Samples are sorted into cells, as the leaves of a k-d tree, and those of a cell share the list of
 * what may be nearest to them (CellDescent.h). Samples that are few, or whose lists stay long, are
 * searched for one by one.
 *
 * Guaranteed: the bits of a distance depend on the source and the sample only, not on other samples
 * or their order. The memory is 32 bytes per sample.
 */
bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor);

} // namespace winding
