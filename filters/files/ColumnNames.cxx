#include "files/ColumnNames.h"

#include "files/Words.h"

#include <algorithm>

namespace winding
{

namespace
{

/// The names that programs give to one component.
using Synonyms = std::vector<std::string>;

/// A name in small letters, without a unit in brackets behind it.
std::string withoutUnit(const std::string& name)
{
  const std::string part = inSmallLetters(name.substr(0, name.find_first_of("([")));
  return part.substr(0, part.find_last_not_of(' ') + 1);
}

/// The first columns of these names, one for each component; none where one is missing. The first
/// synonym that is there counts.
std::vector<std::size_t> columnsNamed(
  const std::vector<Synonyms>& wanted, const std::vector<std::string>& names)
{
  std::vector<std::size_t> columns;
  for (const Synonyms& synonyms : wanted)
  {
    auto found = names.end();
    for (auto name = synonyms.begin(); name != synonyms.end() && found == names.end(); ++name)
    {
      found = std::find_if(names.begin(), names.end(),
        [&name](const std::string& other) { return withoutUnit(other) == *name; });
    }
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
  std::vector<Synonyms> saved, usual = {{"area"}};
  if (meaning == ColumnMeaning::positions)
  {
    saved = {{"points:0"}, {"points:1"}, {"points:2"}};
    usual = {{"x", "easting", "east"}, {"y", "northing", "north"},
      {"z", "elevation", "height", "altitude"}};
  }
  else if (meaning == ColumnMeaning::normals)
  {
    saved = {{"normals:0"}, {"normals:1"}, {"normals:2"}};
    usual = {{"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}};
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
