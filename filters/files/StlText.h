#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/PlainArray.h"

namespace winding
{

/// Reads the vertices of all triangles of an STL file of text: nine numbers for each triangle, in
/// the order of the file. Throws FileRefusal and Interrupted as readStl() does.
PlainArray<double> readStlText(const InputFile& file, Executor& executor);

} // namespace winding
