// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// A block that is a solid, with its name in the composite. A block that is not there is an empty
/// vtkPolyData; one in pieces is composite itself.
struct SolidBlock
{
  std::string name;
  vtkSmartPointer<vtkDataObject> source;
};

/// The solids of composite data, as Solids.h separates them.
std::vector<SolidBlock> solidBlocksOf(vtkDataObject* composite);

/// Throws Refusal, by its name, for a block without a surface where others have one, and for data
/// that is no source at all. asPoints: whether meshes are taken as the clouds of their points.
void checkSolids(vtkDataObject* input, bool asPoints);

} // namespace winding
