#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkPointSet;

/// A format of files that a reader of VTK reads.
struct VtkFormat
{
  const char* suffix;

  /// Makes a reader for a file.
  vtkSmartPointer<vtkAlgorithm> (*makeReader)(const std::string& fileName);

  /// Throws Failure where the data that was read cannot be all that the file holds; null where the
  /// reader notices.
  void (*check)(const std::string& fileName, vtkPointSet* data);
};

/// The format of a suffix; null if none has it.
const VtkFormat* vtkFormatOf(const std::string& suffix);
