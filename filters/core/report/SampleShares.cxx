// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SampleShares.h"

#include "field/Field.h"
#include "report/ReportGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

SampleShares sampleShares(const Field& field, Executor& executor)
{
  const bool isClosed = field.info().netBoundaryEdges == 0;
  SampleShares shares;
  shares.fractional = isClosed ? std::optional<double>(0) : std::nullopt;
  const std::optional<Grid> grid = reportGrid(field.info().bounds, 32);
  if (!grid || field.info().primitives == 0)
  {
    return shares;
  }
  const Extent extent = grid->wholeExtent();
  std::vector<float> values(sampleCount(extent));
  FieldOutput output;
  output.values = values.data();
  field.evaluate(*grid, extent, output, executor);
  if (!isClosed)
  {
    const auto fractional = std::count_if(
      values.begin(), values.end(), [](float w) { return std::abs(w - std::round(w)) > 0.1F; });
    shares.fractional = static_cast<double>(fractional) / static_cast<double>(values.size());
    return shares;
  }
  double inside = 0, sum = 0;
  for (const float w : values)
  {
    inside += w > 0.5F;
    sum += w;
    if (w < 0)
    {
      return shares;
    }
  }
  shares.once = sum > 0 ? inside / sum : 1;
  return shares;
}

} // namespace winding
