// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "farfield/TargetCells.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// A cell of samples to evaluate, with what is known of it from larger cells.
struct FarFieldTask
{
  TargetCell cell;
  std::vector<float> local;        ///< the expansion of all that acts on the larger cells
  std::vector<std::int32_t> nodes; ///< nodes of the source tree that larger cells have left to it
  double spent = 0; ///< seconds that larger cells are taken to have spent on each sample
};

} // namespace winding
