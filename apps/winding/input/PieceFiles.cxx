// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/PieceFiles.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "program/Failure.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

namespace
{

/// An index is no longer than this number of bytes; what lies behind is not looked at.
constexpr std::size_t longestIndex = std::size_t(1) << 24;

/// The text before the name of a part in an index of this suffix; empty for files that are none.
std::string_view beforeName(const std::string& suffix)
{
  const std::pair<std::string_view, std::string_view> marks[] = {
    {".vtm", " file=\""}, {".pvtp", " Source=\""}, {".pvtu", " Source=\""}, {".gltf", "\"uri\""}};
  const auto* const mark = std::find_if(std::begin(marks), std::end(marks),
    [&suffix](const auto& pair) { return pair.first == suffix; });
  return mark == std::end(marks) ? std::string_view() : mark->second;
}

/// Replaces the entities of XML in a name.
std::string withoutEntities(std::string name)
{
  const std::pair<std::string_view, const char*> entities[] = {
    {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}};
  for (const auto& [entity, letter] : entities)
  {
    for (std::size_t at = 0; (at = name.find(entity, at)) != std::string::npos; ++at)
    {
      name.replace(at, entity.size(), letter);
    }
  }
  return name;
}

/// The names between quotation marks behind each of the marks in a text.
std::vector<std::string> namesIn(std::string_view text, std::string_view mark)
{
  std::vector<std::string> names;
  const bool isJson = mark.back() == '"' && mark.front() == '"';
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string_view::npos;)
  {
    at += mark.size();
    const std::size_t first = isJson ? text.find('"', at) + 1 : at;
    const std::size_t last = first == 0 ? std::string_view::npos : text.find('"', first);
    if (last == std::string_view::npos)
    {
      break;
    }
    const std::string name(text.substr(first, last - first));
    if (!isJson || name.rfind("data:", 0) != 0)
    {
      names.push_back(isJson ? withoutPercentCodes(name) : withoutEntities(name));
    }
    at = last;
  }
  return names;
}

void addPieces(const std::string& fileName, std::vector<std::string>& pieces)
{
  const std::string suffix = suffixOf(fileName);
  const std::string_view mark = beforeName(suffix);
  if (mark.empty())
  {
    return;
  }
  for (const std::string& name : namesIn(beginningOf(fileName, longestIndex), mark))
  {
    const std::string piece = (std::filesystem::path(fileName).parent_path() / name).string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(piece, error))
    {
      if (suffix == ".gltf")
      {
        continue; // pictures are not needed, and the reader misses what is
      }
      throw Failure(
        EXIT_REFUSED, fileName, "its part " + name + " is not there; put all of its files there");
    }
    if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end())
    {
      pieces.push_back(piece);
      addPieces(piece, pieces);
    }
  }
}

} // namespace

std::vector<std::string> pieceFilesOf(const std::string& fileName)
{
  std::vector<std::string> pieces;
  addPieces(fileName, pieces);
  return pieces;
}
