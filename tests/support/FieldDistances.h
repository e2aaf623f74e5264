// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"
#include "support/Samples.h"
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

inline std::shared_ptr<const winding::Field> fieldOf(const Mesh& mesh)
{
  winding::SerialExecutor serial;
  return winding::Field::build(std::vector<winding::TrianglesView>{mesh.view()}, {}, serial);
}

inline std::shared_ptr<const winding::Field> fieldOf(const Cloud& cloud)
{
  winding::SerialExecutor serial;
  return winding::Field::build(std::vector<winding::OrientedPointsView>{cloud.view()}, {}, serial);
}

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
  winding::SerialExecutor serial;
  Distances result(samples.size());
  const winding::VectorsView view(samples.empty() ? nullptr : samples[0].data(), samples.size());
  field.evaluate(view, result.output(limit), serial);
  return result;
}

inline std::vector<Point> samplesOf(const winding::Grid& grid)
{
  std::vector<Point> samples(winding::sampleCount(grid.wholeExtent()));
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    samples[n] = grid.sample(n);
  }
  return samples;
}

} // namespace shapes
