// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/InputFile.h"
#include "files/PlainArray.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace winding
{

/// Whole lines of a file, in memory.
class TextBlock
{
public:
  TextBlock(PlainArray<char> bytes, std::size_t offset)
    : bytes_(std::move(bytes))
    , offset_(offset)
  {
  }

  /// The lines. The last one ends with '\n' as all others do, whether the file's does or not.
  std::string_view text() const { return {bytes_.data(), bytes_.size()}; }

  /// Writes one letter for another, in the text only.
  void replace(char letter, char other)
  {
    if (letter != other)
    {
      std::replace(bytes_.begin(), bytes_.end(), letter, other);
    }
  }

  /// The place in the file of a byte of the text.
  std::size_t offsetOf(const char* at) const
  {
    return offset_ + static_cast<std::size_t>(at - bytes_.data());
  }

private:
  PlainArray<char> bytes_;
  std::size_t offset_;
};

/**
 * Divides a text file, from some place on, into blocks of whole lines of about `bytesPerBlock`
 * bytes, or of one line where lines are longer. The blocks depend on the file only.
 */
class LineBlocks
{
public:
  static constexpr std::size_t usualBytes = 1 << 18;

  /// Whether a backslash at the end of a line, unless it is in a comment, joins the line with the
  /// one behind it: the text then has blanks for both.
  enum class Backslash
  {
    joinsLines,
    isLetter
  };

  /// Lines begin at `start`, or behind the byte order mark of a file. Throws FileRefusal where the
  /// file cannot be read.
  explicit LineBlocks(const InputFile& file, std::size_t start = 0,
    std::size_t bytesPerBlock = usualBytes, Backslash backslash = Backslash::isLetter);

  /// The blocks begin at these places, in their order, except for the last, which is the end of the
  /// last block.
  LineBlocks(const InputFile& file, std::vector<std::size_t> starts)
    : file_(&file)
    , starts_(std::move(starts))
  {
  }

  std::size_t count() const { return starts_.size() - 1; }

  /// Reads a block, with joined lines as one. Throws FileRefusal where the file cannot be read.
  TextBlock read(std::size_t block) const;

private:
  const InputFile* file_;
  Backslash backslash_ = Backslash::isLetter;
  std::vector<std::size_t> starts_; ///< places of the blocks, and the end of the file
};

} // namespace winding
