// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ColumnNames.h"
#include "files/InputFile.h"
#include "files/MeshArrays.h"

#include <string>

namespace winding
{

class Executor;

/// A format of files of meshes and points.
struct MeshFormat
{
  const char* suffix; ///< in small letters, with the dot
  /// Null for tables.
  MeshArrays (*read)(const InputFile& file, const ColumnWishes& wishes, Executor& executor);
  char separator;  ///< of a table (TableFile.h)
  bool hasColumns; ///< whether the user may choose columns
};

/// Returns the format of a file by the suffix of its name. Throws FileRefusal for others.
const MeshFormat& formatOf(const InputFile& file);

/// Returns all suffixes, with blanks between them.
const std::string& suffixesOfMeshes();

} // namespace winding
