#pragma once

#include <string>

/**
 * A file that takes its name when it is complete. It is written under a name of its own in the same
 * folder; commit() renames it, and without commit() it is removed again. Where the name is a link,
 * it stays one, and the file that it leads to is replaced.
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

  /// The name of the file to write to until commit().
  const std::string& temporaryName() const { return temporary_; }

  /// Throws the Failure of a writer that had to stop.
  [[noreturn]] void refuseWriting() const;

  /// Gives the file its name. Throws Failure where the disk is full, and leaves the file that had
  /// the name before.
  void commit();

private:
  std::string name_;
  std::string target_; ///< the name, or the file that it leads to
  std::string temporary_;
};
