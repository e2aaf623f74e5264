// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/BoundaryGradient.h"

#include "source/UnitScale.h"
#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"

#include <algorithm>
#include <utility>

namespace winding
{

BoundaryGradient::BoundaryGradient(const Surface& surface, BoundaryEdges edges)
  : surface_(surface)
  , edges_(std::move(edges))
  , scale_(unitScale(surface.bounds))
{
}

void BoundaryGradient::evaluateGradients(const SampleBlock& block, double* gradients) const
{
  const BoundaryEdges& edges = ordered_.get(
    [this]
    {
      SerialExecutor serial;
      BoundaryEdges ordered = sortedByCoordinates(edges_, surface_.vertices, serial);
      edges_ = BoundaryEdges(); // frees its memory
      return ordered;
    });
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  GradientSums sums;
  KernelEdge chunk[kernelChunk];
  for (std::size_t first = 0; first < edges.size(); first += kernelChunk)
  {
    const std::size_t count = std::min(kernelChunk, edges.size() - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      const BoundaryEdge& edge = edges[first + i];
      chunk[i] = kernelEdge(surface_.vertices[edge.from] * scale_,
        surface_.vertices[edge.to] * scale_, edge.multiplicity);
    }
    addEdgeGradients(chunk, count, scaled, sums);
  }
  storeGradients(sums, scaled.count, scale_, gradients);
}

} // namespace winding
