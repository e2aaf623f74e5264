// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/Print.h"

#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkWindingNumberAlgorithm;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * Parts that the reports of several commands have.
 */

/// Describes the source of an executed filter, which was read from a file.
Json describeInput(const std::string& fileName, const vtkWindingNumberAlgorithm& filter);

/// The most memory that the program, or a process that it reads files in, has held up to now, in
/// bytes.
long long peakMemory();

/// The largest of the peaks of memory of all ranks.
long long largestMemory(const std::vector<double>& peaks);

/// Adds the number of ranks and the peak of each, where there are several.
void addRanks(Json& report, const std::vector<double>& peaks);
