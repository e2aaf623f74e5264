#include "input/TableText.h"

#include <algorithm>

namespace
{

bool isSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view withoutSpaces(std::string_view field)
{
  while (!field.empty() && isSpace(field.front()))
  {
    field.remove_prefix(1);
  }
  while (!field.empty() && isSpace(field.back()))
  {
    field.remove_suffix(1);
  }
  return field;
}

bool isQuoted(std::string_view field)
{
  return field.size() >= 2 && field.front() == '"' && field.back() == '"';
}

/// First place from `at` on that is no space within a field.
std::size_t skipSpaces(std::string_view text, char separator, std::size_t at)
{
  while (at < text.size() && isSpace(text[at]) && text[at] != separator)
  {
    ++at;
  }
  return at;
}

/// Moves from the first letter of a field to its end: a separator, the end of a line or of the
/// text. False where quotation marks are not as they should be.
bool passField(std::string_view text, char separator, std::size_t& at)
{
  const std::size_t first = skipSpaces(text, separator, at);
  const auto endFrom = [&](std::size_t from)
  {
    while (from < text.size() && text[from] != separator && text[from] != '\n')
    {
      ++from;
    }
    return from;
  };
  if (first >= text.size() || text[first] != '"')
  {
    at = endFrom(at);
    return true;
  }
  std::size_t mark = text.find('"', first + 1);
  while (mark < text.size() && mark + 1 < text.size() && text[mark + 1] == '"')
  {
    mark = text.find('"', mark + 2);
  }
  if (mark >= text.size())
  {
    return false;
  }
  at = skipSpaces(text, separator, mark + 1);
  return at == endFrom(at);
}

} // namespace

bool takeRow(std::string_view text, char separator, std::size_t& start, std::string_view& row)
{
  std::size_t at = start;
  while (passField(text, separator, at))
  {
    if (at < text.size() && text[at] == separator)
    {
      ++at;
      continue;
    }
    row = text.substr(start, at - start);
    if (!row.empty() && row.back() == '\r')
    {
      row.remove_suffix(1);
    }
    start = at + 1;
    return true;
  }
  return false;
}

bool RowFields::next(std::string_view& field)
{
  const std::size_t first = at_;
  if (first > row_.size() || !passField(row_, separator_, at_))
  {
    return false;
  }
  field = row_.substr(first, at_ - first);
  ++at_;
  return true;
}

std::vector<std::string_view> splitRow(std::string_view row, char separator)
{
  std::vector<std::string_view> fields;
  RowFields rest(row, separator);
  for (std::string_view field; rest.next(field);)
  {
    fields.push_back(field);
  }
  return fields;
}

std::string_view trimmed(std::string_view field)
{
  field = withoutSpaces(field);
  return isQuoted(field) ? field.substr(1, field.size() - 2) : field;
}

std::string unquoted(std::string_view field)
{
  const std::string_view inner = trimmed(field);
  const bool marksAreDoubled = isQuoted(withoutSpaces(field));
  std::string text;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    text += inner[i];
    i += marksAreDoubled && inner[i] == '"'; // the second of two
  }
  return text;
}
