// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Grids.h"
#include "support/Serial.h"
#include "support/ThreadSeconds.h"

#include "base/FieldOutput.h"
#include "base/Views.h"
#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "source/Grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapes
{

/// Seconds on one thread.
struct DiagnosisTime
{
  double answer = HUGE_VAL;    ///< to build a field and to evaluate it on a grid
  double diagnosis = HUGE_VAL; ///< to ask all questions of the field and of the result

  /// Returns the seconds of diagnosis beyond what Diagnosis.h promises.
  double excess() const { return diagnosis - 0.1 * answer - 2e-3; }
};

/// Times an answer and its diagnosis once.
inline DiagnosisTime diagnosisTime(const std::vector<winding::TrianglesView>& views, int resolution)
{
  DiagnosisTime time;
  const double start = threadSeconds();
  const auto field = winding::Field::build(views, winding::FieldOptions(), serial);
  const winding::Grid grid = gridAround(field->info().bounds, resolution);
  const winding::Extent extent = grid.wholeExtent();
  std::vector<float> values(winding::sampleCount(extent));
  winding::SideTally sides;
  winding::FieldOutput output;
  output.values = values.data();
  output.sides = &sides;
  field->evaluate(grid, extent, output, serial);
  const double middle = threadSeconds();
  const winding::Diagnosis& diagnosis = field->diagnosis();
  diagnosis.ofSource(serial);
  diagnosis.facing(sides.counts(values.size()), winding::InsideTest(), serial);
  const auto isInside = [&](int i, int j, int k)
  {
    return values[winding::sampleNumber(extent, i, j, k)] >= 0.5F;
  };
  diagnosis.thinParts(grid, isInside, winding::InsideTest(), serial);
  time.answer = middle - start;
  time.diagnosis = threadSeconds() - middle;
  return time;
}

/// Times both in some attempts, and returns the least excess: other programs take time, too.
inline DiagnosisTime leastDiagnosisTime(
  const std::vector<winding::TrianglesView>& views, int resolution, int attempts)
{
  DiagnosisTime least;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    const DiagnosisTime time = diagnosisTime(views, resolution);
    least.answer = std::min(least.answer, time.answer);
    least.diagnosis = std::min(least.diagnosis, time.diagnosis);
  }
  return least;
}

} // namespace shapes
