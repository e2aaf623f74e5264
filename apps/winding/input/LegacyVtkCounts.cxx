#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
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
bool endsWith(std::string_view word, std::string_view keyword)
{
  return word.size() >= keyword.size() &&
         std::equal(keyword.begin(), keyword.end(), word.end() - static_cast<long>(keyword.size()),
           [](char small, unsigned char c) { return small == std::tolower(c); });
}

/// Whether a keyword stands somewhere in a file with these numbers behind it.
bool announces(
  std::string_view text, std::string_view keyword, std::initializer_list<vtkIdType> numbers)
{
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
  {
    std::string_view rest = text;
    long long value = 0;
    if (endsWith(word, keyword) &&
        std::all_of(numbers.begin(), numbers.end(),
          [&](vtkIdType number) { return parseInteger(takeWord(rest), value) && value == number; }))
    {
      return true;
    }
  }
  return false;
}

/// Throws Failure where a file does not announce so many cells with so many ids.
void requireAnnouncement(const std::string& fileName, std::string_view text,
  std::string_view keyword, vtkIdType cells, vtkIdType ids)
{
  // Before version 5 the second number counts the sizes of the cells, too; since then the first one
  // counts the offsets, of which there is one more.
  if (cells > 0 && !announces(text, keyword, {cells, cells + ids}) &&
      !announces(text, keyword, {cells + 1, ids}))
  {
    throw Failure(REFUSED, fileName,
      "does not hold the " + std::string(keyword) +
        " that it announces; it is truncated or damaged");
  }
}

void checkPolyData(const std::string& fileName, std::string_view text, vtkPolyData* polyData)
{
  const std::pair<const char*, vtkCellArray*> kinds[] = {{"vertices", polyData->GetVerts()},
    {"lines", polyData->GetLines()}, {"polygons", polyData->GetPolys()},
    {"triangle_strips", polyData->GetStrips()}};
  for (const auto& [keyword, cells] : kinds)
  {
    requireAnnouncement(
      fileName, text, keyword, cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
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

void checkGrid(const std::string& fileName, std::string_view text, vtkUnstructuredGrid* grid)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells > 0)
  {
    requireAnnouncement(fileName, text, "cells", cells, idsOf(grid));
  }
  if (cells > 0 && !announces(text, "cell_types", {cells}))
  {
    throw Failure(
      REFUSED, fileName, "does not have a type for each of its cells; it is truncated or damaged");
  }
}

} // namespace

void checkLegacyVtkCounts(const std::string& fileName, vtkPointSet* data)
{
  const std::string text = contentsOf(fileName);
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkPolyData(fileName, text, polyData);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    checkGrid(fileName, text, grid);
  }
}
