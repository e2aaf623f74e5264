#include "SourceParts.h"

#include "Refusal.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtractCells.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <string>

namespace winding
{

namespace
{

/// Whether any of a ghost array's flags is set.
bool hasFlags(vtkUnsignedCharArray* ghosts, int flags)
{
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (ghosts->GetValue(i) & flags)
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool hasFaces(vtkPointSet* leaf)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData->GetNumberOfPolys() + polyData->GetNumberOfStrips() > 0;
  }
  // Cell by cell: ParaView's VTK warns of GetCellTypes(), and most meshes have a face first.
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < leaf->GetNumberOfCells(); ++i)
  {
    cell->SetCellType(leaf->GetCellType(i)); // does nothing for the type that it has
    if (cell->GetCellDimension() >= 2)
    {
      return true;
    }
  }
  return false;
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

void checkCellIds(vtkPointSet* leaf)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < leaf->GetNumberOfCells(); ++cell)
  {
    leaf->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      if (ids->GetId(i) < 0 || ids->GetId(i) >= leaf->GetNumberOfPoints())
      {
        throw Refusal("cell " + std::to_string(cell) + " of the source refers to point " +
                      std::to_string(ids->GetId(i)) + " of " +
                      std::to_string(leaf->GetNumberOfPoints()) + "; mend the data set");
      }
    }
  }
}

vtkSmartPointer<vtkPointSet> withoutGhosts(vtkPointSet* leaf, bool isMesh)
{
  constexpr int ghostCell = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  constexpr int ghostPoint =
    vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  const bool strip = isMesh ? hasFlags(leaf->GetCellGhostArray(), ghostCell)
                            : hasFlags(leaf->GetPointGhostArray(), ghostPoint);
  if (!strip)
  {
    return leaf;
  }
  vtkNew<vtkIdList> own;
  auto clean = vtkSmartPointer<vtkPolyData>::New();
  if (isMesh)
  {
    for (vtkIdType i = 0; i < leaf->GetNumberOfCells(); ++i)
    {
      if (!(leaf->GetCellGhostArray()->GetValue(i) & ghostCell))
      {
        own->InsertNextId(i);
      }
    }
    vtkNew<vtkExtractCells> extract;
    extract->SetInputData(leaf);
    extract->SetCellList(own);
    vtkNew<vtkDataSetSurfaceFilter> skin;
    skin->SetInputConnection(extract->GetOutputPort());
    skin->Update();
    clean->ShallowCopy(skin->GetOutput());
    return clean;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  clean->GetPointData()->CopyAllocate(leaf->GetPointData());
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    if (!(leaf->GetPointGhostArray()->GetValue(i) & ghostPoint))
    {
      clean->GetPointData()->CopyData(
        leaf->GetPointData(), i, points->InsertNextPoint(leaf->GetPoint(i)));
    }
  }
  clean->SetPoints(points);
  return clean;
}

} // namespace winding
