// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

/**
 * @file
 * Readers that need libraries that nothing else needs: VTKHDF, with 30 for HDF5, and 3MF, with
 * libzip. These take 10 to 20 ms and 2 ms to load, so the readers lie in a library of their own.
 */

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

/// The names of the library and of its function.
constexpr char loadedReaders[] = "libwinding_readers.so";
constexpr char readerMaker[] = "windingMakeReader";

/// Returns a new reader of a file of a format, which the caller deletes; null where VTK has none of
/// the format.
using ReaderMaker = vtkAlgorithm* (*)(const char* suffix, const char* fileName);
