#pragma once

#include "base/Executor.h"
#include "files/MeshArrays.h"
#include "files/PlyHeader.h"

namespace winding
{

/**
 * Reads what is behind the header of a binary PLY file. Coordinates and normals are floats where
 * floats hold what the file has: floats and integers of two bytes at most.
 *
 * Items whose lists have the same lengths as the first one's, as in meshes of triangles, are
 * read at once by all threads. For others one thread finds the places of the items first.
 *
 * Throws FileRefusal where the file ends before its last item, for lists whose length is no
 * whole number from 0 on, and for corners that do not exist. Throws Interrupted.
 */
MeshArrays readPlyBinary(const InputFile& file, const PlyHeader& header, Executor& executor);

} // namespace winding
