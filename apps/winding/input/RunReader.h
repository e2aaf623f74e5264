#pragma once

#include <string>

class Messages;
class vtkAlgorithm;

/// Updates a reader that has the name of its file, and shows its progress. Throws Failure where the
/// reader reports an error.
void runReader(vtkAlgorithm* reader, const std::string& fileName, Messages& messages);
