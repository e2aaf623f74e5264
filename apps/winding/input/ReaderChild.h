// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

struct VtkFormat;

/// The messages of a process that reads. Each is followed by what is said here, and all but
/// progress and warnings are the last one.
enum class ReaderMessage : char
{
  progress, ///< a double
  note,     ///< a text for the user
  error,    ///< VTK's text
  failure,  ///< an int, the status, and the text of a Failure
  data      ///< the data (DataStream.h)
};

/// Does the work of a process that was made to read a file: reads within limits for `size` bytes,
/// its own and its parts', sends messages into a pipe, and ends the process. The process's standard
/// output and error are closed, for VTK and the C library print there, too.
[[noreturn]] void readAndSend(
  const std::string& fileName, const VtkFormat& format, std::uintmax_t size, int pipe);
