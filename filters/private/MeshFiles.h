#pragma once

#include "files/InputFile.h"
#include "files/MeshArrays.h"

#include <functional>

class vtkAlgorithm;
class vtkPolyData;

namespace winding
{

class Executor;

/// Reads the content of a file of one format.
using MeshParser = std::function<MeshArrays(const InputFile& file, Executor& executor)>;

/**
 * Does the work of a reader: opens the file of that name (null if none is set), parses it and hands
 * its arrays over to the output. What goes wrong becomes an error of the reader, in one line that
 * begins with the name of the file, and the output stays empty. `errorCode` becomes a vtkErrorCode.
 * Returns the answer to the request for data.
 */
int readMeshFile(vtkAlgorithm* reader, const char* fileName, unsigned long& errorCode,
  const MeshParser& parse, vtkPolyData* output);

} // namespace winding
