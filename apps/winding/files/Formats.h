// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

/// Returns the end of a file name that says what is in the file: from its last dot on, in small
/// letters, or ".nii.gz". May be empty.
std::string suffixOf(const std::string& fileName);

/// Returns a file's name without the suffix .gz: its own suffix says what is packed there. VTK's
/// formats are not read from such files.
std::string unpackedName(const std::string& fileName);

/// Whether the suffix says that a file is a table: .csv, with commas, or .tsv, with tabs.
bool isTable(const std::string& fileName);

/// Whether the points of a file are in columns that a user may choose.
bool hasColumns(const std::string& fileName);

/// Returns the letter between the fields of a table of that name: a tab in .tsv, a comma otherwise.
char separatorOf(const std::string& fileName);

/// A format of files that a reader of VTK reads.
struct VtkFormat
{
  const char* suffix;
  bool isSource; ///< whether it may hold a source; others are for queries

  /// Makes a reader for a file.
  vtkSmartPointer<vtkAlgorithm> (*makeReader)(const std::string& fileName);
};

/// Returns the format of a suffix; null if none has it.
const VtkFormat* vtkFormatOf(const std::string& suffix);

/// Returns the suffixes of all files that may hold a source, with blanks between them: VTK's
/// formats, and what vtkWindingNumberReader reads.
std::string inputSuffixes();

/// Returns the suffixes of files that hold images and grids, for queries only, with blanks between
/// them: VTK's formats, and medical ones (ImageSpace.h).
std::string imageSuffixes();
