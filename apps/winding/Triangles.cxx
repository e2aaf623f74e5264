#include "Triangles.h"

#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{

template <class Append> void eachCell(vtkCellArray* cells, const Append& append)
{
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 2; i < size; ++i)
    {
      append(ids, i);
    }
  }
}

} // namespace

winding::TrianglesView Triangles::view() const
{
  return {{coordinates.data(), this->points()}, {ids.data(), this->triangles()}};
}

Triangles trianglesOf(vtkPointSet* data)
{
  Triangles result;
  vtkNew<vtkDataSetSurfaceFilter> skin;
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    skin->SetInputData(data);
    skin->Update();
    surface = skin->GetOutput();
  }
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    double point[3];
    surface->GetPoint(id, point);
    result.coordinates.insert(result.coordinates.end(), point, point + 3);
  }
  const auto add = [&result](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    result.ids.insert(result.ids.end(), {a, b, c});
  };
  eachCell(surface->GetPolys(),
    [&add](const vtkIdType* ids, vtkIdType i) { add(ids[0], ids[i - 1], ids[i]); });
  eachCell(surface->GetStrips(),
    [&add](const vtkIdType* ids, vtkIdType i)
    {
      const bool turned = i % 2 == 1;
      add(ids[i - 2], ids[turned ? i : i - 1], ids[turned ? i - 1 : i]);
    });
  return result;
}
