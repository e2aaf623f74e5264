// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <memory>
#include <string>
#include <vector>

class Messages;
class OutputFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END
struct Options;

/// Returns the files that no output may replace: all that are read, with their parts, or none with
/// --overwrite.
std::vector<std::string> filesToKeep(const Options& options);

/// Reads the image that the result is to lie on, on the first rank, for all of them. Returns an
/// empty place if the options name none. Collective.
PlacedImage readLike(const Options& options, Messages& messages);

/// Opens the output file on the first rank, and returns null on the others. Throws Failure on all
/// ranks where it cannot be written. Collective.
std::unique_ptr<OutputFile> openOnFirstRank(const Options& options);

/// Reads the positions that estimated normals look toward, where a file has them. Throws Failure.
void readToward(Options& options, Messages& messages);

/// Reads the inputs as readInput() does, on the first rank: one as it is, several as blocks with
/// the names of their files without folders and suffixes. The other ranks get no points. Throws
/// Failure on all ranks where a file cannot be read. Collective.
vtkSmartPointer<vtkDataObject> readSource(const Options& options, Messages& messages);
