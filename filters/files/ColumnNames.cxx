// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ColumnNames.h"

#include "files/Words.h"

#include <algorithm>
#include <iterator>

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

/// A name without what programs put between its words.
std::string withoutSeparators(std::string name)
{
  const auto isSeparator = [](char letter)
  {
    return std::string(" _.:-").find(letter) != std::string::npos;
  };
  name.erase(std::remove_if(name.begin(), name.end(), isSeparator), name.end());
  return name;
}

/// The first columns of these names, one for each component; none where one is missing. The first
/// synonym that is there counts, however its words are divided.
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
        [&name](const std::string& other)
        { return withoutSeparators(withoutUnit(other)) == withoutSeparators(*name); });
    }
    if (found == names.end())
    {
      return {};
    }
    columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
}

constexpr const char* components[] = {"x", "y", "z", "nx", "ny", "nz", "area", "vx", "vy", "vz"};

/// The components that belong together.
std::vector<std::string> componentsOf(ColumnMeaning meaning)
{
  return meaning == ColumnMeaning::positions    ? std::vector<std::string>{"x", "y", "z"}
         : meaning == ColumnMeaning::normals    ? std::vector<std::string>{"nx", "ny", "nz"}
         : meaning == ColumnMeaning::viewpoints ? std::vector<std::string>{"vx", "vy", "vz"}
                                                : std::vector<std::string>{"area"};
}

/// The number of the column that a user calls `name`; as many as there are columns where none is.
std::size_t columnCalled(const std::string& name, const std::vector<std::string>& names)
{
  auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    found = std::find_if(names.begin(), names.end(),
      [&name](const std::string& other) { return withoutUnit(other) == inSmallLetters(name); });
  }
  std::int64_t number = 0;
  const bool isNumber = found == names.end() && parseInteger(name, number) && number >= 1;
  return isNumber ? std::min(static_cast<std::size_t>(number - 1), names.size())
                  : static_cast<std::size_t>(found - names.begin());
}

/// Where a text has a component and an equality sign from `at` on; the end where it has none.
std::size_t nextChoice(const std::string& text, std::size_t at)
{
  for (; at < text.size(); ++at)
  {
    const std::size_t sign = text.find('=', at);
    const bool begins = at == 0 || std::string(" ,;").find(text[at - 1]) != std::string::npos;
    if (begins && sign != std::string::npos &&
        std::find(std::begin(components), std::end(components), text.substr(at, sign - at)) !=
          std::end(components))
    {
      return at;
    }
  }
  return text.size();
}

} // namespace

ColumnChoice::ColumnChoice(const std::string& text)
{
  const std::string separators = " ,;";
  const std::size_t start = std::min(text.find_first_not_of(separators), text.size());
  std::size_t at = nextChoice(text, start);
  bool isRight = at == start;
  while (isRight && at < text.size())
  {
    const std::size_t sign = text.find('=', at), end = nextChoice(text, sign);
    const std::string value = text.substr(sign + 1, end - sign - 1);
    const std::size_t last = value.find_last_not_of(separators);
    isRight = last != std::string::npos &&
              names_.emplace(text.substr(at, sign - at), value.substr(0, last + 1)).second;
    at = end;
  }
  if (!isRight)
  {
    throw Refusal("the columns " + shown(text) +
                  " are not like x=Easting y=Northing z=Height, each of x y z nx ny nz area vx vy "
                  "vz once at most, with the name or the number of a column");
  }
}

bool ColumnChoice::needsNoNames() const
{
  const std::vector<std::string> wanted = componentsOf(ColumnMeaning::positions);
  return std::all_of(wanted.begin(), wanted.end(),
    [this](const std::string& component)
    {
      const std::string* const name = this->of(component);
      return name && name->find_first_not_of("0123456789") == std::string::npos;
    });
}

const std::string* ColumnChoice::of(const std::string& component) const
{
  const auto found = names_.find(component);
  return found == names_.end() ? nullptr : &found->second;
}

void ColumnChoice::check(const InputFile& file, const std::vector<std::string>& names) const
{
  for (const auto& [component, name] : names_)
  {
    if (columnCalled(name, names) == names.size())
    {
      std::string all;
      for (std::size_t i = 0; i < names.size() && all.size() < 200; ++i)
      {
        all += (i > 0 ? ", " : "") + names[i];
      }
      file.refuse("has no column " + name + " for " + component + "; its columns are " + all);
    }
  }
  std::set<std::size_t> taken;
  for (const ColumnMeaning meaning : {ColumnMeaning::positions, ColumnMeaning::normals,
         ColumnMeaning::areas, ColumnMeaning::viewpoints})
  {
    for (const std::size_t column : columnsOf(meaning, names, *this))
    {
      if (!names_.empty() && !taken.insert(column).second)
      {
        file.refuse("column " + names[column] + " is taken twice; choose another one");
      }
    }
    const std::vector<std::string> wanted = componentsOf(meaning);
    const bool isAny = std::any_of(wanted.begin(), wanted.end(),
      [this](const std::string& component) { return this->of(component); });
    if (isAny && columnsOf(meaning, names, *this).empty())
    {
      file.refuse("has no columns for all of " + wanted[0] + ", " + wanted[1] + " and " +
                  wanted[2] + "; choose each");
    }
  }
}

std::vector<std::size_t> columnsOf(
  ColumnMeaning meaning, const std::vector<std::string>& names, const ColumnChoice& choice)
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
    usual = {{"nx", "normal_x", "normals_x", "normals_0", "normal_0"},
      {"ny", "normal_y", "normals_y", "normals_1", "normal_1"},
      {"nz", "normal_z", "normals_z", "normals_2", "normal_2"}};
  }
  else if (meaning == ColumnMeaning::viewpoints)
  {
    saved = {{"viewpoints:0"}, {"viewpoints:1"}, {"viewpoints:2"}};
    usual = {{"vp_x", "viewpoint_x"}, {"vp_y", "viewpoint_y"}, {"vp_z", "viewpoint_z"}};
  }
  std::vector<std::size_t> columns;
  const std::vector<std::string> wanted = componentsOf(meaning);
  bool isAnyChosen = false;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const std::string* const name = choice.of(wanted[i]);
    const std::vector<std::size_t> found =
      name ? std::vector<std::size_t>{columnCalled(*name, names)} : columnsNamed({usual[i]}, names);
    isAnyChosen = isAnyChosen || name;
    columns.push_back(found.empty() ? names.size() : found[0]);
  }
  if (isAnyChosen)
  {
    const bool areAll = *std::max_element(columns.begin(), columns.end()) < names.size();
    return areAll ? columns : std::vector<std::size_t>();
  }
  columns = columnsNamed(saved, names);
  return columns.empty() ? columnsNamed(usual, names) : columns;
}

std::vector<std::string> numberedColumns(std::size_t count)
{
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i)
  {
    names.push_back("Column " + std::to_string(i));
  }
  return names;
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
