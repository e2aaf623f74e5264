// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "base/Lazy.h"
#include "source/Surface.h"
#include "surface/Boundary.h"

#include <vector>

namespace winding
{

/**
 * The gradient of the winding number of a surface. It depends on the surface's boundary chain
 * alone, and is the magnetic field of a current along that (Biot and Savart):
 *
 *   ∇w = (1/4π) Σ m (a×b) (|a|+|b|) / (|a||b| (|a||b| + a·b))
 *
 * over the edges u → v of ∂M with multiplicity m, where q is the sample, a = u − q and b = v − q.
 * For a·b < 0 the sum is taken as (1/4π) Σ m (a×b) (|a|+|b|) (|a||b| − a·b) / (|a||b| |a×b|²),
 * which does not cancel near the edge.
 *
 * Guaranteed: (1) the gradient is exactly 0 for surfaces without a boundary chain; (2) there is no
 * absolute epsilon: a uniform scale s divides the gradient by s and changes nothing else but
 * rounding; (3) an edge gives 0 to samples on the line through it, as near as rounding allows,
 * and at a distance d from it, down to 1e-150 of the surface's size, at most m/(2πd); (4) the
 * gradient is smooth across triangles; (5) it is finite for finite samples; (6) a sample's bits do
 * not depend on neighbouring samples; (7) errors are roundings: some 1e-16/d in all, d being the
 * distance to the boundary (measured: 2.2e-16/d at random samples of seven meshes), and near an
 * edge of length L up to 1e-16 L/d of its share; (8) the bits depend on the set of edges, not on
 * their order and the numbers of vertices: edges are sorted by coordinates first. Not guaranteed:
 * the same bits on machines with and without fused multiply-add.
 *
 * Each sample costs a sum over all boundary edges.
 */
class BoundaryGradient final : public GradientEvaluator
{
public:
  /// Keeps a reference to the surface, which must outlive this; edges form its boundary
  /// chain.
  BoundaryGradient(const Surface& surface, BoundaryEdges edges);

  void evaluateGradients(const SampleBlock& block, double* gradients) const override;

private:
  const Surface& surface_;
  mutable BoundaryEdges edges_; ///< none once they are ordered
  Lazy<BoundaryEdges> ordered_; ///< by coordinates
  double scale_;                ///< brings the surface to about unit size (UnitScale.h)
};

} // namespace winding
