// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <vector>

class Messages;
struct Options;
VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkWindingNumberProbe;
VTK_ABI_NAMESPACE_END

/// The answer to queries.
struct ProbeAnswer
{
  vtkSmartPointer<vtkDataSet> data;  ///< the queries, or the part that is inside, with the results
  std::vector<unsigned char> inside; ///< of each query: whether it is inside
};

/**
 * Executes a probe, which has all properties and its source, on queries that the first rank has;
 * only that one gets the answer, which is in their order. The queries are dealt out to all ranks as
 * bare points, unless the probe extracts what is inside or fills cells: then the first rank
 * answers for all.
 * Throws Failure on all ranks. Collective.
 */
ProbeAnswer probeOnAllRanks(
  vtkWindingNumberProbe& probe, vtkDataSet* queries, const Options& options, Messages& messages);
