// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "field/Field.h"
#include "level/VoxelTrees.h"
#include "source/Grid.h"

namespace shapes
{

/// The arrays of extents for VoxelTrees, as the field has them. Keeps references to its arguments.
inline winding::VoxelTrees::Evaluate extentsOf(const winding::Field& field,
  const winding::Grid& grid, const winding::VoxelTreeOptions& options, winding::Executor& executor)
{
  return [&](const winding::Extent& extent, const winding::VoxelArrays& arrays)
  {
    winding::FieldOutput output;
    output.values = arrays.values;
    output.doubleValues = arrays.doubleValues;
    output.inside = arrays.inside;
    output.rule = options.rule;
    output.threshold = options.threshold;
    field.evaluate(grid, extent, output, executor);
  };
}

} // namespace shapes
