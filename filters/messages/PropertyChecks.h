// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Parameter.h"

#include <limits>

/**
 * @file
 * The ranges of properties. All checks throw Refusal about the property, with its value and what it
 * may be, for values out of range; none of them is a number that is NaN or infinite.
 */
namespace winding
{

/// Throws unless a property has a value of the range or one of the choices that Options.def gives
/// it. `choices` is the number of choices that a class has if it does not have all of them.
void checkProperty(Parameter property, double value, int choices = std::numeric_limits<int>::max());

/// Throws unless all three numbers of voxels are 1 or more.
void checkDimensions(const int dimensions[3]);

} // namespace winding
