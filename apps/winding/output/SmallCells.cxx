#include "output/SmallCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>

namespace
{

/// Cells of one kind, in the order in which vtkPolyData counts them, and their fewest points.
struct Kind
{
  vtkCellArray* cells;
  vtkIdType fewest;
};

std::array<Kind, 4> kindsOf(vtkPolyData* data)
{
  return {Kind{data->GetVerts(), 1}, Kind{data->GetLines(), 2}, Kind{data->GetPolys(), 3},
    Kind{data->GetStrips(), 3}};
}

vtkIdType countSmall(vtkPolyData* data)
{
  vtkIdType count = 0;
  for (const Kind& kind : kindsOf(data))
  {
    for (vtkIdType i = 0; i < kind.cells->GetNumberOfCells(); ++i)
    {
      count += kind.cells->GetCellSize(i) < kind.fewest;
    }
  }
  return count;
}

} // namespace

vtkSmartPointer<vtkPolyData> withoutSmallCells(vtkPolyData* data, vtkIdType& dropped)
{
  dropped = countSmall(data);
  if (dropped == 0)
  {
    return data;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(data->GetPoints());
  result->GetPointData()->ShallowCopy(data->GetPointData());
  result->GetFieldData()->ShallowCopy(data->GetFieldData());
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(data->GetCellData());
  vtkIdType from = 0, to = 0;
  std::array<vtkNew<vtkCellArray>, 4> kept;
  for (std::size_t kind = 0; kind < kept.size(); ++kind)
  {
    const auto [cells, fewest] = kindsOf(data)[kind];
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++from)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(i, size, ids);
      if (size >= fewest)
      {
        kept[kind]->InsertNextCell(size, ids);
        result->GetCellData()->CopyData(data->GetCellData(), from, to++);
      }
    }
  }
  result->SetVerts(kept[0]);
  result->SetLines(kept[1]);
  result->SetPolys(kept[2]);
  result->SetStrips(kept[3]);
  return result;
}
