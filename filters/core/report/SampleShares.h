// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <optional>

namespace winding
{

class Field;

/// The shares of samples of a field. They are the centres of cubic voxels, 32 along the longest
/// side of the field's bounds with 0.05 of it added on each side.
struct SampleShares
{
  /// Samples whose winding number is farther than 0.1 from the nearest integer, as a share of all:
  /// they show how open a surface is. It is 0 for closed surfaces, and for those without triangles.
  /// Nothing is known where the bounds admit no grid, because coordinates are all but equal or all
  /// but infinite.
  std::optional<double> fractional;

  /// Samples inside of a closed surface, as a share of the sum of their winding numbers: it is less
  /// than 1 where parts overlap. It is 1 where others look inward.
  double once = 1;
};

/// Throws Interrupted.
SampleShares sampleShares(const Field& field, Executor& executor);

} // namespace winding
