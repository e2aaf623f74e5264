// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyFile.h"

#include "files/PlyBody.h"
#include "files/PlyHeader.h"

namespace winding
{

MeshArrays readPly(const InputFile& file, Executor& executor)
{
  return readPlyColumns(file, {}, executor);
}

MeshArrays readPlyColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor)
{
  const PlyHeader header = readPlyHeader(file);
  MeshArrays mesh = header.encoding == PlyEncoding::text
                      ? readPlyText(file, header, wishes, executor)
                      : readPlyBinary(file, header, wishes, executor);
  mesh.notes = header.notes;
  return mesh;
}

} // namespace winding
