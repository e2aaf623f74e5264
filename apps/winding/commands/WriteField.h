// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

class FieldRun;
class OutputFile;
class PiecesFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * These functions write what a run gives, and note it in its report. They throw Failure for
 * whatever keeps them from being done, and are collective (ParallelRun.h): the first rank writes
 * what is one file; images and files are null on the others.
 */

/// Writes the field that the filter gives, and evaluates it piece by piece where run.update() was
/// not called. Warns where the grid cannot be cut into as many pieces as the options ask for.
void writeField(FieldRun& run, OutputFile& file);

/// Makes and writes the field in pieces, as many on each rank as the options ask for.
void writeFieldPieces(FieldRun& run, const PiecesFile& file);

/// Makes the image of the whole grid, a slab on each rank. A single rank has the filter's own.
vtkSmartPointer<vtkImageData> gatherImage(FieldRun& run);

/// Writes an image that was gathered.
void writeResult(FieldRun& run, vtkImageData* image, OutputFile* file);

/// Writes a surface that was made of the field or by the filter.
void writeResult(FieldRun& run, vtkPolyData* surface, OutputFile* file);
