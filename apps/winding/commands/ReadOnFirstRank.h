#pragma once

#include "vtkSmartPointer.h"

#include <string>

class Messages;
class vtkPointSet;

/// Reads a file as readInput() does, on the first rank; the others get a data set without points.
/// Throws Failure on all ranks where it cannot be read. Collective.
vtkSmartPointer<vtkPointSet> readOnFirstRank(const std::string& fileName, Messages& messages);
