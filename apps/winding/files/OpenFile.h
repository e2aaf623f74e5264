#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <sys/stat.h>

/**
 * A file that stays open while others read it by its name, so that parts of it can be read again:
 * also when it has been removed or replaced by then. What is written into it meanwhile is noticed.
 */
class OpenFile
{
public:
  /// Throws Failure where the file cannot be opened.
  explicit OpenFile(const std::string& name);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  void operator=(const OpenFile&) = delete;

  /// Throws Failure where the name leads to another file by now, or this one has changed.
  void checkName() const;

  /// Throws Failure where something has been written into the file since it was opened.
  void checkIsUnchanged() const;

  /// So many bytes from the place `offset` on, valid until the next call. Parts that follow each
  /// other in the file are read many at once. Throws Failure where they are not there.
  std::string_view read(std::size_t offset, std::size_t count);

private:
  [[noreturn]] void refuseChanged() const;

  std::string name_;
  int descriptor_;
  struct stat opened_;
  std::vector<char> bytes_;
  std::size_t first_ = 0; ///< the place of these bytes in the file
};
