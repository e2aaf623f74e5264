// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkMultiBlockDataSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Returns data as a block of a vtkMultiBlockDataSet, which takes no partitioned data sets: a
/// collection of these as blocks, and one of them in pieces. Other data stay what they are.
vtkSmartPointer<vtkDataObject> asBlock(vtkDataObject* data);

/// Returns data objects, which may be null, as blocks with these names. Those without a name are
/// called "Input 1" and so on, by their places. Throws Refusal for data that no block can have.
vtkSmartPointer<vtkMultiBlockDataSet> namedBlocksOf(
  const std::vector<std::pair<vtkSmartPointer<vtkDataObject>, std::string>>& sources);

} // namespace winding
