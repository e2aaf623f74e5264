// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "distance/DistanceTree.h"
#include "distance/NearestNumbers.h"

#include <vector>

namespace winding
{

/**
 * Writes the distances of scattered samples; NaN at samples that are NaN or infinite. Throws
 * Interrupted.
 *
 * Samples are sorted by a k-d tree, and samples of a cell share the list of what may be nearest to
 * them (CellDescent.h). Where there are fewer samples than items in the source, samples of regions
 * whose lists are long for their few samples are searched for one after the other
 * (OrderedSearch.h). Measured on two threads: at 70 000 triangles 30 000 random samples take 0.07 s
 * by searches and 0.11 by lists, 100 000 take 0.20 and 0.17; at 560 000 triangles 100 000 random
 * ones take 0.50 and 0.79, but 0.31 and 0.22 where they lie close together.
 *
 * Guaranteed: the bits of a distance depend on the source and the sample only, not on other samples
 * or their order. The memory is 32 bytes per sample.
 */
void evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor);

/// Writes the numbers of the items that are nearest to scattered samples, in the same way and with
/// the same guarantee; none at samples that are NaN or infinite. Throws Interrupted.
void findNearestNumbers(const DistanceTree& tree, const VectorsView& samples,
  const NumberOutput& output, Executor& executor);

/// Returns these distances without signs.
std::vector<double> distancesFrom(
  const DistanceTree& tree, const VectorsView& samples, Executor& executor);

} // namespace winding
