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
 * Reads a surface or points from the Polygon File Format (.ply) of version 1.0, as text or in
 * either order of bytes: the vertices with their normals (nx, ny, nz), colours (red, green, blue
 * and alpha, diffuse_red and so on, or r, g, b and a) and texture coordinates (u and v, s and t, or
 * texture_u and so on), where there are any, and the faces (vertex_indices or vertex_index). All
 * other elements are passed over, and so are other properties, unless these are of vertices, and
 * wanted. Numbers may be of any type; colours become bytes (bytesOfColors()).
 *
 * Positions are doubles in all text and where the file holds doubles or integers of four bytes, and
 * floats else; so are normals.
 *
 * Throws FileRefusal for headers that PLY does not know, files that hold less than they promise,
 * lists whose length is no whole number from 0 on, and corners that do not exist. Nothing
 * is allocated for items that the file cannot hold. Throws Interrupted. The result is the same for
 * any number of threads.
 *
 * The format is described by Greg Turk, "The PLY Polygon File Format", Stanford University, 1994.
 */
MeshArrays readPly(const InputFile& file, Executor& executor);

/// Reads a file as readPly() does. If they are wanted, other single numbers of vertices are read,
/// too, by the names of their properties.
MeshArrays readPlyColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor);

} // namespace winding
