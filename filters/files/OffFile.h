// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/**
 * Reads a surface from Geomview's Object File Format as text (.off): the keyword OFF with the
 * prefixes ST, C and N in any order, the counts on the same line or the next, comments from '#'
 * on, one vertex and one face on a line. Faces with two corners become lines, those with one become
 * vertices; a file without faces gives one cell of all its points. Vertex normals are read; colours
 * and texture coordinates are passed over. A note counts lines behind the last face.
 *
 * Throws FileRefusal for all else, for counts that the file cannot hold, before anything is
 * allocated, and for corners that do not exist. Throws Interrupted. The result is the same for any
 * number of threads.
 */
MeshArrays readOff(const InputFile& file, Executor& executor);

} // namespace winding
