// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/ColumnNames.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/**
 * Reads a surface from Wavefront's object file format (.obj): vertices (v), faces (f) of three and
 * more corners, lines (l) and points (p), whose cells may go on behind a backslash at the end of a
 * line. Corners name vertices from 1 on, or with negative numbers back from the last one before.
 *
 * Normals (vn) belong to vertices where there are as many of them as vertices, and no corner
 * names the normal of another vertex; else they are left out, with a note where there are no
 * faces. Objects (o), groups (g) and materials (usemtl) are regions of the faces, each by its name,
 * and faces before the first have one without a name. Colours are the numbers behind the position
 * of a vertex, red, green and blue; where only some vertices have them, the others are white, and a
 * note says so. Texture coordinates (vt) are passed over, and so are free-form curves and surfaces,
 * which a note counts.
 *
 * Throws FileRefusal for files without vertices, vertices, normals and texture coordinates without
 * their numbers, faces with fewer than three corners, and vertices of corners that do not exist.
 * Throws Interrupted. The result is the same for any number of threads.
 *
 * The format is described in "Object Files (.obj)", Advanced Visualizer Manual, Wavefront
 * Technologies, appendix B1.
 */
MeshArrays readObj(const InputFile& file, Executor& executor);

/// Reads a file as readObj() does. If other numbers are wanted, texture coordinates are read, too:
/// a vertex whose corners name several is there once for each of these, behind all others.
MeshArrays readObjColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor);

} // namespace winding
