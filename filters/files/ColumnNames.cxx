#include "files/ColumnNames.h"

#include <algorithm>

namespace winding
{

namespace
{

/// A text with small letters for capital ones, of those that ASCII has.
std::string inSmallLetters(std::string text)
{
  for (char& c : text)
  {
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return text;
}

/// The first columns of these names, in small letters or large ones; none where one is missing.
std::vector<std::size_t> columnsNamed(
  const std::vector<std::string>& wanted, const std::vector<std::string>& names)
{
  std::vector<std::size_t> columns;
  for (const std::string& name : wanted)
  {
    const auto found = std::find_if(names.begin(), names.end(),
      [&name](const std::string& other) { return inSmallLetters(other) == name; });
    if (found == names.end())
    {
      return {};
    }
    columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
}

} // namespace

std::vector<std::size_t> columnsOf(ColumnMeaning meaning, const std::vector<std::string>& names)
{
  // The names by ParaView and by others; a table may have both.
  std::vector<std::string> saved, usual = {"area"};
  if (meaning == ColumnMeaning::positions)
  {
    saved = {"points:0", "points:1", "points:2"};
    usual = {"x", "y", "z"};
  }
  else if (meaning == ColumnMeaning::normals)
  {
    saved = {"normals:0", "normals:1", "normals:2"};
    usual = {"nx", "ny", "nz"};
  }
  const std::vector<std::size_t> columns = columnsNamed(saved, names);
  return columns.empty() ? columnsNamed(usual, names) : columns;
}

std::vector<std::string> namesOfArrays(const std::vector<std::size_t>& columns,
  const std::vector<std::string>& names, std::set<std::string> taken)
{
  std::vector<std::string> own(columns.size());
  const auto nameOf = [&](std::size_t i)
  {
    return std::string(names[columns[i]].c_str()); // names of arrays end at a zero byte
  };
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const std::string name = nameOf(i);
    if (!name.empty() && taken.insert(name).second)
    {
      own[i] = name;
    }
  }
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    if (own[i].empty())
    {
      const std::string name = nameOf(i);
      own[i] = name.empty() ? "Column" : name;
      do
      {
        own[i] += ' ' + std::to_string(columns[i] + 1);
      } while (!taken.insert(own[i]).second);
    }
  }
  return own;
}

} // namespace winding
