#include "private/source/Solids.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "private/pipeline/VtkVersions.h"
#include "private/source/CellChecks.h"
#include "private/source/ContentHash.h"
#include "private/source/RegionCells.h"
#include "private/source/SolidBlocks.h"
#include "private/source/SourceParts.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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

/// Returns the refusal of an array of regions.
Refusal refusedRegions(const std::string& fault)
{
  return Refusal(Message(fault, {{"choose another array of regions", {Parameter::regionArray}}}));
}

/// The array of regions. Throws Refusal if there is none of that name, or not for all cells.
vtkDataArray* regionsOf(vtkPointSet* data, const std::string& name)
{
  vtkDataArray* regions = data->GetCellData()->GetArray(name.c_str());
  if (!regions && data->GetCellData()->HasArray(name.c_str()) != 0)
  {
    throw Refusal(Message("'" + name + "' holds text, and regions are integers",
      {{"number its values in another array", {Parameter::regionArray}}}));
  }
  if (!regions)
  {
    const bool isOfPoints = data->GetPointData()->HasArray(name.c_str()) != 0;
    throw refusedRegions(
      "'" + name + "' is " +
      (isOfPoints ? "an array of the points, not of the cells" : "no array of the cells"));
  }
  if (regions->GetNumberOfComponents() != 1 ||
      regions->GetNumberOfTuples() < data->GetNumberOfCells())
  {
    throw refusedRegions("'" + name + "' has not one value for each cell");
  }
  return regions;
}

/// The region of a cell. Throws Refusal for what is no integer.
int regionOf(vtkDataArray* regions, vtkIdType cell)
{
  const double value = regions->GetComponent(cell, 0);
  if (!(std::abs(value) < 1e9) || value != std::floor(value))
  {
    throw refusedRegions("'" + std::string(regions->GetName()) + "' has the value " +
                         std::to_string(value) + " at cell " + std::to_string(cell) +
                         ", and regions are integers");
  }
  return static_cast<int>(value);
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
    if (options.regionArray.empty() || isNone)
    {
      this->addParts(data_, options, ranks, executor);
    }
    else
    {
      this->addRegions(data_, options, ranks);
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
    throw Refusal("give all ranks the same blocks, of which each may have a part: they have "
                  "different numbers of them");
  }
  for (SolidBlock& block : blocks)
  {
    labels_.push_back(labelOf(static_cast<double>(labels_.size() + 1), "block '" + block.name + "'",
      {"extract fewer blocks", {}}));
    names_.push_back(block.name);
    blocks_.push_back(block.source);
  }
}

void Solids::addRegions(vtkPointSet* data, const SolidOptions& options, Ranks& ranks)
{
  std::map<int, std::vector<vtkIdType>> cells;
  std::vector<int> own;
  ranks.agree(
    [&]
    {
      const vtkIdType count = data->GetNumberOfCells();
      vtkDataArray* regions = count > 0 ? regionsOf(data, options.regionArray) : nullptr;
      const auto [first, last] = facesOf(data);
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        cells[regionOf(regions, cell)].push_back(cell);
      }
      for (const auto& [region, ids] : cells)
      {
        own.push_back(region);
      }
    });
  const std::vector<int> ofAll = ranks.gather(own, false).numbers;
  for (const int region : std::set<int>(ofAll.begin(), ofAll.end()))
  {
    const std::string name = options.regionArray + " " + std::to_string(region);
    labels_.push_back(labelOf(static_cast<double>(region) + options.labelOffset,
      "region " + std::to_string(region) + " of '" + options.regionArray + "'",
      {"choose another offset", {Parameter::labelOffset}}));
    names_.push_back(name);
    parts_.cells.push_back(std::move(cells[region]));
  }
}

void Solids::addParts(
  vtkPointSet* data, const SolidOptions& options, Ranks& ranks, Executor& executor)
{
  if (!ranks.isAlone() && !isWhole(data, ranks))
  {
    throw Refusal(Message("several ranks cannot find solids that are in parts",
      {{"name an array of regions", {Parameter::regionArray}}, {"give blocks", {}},
        {"give one rank the whole surface", {}}}));
  }
  const std::vector<Ranks::Number> counts = ranks.allGather(
    [&]() -> Ranks::Number
    {
      this->findParts(data, options, executor);
      return parts_.cells.size();
    });
  parts_.cells.resize(static_cast<std::size_t>(*std::max_element(counts.begin(), counts.end())));
  for (std::size_t i = 1; i <= parts_.cells.size(); ++i)
  {
    labels_.push_back(static_cast<unsigned short>(i));
    names_.push_back("Part " + std::to_string(i));
  }
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
    throw Refusal("give blocks, one for each solid: the input is points, and nothing tells which "
                  "belong together");
  }
  if (!vtkPolyData::SafeDownCast(data))
  {
    data_ = outerSurfaceOf(data, false, counts_);
  }
  parts_ = solidCellsOf(vtkPolyData::SafeDownCast(data_), options.ignoresOpenParts, executor);
  if (parts_.cells.size() > largestLabel)
  {
    throw Refusal(Message("the surface has too many parts for labels",
      {{"name an array of regions", {Parameter::regionArray}},
        {"close the gaps between triangles", {}}},
      "it has " + std::to_string(parts_.cells.size()) +
        " by connectivity, and labels are 1 to 65535"));
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
    return cellsOf(data_, parts_.cells[solid], newIds_);
  }
  return blocks_[solid];
}

} // namespace winding
