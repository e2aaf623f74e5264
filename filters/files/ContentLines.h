// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/LineBlocks.h"
#include "files/LineScanner.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace winding
{

/// The letters that stand for the commas and semicolons of a text: blanks, where these separate
/// words.
struct Letters
{
  char comma = ',';
  char semicolon = ';';
};

/**
 * The lines of a text file with more on them than blanks and comments, numbered from 0
 * on: formats that promise a number of items, one on a line, find each by its number.
 */
class ContentLines
{
public:
  /// Counts the lines, and reads the whole file for it. The file must live as long as this object.
  /// `letters` are written for others before words are taken. Throws FileRefusal where the file
  /// cannot be read, and Interrupted.
  ContentLines(const InputFile& file, Executor& executor, const Letters& letters = {});

  std::size_t count() const { return starts_.back(); }

  /// The number of blocks that the lines come in.
  std::size_t blocks() const { return blocks_.count(); }

  /// The lines of a block whose numbers lie in some range.
  class Part
  {
  public:
    /// `lines` are all of the block, by their numbers from `blockFirst` up to, without,
    /// `blockLast`; those from `first` up to, without, `last` are the part.
    Part(const InputFile& file, const LineScanner& lines, std::size_t blockFirst,
      std::size_t blockLast, std::size_t first, std::size_t last);

    /// Goes to the next line; false at the end of the part. Throws FileRefusal where the file has
    /// changed since its lines were counted.
    bool nextLine();

    /// The number of the present line.
    std::size_t number() const { return next_ - 1; }

    /// The words of the present line.
    LineScanner& words() { return lines_; }

  private:
    const InputFile& file_;
    LineScanner lines_;
    std::size_t next_; ///< the number of the next line
    std::size_t blockLast_, first_, last_;
  };

  /// Calls work(block, part) for all blocks that have lines of the numbers first … last − 1, on the
  /// executor. Work may throw, as in runOrderedBlocks().
  void visit(std::size_t first, std::size_t last,
    const std::function<void(std::size_t block, Part& part)>& work, Executor& executor) const;

private:
  friend class FirstLines;

  TextBlock read(std::size_t block) const;

  const InputFile& file_;
  LineBlocks blocks_;
  Letters letters_;
  std::vector<std::size_t> starts_; ///< the number of the first line of each block; last, of all
};

/// The first lines of a file, one after the other, for what stands before the items.
class FirstLines
{
public:
  explicit FirstLines(const ContentLines& lines)
    : lines_(lines)
  {
  }

  /// Goes to the next line; false at the end of the file.
  bool nextLine();

  /// The words of the present line. nextLine() must have found it.
  LineScanner& words() { return *words_; }

private:
  const ContentLines& lines_;
  std::size_t nextBlock_ = 0;
  std::optional<TextBlock> text_;
  std::optional<LineScanner> words_;
};

} // namespace winding
