// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/FaultBlocks.h"

#include "surface/Cap.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace winding
{

namespace
{

/// Cells over vertices of a surface, as polydata with the vertices that they use.
class BlockMaker
{
public:
  BlockMaker(const Surface& surface, int pointType)
    : surface_(surface)
    , newIds_(surface.vertices.size(), -1)
    , pointType_(pointType)
  {
  }

  template <class Vertices> void addCell(const Vertices& vertices)
  {
    cells_->InsertNextCell(static_cast<int>(vertices.size()));
    for (const std::int32_t vertex : vertices)
    {
      cells_->InsertCellPoint(vertex); // renumbered in the end
      newIds_[vertex] = 0;
    }
  }

  ///@{
  /// The name of a number that every cell has, to be added after it.
  void addValue(const char* name, std::size_t value)
  {
    this->add<vtkIdTypeArray>(name, static_cast<double>(value));
  }
  void addMeasure(const char* name, double value) { this->add<vtkDoubleArray>(name, value); }
  ///@}

  vtkSmartPointer<vtkPolyData> make(bool areLines)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(pointType_);
    for (std::size_t vertex = 0; vertex < newIds_.size(); ++vertex)
    {
      if (newIds_[vertex] == 0)
      {
        newIds_[vertex] = points->InsertNextPoint(surface_.vertices[vertex].data());
      }
    }
    vtkNew<vtkCellArray> cells;
    vtkIdType size;
    const vtkIdType* ids;
    for (vtkIdType cell = 0; cell < cells_->GetNumberOfCells(); ++cell)
    {
      cells_->GetCellAtId(cell, size, ids);
      cells->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        cells->InsertCellPoint(newIds_[static_cast<std::size_t>(ids[i])]);
      }
    }
    auto block = vtkSmartPointer<vtkPolyData>::New();
    block->SetPoints(points);
    if (areLines)
    {
      block->SetLines(cells);
    }
    else
    {
      block->SetPolys(cells);
    }
    for (const auto& [name, array] : values_)
    {
      block->GetCellData()->AddArray(array);
    }
    return block;
  }

private:
  template <class Array> void add(const char* name, double value)
  {
    auto& array = values_[name];
    if (!array)
    {
      array = vtkSmartPointer<Array>::New();
      array->SetName(name);
    }
    array->InsertNextTuple1(value);
  }

  const Surface& surface_;
  std::vector<vtkIdType> newIds_; ///< by vertex: −1 unused, 0 used, until make() numbers them
  int pointType_;
  vtkNew<vtkCellArray> cells_;
  std::map<std::string, vtkSmartPointer<vtkDataArray>> values_;
};

/// By the lower vertex and the higher one.
using Multiplicities = std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t>;

std::int32_t largestOf(const BoundaryLoop& loop, const Multiplicities& multiplicities)
{
  std::int32_t largest = 1;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto found = multiplicities.find(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    largest = found == multiplicities.end() ? largest : std::max(largest, found->second);
  }
  return largest;
}

vtkSmartPointer<vtkPolyData> boundaryBlock(const Surface& surface, const BoundaryChain& chain,
  const BoundaryLoops& loops, const SurfaceEdges& edges, const Slits& slits, int pointType)
{
  Multiplicities multiplicities; // the few that are more than 1
  for (const BoundaryEdge& edge : chain.edges)
  {
    if (edge.multiplicity > 1)
    {
      multiplicities[std::minmax(edge.from, edge.to)] = edge.multiplicity;
    }
  }
  BlockMaker maker(surface, pointType);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    std::vector<std::int32_t> closed(loops[i].begin(), loops[i].end());
    closed.push_back(closed.front());
    maker.addCell(closed);
    maker.addValue("Loop", i);
    maker.addValue("Edges", loops[i].size());
    maker.addValue("Multiplicity", static_cast<std::size_t>(largestOf(loops[i], multiplicities)));
    maker.addMeasure("SlitWidth",
      widestAlong(loops[i], edges, slits).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return maker.make(true);
}

vtkSmartPointer<vtkPolyData> capBlock(
  const Surface& surface, const BoundaryLoops& loops, int pointType)
{
  BlockMaker maker(surface, pointType);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const Triangle& triangle : capOf(loops[i]))
    {
      maker.addCell(triangle);
      maker.addValue("Loop", i);
    }
  }
  return maker.make(false);
}

vtkSmartPointer<vtkPolyData> nonManifoldBlock(
  const Surface& surface, const SurfaceEdges& edges, int pointType)
{
  BlockMaker maker(surface, pointType);
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    maker.addCell(std::array<std::int32_t, 2>{crowd.low, crowd.high});
    maker.addValue("Triangles", crowd.endOfUses - crowd.firstUse);
  }
  return maker.make(true);
}

vtkSmartPointer<vtkPolyData> inconsistentBlock(
  const Surface& surface, const SurfaceEdges& edges, int pointType)
{
  BlockMaker maker(surface, pointType);
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    if (!pair.agrees)
    {
      maker.addCell(std::array<std::int32_t, 2>{pair.low, pair.high});
    }
  }
  return maker.make(true);
}

vtkSmartPointer<vtkPolyData> tubes(vtkPolyData* lines, double radius)
{
  vtkNew<vtkTubeFilter> filter;
  filter->SetInputData(lines);
  filter->SetRadius(radius);
  filter->SetNumberOfSides(8);
  filter->CappingOn();
  filter->SetOutputPointsPrecision(lines->GetPoints()->GetDataType() == VTK_DOUBLE
                                     ? vtkAlgorithm::DOUBLE_PRECISION
                                     : vtkAlgorithm::SINGLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

/// Every cell of a block gets the number of its kind, by which views colour unless they are set
/// otherwise.
void addKind(vtkPolyData* block, int kind)
{
  constexpr const char* name = "FaultKind";
  vtkNew<vtkIntArray> kinds;
  kinds->SetName(name);
  kinds->SetNumberOfValues(block->GetNumberOfCells());
  kinds->FillValue(kind);
  block->GetCellData()->AddArray(kinds);
  block->GetCellData()->SetActiveScalars(name);
}

/// Whether every edge has two triangles that agree about it, so that there is no boundary to look
/// for.
bool allPairUp(const SurfaceEdges& edges)
{
  return edges.rims.empty() && edges.crowds.empty() &&
         std::all_of(edges.pairs.begin(), edges.pairs.end(),
           [](const SurfaceEdges::Pair& pair) { return pair.agrees; });
}

} // namespace

vtkSmartPointer<vtkMultiBlockDataSet> faultBlocks(const Surface& surface, const SurfaceEdges& edges,
  const Slits& slits, const FaultShape& shape, Executor& executor)
{
  const BoundaryChain chain = allPairUp(edges) ? BoundaryChain() : boundaryChain(surface, executor);
  const BoundaryLoops loops = boundaryLoops(chain.edges, surface.vertices.size(), executor);
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const double radius = shape.thickness * surface.bounds.diagonal().norm();
  const auto set = [&blocks, radius](unsigned int place, const char* name, vtkPolyData* block)
  {
    if (block->GetNumberOfCells() == 0)
    {
      return;
    }
    // Tubes of 100 000 edges take seconds and half a gigabyte; lines can be seen then, too.
    constexpr vtkIdType mostTubes = 20'000;
    const vtkIdType sections =
      block->GetLines()->GetNumberOfConnectivityIds() - block->GetNumberOfLines();
    const bool isThick = radius > 0 && sections > 0 && sections <= mostTubes;
    auto shown = isThick ? tubes(block, radius) : vtkSmartPointer<vtkPolyData>(block);
    addKind(shown, static_cast<int>(place));
    blocks->SetBlock(place, shown);
    blocks->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name);
  };
  set(0, "Caps", capBlock(surface, loops, shape.pointType));
  set(1, "Boundary", boundaryBlock(surface, chain, loops, edges, slits, shape.pointType));
  set(2, "NonManifoldEdges", nonManifoldBlock(surface, edges, shape.pointType));
  set(3, "InconsistentEdges", inconsistentBlock(surface, edges, shape.pointType));
  return blocks;
}

} // namespace winding
