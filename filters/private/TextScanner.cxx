#include "private/TextScanner.h"

#include "base/Refusal.h"

#include "vtkErrorCode.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <charconv>

namespace
{

bool isSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

void skipSpaces(std::string_view& text)
{
  std::size_t spaces = 0;
  while (spaces < text.size() && isSpace(text[spaces]))
  {
    ++spaces;
  }
  text.remove_prefix(spaces);
}

std::string_view takeWord(std::string_view& text)
{
  skipSpaces(text);
  std::size_t length = 0;
  while (length < text.size() && !isSpace(text[length]))
  {
    ++length;
  }
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

template <class Number> bool parse(std::string_view word, Number& value)
{
  // from_chars knows no plus sign.
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1);
  }
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// Numbers below the smallest double are 0 to us; from_chars only says that they are out of range.
bool parseNumber(std::string_view word, double& value)
{
  if (parse(word, value))
  {
    return true;
  }
  const std::size_t exponent = word.find_first_of("eE");
  value = 0;
  double mantissa = 0;
  return exponent != std::string_view::npos && exponent + 2 < word.size() &&
         word[exponent + 1] == '-' && parse(word.substr(0, exponent), mantissa) &&
         std::all_of(word.begin() + static_cast<std::ptrdiff_t>(exponent) + 2, word.end(),
           [](char c) { return c >= '0' && c <= '9'; });
}

/// A word as it may be shown: short, and without control characters.
std::string shown(std::string_view word)
{
  std::string text(word.substr(0, 20));
  for (char& c : text)
  {
    c = c >= ' ' && c <= '~' ? c : '?';
  }
  return "\"" + text + (word.size() > 20 ? "...\"" : "\"");
}

} // namespace

TextScanner::TextScanner(const char* fileName, unsigned long& errorCode)
  : errorCode_(errorCode)
{
  errorCode_ = vtkErrorCode::NoError;
  if (!fileName || !*fileName)
  {
    this->refuse(vtkErrorCode::NoFileNameError, "no file name is set; call SetFileName");
  }
  fileName_ = fileName;
  this->readFile();
}

void TextScanner::readFile()
{
  if (vtksys::SystemTools::FileIsDirectory(fileName_))
  {
    this->refuse(vtkErrorCode::CannotOpenFileError, fileName_ + ": is a directory, not a file");
  }
  vtksys::ifstream file(fileName_.c_str(), std::ios::binary);
  if (!file)
  {
    const bool there = vtksys::SystemTools::FileExists(fileName_);
    this->refuse(there ? vtkErrorCode::CannotOpenFileError : vtkErrorCode::FileNotFoundError,
      fileName_ + (there ? ": cannot be opened; check its permissions" : ": no such file"));
  }
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  file.seekg(0);
  text_.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  file.read(text_.data(), static_cast<std::streamsize>(text_.size()));
  if (text_.empty() || !file)
  {
    this->refuse(vtkErrorCode::PrematureEndOfFileError,
      fileName_ + (text_.empty() ? ": is empty" : ": cannot be read to its end"));
  }
}

std::string_view TextScanner::lineAt(std::size_t& start) const
{
  const std::size_t end = std::min(text_.find('\n', start), text_.size());
  std::string_view line(text_.data() + start, end - start);
  start = end + 1;
  line = line.substr(0, line.find('#'));
  skipSpaces(line);
  return line;
}

bool TextScanner::nextLine()
{
  while (next_ < text_.size())
  {
    line_ = this->lineAt(next_);
    ++lineNumber_;
    if (!line_.empty())
    {
      return true;
    }
  }
  line_ = {};
  return false;
}

std::string_view TextScanner::word()
{
  return takeWord(line_);
}

std::size_t TextScanner::wordsLeft() const
{
  std::string_view rest = line_;
  std::size_t words = 0;
  while (!takeWord(rest).empty())
  {
    ++words;
  }
  return words;
}

double TextScanner::number(const char* what)
{
  const std::string_view text = this->word();
  double value = 0;
  if (!parseNumber(text, value))
  {
    this->refuse(text.empty() ? std::string(what) + " is missing"
                              : shown(text) + " stands where " + what + " should, a number");
  }
  return value;
}

std::int64_t TextScanner::integer(const char* what)
{
  const std::string_view text = this->word();
  std::int64_t value = 0;
  if (!parse(text, value))
  {
    this->refuse(text.empty() ? std::string(what) + " is missing"
                              : shown(text) + " stands where " + what + " should, an integer");
  }
  return value;
}

std::int64_t TextScanner::count(const char* what, std::size_t bytesPerItem)
{
  const std::int64_t value = this->integer(what);
  if (value < 0)
  {
    this->refuse(std::string(what) + " is negative: " + std::to_string(value));
  }
  // The last item needs no end of line.
  const std::size_t rest = text_.size() - std::min(text_.size(), next_) + 1;
  if (static_cast<std::uint64_t>(value) > rest / bytesPerItem)
  {
    this->refuse(std::string(what) + " is " + std::to_string(value) +
                 ", more than the rest of the file can hold; it is truncated or damaged");
  }
  return value;
}

std::size_t TextScanner::linesLeft() const
{
  std::size_t lines = 0;
  for (std::size_t start = next_; start < text_.size();)
  {
    lines += !this->lineAt(start).empty();
  }
  return lines;
}

double TextScanner::fractionRead() const
{
  return static_cast<double>(std::min(next_, text_.size())) / static_cast<double>(text_.size());
}

void TextScanner::refuse(unsigned long errorCode, const std::string& message) const
{
  errorCode_ = errorCode;
  throw winding::Refusal(message);
}

void TextScanner::refuse(const std::string& message) const
{
  this->refuse(vtkErrorCode::FileFormatError,
    fileName_ + ": line " + std::to_string(lineNumber_) + ": " + message);
}

void TextScanner::refuseEnd(const std::string& message) const
{
  this->refuse(vtkErrorCode::PrematureEndOfFileError,
    fileName_ + ": ends at line " + std::to_string(lineNumber_) + ": " + message);
}
