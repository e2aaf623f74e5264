#pragma once

#include "vtkSmartPointer.h"

#include <string>

class Messages;
class vtkPointSet;

/**
 * Reads a surface, grid or cloud by the suffix of its name: .vtp .vtk .vtu .ply .stl .obj .off .xyz
 * .pwn .csv .tsv. Throws Failure for whatever cannot be read in full, in one line that says why.
 * Coordinates are in the file's own precision: double for text, for binary files what they have.
 */
vtkSmartPointer<vtkPointSet> readInput(const std::string& fileName, Messages& messages);
