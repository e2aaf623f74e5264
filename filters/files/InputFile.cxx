// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/InputFile.h"

#include "files/Words.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace winding
{

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 18;

/// Whether the first bytes of a file are text in UTF-16: many of its pairs of bytes have one that
/// is 0, the same one of each pair. Without a byte order mark all have.
bool isUtf16(std::string_view head)
{
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < head.size(); ++i)
  {
    zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  }
  const std::size_t pairs = head.size() / 2, found = std::max(zeros[0], zeros[1]);
  const std::string_view mark = head.substr(0, 2);
  return mark == "\xFE\xFF" || mark == "\xFF\xFE"
           ? 4 * found > pairs && found > 2 * std::min(zeros[0], zeros[1])
           : pairs > 1 && found == pairs && std::min(zeros[0], zeros[1]) == 0;
}

} // namespace

InputFile::InputFile(const char* name, const Unpack& unpack)
  : name_(name ? name : "")
  , handle_(name_)
{
  if (name_.empty())
  {
    throw FileRefusal(FileFault::noName, "no file name is set; call SetFileName");
  }
  switch (handle_.answer())
  {
  case FileAnswer::opened:
    break;
  case FileAnswer::notFound:
    this->refuse("no such file", FileFault::notFound);
  case FileAnswer::isFolder:
    this->refuse("is a directory, not a file", FileFault::cannotOpen);
  case FileAnswer::isSpecial:
    this->refuse("is a pipe, a device or a socket; give a regular file", FileFault::cannotOpen);
  case FileAnswer::cannotOpen:
    this->refuse("cannot be opened; check its permissions", FileFault::cannotOpen);
  }
  if (handle_.size() == 0)
  {
    this->refuse("is empty", FileFault::ends);
  }
  if (this->unpackedName() != name_)
  {
    if (!unpack)
    {
      this->refuse("is packed by gzip; unpack it first");
    }
    content_ = unpack(*this);
    if (content_.empty())
    {
      this->refuse("is empty when it is unpacked", FileFault::ends);
    }
  }
  char head[256];
  const std::size_t count = std::min(sizeof head, this->size());
  this->read(0, head, count);
  if (isUtf16({head, count}))
  {
    this->refuse("is text in UTF-16; save it as UTF-8");
  }
}

std::string InputFile::unpackedName() const
{
  constexpr std::string_view packed = ".gz";
  const std::size_t rest = name_.size() - std::min(name_.size(), packed.size());
  return inSmallLetters(name_.substr(rest)) == packed ? name_.substr(0, rest) : name_;
}

void InputFile::read(std::size_t offset, char* bytes, std::size_t count) const
{
  if (!content_.empty())
  {
    if (offset > content_.size() || count > content_.size() - offset)
    {
      this->refuse("cannot be read to its end", FileFault::ends);
    }
    std::copy_n(content_.data() + offset, count, bytes);
    return;
  }
  while (count > 0)
  {
    const std::size_t taken = handle_.read(offset, bytes, count);
    if (taken == 0)
    {
      this->refuse("cannot be read to its end", FileFault::ends);
    }
    offset += taken;
    bytes += taken;
    count -= taken;
  }
}

void InputFile::readText(std::size_t offset, char* bytes, std::size_t count) const
{
  this->read(offset, bytes, count);
  if (count == 0 || !std::memchr(bytes, '\r', count))
  {
    return;
  }
  char behind = ' ';
  if (bytes[count - 1] == '\r' && offset + count < this->size())
  {
    this->read(offset + count, &behind, 1);
  }
  for (std::size_t i = 0; i + 1 < count; ++i) // without branches, for vectors
  {
    const bool isLone = (bytes[i] == '\r') & (bytes[i + 1] != '\n');
    bytes[i] = isLone ? '\n' : bytes[i];
  }
  if (bytes[count - 1] == '\r' && behind != '\n')
  {
    bytes[count - 1] = '\n';
  }
}

std::size_t InputFile::textStart() const
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  char first[mark.size()] = {};
  this->read(0, first, std::min(sizeof first, this->size()));
  return std::string_view(first, sizeof first) == mark ? mark.size() : 0;
}

std::size_t InputFile::lineOf(std::size_t offset) const
{
  PlainArray<char> bytes(std::min(bytesAtOnce, this->size()));
  std::size_t line = 1;
  for (std::size_t first = 0; first < offset; first += bytes.size())
  {
    const std::size_t count = std::min(bytes.size(), offset - first);
    this->readText(first, bytes.data(), count);
    line += static_cast<std::size_t>(std::count(bytes.data(), bytes.data() + count, '\n'));
  }
  return line;
}

void InputFile::refuse(const std::string& message, FileFault fault) const
{
  throw FileRefusal(fault, name_ + ": " + message);
}

void InputFile::refuseLine(std::size_t offset, const std::string& message) const
{
  this->refuse("line " + std::to_string(this->lineOf(offset)) + ": " + message);
}

void InputFile::refuseEnd(const std::string& message) const
{
  this->refuse("ends at line " + std::to_string(this->lineOf(this->size() - 1)) + ": " + message,
    FileFault::ends);
}

void InputFile::refuseChanged() const
{
  this->refuse("has changed while it was read; read it again");
}

} // namespace winding
