#pragma once

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class Messages;
class OutputFile;
class vtkPointSet;
struct Options;

/// Returns the files that no output may replace: those that are read, or none with --overwrite.
std::vector<std::string> filesToKeep(const Options& options);

/// Opens the output file on the first rank, and returns null on the others. Throws Failure on all
/// ranks where it cannot be written. Collective.
std::unique_ptr<OutputFile> openOnFirstRank(const Options& options);

/// Reads `fileName` as readInput() does, on the first rank; the others get a data set without
/// points. Throws Failure on all ranks where it cannot be read. Collective.
vtkSmartPointer<vtkPointSet> readOnFirstRank(const std::string& fileName, Messages& messages);
