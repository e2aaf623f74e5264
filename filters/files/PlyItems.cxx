// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyItems.h"

#include "files/OrderedBlocks.h"
#include "files/PlainArray.h"
#include "files/PlyNumbers.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The numbers of a block stay in the caches from one column to the next.
constexpr std::size_t bytesPerBlock = 1 << 18;

/// Thrown where items are not like the first one.
struct NotUniform
{
};

} // namespace

PlyLayout::PlyLayout(const InputFile& file, PlyEncoding encoding, const PlyElement& element)
  : file_(file)
  , encoding_(encoding)
  , element_(element)
  , places_(element.properties.size())
{
}

std::size_t PlyLayout::lengthAt(const PlyProperty& property, const char* at) const
{
  if (*property.lengthType == PlyNumber::uint8)
  {
    // Nearly all files have these lengths, which are never too long.
    return static_cast<unsigned char>(*at);
  }
  const double value = plyNumberAt(*property.lengthType, encoding_, at);
  // Lengths of 2^62 and more, which floats can be, are beyond the bytes of any file.
  if (!(value >= 0 && value < 0x1p62) || value != std::floor(value))
  {
    refusePly(file_, badPlyLength(value));
  }
  return static_cast<std::size_t>(value);
}

bool PlyLayout::find(const char* at, const char* end)
{
  const auto size = static_cast<std::size_t>(end - at);
  std::size_t next = 0;
  for (std::size_t i = 0; i < places_.size(); ++i)
  {
    const PlyProperty& property = element_.properties[i];
    std::size_t length = 1;
    if (property.lengthType)
    {
      const std::size_t bytes = bytesOf(*property.lengthType);
      if (bytes > size - next)
      {
        return false;
      }
      length = this->lengthAt(property, at + next);
      next += bytes;
    }
    const std::size_t rest = size - next;
    if (length > rest || length * bytesOf(property.type) > rest)
    {
      return false;
    }
    places_[i] = {next, length};
    next += length * bytesOf(property.type);
  }
  bytes_ = next;
  return true;
}

bool PlyLayout::fits(const char* at, std::size_t count) const
{
  for (const PlyProperty& property : element_.properties)
  {
    if (property.lengthType)
    {
      const Place& list = this->place(property);
      const std::size_t offset = list.offset - bytesOf(*property.lengthType);
      const PlyColumn lengths = {at + offset, bytes_, count, *property.lengthType, encoding_};
      if (!areAll(lengths, static_cast<double>(list.length)))
      {
        return false;
      }
    }
  }
  return true;
}

PlyElementReader::PlyElementReader(const InputFile& file, PlyEncoding encoding,
  const PlyElement& element, const PlyProperty* list, std::size_t start)
  : file_(file)
  , encoding_(encoding)
  , element_(element)
  , list_(list)
  , first_(file, encoding, element)
  , hasLists_(std::any_of(element.properties.begin(), element.properties.end(),
      [](const PlyProperty& property) { return property.lengthType.has_value(); }))
  , blocks_{{start, 0, 0}}
{
}

void PlyElementReader::findEnd()
{
  areUniform_ = this->guessEnd();
  if (!areUniform_)
  {
    this->walk();
  }
}

bool PlyElementReader::guessEnd()
{
  const auto count = static_cast<std::size_t>(element_.count);
  const Block start = blocks_[0];
  if (count == 0)
  {
    return true;
  }
  const std::size_t rest = file_.size() - start.offset;
  PlainArray<char> bytes(std::min(std::max(bytesPerBlock, 8 * element_.properties.size()), rest));
  file_.read(start.offset, bytes.data(), bytes.size());
  const bool isKnown = first_.find(bytes.begin(), bytes.end());
  if (!isKnown || count > rest / first_.bytes())
  {
    if (!hasLists_)
    {
      refusePly(file_, "ends before the last of the " + std::to_string(count) + " items of " +
                         element_.name + " that it promises; it is truncated");
    }
    return false;
  }
  const std::size_t perBlock = std::max<std::size_t>(1, bytesPerBlock / first_.bytes());
  const std::size_t entries = list_ ? first_.place(*list_).length : 0;
  for (std::size_t item = 0; item < count;)
  {
    item = std::min(count, item + perBlock);
    blocks_.push_back({start.offset + item * first_.bytes(), item, item * entries});
  }
  return true;
}

void PlyElementReader::walk()
{
  const auto count = static_cast<std::size_t>(element_.count);
  blocks_.resize(1);
  Block at = blocks_[0];
  PlyLayout layout(file_, encoding_, element_);
  PlainArray<char> window(std::min(bytesPerBlock, file_.size() - at.offset));
  std::size_t windowStart = at.offset, windowEnd = at.offset;
  while (at.item < count)
  {
    const char* const bytes = window.data() + (at.offset - windowStart);
    if (layout.find(bytes, window.data() + (windowEnd - windowStart)))
    {
      at.offset += layout.bytes();
      at.entry += list_ ? layout.place(*list_).length : 0;
      ++at.item;
      if (at.offset - blocks_.back().offset >= bytesPerBlock)
      {
        blocks_.push_back(at);
      }
      continue;
    }
    if (windowEnd == file_.size())
    {
      refusePly(file_, "ends before its last item; it is truncated");
    }
    // An item that is longer than the window needs a longer one.
    const std::size_t size = windowStart == at.offset ? 2 * window.size() : window.size();
    const std::size_t taken = std::min(std::max(size, bytesPerBlock), file_.size() - at.offset);
    if (taken > window.size())
    {
      window = PlainArray<char>(taken);
    }
    file_.read(at.offset, window.data(), taken);
    windowStart = at.offset;
    windowEnd = at.offset + taken;
  }
  if (at.item > blocks_.back().item)
  {
    blocks_.push_back(at);
  }
}

bool PlyElementReader::read(const std::function<void(const PlyItems&)>& work, Executor& executor)
{
  try
  {
    runOrderedBlocks(
      blocks_.size() - 1, [&](std::size_t block) { this->readBlock(block, work); }, executor);
  }
  catch (const NotUniform&)
  {
    areUniform_ = false;
    this->walk();
    return false;
  }
  return true;
}

void PlyElementReader::passOver(Executor& executor)
{
  if (hasLists_ && areUniform_)
  {
    this->read([](const PlyItems&) {}, executor);
  }
}

void PlyElementReader::readBlock(
  std::size_t block, const std::function<void(const PlyItems&)>& work) const
{
  const Block first = blocks_[block], last = blocks_[block + 1];
  PlainArray<char> bytes(last.offset - first.offset);
  file_.read(first.offset, bytes.data(), bytes.size());
  if (areUniform_)
  {
    if (!first_.fits(bytes.data(), last.item - first.item))
    {
      throw NotUniform();
    }
    work({bytes.data(), last.item - first.item, first.item, first.entry, first_});
    return;
  }
  PlyLayout layout(file_, encoding_, element_);
  const char* at = bytes.data();
  std::size_t entry = first.entry;
  for (std::size_t item = first.item; item < last.item; ++item)
  {
    // The file may have changed since the places were found.
    if (!layout.find(at, bytes.end()) ||
        (list_ && layout.place(*list_).length > last.entry - entry))
    {
      file_.refuseChanged();
    }
    work({at, 1, item, entry, layout});
    at += layout.bytes();
    entry += list_ ? layout.place(*list_).length : 0;
  }
  if (entry != last.entry)
  {
    file_.refuseChanged();
  }
}

} // namespace winding
