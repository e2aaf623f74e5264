// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/RowScanner.h"

#include "files/Words.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace winding
{

namespace
{

std::string_view withoutBlanks(std::string_view field)
{
  while (!field.empty() && isBlank(field.front()))
  {
    field.remove_prefix(1);
  }
  while (!field.empty() && isBlank(field.back()))
  {
    field.remove_suffix(1);
  }
  return field;
}

bool isQuoted(std::string_view field)
{
  return field.size() >= 2 && field.front() == '"' && field.back() == '"';
}

} // namespace

RowScanner::RowScanner(std::string_view text, char separator)
  : row_(text.data())
  , at_(text.data())
  , end_(text.data() + text.size())
  , separator_(separator)
{
}

bool RowScanner::nextRow()
{
  for (const char* at = at_; at < end_; ++at)
  {
    if (*at == '\n')
    {
      at_ = at + 1;
    }
    else if (!isBlank(*at) || *at == separator_)
    {
      row_ = at_;
      state_ = RowState::hasMore;
      return true;
    }
  }
  return false;
}

bool RowScanner::nextField(std::string_view& field)
{
  if (state_ != RowState::hasMore)
  {
    return false;
  }
  const char* const first = at_;
  const char* at = this->skipBlanks(first);
  if (at < end_ && *at == '"')
  {
    this->passQuoted(at);
  }
  else
  {
    while (at < end_ && *at != separator_ && *at != '\n')
    {
      ++at;
    }
    this->endField(at);
  }
  if (state_ != RowState::hasMore && state_ != RowState::ended)
  {
    return false;
  }
  field = {first, static_cast<std::size_t>(at_ - 1 - first)};
  return true;
}

bool RowScanner::nextNumber(double& value)
{
  if (state_ != RowState::hasMore)
  {
    return false;
  }
  const auto result = std::from_chars(this->skipBlanks(at_), end_, value);
  if (result.ec == std::errc())
  {
    const char* const behind = this->skipBlanks(result.ptr);
    if (behind < end_ && (*behind == separator_ || *behind == '\n'))
    {
      hasDecimalPoints_ = hasDecimalPoints_ || std::find(at_, result.ptr, '.') != result.ptr;
      this->endField(behind);
      return true;
    }
  }
  const RowScanner before = *this;
  std::string_view field;
  if (this->nextField(field))
  {
    std::string number(contentOf(field));
    if (parseNumber(number, value))
    {
      return true;
    }
    const std::size_t comma = separator_ != ',' ? number.find(',') : std::string::npos;
    if (comma != std::string::npos && parseNumber(number.replace(comma, 1, "."), value))
    {
      hasDecimalCommas_ = true;
      return true;
    }
  }
  *this = before;
  return false;
}

bool RowScanner::passRow()
{
  for (std::string_view field; this->nextField(field);)
  {
  }
  return state_ == RowState::ended;
}

bool RowScanner::passLine()
{
  const auto length = static_cast<std::size_t>(end_ - at_);
  const auto* const end = static_cast<const char*>(std::memchr(at_, '\n', length));
  this->endField(end ? end : end_);
  return state_ == RowState::ended;
}

std::string_view RowScanner::row() const
{
  const char* last = at_ - 1; // the '\n'
  last -= last > row_ && last[-1] == '\r' ? 1 : 0;
  return {row_, static_cast<std::size_t>(last - row_)};
}

/// The first place from `at` on that is not blank, or a separator.
const char* RowScanner::skipBlanks(const char* at) const
{
  while (at < end_ && isBlank(*at) && *at != separator_)
  {
    ++at;
  }
  return at;
}

/// Ends a field where a separator, the end of the line or of the text stands.
void RowScanner::endField(const char* at)
{
  state_ = at == end_ ? RowState::cut : *at == '\n' ? RowState::ended : RowState::hasMore;
  at_ = at == end_ ? at : at + 1;
}

/// Passes over the field that begins with this quotation mark.
void RowScanner::passQuoted(const char* mark)
{
  const auto nextMark = [this](const char* from)
  {
    return static_cast<const char*>(std::memchr(from, '"', static_cast<std::size_t>(end_ - from)));
  };
  const char* close = nextMark(mark + 1);
  while (close && close + 1 < end_ && close[1] == '"')
  {
    close = nextMark(close + 2);
  }
  const char* const behind = close ? this->skipBlanks(close + 1) : end_;
  if (behind < end_ && *behind != separator_ && *behind != '\n')
  {
    state_ = RowState::broken;
    return;
  }
  this->endField(behind);
}

std::string_view contentOf(std::string_view field)
{
  field = withoutBlanks(field);
  return isQuoted(field) ? field.substr(1, field.size() - 2) : field;
}

std::string unquoted(std::string_view field)
{
  const std::string_view inner = contentOf(field);
  const bool marksAreDoubled = isQuoted(withoutBlanks(field));
  std::string text;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    text += inner[i];
    i += marksAreDoubled && inner[i] == '"' ? 1 : 0; // the second of two
  }
  return text;
}

} // namespace winding
