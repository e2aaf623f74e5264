// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"
#include "support/Samples.h"
#include "support/Serial.h"

#include "base/FieldOutput.h"
#include "base/Views.h"
#include "source/Grid.h"

#include <memory>
#include <vector>

/**
 * @file
 * Fields of single sources, and their values and gradients in double precision.
 */
namespace shapes
{

/// Builds the field of a Mesh or a Cloud.
template <class Source>
std::shared_ptr<const winding::Field> fieldOf(
  const Source& source, const winding::FieldOptions& options = {})
{
  return winding::Field::build(std::vector{source.view()}, options, serial);
}

/// Builds the field of a Mesh or a Cloud by `method`, for scattered samples or for a grid.
template <class Source>
std::shared_ptr<const winding::Field> fieldOf(
  const Source& source, winding::Method method, bool isScattered = false)
{
  winding::FieldOptions options;
  options.method = method;
  options.scattered = isScattered;
  return fieldOf(source, options);
}

/// Builds the field of a Mesh or a Cloud with one option that is not the default.
template <class Source, class Option, class Value>
std::shared_ptr<const winding::Field> fieldOf(
  const Source& source, Option winding::FieldOptions::*option, const Value& value)
{
  winding::FieldOptions options;
  options.*option = value;
  return fieldOf(source, options);
}

inline std::vector<double> valuesOn(const winding::Field& field, const winding::Grid& grid,
  const winding::Extent& extent, winding::Executor& executor)
{
  std::vector<double> values(winding::sampleCount(extent));
  winding::FieldOutput output;
  output.doubleValues = values.data();
  field.evaluate(grid, extent, output, executor);
  return values;
}

inline std::vector<double> valuesOn(const winding::Field& field, const winding::Grid& grid)
{
  return valuesOn(field, grid, grid.wholeExtent(), serial);
}

inline std::vector<double> valuesAt(const winding::Field& field, const std::vector<Point>& samples)
{
  std::vector<double> values(samples.size());
  winding::FieldOutput output;
  output.doubleValues = values.data();
  field.evaluate(winding::VectorsView(samples.front().data(), samples.size()), output, serial);
  return values;
}

inline std::vector<Point> gradientsAt(const winding::Field& field,
  const std::vector<Point>& samples, winding::Executor& executor = serial)
{
  std::vector<Point> gradients(samples.size(), Point(-99, -99, -99));
  field.gradient(
    winding::VectorsView(samples[0].data(), samples.size()), gradients[0].data(), executor);
  return gradients;
}

} // namespace shapes
