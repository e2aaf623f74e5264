// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/LineBlocks.h"

#include "files/Words.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace winding
{

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 12;

/// The number of bytes before a line that decide whether it goes on the one before: a backslash and
/// the end of the line, which may have two bytes.
constexpr std::size_t bytesBefore = 3;

/// Whether a line that ends with the '\n' at `end` goes on in the next one, behind a backslash.
/// `first` is the first byte that is known.
bool goesOn(const char* first, const char* end)
{
  const char* last = end - (end > first && end[-1] == '\r' ? 1 : 0);
  return last > first && last[-1] == '\\';
}

/// The place of the first line that begins at or behind `from`, which is greater than 0, and does
/// not go on the one before; the size of the file if there is none.
std::size_t nextLine(const InputFile& file, std::size_t from, LineBlocks::Backslash backslash)
{
  PlainArray<char> bytes(bytesAtOnce);
  std::size_t first = from - std::min(from, bytesBefore);
  std::size_t searched = from - 1; // the '\n' before the line
  while (searched < file.size())
  {
    const std::size_t count = std::min(bytes.size(), file.size() - first);
    file.readText(first, bytes.data(), count);
    const char* const end = bytes.data() + count;
    const char* at = bytes.data() + (searched - first);
    while (at < end && (at = static_cast<const char*>(
                          std::memchr(at, '\n', static_cast<std::size_t>(end - at)))))
    {
      if (backslash == LineBlocks::Backslash::isLetter || !goesOn(bytes.data(), at))
      {
        return first + static_cast<std::size_t>(at - bytes.data()) + 1;
      }
      ++at;
    }
    searched = first + count;
    first = searched - std::min(searched, bytesBefore);
  }
  return file.size();
}

/// Whether a comment begins between `at`, where a word may begin, and `end`.
bool hasComment(const char* at, const char* end)
{
  std::string_view word;
  do
  {
    word = takeWord(at, end);
  } while (!word.empty() && word[0] != '#');
  return !word.empty();
}

/// Writes blanks for the backslashes that join lines in `text`, and for the ends of these lines.
/// The last of `size` bytes is the end of a line, and stays.
void joinLines(char* text, std::size_t size)
{
  char* const last = text + size - 1;
  char* known = text; // before it all is joined
  char* at = text;
  while (at < last &&
         (at = static_cast<char*>(std::memchr(at, '\\', static_cast<std::size_t>(last - at)))))
  {
    char* const backslash = at++;
    char* const end = at + (*at == '\r' ? 1 : 0);
    if (*end != '\n')
    {
      continue;
    }
    const char* start = backslash;
    while (start > known && start[-1] != '\n')
    {
      --start;
    }
    if (!hasComment(start, backslash))
    {
      std::fill(backslash, std::min(end + 1, last), ' ');
    }
    known = at = end + 1;
  }
}

} // namespace

LineBlocks::LineBlocks(
  const InputFile& file, std::size_t start, std::size_t bytesPerBlock, Backslash backslash)
  : file_(&file)
  , backslash_(backslash)
  , starts_{std::max(start, file.textStart())}
{
  while (starts_.back() < file.size())
  {
    const std::size_t from = starts_.back() + bytesPerBlock;
    starts_.push_back(from < file.size() ? nextLine(file, from, backslash) : file.size());
  }
}

TextBlock LineBlocks::read(std::size_t block) const
{
  const std::size_t first = starts_[block], size = starts_[block + 1] - first;
  char last = '\n';
  file_->readText(first + size - 1, &last, 1);
  PlainArray<char> bytes(size + (last != '\n' ? 1 : 0));
  file_->readText(first, bytes.data(), size);
  bytes[bytes.size() - 1] = '\n'; // the file may change between both readings
  if (backslash_ == Backslash::joinsLines)
  {
    joinLines(bytes.data(), bytes.size());
  }
  return {std::move(bytes), first};
}

} // namespace winding
