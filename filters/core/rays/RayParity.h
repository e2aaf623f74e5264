// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "source/Surface.h"

namespace winding
{

/**
 * The baseline that winding numbers replace: one ray per sample, along +x, and 1 where it crosses
 * the surface an odd number of times. Orientation is ignored, holes and overlaps give stripes.
 *
 * Guaranteed: the parity is right for every sample off a closed surface, rays through edges,
 * through vertices and along faces included: whether a ray meets a triangle is decided exactly, as
 * far as Predicates.h goes. A sample on the surface itself gets 0 or 1. Takes O(n) per sample.
 */
class RayParity final : public Evaluator
{
public:
  /// Keeps a reference: the surface must outlive this.
  explicit RayParity(const Surface& surface);

  void evaluate(const SampleBlock& block, double* values) const override;

private:
  const Surface& surface_;
  double scale_;
};

} // namespace winding
