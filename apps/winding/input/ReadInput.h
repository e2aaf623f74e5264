#pragma once

#include "vtkSmartPointer.h"

#include <string>

class Messages;
class vtkPointSet;
class vtkSourceReader;

/**
 * Reads a surface, grid or cloud by the suffix of its name, one of inputSuffixes(). Throws Failure
 * for whatever cannot be read in full, in one line that says why. Coordinates are in the file's own
 * precision: double for text, for binary files what they have.
 */
vtkSmartPointer<vtkPointSet> readInput(const std::string& fileName, Messages& messages);

/// Reads a file with a reader of the module, which believes nothing that the file does not hold,
/// and shows its progress. Throws Failure as readInput() does.
void readBy(vtkSourceReader* reader, const std::string& fileName, Messages& messages);
