// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/SampledSource.h"
#include "source/Surface.h"

namespace winding
{

/// Returns the expected memory of a tree and its moments, the source included.
std::size_t bytesOfFarField(Primitive kind, std::size_t primitives, int order);

///@{
/// Weigh the work of scattered samples by each method, for the choice between them alone: in
/// seconds of one thread on one processor, a few times as many on others.
double weightOfDirectSum(std::size_t triangles, std::size_t samples);
double weightOfFarField(const SampledSource& triangles, int order);
///@}

/// Whether a far field stands already, or is to be built for the samples in question.
enum class FarFieldState
{
  toBuild,
  built
};

/// Whether a far field is likely to save time, as for surfaces, or to save nothing, as for soups.
enum class FarFieldGain
{
  likely,
  doubtful
};

/// Returns the gain to expect of triangles. It is doubtful where a quarter of them reach over more
/// than an eighth of the longest side of `bounds`: they are near to most samples. The
/// order of the triangles does not matter.
FarFieldGain gainOfFarField(const std::vector<Eigen::Vector3d>& vertices,
  const TriangleList& triangles, const Bounds& bounds);

///@{
/**
 * Returns whether the direct sum is taken to be faster than a far field of an order, on grids of
 * usual sizes or for `samples` samples. The rule has figures of its own, measured on one
 * processor: values differ within the tolerance with the method, so that the choice must not move.
 */
bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order);
bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order,
  FarFieldState state = FarFieldState::toBuild, FarFieldGain gain = FarFieldGain::likely);
///@}

} // namespace winding
