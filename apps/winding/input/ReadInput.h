// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>

class Messages;
VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;
class vtkPointSet;
class vtkWindingNumberReader;
VTK_ABI_NAMESPACE_END

/// The columns that are read of tables and points; other files have none.
struct ColumnOptions
{
  std::string chosen;  ///< for vtkWindingNumberReader::SetColumns()
  bool areAll = false; ///< whether columns without a meaning are read, too
};

/**
 * Reads a surface, grid or cloud, or blocks of these, by the suffix of its name, one of
 * inputSuffixes(). Throws Failure for whatever cannot be read in full, in one line that says why.
 * Coordinates are in the file's own precision: double for text, for binary files what they have.
 */
vtkSmartPointer<vtkDataObject> readInput(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns = {});

/// Reads a file as readInput() does, and throws Failure where it has blocks.
vtkSmartPointer<vtkPointSet> readPoints(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns = {});

/**
 * Reads queries, which may also be an image or a grid, by the suffix of its name: one of
 * inputSuffixes() or imageSuffixes(). Of a medical image it reads where its voxels lie, and no
 * values (ImageHeader.h). Throws Failure as readInput() does.
 */
vtkSmartPointer<vtkDataSet> readQueries(
  const std::string& fileName, Messages& messages, const ColumnOptions& columns = {});

/// Reads where the voxels of an image lie: .vti or a medical one. Throws Failure as readInput()
/// does.
PlacedImage readPlace(const std::string& fileName, Messages& messages);

/// Reads a file with a reader of the module, which believes nothing that the file does not hold,
/// and shows its progress. Throws Failure as readInput() does.
void readBy(vtkWindingNumberReader* reader, const std::string& fileName, Messages& messages);
