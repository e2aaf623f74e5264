#pragma once

#include <string>

class Messages;
class vtkMultiBlockDataSet;

/**
 * A .vtm file: an index of blocks, which are files of their own in a folder beside it that has its
 * name without the suffix. Each file takes its name when it is complete (OutputFile.h), the index
 * last.
 */
class BlocksFile
{
public:
  /// Makes the folder, unless it is there. Throws Failure where that is not allowed, before any
  /// work.
  explicit BlocksFile(const std::string& name);
  /// Removes the folder again if it is new and empty.
  ~BlocksFile();
  BlocksFile(const BlocksFile&) = delete;
  void operator=(const BlocksFile&) = delete;

  /// Writes blocks, which are named polydata. Throws Failure when that fails or the program is
  /// interrupted.
  void write(vtkMultiBlockDataSet* blocks, Messages& messages) const;

private:
  void removeFolder() const;

  std::string name_;
  std::string folder_;
  bool isNew_;
};
