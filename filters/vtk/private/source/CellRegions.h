// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/Ranks.h"

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkFieldData;
class vtkPointSet;
class vtkStringArray;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * The regions of cells by an array, in the order of its values: integers, or texts, which are their
 * names. Integers of an array "…Ids" have the names that a string array "…Names" of the field data
 * holds at their places, as readers give objects, groups, materials and solids of files.
 */
class CellRegions
{
public:
  /// Looks at the cells `first` … `last` − 1. Ranks share values, and each has its own cells.
  /// Collective. Throws Refusal for an array that is not there, or does not say regions.
  CellRegions(vtkPointSet* data, vtkIdType first, vtkIdType last, const std::string& array,
    vtkFieldData* fields, Ranks& ranks);

  std::size_t size() const { return names_.size(); }

  /// Returns the values of the regions; nothing for texts.
  const std::vector<vtkIdType>& values() const { return values_; }

  /// The names of the regions: texts, or the array and the value.
  const std::vector<std::string>& names() const { return names_; }

  /// Gives out the cells of each region.
  std::vector<std::vector<vtkIdType>> takeCells() { return std::move(cells_); }

private:
  void findTexts(vtkStringArray* texts, vtkIdType first, vtkIdType last, Ranks& ranks);
  void findIntegers(vtkDataArray* integers, vtkIdType first, vtkIdType last,
    const std::string& array, vtkFieldData* fields, Ranks& ranks);

  std::vector<vtkIdType> values_;
  std::vector<std::string> names_;
  std::vector<std::vector<vtkIdType>> cells_;
};

/// Parts of a surface in regions that have names.
struct NamedParts
{
  std::vector<std::size_t> ofPart; ///< the region of each part
  std::vector<std::string> names;  ///< of regions, in the order of the file
};

/**
 * Returns the regions by which a file names `parts`, cells of a surface: the first of objects,
 * solids and groups that do not divide a part, or else its materials, if each part has one of its
 * own. Nothing if there are no names, or less than two regions. `divides` is set to the array of
 * names that divide parts, or stays.
 */
std::optional<NamedParts> namesOfParts(vtkPointSet* surface, vtkFieldData* fields,
  const std::vector<std::vector<vtkIdType>>& parts, std::string& divides);

/// Returns the texts of all ranks, rank by rank. Collective.
std::vector<std::string> gatherTexts(const std::vector<std::string>& own, Ranks& ranks);

} // namespace winding
