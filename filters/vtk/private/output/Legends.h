// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class vtkFieldData;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Returns a line for each name in array `names` of field data, of its number, a tab and the name.
/// Numbers are in array `values`, or count from 0 where that is null. Empty without these arrays.
std::string legendOf(vtkFieldData* facts, const char* values, const char* names);

/// Returns the legend of an image or a surface of labels.
std::string legendOfLabels(vtkFieldData* facts);

/// Adds the volume of the voxels of each label to the field data of an image, as "LabelVolumes".
void addLabelVolumes(vtkImageData* image, vtkDataSetAttributes* attributes);

/// Returns a line for each label with its name and its volume, at most `most` of them.
std::string volumesInWords(vtkFieldData* facts, int most = 20);

} // namespace winding
