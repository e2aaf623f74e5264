#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/**
 * Reads a surface or points from the Polygon File Format (.ply) of version 1.0, as text or in
 * either order of bytes: the vertices, their normals (nx, ny, nz) where there are any, and the
 * faces (vertex_indices or vertex_index), of any number of corners. All other elements and
 * properties are passed over. Numbers may be of any type.
 *
 * Positions are doubles in all text and where the file holds doubles or integers of four bytes, and
 * floats else; so are normals.
 *
 * Throws FileRefusal for headers that PLY does not know, files that hold less than they promise,
 * lists of a length below 0, faces of more than 255 corners, and corners that do not exist. Nothing
 * is allocated for items that the file cannot hold. Throws Interrupted. The result is the same for
 * any number of threads.
 *
 * The format is that of Greg Turk, "The PLY Polygon File Format", Stanford University, 1994.
 */
MeshArrays readPly(const InputFile& file, Executor& executor);

} // namespace winding
