#include "files/ColumnNames.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace winding
{

namespace
{

/// The meaning of a column: its name in small letters, and x, y and so on for ParaView's names.
std::string meaningOf(const std::string& name)
{
  std::string small(name);
  std::transform(small.begin(), small.end(), small.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  static const std::map<std::string, std::string> others = {{"points:0", "x"}, {"points:1", "y"},
    {"points:2", "z"}, {"normals:0", "nx"}, {"normals:1", "ny"}, {"normals:2", "nz"}};
  const auto other = others.find(small);
  return other == others.end() ? small : other->second;
}

} // namespace

std::vector<std::size_t> columnsOf(
  const std::vector<std::string>& meanings, const std::vector<std::string>& names)
{
  std::vector<std::size_t> columns;
  for (const std::string& meaning : meanings)
  {
    const auto found = std::find_if(names.begin(), names.end(),
      [&meaning](const std::string& name) { return meaningOf(name) == meaning; });
    if (found == names.end())
    {
      return {};
    }
    columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
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
