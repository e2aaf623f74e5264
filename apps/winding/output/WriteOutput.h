// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <functional>

class Messages;
class OutputFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * These functions write to an output file, in the format of its suffix; commit() is left to the
 * caller. They throw Failure when the file cannot be written whole or the program is interrupted.
 */

/// Writes an image (.vti), made and written in `pieces` pieces. `check` is called at the end, and
/// throws where the pieces could not be made.
void writeImage(vtkAlgorithmOutput* image, int pieces, OutputFile& file, Messages& messages,
  const std::function<void()>& check);

/// Writes an image that is there, or a part of one, with the extent that it has.
void writeImage(vtkImageData* image, OutputFile& file, Messages& messages);

/// Writes a surface: .vtp .ply .stl .obj.
void writeSurface(vtkPolyData* surface, OutputFile& file, Messages& messages);

/// Writes points with the arrays of a probe, and their cells: .vtp or .vtu; or the image or grid
/// that they are the points of: .vti .vtr .vts.
void writePoints(vtkDataSet* points, OutputFile& file, Messages& messages);
