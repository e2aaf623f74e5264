// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

class Messages;
class OutputFile;
VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * Writes points with active normals in the format of the file's suffix; commit() is left to the
 * caller. Numbers keep all their bits, whatever the format.
 *
 * - .ply: binary, with the properties x, y, z, nx, ny, nz, of type float or double as the arrays,
 *   then colours as bytes and other numbers as doubles
 * - .xyz: lines `x y z nx ny nz`
 * - .pwn: the number of points, lines `x y z`, lines `nx ny nz`
 * - .csv, .tsv: columns x, y, z, nx, ny, nz, for the point data array "Area" area, and one for
 *   each component of other arrays
 * - .vtp, .vtu: with all arrays of the points (WriteOutput.h)
 *
 * The program reads all of them again, with the normals. Throws Failure when the file cannot be
 * written whole or the program is interrupted.
 */
void writeCloud(vtkPolyData* cloud, OutputFile& file, Messages& messages);
