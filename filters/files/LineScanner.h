// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/LineBlocks.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace winding
{

/**
 * Takes a block of text apart into lines of words. Blank lines and comments, from '#' to the end of
 * the line, are passed over. What is refused names the line.
 */
class LineScanner
{
public:
  /// Both must live as long as the scanner.
  LineScanner(const InputFile& file, const TextBlock& block);

  /// Goes to the next line that has anything on it; false at the end of the block.
  bool nextLine();

  /// The next word of the line; empty at its end.
  std::string_view word();

  /// Returns the text that is left of the line.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  /// The number of words that are left on the line.
  std::size_t wordsLeft() const;

  /// The next word of the line as a number. False, and the word is left, if it is none.
  bool tryNumber(double& value);

  /// The next word of the line as a number. Throws FileRefusal, naming `what`, if it is none.
  double number(const char* what);
  std::int64_t integer(const char* what);

  /// An integer from 0 to what could stand in the file behind this line at `bytesPerItem` or more
  /// each.
  std::int64_t count(const char* what, std::size_t bytesPerItem);

  /// The place in the file of the next line.
  std::size_t nextOffset() const { return block_.offsetOf(next_); }

  /// Throws a FileRefusal about the present line.
  [[noreturn]] void refuse(const std::string& message) const;

private:
  [[noreturn]] void refuseWord(const char* what, const char* kind) const;

  const InputFile& file_;
  const TextBlock& block_;
  const char* line_; ///< the beginning of the present line
  const char* at_;   ///< the unread rest of it
  const char* end_;
  const char* next_; ///< the beginning of the next line
  const char* last_; ///< the end of the block
};

} // namespace winding
