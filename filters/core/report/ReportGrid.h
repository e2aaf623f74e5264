// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Refusal.h"
#include "source/Grid.h"

#include <optional>

namespace winding
{

/// Returns a grid of `resolution` cubic voxels along the longest side of bounds, with 0.05 of it
/// added on each side; none where coordinates are all but equal or all but infinite.
inline std::optional<Grid> reportGrid(const Bounds& bounds, int resolution)
{
  GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = resolution;
  try
  {
    return setUpGrid(request);
  }
  catch (const Refusal&)
  {
    return std::nullopt;
  }
}

} // namespace winding
