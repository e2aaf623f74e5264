#pragma once

#include <string>

class vtkPointSet;

/**
 * @file
 * VTK's readers silently give part of the data, or other data, for some broken files. Each guard
 * walks through a file as the reader of its format would, and throws a one-line Failure for what
 * the reader would not notice: counts that the file does not hold, truncation, indices out of
 * range.
 */
void guardStl(const std::string& fileName);
void guardPly(const std::string& fileName);

/// Throws Failure where the cells that came out of a legacy .vtk file are not as many as it
/// announces: where sizes of cells contradict their sum, VTK's reader reads on in memory that is
/// not its own.
void checkLegacyVtkCounts(const std::string& fileName, vtkPointSet* data);
