// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/// Reads the vertices of all triangles of an STL file of text, three points for each triangle in
/// the order of the file, and its solids as regions of that many triangles. Throws FileRefusal and
/// Interrupted as readStl() does.
void readStlText(const InputFile& file, MeshArrays& mesh, Executor& executor);

} // namespace winding
