#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <sys/stat.h>

/**
 * A file that others read by its name, and whose parts are read again later. It stays open, so
 * it may be removed or replaced when they have read it, touched or written to at its end. Parts
 * that are read again are what they were when the file was opened: checksums show that.
 */
class CheckedFile
{
public:
  /// Reads the whole file once. Throws Failure where it cannot be read, and when a signal has come.
  explicit CheckedFile(const std::string& name);
  ~CheckedFile();
  CheckedFile(const CheckedFile&) = delete;
  void operator=(const CheckedFile&) = delete;

  /// Throws Failure where the name leads to another file by now, or this one holds something else:
  /// then what others have read may be something else, too.
  void checkName() const;

  /// Returns `bytes` bytes from the place `offset` on, valid until the next call. Parts that follow
  /// each other in the file are read many at once. Throws Failure where they are not what they
  /// were.
  std::string_view read(std::size_t offset, std::size_t count);

private:
  /// Owns the descriptor, so that it is closed whatever the other constructor throws.
  CheckedFile(const std::string& name, int descriptor);

  std::uint64_t takeBlock(std::size_t block, char* bytes) const;
  void checkBlock(std::size_t block, char* bytes) const;
  std::size_t sizeOf(std::size_t block) const;
  [[noreturn]] void refuseChanged() const;

  std::string name_;
  int descriptor_;
  struct stat opened_;
  std::size_t size_ = 0;
  std::vector<std::uint64_t> checksums_; ///< one for each block
  std::vector<char> bytes_;              ///< some blocks
  std::size_t first_ = 0;                ///< the place of these bytes in the file
};
