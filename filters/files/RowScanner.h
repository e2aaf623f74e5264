// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace winding
{

/// How a row of a table goes on behind the field that was taken last.
enum class RowState
{
  hasMore, ///< with another field
  ended,   ///< not at all: its line has ended
  cut,     ///< the text ends within the row
  broken   ///< its field goes on behind the quotation mark that closes it
};

/**
 * Takes the text of a table apart into rows of fields, as RFC 4180 has it. A field that begins with
 * a quotation mark goes on to the mark that closes it, over separators and ends of lines; two marks
 * in it stand for one. Spaces around a field are no part of it, and a mark within a field that
 * begins otherwise is a letter. Every row ends with '\n' or "\r\n"; the last one does, too.
 */
class RowScanner
{
public:
  /// The text must live as long as the scanner.
  RowScanner(std::string_view text, char separator);

  /// Goes to the next row with more on it than spaces, be it a separator; false if there
  /// is none. The row before must have ended.
  bool nextRow();

  /// Takes the next field of the row, with spaces and quotation marks. False where there is none,
  /// and where its end is not found.
  bool nextField(std::string_view& field);

  /// Takes the next field of the row as a number. Where it is none the field is left, and the
  /// result is false. A comma may be the decimal point unless it is the separator.
  bool nextNumber(double& value);

  /// Whether a comma was the decimal point of any number, and whether a point was.
  bool hasDecimalCommas() const { return hasDecimalCommas_; }
  bool hasDecimalPoints() const { return hasDecimalPoints_; }

  /// Passes over the fields that are left. False where the row does not end.
  bool passRow();

  /// Passes over what is left of the line: the fields that are left where none is in quotation
  /// marks. False where the line does not end.
  bool passLine();

  RowState state() const { return state_; }

  /// The beginning of the present row.
  const char* rowStart() const { return row_; }

  /// The text of a row that has ended, without the end of its last line.
  std::string_view row() const;

  /// The text behind what was taken.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

private:
  const char* skipBlanks(const char* at) const;
  void endField(const char* at);
  void passQuoted(const char* mark);

  const char* row_;
  const char* at_; ///< the beginning of the next field, or row
  const char* end_;
  char separator_;
  RowState state_ = RowState::ended;
  bool hasDecimalCommas_ = false;
  bool hasDecimalPoints_ = false;
};

/// A field without spaces and quotation marks around it. Two marks within are still two.
std::string_view contentOf(std::string_view field);

/// The text that a field stands for.
std::string unquoted(std::string_view field);

} // namespace winding
