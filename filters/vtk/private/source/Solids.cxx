// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/Solids.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "pipeline/VtkVersions.h"
#include "private/source/CellChecks.h"
#include "private/source/CellRegions.h"
#include "private/source/ContentHash.h"
#include "private/source/RegionCells.h"
#include "private/source/SolidBlocks.h"
#include "private/source/SourceParts.h"
#include "tasks/Sentences.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>
#include <utility>

namespace winding
{

namespace
{

unsigned short labelOf(double number, const std::string& what, const Remedy& remedy)
{
  if (!(number >= 1 && number <= largestLabel))
  {
    throw Refusal(Message("labels are 1 to 65535", {remedy},
      what + " would get " + std::to_string(static_cast<long long>(number))));
  }
  return static_cast<unsigned short>(number);
}

/// The data set as cells that regions can be made of: without ghosts, and with ids that may be
/// followed unless it is polydata.
vtkSmartPointer<vtkPointSet> checkedCells(vtkPointSet* data, bool takesFaces, CellCounts& counts)
{
  const std::string name = "the source";
  if (vtkPolyData::SafeDownCast(data))
  {
    checkStructure(data, name);
  }
  else
  {
    checkCells(data, name);
  }
  checkArrays(data, name);
  return ownPartOf(data, takesFaces, name, counts);
}

/// A hash of points and cells; 0 where there are no points.
Ranks::Number hashOf(vtkPointSet* data)
{
  if (data->GetNumberOfPoints() == 0)
  {
    return 0;
  }
  ContentHash hash;
  hash.addArray(data->GetPoints()->GetData());
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    hash.addCells(polygons->GetPolys());
    hash.addCells(polygons->GetStrips());
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    hash.addArray(cellTypesOf(grid));
    hash.addCells(grid->GetCells());
  }
  return std::max<Ranks::Number>(1, hash.value());
}

/// Whether a data set is whole on each rank that has any of it: on one, or on all.
bool isWhole(vtkPointSet* data, Ranks& ranks)
{
  const std::vector<Ranks::Number> hashes = ranks.allGather([data] { return hashOf(data); });
  const auto empty = std::count(hashes.begin(), hashes.end(), 0);
  return empty + 1 >= static_cast<std::ptrdiff_t>(hashes.size()) || areEqual(hashes);
}

} // namespace

Solids::Solids(vtkDataObject* input, const SolidOptions& options, Ranks& ranks, Executor& executor)
  : asPoints_(options.asPoints)
{
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    this->addBlocks(input, ranks);
  }
  else
  {
    auto* data = vtkPointSet::SafeDownCast(input);
    ranks.agree(
      [&]
      {
        checkSolids(input, options.asPoints);
        data_ = checkedCells(data, options.takesFaces, counts_);
      });
    // Lists of arrays in ParaView have the entry None, which arrives here as a name.
    const bool isNone = options.regionArray == "None" && !data_->GetCellData()->HasArray("None");
    const bool isOfParts = options.regionArray.empty() || isNone;
    // Regions of other data sets are sources, and count their own cells.
    if (!asPoints_ && hasFaces(data) && (isOfParts || vtkPolyData::SafeDownCast(data)))
    {
      countLoose(data, counts_);
    }
    if (isOfParts)
    {
      this->addParts(data_, input->GetFieldData(), options, ranks, executor);
    }
    else
    {
      this->addRegions(data_, input->GetFieldData(), options, ranks);
    }
  }
  this->makeNamesUnique();
}

void Solids::addBlocks(vtkDataObject* composite, Ranks& ranks)
{
  std::vector<SolidBlock> blocks = solidBlocksOf(composite);
  const bool areAsMany =
    areEqual(ranks.allGather([&]() -> Ranks::Number { return blocks.size(); }));
  if (!areAsMany)
  {
    throw Refusal(messageOf(Sentence::otherBlocksOnRanks));
  }
  for (SolidBlock& block : blocks)
  {
    labels_.push_back(labelOf(static_cast<double>(labels_.size() + 1), "block '" + block.name + "'",
      {"extract fewer blocks", {}}));
    names_.push_back(block.name);
    blocks_.push_back(block.source);
  }
}

void Solids::addRegions(
  vtkPointSet* data, vtkFieldData* fields, const SolidOptions& options, Ranks& ranks)
{
  const auto [first, last] = facesOf(data);
  CellRegions regions(data, first, last, options.regionArray, fields, ranks);
  const std::vector<vtkIdType>& values = regions.values();
  const bool areLabels = !values.empty() && values.front() + options.labelOffset >= 1 &&
                         values.back() + options.labelOffset <= largestLabel;
  areNumbered_ = !values.empty() && !areLabels && options.labelOffset == 0;
  const bool areCounted = values.empty() || areNumbered_;
  areOffset_ = !areCounted;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    const std::string what =
      areCounted ? "region '" + regions.names()[i] + "'"
                 : "region " + std::to_string(values[i]) + " of '" + options.regionArray + "'";
    labels_.push_back(labelOf(areCounted ? static_cast<double>(i + 1)
                                         : static_cast<double>(values[i]) + options.labelOffset,
      what, {"choose another offset", {Parameter::labelOffset}}));
  }
  names_ = regions.names();
  parts_.cells = regions.takeCells();
}

void Solids::addParts(vtkPointSet* data, vtkFieldData* fields, const SolidOptions& options,
  Ranks& ranks, Executor& executor)
{
  if (!ranks.isAlone() && !isWhole(data, ranks))
  {
    throw Refusal(messageOf(Sentence::solidsInPartsOnRanks));
  }
  std::vector<std::string> names;
  ranks.agree(
    [&]
    {
      this->findParts(data, options, executor);
      names = this->nameParts(fields);
      if (!parts_.cells.empty())
      {
        // They are left out and counted where the field of the first solid is built.
        std::vector<vtkIdType>& first = parts_.cells[0];
        first.insert(first.end(), parts_.unusable.begin(), parts_.unusable.end());
      }
    });
  // Ranks that have the surface have the same names, and others have none.
  const auto counts = ranks.allGather([&]() -> Ranks::Number { return names.size(); });
  const std::vector<std::string> ofAll = gatherTexts(names, ranks);
  const auto count = static_cast<std::size_t>(*std::max_element(counts.begin(), counts.end()));
  names_.assign(ofAll.begin(), ofAll.begin() + static_cast<std::ptrdiff_t>(count));
  parts_.cells.resize(count);
  for (std::size_t i = 1; i <= count; ++i)
  {
    labels_.push_back(static_cast<unsigned short>(i));
  }
}

/// Returns the names of the parts, once parts that the file names alike are one.
std::vector<std::string> Solids::nameParts(vtkFieldData* fields)
{
  std::vector<std::string> names;
  if (const auto named = namesOfParts(data_, fields, parts_.cells, dividingNames_))
  {
    SolidCells solids;
    solids.unusable = std::move(parts_.unusable);
    solids.cells.resize(named->names.size());
    solids.isOpenPart.resize(named->names.size(), 1);
    for (std::size_t part = 0; part < parts_.cells.size(); ++part)
    {
      const std::size_t solid = named->ofPart[part];
      const std::vector<vtkIdType>& cells = parts_.cells[part];
      solids.cells[solid].insert(solids.cells[solid].end(), cells.begin(), cells.end());
      solids.isOpenPart[solid] &= parts_.isOpenPart[part];
    }
    parts_ = std::move(solids);
    return named->names;
  }
  for (std::size_t i = 1; i <= parts_.cells.size(); ++i)
  {
    names.push_back("Part " + std::to_string(i));
  }
  return names;
}

/// Finds the cells of the parts that this rank has: of all, or of none.
void Solids::findParts(vtkPointSet* data, const SolidOptions& options, Executor& executor)
{
  if (data->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!hasFaces(data))
  {
    throw Refusal(messageOf(Sentence::pointsAreNoSolids));
  }
  if (!vtkPolyData::SafeDownCast(data))
  {
    data_ = outerSurfaceOf(data, false, counts_);
  }
  parts_ = solidCellsOf(
    vtkPolyData::SafeDownCast(data_), options.ignoresOpenParts, options.weldTolerance, executor);
  if (parts_.cells.size() > largestLabel)
  {
    throw Refusal(messageOf(Sentence::tooManyParts, {std::to_string(parts_.cells.size())}));
  }
}

void Solids::makeNamesUnique()
{
  std::set<std::string> all(names_.begin(), names_.end()), taken;
  for (std::string& name : names_)
  {
    const std::string given = name;
    for (int number = 2; !taken.insert(name).second; ++number)
    {
      const std::string next = given + " (" + std::to_string(number) + ")";
      name = all.count(next) ? name : next;
    }
    repeatedNames_ += name != given;
  }
}

vtkSmartPointer<vtkDataObject> Solids::source(std::size_t solid) const
{
  if (data_)
  {
    return cellsOf(data_, parts_.cells[solid], newIds_, asPoints_);
  }
  return blocks_[solid];
}

} // namespace winding
