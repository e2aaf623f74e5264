// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <optional>

namespace winding
{

class Field;

/**
 * The share (0 to 1) of samples whose winding number is farther than 0.1 from the nearest integer:
 * it shows how open a surface is. The samples are the centres of cubic voxels, 32 along the longest
 * side of the field's bounds with 0.05 of it added on each side. The share is 0 for closed
 * surfaces, and for those without triangles. Nothing is returned where the bounds admit no grid,
 * because coordinates are all but equal or all but infinite. Throws Interrupted.
 */
std::optional<double> fractionalShare(const Field& field, Executor& executor);

} // namespace winding
