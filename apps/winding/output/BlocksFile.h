// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

class Messages;
VTK_ABI_NAMESPACE_BEGIN
class vtkMultiBlockDataSet;
VTK_ABI_NAMESPACE_END

/**
 * A .vtm file: an index of blocks, which are files of their own in a folder next to it that has its
 * name without the suffix. They take their names when all of them are complete (OutputFile.h), the
 * index last. Then files are removed that the index of an earlier run named and this one does not.
 */
class BlocksFile
{
public:
  /// Throws Failure, before any work, where files of these names cannot be written, or would
  /// replace one of `inputs`.
  BlocksFile(const std::string& name, const std::vector<std::string>& inputs);

  /// Writes blocks, which are named polydata. Throws Failure when that fails or the program is
  /// interrupted. Warns of files of an earlier run that it cannot remove.
  void write(vtkMultiBlockDataSet* blocks, Messages& messages) const;

private:
  std::string name_;
  std::string folder_;
  std::vector<std::string> inputs_;
};
