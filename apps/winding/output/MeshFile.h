// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

class OutputFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * Files of meshes with what belongs to their points and faces. The program reads all of it again.
 * Positions are in single precision in .ply, and keep all their bits in .obj.
 *
 * - .ply: binary. Vertices have x, y, z, and as far as the mesh has them nx, ny, nz; red, green,
 *   blue and alpha as bytes; texture_u, texture_v; and any other single number by the name of its
 *   array. Faces have their vertices, colours and other numbers.
 * - .obj: text. Vertices have a colour, too, from 0 to 1 behind their position, texture coordinates
 *   (vt) and normals (vn). Where faces have regions with names, as from .obj, they stand behind a
 *   statement (o, g, usemtl) with the name. Lines and points stay. An empty mesh is a comment.
 */

/// Returns the names of the arrays of a mesh that a format does not hold, first of points, each
/// once: names of regions, too, and of colours the alpha alone, unless all are opaque. Normals are
/// left out, which other programs make again.
std::vector<std::string> arraysLostIn(const std::string& suffix, vtkPolyData* mesh);

///@{
/// Writes polygons and strips, in .obj lines and points, too; commit() is left to the caller.
/// Throws Failure when the file cannot be written whole or the program is interrupted.
void writePlyMesh(vtkPolyData* mesh, OutputFile& file);
void writeObjMesh(vtkPolyData* mesh, OutputFile& file);
///@}
