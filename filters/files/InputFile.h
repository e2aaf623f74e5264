// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Refusal.h"
#include "files/FileHandle.h"
#include "files/PlainArray.h"

#include <cstddef>
#include <functional>
#include <string>

namespace winding
{

/// The ways in which a file can be at fault.
enum class FileFault
{
  noName,
  notFound,
  cannotOpen,
  ends, ///< it ends too early, or is empty
  format
};

/// Thrown where a file cannot be read or holds something else than it should. The message begins
/// with the name of the file, if there is one.
class FileRefusal : public Refusal
{
public:
  FileRefusal(FileFault fault, const std::string& message)
    : Refusal(message)
    , fault_(fault)
  {
  }

  FileFault fault() const { return fault_; }

private:
  FileFault fault_;
};

/**
 * A file that is read in pieces, from any place and by any number of threads at a time. Pieces are
 * copied rather than mapped: a file that somebody cuts off meanwhile ends the reading with one
 * line, where access to a mapping would end the program, and the file takes no memory of its own.
 */
class InputFile
{
public:
  /// Unpacks the bytes of a file. Throws FileRefusal where they are not packed, or damaged.
  using Unpack = std::function<PlainArray<char>(const InputFile& packed)>;

  /// Opens a regular file. Throws FileRefusal when there is no name (null or empty) and where the
  /// file is missing, a folder, a pipe, unreadable, empty or text in UTF-16; it never waits for a
  /// pipe. A file with the suffix .gz is unpacked into memory, and refused where `unpack` is empty.
  explicit InputFile(const char* name, const Unpack& unpack = {});

  const std::string& name() const { return name_; }

  /// Returns the name without the suffix .gz: its suffix says what the bytes are.
  std::string unpackedName() const;

  /// The number of bytes, unpacked, when the file was opened.
  std::size_t size() const { return content_.empty() ? handle_.size() : content_.size(); }

  /// The place where text begins: behind a byte order mark of UTF-8, if there is one.
  std::size_t textStart() const;

  /// Copies `count` bytes from the place `offset` on. Throws FileRefusal if they are not there.
  void read(std::size_t offset, char* bytes, std::size_t count) const;

  /// Copies as read() does, with LF for each CR that no LF follows. Old programs of the Mac end
  /// lines by CR.
  void readText(std::size_t offset, char* bytes, std::size_t count) const;

  /// The number of the line in which the byte at `offset` stands, from 1 on. It reads all lines
  /// before.
  std::size_t lineOf(std::size_t offset) const;

  /// Throw a FileRefusal about the file as a whole, about the line of the byte at `offset`, and
  /// about the file's end.
  [[noreturn]] void refuse(const std::string& message, FileFault fault = FileFault::format) const;
  [[noreturn]] void refuseLine(std::size_t offset, const std::string& message) const;
  [[noreturn]] void refuseEnd(const std::string& message) const;

  /// Throws a FileRefusal for a file that holds something else than when it was read before.
  [[noreturn]] void refuseChanged() const;

private:
  std::string name_;
  FileHandle handle_;
  PlainArray<char> content_; ///< unpacked; empty where the file is read as it is
};

} // namespace winding
