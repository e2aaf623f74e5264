#pragma once

#include <string>

class Messages;

/// Throws Failure, about the file, where a filter was not done or the program was interrupted.
/// status is a StatusType of vtkWindingNumberAlgorithm.
void checkFilter(int status, const std::string& fileName, Messages& messages);
