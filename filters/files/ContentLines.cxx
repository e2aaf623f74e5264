// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ContentLines.h"

#include "files/OrderedBlocks.h"

#include <algorithm>

namespace winding
{

ContentLines::Part::Part(const InputFile& file, const LineScanner& lines, std::size_t blockFirst,
  std::size_t blockLast, std::size_t first, std::size_t last)
  : file_(file)
  , lines_(lines)
  , next_(blockFirst)
  , blockLast_(blockLast)
  , first_(first)
  , last_(last)
{
}

bool ContentLines::Part::nextLine()
{
  while (next_ < std::min(last_, blockLast_))
  {
    if (!lines_.nextLine())
    {
      file_.refuseChanged();
    }
    if (next_++ >= first_)
    {
      return true;
    }
  }
  return false;
}

ContentLines::ContentLines(const InputFile& file, Executor& executor, const Letters& letters)
  : file_(file)
  , blocks_(file)
  , letters_(letters)
  , starts_(blocks_.count() + 1)
{
  runOrderedBlocks(
    blocks_.count(),
    [this](std::size_t block)
    {
      const TextBlock text = this->read(block);
      for (LineScanner lines(file_, text); lines.nextLine();)
      {
        ++starts_[block + 1];
      }
    },
    executor);
  for (std::size_t block = 0; block < blocks_.count(); ++block)
  {
    starts_[block + 1] += starts_[block];
  }
}

TextBlock ContentLines::read(std::size_t block) const
{
  TextBlock text = blocks_.read(block);
  text.replace(',', letters_.comma);
  text.replace(';', letters_.semicolon);
  return text;
}

void ContentLines::visit(std::size_t first, std::size_t last,
  const std::function<void(std::size_t block, Part& part)>& work, Executor& executor) const
{
  const auto blockOf = [this](std::size_t line)
  {
    return static_cast<std::size_t>(
      std::upper_bound(starts_.begin(), starts_.end(), line) - starts_.begin() - 1);
  };
  const std::size_t firstBlock = blockOf(first);
  const std::size_t blocks = first < last ? blockOf(last - 1) + 1 - firstBlock : 0;
  runOrderedBlocks(
    blocks,
    [&](std::size_t index)
    {
      const std::size_t block = firstBlock + index;
      const TextBlock text = this->read(block);
      Part part(file_, LineScanner(file_, text), starts_[block], starts_[block + 1], first, last);
      work(block, part);
    },
    executor);
}

bool FirstLines::nextLine()
{
  while (!words_ || !words_->nextLine())
  {
    if (nextBlock_ == lines_.blocks())
    {
      return false;
    }
    text_.emplace(lines_.read(nextBlock_++));
    words_.emplace(lines_.file_, *text_);
  }
  return true;
}

} // namespace winding
