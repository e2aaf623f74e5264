// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "field/Field.h"
#include "report/Verify.h"
#include "source/Grid.h"

#include <functional>
#include <memory>

/**
 * @file
 * Measurements of methods on grids. An interrupt of the program ends them with a Failure.
 */

/// The times of one method on one grid, and what it gave.
struct Measurement
{
  std::shared_ptr<const winding::Field> field;
  double prepare = 0;              ///< seconds to build the field and prepare it for the grid
  double evaluate = 0;             ///< seconds to evaluate the grid
  double evaluateOnProcessors = 0; ///< processor seconds of all threads; 0 if isScaled
  bool isScaled = false;           ///< whether evaluate was found from random samples
  std::unique_ptr<float[]> values; ///< winding numbers of all samples; none if isScaled
};

/// Measures the field that build() makes, with so many threads; 0 stands for all. The direct sum
/// and parity are measured at random samples where all of them would take more than two seconds.
/// Throws Refusal as Field::build() does.
Measurement measure(
  const std::function<std::shared_ptr<const winding::Field>(winding::Executor&)>& build,
  const winding::Grid& grid, int threads = 0);

/// Errors of what was measured at `samples` random samples, and as many near the surface.
winding::Verification verified(
  const Measurement& measured, const winding::Grid& grid, std::size_t samples);
