// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/LineScanner.h"

#include "files/Words.h"

#include <algorithm>
#include <cstring>

namespace winding
{

LineScanner::LineScanner(const InputFile& file, const TextBlock& block)
  : file_(file)
  , block_(block)
  , line_(block.text().data())
  , at_(line_)
  , end_(line_)
  , next_(line_)
  , last_(line_ + block.text().size())
{
}

bool LineScanner::nextLine()
{
  while (next_ < last_)
  {
    line_ = next_;
    const auto bytesFrom = [this](const char* end)
    {
      return static_cast<std::size_t>(end - line_);
    };
    const auto* const lineEnd =
      static_cast<const char*>(std::memchr(line_, '\n', bytesFrom(last_)));
    const auto commentFrom = [&](const char* at)
    {
      return static_cast<const char*>(std::memchr(at, '#', static_cast<std::size_t>(lineEnd - at)));
    };
    const char* comment = commentFrom(line_);
    while (comment && comment > line_ && comment[-1] == '.') // 1.#QNAN is a number (Words.h)
    {
      comment = commentFrom(comment + 1);
    }
    next_ = lineEnd + 1;
    end_ = comment ? comment : lineEnd;
    at_ = skipBlanks(line_, end_);
    if (at_ < end_)
    {
      return true;
    }
  }
  return false;
}

std::string_view LineScanner::word()
{
  return takeWord(at_, end_);
}

std::size_t LineScanner::wordsLeft() const
{
  return countWords(at_, end_);
}

bool LineScanner::tryNumber(double& value)
{
  return takeNumber(at_, end_, value);
}

double LineScanner::number(const char* what)
{
  double value = 0;
  if (!this->tryNumber(value))
  {
    this->refuseWord(what, "a number");
  }
  return value;
}

std::int64_t LineScanner::integer(const char* what)
{
  const char* next = at_;
  std::int64_t value = 0;
  if (!parseInteger(takeWord(next, end_), value))
  {
    this->refuseWord(what, "an integer");
  }
  at_ = next;
  return value;
}

std::int64_t LineScanner::count(const char* what, std::size_t bytesPerItem)
{
  const std::int64_t value = this->integer(what);
  if (value < 0)
  {
    this->refuse(std::string(what) + " is negative: " + std::to_string(value));
  }
  // The last item needs no end of line.
  const std::size_t rest = file_.size() - std::min(file_.size(), this->nextOffset()) + 1;
  if (static_cast<std::uint64_t>(value) > rest / bytesPerItem)
  {
    this->refuse(std::string(what) + " is " + std::to_string(value) +
                 ", more than the rest of the file can hold; it is truncated or damaged");
  }
  return value;
}

void LineScanner::refuse(const std::string& message) const
{
  file_.refuseLine(block_.offsetOf(line_), message);
}

void LineScanner::refuseWord(const char* what, const char* kind) const
{
  const char* next = at_;
  const std::string_view word = takeWord(next, end_);
  this->refuse(word.empty() ? std::string(what) + " is missing"
                            : shown(word) + " stands where " + what + " should, " + kind);
}

} // namespace winding
