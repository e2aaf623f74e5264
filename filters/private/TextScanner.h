#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/**
 * A text file taken apart into lines of numbers, for the readers of this module. Blank lines and
 * comments, from '#' to the end of the line, are passed over. Numbers are read the same way in
 * every locale. The whole file is in memory, so that counts which a file promises can be held
 * against what it has before anything is allocated for them.
 */
class TextScanner
{
public:
  /// Reads the file; refuses it when it cannot, or when the file is empty. `errorCode` is a
  /// vtkErrorCode: that of what the scanner refuses, then and later, and NoError before.
  TextScanner(const char* fileName, unsigned long& errorCode);

  /// Goes to the next line that has anything on it; false at the end of the file.
  bool nextLine();

  /// The next word of the line; empty at its end.
  std::string_view word();

  /// The number of words that are left on the line.
  std::size_t wordsLeft() const;

  /// The next word of the line as a number. Throws Refusal, naming `what`, if it is none.
  double number(const char* what);
  std::int64_t integer(const char* what);

  /// An integer from 0 to what could stand in the rest of the file at `bytesPerItem` or more each.
  std::int64_t count(const char* what, std::size_t bytesPerItem);

  /// The number of lines with anything on them that follow the present one. O(rest of the file).
  std::size_t linesLeft() const;

  /// The part of the file that has been read, from 0 to 1, for progress.
  double fractionRead() const;

  /// Throw a Refusal about the present line, or about the file's end.
  [[noreturn]] void refuse(const std::string& message) const;
  [[noreturn]] void refuseEnd(const std::string& message) const;

private:
  void readFile();
  [[noreturn]] void refuse(unsigned long errorCode, const std::string& message) const;

  /// The line that starts at `start` without its comment; moves `start` behind it.
  std::string_view lineAt(std::size_t& start) const;

  unsigned long& errorCode_;
  std::string fileName_;
  std::string text_;
  std::size_t next_ = 0; ///< start of the next line
  std::size_t lineNumber_ = 0;
  std::string_view line_; ///< the unread rest of the present line
};
