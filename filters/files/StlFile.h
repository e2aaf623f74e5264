// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

namespace winding
{

/**
 * Reads a surface of triangles from stereolithography files (.stl), binary ones or text, whose
 * words may be in small letters or capital ones, with any number of solids behind each other. A
 * file is binary where it has the size of a binary file of the number of triangles that it
 * promises, or where it is no text. Text begins with "solid", behind blank lines or not.
 *
 * Each triangle has three points of its own, in the order of the file, as floats from binary files
 * and doubles from text; nothing is welded. Solids are regions, and several may have one name, or
 * none. The normals and attributes of facets and colours are passed over.
 *
 * Throws FileRefusal for binary files of another size than they promise, vertices without three
 * numbers, text without its end, and lines in an order that STL does not have. Throws Interrupted.
 * The result is the same for any number of threads.
 *
 * The format is described in the StereoLithography Interface Specification, 3D Systems, 1989.
 */
MeshArrays readStl(const InputFile& file, Executor& executor);

} // namespace winding
