#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/**
 * @file
 * The text of tables, as RFC 4180 has it. A field that begins with a quotation mark goes on to the
 * mark that closes it, over separators and ends of lines; two marks in it stand for one. Spaces
 * around a field are no part of it, and a mark within a field that begins otherwise is a letter.
 */

/// The next row from `start` on, without the end of its last line; moves `start` behind it. False
/// where a quotation mark is not closed, or where more of the field stands behind the one that
/// closes it.
bool takeRow(std::string_view text, char separator, std::size_t& start, std::string_view& row);

/// The fields of a row, one after the other, with their quotation marks.
class RowFields
{
public:
  RowFields(std::string_view row, char separator)
    : row_(row)
    , separator_(separator)
  {
  }

  /// Takes the next field. False where there are no more.
  bool next(std::string_view& field);

private:
  std::string_view row_;
  char separator_;
  std::size_t at_ = 0; ///< the beginning of the next field; beyond the end when there is none
};

/// All fields of a row, with their quotation marks.
std::vector<std::string_view> splitRow(std::string_view row, char separator);

/// A field without spaces and quotation marks around it. Two marks within are still two.
std::string_view trimmed(std::string_view field);

/// The text that a field stands for.
std::string unquoted(std::string_view field);
