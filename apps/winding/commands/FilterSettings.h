// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>

class Messages;
struct Options;
VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkWindingNumberAlgorithm;
class vtkWindingNumberField;
class vtkWindingNumberGridAlgorithm;
class vtkWindingNumberImageAlgorithm;
class vtkWindingNumberLabels;
VTK_ABI_NAMESPACE_END

/// Hands on to a filter how to make winding numbers and what to make of them: method, areas,
/// threshold, arrays, threads.
void applyMethod(const Options& options, vtkWindingNumberAlgorithm* filter);

/// Hands on the grid, and how many samples to verify.
void applyGrid(const Options& options, vtkWindingNumberGridAlgorithm* filter);

/// Hands on what the samples are in the image, and what makes a voxel inside.
void applyImage(const Options& options, vtkWindingNumberImageAlgorithm* filter);

/// Hands on what applyImage() does, and how far distances reach.
void applyField(const Options& options, vtkWindingNumberField* filter);

/// Hands on what applyImage() does, what the solids are, and which arrays they give.
void applyLabels(const Options& options, vtkWindingNumberLabels* filter);

/// Warns of options for points where the filter's source, which it has looked at, is a surface.
void warnOfIdleOptions(
  const Options& options, vtkWindingNumberAlgorithm& filter, Messages& messages);

/// Throws Failure, about the file, where a filter was not done or the program was interrupted.
/// `status` is a StatusType of vtkWindingNumberAlgorithm.
void checkFilter(int status, const std::string& fileName, Messages& messages);

/// Throws Failure as checkFilter() does, but not for a signal.
void checkStatus(int status, const std::string& fileName, Messages& messages);
