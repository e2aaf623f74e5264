#pragma once

#include "files/InputFile.h"
#include "files/MeshArrays.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkPolyData;

namespace winding
{

class Executor;

/// Hands the arrays of a mesh over to VTK's data: points, cells, and the arrays of points
/// "Normals", "RGB" or "RGBA", "TCoords" and "Area", as far as the mesh has them.
void handOver(MeshArrays& mesh, vtkPolyData* output);

/// The suffix of a file's name, from its last dot on, in small letters. May be empty.
std::string suffixOf(const InputFile& file);

/// Reads a file into the output of a reader.
using FileParser = std::function<void(const InputFile& file, Executor& executor)>;

/**
 * Does the work of a reader: opens the file of that name (null if none is set) and parses it. What
 * goes wrong becomes an error of the reader, in one line that begins with the name of the file, and
 * the output is left empty. `errorCode` becomes a vtkErrorCode. Returns the answer to the request
 * for data.
 */
int readFile(vtkAlgorithm* reader, const char* fileName, unsigned long& errorCode,
  const FileParser& parse, vtkPolyData* output);

/// Reads the content of a file of one format.
using MeshParser = std::function<MeshArrays(const InputFile& file, Executor& executor)>;

/// Does the work of a reader as readFile() does, and hands what was parsed over to the output.
int readMeshFile(vtkAlgorithm* reader, const char* fileName, unsigned long& errorCode,
  const MeshParser& parse, vtkPolyData* output);

} // namespace winding
