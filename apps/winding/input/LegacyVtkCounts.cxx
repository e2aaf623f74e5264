// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/LegacyVtkCounts.h"

#include "files/Text.h"
#include "program/Failure.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <utility>

namespace
{

/// Whether a word ends with a keyword, which is in small letters. Binary numbers may stand right
/// before a keyword.
bool endsWithKeyword(std::string_view word, std::string_view keyword)
{
  return word.size() >= keyword.size() &&
         std::equal(keyword.begin(), keyword.end(), word.end() - static_cast<long>(keyword.size()),
           [](char small, unsigned char c) { return small == std::tolower(c); });
}

/// A legacy file as text, with what it announces.
class Announcements
{
public:
  explicit Announcements(const std::string& fileName)
    : fileName_(fileName)
    , text_(contentsOf(fileName))
  {
    std::size_t start = 0;
    takeLine(text_, start); // the version
    takeLine(text_, start); // the title, which may be any
    start = std::min(start, text_.size());
    body_ = std::string_view(text_).substr(start);
    isText_ = endsWithKeyword(takeWord(body_), "ascii");
  }

  /// Throws Failure where the file does not announce `cells` cells with `ids` ids, or does not
  /// hold them.
  void requireCells(std::string_view keyword, vtkIdType cells, vtkIdType ids) const
  {
    // Before version 5 the second number counts the sizes of the cells, too; since then the first
    // one counts the offsets, one more than cells.
    const bool isFound = cells == 0 ? !this->announcesAny(keyword)
                                    : this->announces(keyword, {cells, cells + ids}, cells + ids) ||
                                        this->announces(keyword, {cells + 1, ids}, 0);
    if (!isFound)
    {
      throw Failure(EXIT_REFUSED, fileName_,
        "does not hold the " + std::string(keyword) +
          " that it announces; it is truncated or damaged");
    }
  }

  void requireTypes(vtkIdType cells) const
  {
    if (cells > 0 && !this->announces("cell_types", {cells}, cells))
    {
      throw Failure(EXIT_REFUSED, fileName_,
        "does not have a type for each of its cells; it is truncated or damaged");
    }
  }

private:
  /// Whether a keyword stands somewhere with these numbers behind it, and in files of text with so
  /// many integers behind these.
  bool announces(std::string_view keyword, std::initializer_list<vtkIdType> numbers,
    vtkIdType integersBehind) const
  {
    std::string_view text = body_;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
    {
      std::string_view rest = text;
      long long value = 0;
      const auto isNext = [&](vtkIdType number)
      {
        return parseInteger(takeWord(rest), value) && value == number;
      };
      if (endsWithKeyword(word, keyword) && std::all_of(numbers.begin(), numbers.end(), isNext))
      {
        for (vtkIdType i = 0; isText_ && i < integersBehind; ++i)
        {
          if (!parseInteger(takeWord(rest), value))
          {
            return false;
          }
        }
        return true;
      }
    }
    return false;
  }

  /// Whether a keyword stands somewhere with two numbers behind it on its line, the first of which
  /// is not 0. Arrays of the same name have their type on that line, too.
  bool announcesAny(std::string_view keyword) const
  {
    std::string_view text = body_;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
    {
      std::size_t start = 0;
      std::string_view line =
        endsWithKeyword(word, keyword) ? takeLine(text, start) : std::string_view();
      long long first = 0, second = 0;
      if (parseInteger(takeWord(line), first) && parseInteger(takeWord(line), second) &&
          first != 0 && takeWord(line).empty())
      {
        return true;
      }
    }
    return false;
  }

  std::string fileName_;
  std::string text_;
  std::string_view body_; ///< the text behind its first three lines
  bool isText_ = false;   ///< whether the numbers are text
};

void checkPolyData(const Announcements& file, vtkPolyData* polyData)
{
  const std::pair<const char*, vtkCellArray*> kinds[] = {{"vertices", polyData->GetVerts()},
    {"lines", polyData->GetLines()}, {"polygons", polyData->GetPolys()},
    {"triangle_strips", polyData->GetStrips()}};
  for (const auto& [keyword, cells] : kinds)
  {
    file.requireCells(keyword, cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  }
}

/// The number of ids of a grid's cells in a file, where a polyhedron is a list of its faces.
vtkIdType idsOf(vtkUnstructuredGrid* grid)
{
  vtkIdType ids = 0;
  vtkNew<vtkIdList> stream;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCellType(i) == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(i, stream);
      ids += stream->GetNumberOfIds();
    }
    else
    {
      ids += grid->GetCells()->GetCellSize(i);
    }
  }
  return ids;
}

} // namespace

void checkLegacyVtkCounts(const std::string& fileName, vtkPointSet* data)
{
  const Announcements file(fileName);
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkPolyData(file, polyData);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    file.requireCells("cells", grid->GetNumberOfCells(), idsOf(grid));
    file.requireTypes(grid->GetNumberOfCells());
  }
}
