// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/HandedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>

namespace winding
{

namespace
{

vtkSmartPointer<vtkDataArray> handedOver(VectorArrays& vectors)
{
  if (vectors.doubles.empty() && !vectors.floats.empty())
  {
    return handedArray<vtkFloatArray>(vectors.floats, 3);
  }
  return handedArray<vtkDoubleArray>(vectors.doubles, 3);
}

vtkSmartPointer<vtkCellArray> handedOver(CellArrays& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  if (cells.count() > 0)
  {
    const auto offsets = handedArray<vtkTypeInt64Array>(cells.offsets, 1);
    array->SetData(offsets, handedArray<vtkTypeInt64Array>(cells.connectivity, 1));
  }
  return array;
}

/// Returns an array of other numbers, of integers where the file has no others: there is nothing
/// between two labels.
vtkSmartPointer<vtkDataArray> handedOver(OtherNumbers& other)
{
  vtkSmartPointer<vtkDataArray> array;
  if (other.areIntegers)
  {
    vtkNew<vtkTypeInt64Array> integers;
    integers->SetNumberOfValues(static_cast<vtkIdType>(other.numbers.size()));
    std::transform(other.numbers.begin(), other.numbers.end(), integers->GetPointer(0),
      [](double number) { return static_cast<vtkTypeInt64>(number); });
    array = integers;
  }
  else
  {
    array = handedArray<vtkDoubleArray>(other.numbers, 1);
  }
  array->SetName(other.name.c_str());
  return array;
}

/// Returns an array of colours.
vtkSmartPointer<vtkUnsignedCharArray> colorsOf(PlainArray<std::uint8_t>& colors, int components)
{
  auto array = handedArray<vtkUnsignedCharArray>(colors, components);
  array->SetName(components == 4 ? "RGBA" : "RGB");
  return array;
}

/// Adds the regions of polygons, which are −1 for other cells, and their names.
void addRegions(NamedRegions& regions, vtkPolyData* output)
{
  const std::string kind = regions.kind;
  const vtkIdType others = output->GetNumberOfVerts() + output->GetNumberOfLines();
  vtkSmartPointer<vtkIntArray> ids;
  if (others == 0)
  {
    ids = handedArray<vtkIntArray>(regions.ofPolygon, 1);
  }
  else
  {
    ids = vtkSmartPointer<vtkIntArray>::New();
    ids->SetNumberOfValues(output->GetNumberOfCells());
    std::fill_n(ids->GetPointer(0), others, -1);
    std::copy(regions.ofPolygon.begin(), regions.ofPolygon.end(), ids->GetPointer(others));
  }
  ids->SetName((kind + "Ids").c_str());
  output->GetCellData()->AddArray(ids);
  vtkNew<vtkStringArray> names;
  names->SetName((kind + "Names").c_str());
  for (const std::string& name : regions.names)
  {
    names->InsertNextValue(name);
  }
  output->GetFieldData()->AddArray(names);
}

} // namespace

void handOver(MeshArrays& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(handedOver(mesh.points));
  output->SetPoints(points);
  output->SetVerts(handedOver(mesh.vertices));
  output->SetLines(handedOver(mesh.lines));
  output->SetPolys(handedOver(mesh.polygons));
  if (mesh.normals.count() > 0)
  {
    const auto normals = handedOver(mesh.normals);
    normals->SetName("Normals");
    output->GetPointData()->SetNormals(normals);
  }
  if (!mesh.colors.empty())
  {
    output->GetPointData()->SetScalars(colorsOf(mesh.colors, mesh.colorComponents));
  }
  if (!mesh.textureCoordinates.empty())
  {
    const auto coordinates = handedArray<vtkFloatArray>(mesh.textureCoordinates, 2);
    coordinates->SetName("TCoords");
    output->GetPointData()->SetTCoords(coordinates);
  }
  if (!mesh.areas.empty())
  {
    const auto areas = handedArray<vtkDoubleArray>(mesh.areas, 1);
    areas->SetName("Area");
    output->GetPointData()->AddArray(areas);
  }
  if (!mesh.viewpoints.empty())
  {
    const auto viewpoints = handedArray<vtkDoubleArray>(mesh.viewpoints, 3);
    viewpoints->SetName("Viewpoints");
    output->GetPointData()->AddArray(viewpoints);
  }
  for (OtherNumbers& other : mesh.others)
  {
    output->GetPointData()->AddArray(handedOver(other));
  }
  if (!mesh.faceColors.empty())
  {
    output->GetCellData()->SetScalars(colorsOf(mesh.faceColors, mesh.faceColorComponents));
  }
  for (OtherNumbers& other : mesh.faceNumbers)
  {
    output->GetCellData()->AddArray(handedOver(other));
  }
  for (NamedRegions& regions : mesh.regions)
  {
    addRegions(regions, output);
  }
}

} // namespace winding
