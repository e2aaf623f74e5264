// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
VTK_ABI_NAMESPACE_END

/// Returns how well single precision holds the coordinates of points.
enum class SinglePrecision
{
  holds,           ///< rounding moves no point by more than 1/10000 of the longest side of all
  movesPoints,     ///< rounding moves points by more than that
  collapsesPoints, ///< rounding moves points by more than a tenth of the longest side
  isExceeded       ///< coordinates, or differences between them, are beyond its range
};

/// The answer for points by their bounds; `holds` if there are none.
SinglePrecision singlePrecisionOf(vtkPointSet* points);
