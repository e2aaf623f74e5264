// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/ColumnNames.h"
#include "files/MeshArrays.h"
#include "files/PlyHeader.h"

namespace winding
{

/**
 * Reads what is behind the header of a PLY file of text: each item stands on a line of its own, and
 * what else is on its line is passed over, as are blank lines and lines that begin with '#'.
 * Coordinates and normals are doubles, whatever the header calls them: text may have more digits.
 *
 * Throws FileRefusal for numbers that are missing or are none, for lists whose length is no
 * whole number from 0 on, and for corners that do not exist. Throws Interrupted.
 */
MeshArrays readPlyText(
  const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor);

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
MeshArrays readPlyBinary(
  const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor);

} // namespace winding
