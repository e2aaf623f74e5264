// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CellTypes.h"
#include "private/source/SourceParts.h"

#include "pipeline/VtkVersions.h"
#include "private/source/CellChecks.h"
#include "private/source/OuterSurface.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtentTranslator.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Returns a cloud without points that another piece of the data has too, or that are hidden.
vtkSmartPointer<vtkPointSet> withoutGhosts(vtkPointSet* cloud, const std::string& name)
{
  constexpr int ghostPoint =
    vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  vtkUnsignedCharArray* flags = cloud->GetPointGhostArray();
  const auto isGhost = [flags](vtkIdType point)
  {
    return (flags->GetValue(point) & ghostPoint) != 0;
  };
  bool isAny = false;
  for (vtkIdType i = 0; flags && i < flags->GetNumberOfTuples() && !isAny; ++i)
  {
    isAny = isGhost(i);
  }
  if (!isAny)
  {
    return cloud;
  }
  checkCells(cloud, name);
  checkArrays(cloud, name);
  auto clean = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  clean->GetPointData()->CopyAllocate(cloud->GetPointData());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    if (!isGhost(i))
    {
      double position[3];
      cloud->GetPoint(i, position);
      clean->GetPointData()->CopyData(cloud->GetPointData(), i, points->InsertNextPoint(position));
    }
  }
  clean->SetPoints(points);
  return clean;
}

/// Returns a mesh of lines as polydata.
vtkSmartPointer<vtkPolyData> linesOf(vtkPointSet* mesh)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(mesh))
  {
    return polyData;
  }
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> leafAsPolyData(vtkPointSet* leaf, bool takesFaces, CellCounts& counts)
{
  if (hasFaces(leaf))
  {
    countLoose(leaf, counts);
  }
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData;
  }
  if (leaf->GetNumberOfPoints() > 0 && hasFaces(leaf))
  {
    const auto own = ownCellsOf(leaf, takesFaces, "the source", counts);
    return outerSurfaceOf(own, false, counts);
  }
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(leaf->GetPoints());
  points->GetPointData()->ShallowCopy(leaf->GetPointData());
  points->GetFieldData()->ShallowCopy(leaf->GetFieldData());
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType point = 0; point < leaf->GetNumberOfPoints(); ++point)
  {
    vertices->InsertNextCell(1, &point);
  }
  points->SetVerts(vertices);
  return points;
}

} // namespace

bool hasFaces(vtkPointSet* leaf)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData->GetNumberOfPolys() + polyData->GetNumberOfStrips() > 0;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf);
  vtkDataArray* types = grid ? cellTypesOf(grid) : nullptr;
  const vtkIdType cells = leaf->GetNumberOfCells();
  // Nobody has looked yet whether every cell has a type. Most meshes have a face first.
  const vtkIdType known = !grid ? cells : types ? std::min(cells, types->GetNumberOfTuples()) : 0;
  for (vtkIdType i = 0; i < known; ++i)
  {
    if (dimensionOf(leaf->GetCellType(i)) >= 2)
    {
      return true;
    }
  }
  return false;
}

bool isOfLines(vtkPointSet* leaf)
{
  if (hasFaces(leaf))
  {
    return false;
  }
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData->GetNumberOfLines() > 0 && polyData->GetLines()->GetNumberOfConnectivityIds() >
                                                 polyData->GetVerts()->GetNumberOfConnectivityIds();
  }
  vtkIdType ofLines = 0;
  for (vtkIdType i = 0; i < leaf->GetNumberOfCells(); ++i)
  {
    ofLines += dimensionOf(leaf->GetCellType(i)) == 1 ? 1 : -1;
  }
  return ofLines > 0;
}

SourceKind kindOf(vtkDataObject* source)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(source))
  {
    SourceKind kind = SourceKind::nothing;
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal() && kind != SourceKind::mesh;
         iterator->GoToNextItem())
    {
      const SourceKind leaf = kindOf(iterator->GetCurrentDataObject());
      kind = leaf == SourceKind::nothing ? kind : leaf;
    }
    return kind;
  }
  auto* points = vtkPointSet::SafeDownCast(source);
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return SourceKind::nothing;
  }
  return hasFaces(points) ? SourceKind::mesh : SourceKind::cloud;
}

vtkSmartPointer<vtkPointSet> ownPartOf(
  vtkPointSet* leaf, bool takesFaces, const std::string& name, CellCounts& counts)
{
  return hasFaces(leaf) ? ownCellsOf(leaf, takesFaces, name, counts) : withoutGhosts(leaf, name);
}

std::vector<vtkSmartPointer<vtkPolyData>> leavesAsPolyData(
  vtkDataObject* source, bool takesFaces, CellCounts& counts)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(source);
  if (!composite)
  {
    return {leafAsPolyData(vtkPointSet::SafeDownCast(source), takesFaces, counts)};
  }
  std::vector<vtkPointSet*> pointSets;
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    pointSets.push_back(vtkPointSet::SafeDownCast(iterator->GetCurrentDataObject()));
  }
  const bool isSurface = std::any_of(pointSets.begin(), pointSets.end(), hasFaces);
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  for (vtkPointSet* leaf : pointSets)
  {
    if (isSurface && isOfLines(leaf))
    {
      countLoose(leaf, counts);
      leaves.push_back(linesOf(leaf));
    }
    else
    {
      leaves.push_back(leafAsPolyData(leaf, takesFaces, counts));
    }
  }
  return leaves;
}

vtkSmartPointer<vtkPolyData> appended(const std::vector<vtkSmartPointer<vtkPolyData>>& leaves)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& leaf : leaves)
  {
    append->AddInputData(leaf);
  }
  if (!leaves.empty())
  {
    append->Update();
  }
  return append->GetOutput();
}

vtkSmartPointer<vtkMultiBlockDataSet> asBlocks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const auto& leaf : leaves)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), leaf);
  }
  return blocks;
}

void requestPiece(vtkInformation* source, int piece, int pieces)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  source->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  source->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  source->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  // A structured source, such as a curvilinear grid, is asked for by extent instead.
  if (source->Has(Pipeline::WHOLE_EXTENT()))
  {
    int whole[6], extent[6];
    source->Get(Pipeline::WHOLE_EXTENT(), whole);
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(
      piece, pieces, 0, whole, extent, vtkExtentTranslator::BLOCK_MODE, 0);
    source->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  }
}

} // namespace winding
