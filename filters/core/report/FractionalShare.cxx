// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/FractionalShare.h"

#include "base/Bounds.h"
#include "base/Refusal.h"
#include "field/Field.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

namespace
{

std::optional<Grid> gridAround(const Bounds& bounds)
{
  GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = 32;
  try
  {
    return setUpGrid(request);
  }
  catch (const Refusal&)
  {
    return std::nullopt;
  }
}

} // namespace

std::optional<double> fractionalShare(const Field& field, Executor& executor)
{
  if (field.info().netBoundaryEdges == 0)
  {
    return 0;
  }
  const std::optional<Grid> grid = gridAround(field.info().bounds);
  if (!grid)
  {
    return std::nullopt;
  }
  const Extent extent = grid->wholeExtent();
  std::vector<float> values(sampleCount(extent));
  FieldOutput output;
  output.values = values.data();
  field.evaluate(*grid, extent, output, executor);
  const auto fractional = std::count_if(
    values.begin(), values.end(), [](float w) { return std::abs(w - std::round(w)) > 0.1F; });
  return static_cast<double>(fractional) / static_cast<double>(values.size());
}

} // namespace winding
