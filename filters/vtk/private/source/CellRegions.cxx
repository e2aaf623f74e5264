// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/CellRegions.h"

#include "base/Digits.h"
#include "base/Parameter.h"
#include "base/Refusal.h"
#include "tasks/Sentences.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace winding
{

namespace
{

/// The array of regions. Throws Refusal if there is none of that name, or not for all cells.
vtkAbstractArray* regionsOf(vtkPointSet* data, const std::string& name)
{
  vtkAbstractArray* regions = data->GetCellData()->GetAbstractArray(name.c_str());
  if (!regions)
  {
    const bool isOfPoints = data->GetPointData()->HasArray(name.c_str()) != 0;
    throw Refusal(messageOf(isOfPoints ? Sentence::regionsOfPoints : Sentence::noRegions, {name}));
  }
  if (regions->GetNumberOfComponents() != 1 ||
      regions->GetNumberOfTuples() < data->GetNumberOfCells())
  {
    throw Refusal(messageOf(Sentence::otherRegionsLength, {name}));
  }
  if (!vtkDataArray::SafeDownCast(regions) && !vtkStringArray::SafeDownCast(regions))
  {
    throw Refusal(messageOf(Sentence::regionsOfOtherType, {name}));
  }
  return regions;
}

/// The region of a cell. Throws Refusal for what is no integer, or too large for one.
vtkIdType regionOf(vtkDataArray* regions, vtkIdType cell)
{
  constexpr double mostOfReal = 9007199254740992.0, most = 9223372036854775808.0; // 2⁵³ and 2⁶³
  const double value = regions->GetComponent(cell, 0);
  const bool isReal = regions->GetDataType() == VTK_FLOAT || regions->GetDataType() == VTK_DOUBLE;
  const bool isWhole = value == std::floor(value) && std::isfinite(value);
  if (!isWhole || !(std::abs(value) < (isReal ? mostOfReal : most)))
  {
    throw Refusal(messageOf(isWhole ? Sentence::regionIsTooLarge : Sentence::regionIsNoInteger,
      {regions->GetName(), joined(value), std::to_string(cell)}));
  }
  return isReal ? static_cast<vtkIdType>(value)
                : static_cast<vtkIdType>(regions->GetVariantValue(cell).ToLongLong());
}

/// The names of an array of regions "…Ids"; null if there are none.
vtkStringArray* namesOfIds(vtkFieldData* fields, const std::string& array)
{
  const std::string ending = "Ids";
  if (!fields || array.size() < ending.size() ||
      array.compare(array.size() - ending.size(), ending.size(), ending) != 0)
  {
    return nullptr;
  }
  const std::string names = array.substr(0, array.size() - ending.size()) + "Names";
  return vtkStringArray::SafeDownCast(fields->GetAbstractArray(names.c_str()));
}

/// The names by label that results of vtkWindingNumberLabels have; null if there are none.
vtkSmartPointer<vtkStringArray> namesOfLabels(vtkFieldData* fields)
{
  vtkDataArray* const values = fields ? fields->GetArray("LabelValues") : nullptr;
  auto* const names =
    vtkStringArray::SafeDownCast(fields ? fields->GetAbstractArray("LabelNames") : nullptr);
  if (!values || !names || values->GetNumberOfTuples() != names->GetNumberOfValues())
  {
    return nullptr;
  }
  constexpr double most = 65535;
  auto byLabel = vtkSmartPointer<vtkStringArray>::New();
  vtkIdType i = 0;
  for (const double value : vtk::DataArrayValueRange(values))
  {
    if (value >= 0 && value <= most)
    {
      byLabel->InsertValue(static_cast<vtkIdType>(value), names->GetValue(i));
    }
    ++i;
  }
  return byLabel;
}

std::string nameOf(vtkIdType value, const std::string& array, vtkStringArray* names)
{
  const std::string name =
    names && value >= 0 && value < names->GetNumberOfValues() ? names->GetValue(value) : "";
  return name.empty() ? array + " " + std::to_string(value) : name;
}

} // namespace

CellRegions::CellRegions(vtkPointSet* data, vtkIdType first, vtkIdType last,
  const std::string& array, vtkFieldData* fields, Ranks& ranks)
{
  vtkAbstractArray* regions = nullptr;
  const auto kinds = ranks.allGather(
    [&]() -> Ranks::Number
    {
      regions = data->GetNumberOfCells() > 0 ? regionsOf(data, array) : nullptr;
      return !regions ? 0 : vtkStringArray::SafeDownCast(regions) ? 1 : 2;
    });
  const bool areTexts = std::count(kinds.begin(), kinds.end(), 1) > 0;
  if (areTexts && std::count(kinds.begin(), kinds.end(), 2) > 0)
  {
    throw Refusal(messageOf(Sentence::regionsOfTwoTypes, {array}));
  }
  if (areTexts)
  {
    this->findTexts(vtkStringArray::SafeDownCast(regions), first, last, ranks);
  }
  else
  {
    this->findIntegers(vtkDataArray::SafeDownCast(regions), first, last, array, fields, ranks);
  }
}

void CellRegions::findTexts(vtkStringArray* texts, vtkIdType first, vtkIdType last, Ranks& ranks)
{
  std::map<std::string, std::vector<vtkIdType>> cells;
  for (vtkIdType cell = first; texts && cell < last; ++cell)
  {
    cells[texts->GetValue(cell)].push_back(cell);
  }
  std::vector<std::string> own;
  for (const auto& [text, ids] : cells)
  {
    own.push_back(text);
  }
  const std::vector<std::string> ofAll = gatherTexts(own, ranks);
  for (const std::string& text : std::set<std::string>(ofAll.begin(), ofAll.end()))
  {
    names_.push_back(text.empty() ? "(no text)" : text);
    cells_.push_back(std::move(cells[text]));
  }
}

void CellRegions::findIntegers(vtkDataArray* integers, vtkIdType first, vtkIdType last,
  const std::string& array, vtkFieldData* fields, Ranks& ranks)
{
  std::map<vtkIdType, std::vector<vtkIdType>> cells;
  std::vector<vtkIdType> own;
  std::vector<std::string> names;
  const vtkSmartPointer<vtkStringArray> ofLabels = namesOfLabels(fields);
  vtkStringArray* const ofIds = namesOfIds(fields, array);
  ranks.agree(
    [&]
    {
      for (vtkIdType cell = first; integers && cell < last; ++cell)
      {
        cells[regionOf(integers, cell)].push_back(cell);
      }
      for (const auto& [region, ids] : cells)
      {
        own.push_back(region);
        names.push_back(nameOf(region, array, ofIds ? ofIds : ofLabels.Get()));
      }
    });
  const std::vector<vtkIdType> ofAll = ranks.gather(own, false).numbers;
  const std::vector<std::string> namesOfAll = gatherTexts(names, ranks);
  std::map<vtkIdType, std::string> regions;
  for (std::size_t i = 0; i < ofAll.size(); ++i)
  {
    regions.emplace(ofAll[i], namesOfAll[i]);
  }
  for (const auto& [region, name] : regions)
  {
    values_.push_back(region);
    names_.push_back(name);
    cells_.push_back(std::move(cells[region]));
  }
}

std::optional<NamedParts> namesOfParts(vtkPointSet* surface, vtkFieldData* fields,
  const std::vector<std::vector<vtkIdType>>& parts, std::string& divides)
{
  for (const std::string kind : {"Object", "Solid", "Group", "Material"})
  {
    const std::string array = kind + "Ids";
    vtkDataArray* const ids = surface->GetCellData()->GetArray(array.c_str());
    vtkStringArray* const names = namesOfIds(fields, array);
    if (!ids || !names || ids->GetNumberOfTuples() < surface->GetNumberOfCells())
    {
      continue;
    }
    std::vector<vtkIdType> ofPart;
    std::set<vtkIdType> regions;
    bool isDivided = false;
    for (const std::vector<vtkIdType>& cells : parts)
    {
      ofPart.push_back(regionOf(ids, cells[0]));
      regions.insert(ofPart.back());
      isDivided =
        isDivided || std::any_of(cells.begin(), cells.end(),
                       [&](vtkIdType cell) { return regionOf(ids, cell) != ofPart.back(); });
    }
    if (isDivided)
    {
      divides = divides.empty() ? array : divides;
      continue;
    }
    if (regions.size() < 2)
    {
      continue;
    }
    NamedParts result;
    if (kind == "Material" && regions.size() < parts.size())
    {
      // Bodies of one material are still bodies of their own, and get numbers from the second on.
      std::map<vtkIdType, int> counts;
      for (const vtkIdType region : ofPart)
      {
        const int count = ++counts[region];
        result.ofPart.push_back(result.names.size());
        result.names.push_back(
          nameOf(region, kind, names) + (count > 1 ? " " + std::to_string(count) : ""));
      }
      return result;
    }
    for (const vtkIdType region : regions)
    {
      result.names.push_back(nameOf(region, kind, names));
    }
    for (const vtkIdType region : ofPart)
    {
      result.ofPart.push_back(
        static_cast<std::size_t>(std::distance(regions.begin(), regions.find(region))));
    }
    return result;
  }
  return std::nullopt;
}

std::vector<std::string> gatherTexts(const std::vector<std::string>& own, Ranks& ranks)
{
  if (ranks.isAlone())
  {
    return own;
  }
  std::vector<int> letters;
  for (const std::string& text : own)
  {
    letters.insert(letters.end(), text.begin(), text.end());
    letters.push_back('\0');
  }
  std::vector<std::string> all(1);
  for (const int letter : ranks.gather(letters, false).numbers)
  {
    if (letter == '\0')
    {
      all.emplace_back();
    }
    else
    {
      all.back() += static_cast<char>(letter);
    }
  }
  all.pop_back();
  return all;
}

} // namespace winding
