#pragma once

#include <string>

class Messages;
struct Options;
class vtkPointSet;
class vtkWindingNumberAlgorithm;
class vtkWindingNumberField;
class vtkWindingNumberGridAlgorithm;

/// Hands the options on to a filter: method, areas, threshold, result array, threads.
void applyMethod(const Options& options, vtkWindingNumberAlgorithm* filter);

/// The grid, and how many samples to verify.
void applyGrid(const Options& options, vtkWindingNumberGridAlgorithm* filter);

/// What the samples are in the image, what makes a voxel inside, and how far distances reach.
void applyImage(const Options& options, vtkWindingNumberField* filter);

/// Warns of options for points where the filter's source, which it has looked at, is a surface.
void warnOfIdleOptions(
  const Options& options, vtkWindingNumberAlgorithm& filter, Messages& messages);

/// Throws what kept the filter from being done as a Failure about the file. status is the filter's.
void checkFilter(int status, const std::string& fileName, Messages& messages);
