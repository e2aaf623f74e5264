// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "source/Grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

/**
 * @file
 * Signed distances of grids and of scattered samples, as fields give them.
 */
namespace shapes
{

inline constexpr double infinite = std::numeric_limits<double>::infinity();

struct Distances
{
  std::vector<double> distances;
  std::vector<unsigned char> inside;

  explicit Distances(std::size_t count)
    : distances(count, -7)
    , inside(count, 7)
  {
  }

  winding::FieldOutput output(double limit)
  {
    winding::FieldOutput output;
    output.doubleDistances = distances.data();
    output.inside = inside.data();
    output.distanceLimit = limit;
    return output;
  }
};

inline Distances evaluate(const winding::Field& field, const winding::Grid& grid,
  const winding::Extent& extent, double limit = infinite,
  winding::Executor&& executor = winding::SerialExecutor())
{
  Distances result(winding::sampleCount(extent));
  field.evaluate(grid, extent, result.output(limit), executor);
  return result;
}

inline Distances evaluate(const winding::Field& field, const winding::Grid& grid)
{
  return evaluate(field, grid, grid.wholeExtent());
}

inline Distances evaluate(
  const winding::Field& field, const std::vector<Point>& samples, double limit = infinite)
{
  Distances result(samples.size());
  const winding::VectorsView view(samples.empty() ? nullptr : samples[0].data(), samples.size());
  field.evaluate(view, result.output(limit), serial);
  return result;
}

} // namespace shapes
