#pragma once

#include <string>

/**
 * A file that takes its name when it is complete; where that is a link, the file that it leads to. It is written under a name of its own in the same
 * folder; commit() renames it, and without commit() it is removed again.
 */
class OutputFile
{
public:
  /// Makes the temporary file. Throws Failure where the folder does not allow it, before any work.
  explicit OutputFile(const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  void operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }

  /// Where to write to.
  const std::string& temporaryName() const { return temporary_; }

  /// Throws the Failure of a writer that had to stop.
  [[noreturn]] void refuseWriting() const;

  /// Throws Failure, and leaves what had the name before, where the disk is full.
  void commit();

private:
  std::string name_;
  std::string target_; ///< the name, or what it leads to
  std::string temporary_;
};
