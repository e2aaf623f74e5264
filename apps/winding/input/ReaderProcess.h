// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>

class Messages;
VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END
struct VtkFormat;

/**
 * Reads a file with a reader of VTK in a process of its own, and gets the data from there. Broken
 * files make VTK's readers crash, end the program, never end, take all memory, or write over what
 * is not theirs; so they do it where nothing else lives, with limits on memory and processor time
 * that follow from the size of the file.
 *
 * Throws Failure, in one line about the file, for each of these ends, and for whatever VTK reports
 * while it reads, save warnings that leave the data whole; these are printed.
 */
vtkSmartPointer<vtkDataObject> readInProcess(
  const std::string& fileName, const VtkFormat& format, Messages& messages);

/// Returns the most memory that a process of readInProcess() has held, in bytes.
long long peakMemoryOfReaders();
