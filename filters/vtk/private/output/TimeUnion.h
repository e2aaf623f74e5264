// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * The unions of results at several times. `all` has the arrays of earlier times, and takes `other`,
 * the same arrays of another time, into them.
 */
namespace winding
{

/// Unites the arrays of a field, whose values are named `name`, empty for no values. These come
/// from the time at which they are farthest inside by the rule. What is inside at any time is
/// inside; shares are the largest, and distances the least. Returns how many samples are inside.
vtkIdType uniteResults(vtkDataSetAttributes* all, vtkDataSetAttributes* other,
  const std::string& name, const InsideTest& isInside);

/// Unites the arrays of labels. A voxel keeps the label of the first time at which it has one.
/// Counts and shares of labels are the largest; the two largest shares are from one time, which has
/// the largest first share.
void uniteLabels(vtkDataSetAttributes* all, vtkDataSetAttributes* other);

} // namespace winding
