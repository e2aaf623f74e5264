// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/LineBlocks.h"
#include "files/RowScanner.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace winding
{

/// The first row of a table, which names its columns.
struct TableHeader
{
  std::string text; ///< as it is in the file, and the end of its last line; empty if there is none
  std::vector<std::string> names;
  std::size_t start = 0; ///< the place in the file where it may begin, and blank lines before it
  std::size_t end = 0;   ///< the place in the file behind it
};

/// Reads the first row that has anything on it, behind a byte order mark if there is one. Passes
/// over what programs write about it: a line "sep=;" before, for any separator (Excel); slashes
/// before the first name, and a number of points on a line behind (CloudCompare). Throws
/// FileRefusal for quotation marks that are not as they should be.
TableHeader readTableHeader(const InputFile& file, char separator, std::size_t bytesAtOnce);

/**
 * The rows of a table, numbered from 0 on, in blocks that any thread may read. Where no quotation
 * mark stands in them all threads find the rows; otherwise one goes through them, for only what
 * stands before decides whether an end of line is in a field. Blank lines are no rows.
 */
class TableRows
{
public:
  /// Finds the rows from the place `start` on, and reads the whole file for it. The file must live
  /// as long as this object. They end before a row with a quotation mark that is not as it should
  /// be. Throws FileRefusal where the file cannot be read, and Interrupted.
  TableRows(const InputFile& file, char separator, std::size_t start, std::size_t bytesPerBlock,
    Executor& executor);

  std::size_t count() const { return starts_.back(); }

  /// Throws FileRefusal where the rows ended before the file did. What is wrong with rows before
  /// that one is to be reported first.
  void checkEnd() const;

  /// The rows of a block.
  class Part
  {
  public:
    /// They have the numbers from `first` up to, without, `last`.
    Part(
      const InputFile& file, TextBlock text, char separator, std::size_t first, std::size_t last);

    /// Goes to the next row; false at the end of the part. All fields of the row before must have
    /// been taken. Throws FileRefusal where the file has changed since its rows were found.
    bool nextRow();

    /// The number of the present row.
    std::size_t number() const { return next_ - 1; }

    /// The fields of the present row.
    RowScanner& fields() { return fields_; }

    /// The number of fields in the present row. Throws FileRefusal for quotation marks that are not
    /// as they should be.
    std::size_t countFields() const;

    /// The place of the present row in the file.
    std::size_t offset() const { return text_.offsetOf(fields_.rowStart()); }

    /// Throws a FileRefusal about the line in which the present row begins.
    [[noreturn]] void refuse(const std::string& message) const;

  private:
    const InputFile& file_;
    TextBlock text_;
    RowScanner fields_;
    char separator_;
    std::size_t next_; ///< the number of the next row
    std::size_t last_;
  };

  /// Calls work(part) for all parts of the table, on the executor. Work may throw, as in
  /// runOrderedBlocks().
  void visit(const std::function<void(Part& part)>& work, Executor& executor) const;

private:
  bool countPlainRows(Executor& executor);
  void findQuotedRows(std::size_t start, std::size_t bytesPerBlock, Executor& executor);

  const InputFile& file_;
  char separator_;
  LineBlocks blocks_;
  std::vector<std::size_t> starts_; ///< the number of the first row of each block; last, of all
  std::optional<std::size_t> brokenRow_; ///< the place of the row before which the rows ended
};

} // namespace winding
