// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/ArraySink.h"

#include "private/output/ResultArrays.h"

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
#include "vtkTypeInt64Array.h"

namespace winding
{

namespace
{

vtkSmartPointer<vtkDataArray> makeArray(NumberType type)
{
  switch (type)
  {
  case NumberType::uint8:
    return vtkSmartPointer<vtkUnsignedCharArray>::New();
  case NumberType::int32:
    return vtkSmartPointer<vtkIntArray>::New();
  case NumberType::int64:
    return vtkSmartPointer<vtkTypeInt64Array>::New();
  case NumberType::float32:
    return vtkSmartPointer<vtkFloatArray>::New();
  case NumberType::float64:
    return vtkSmartPointer<vtkDoubleArray>::New();
  }
  return nullptr;
}

} // namespace

vtkDataArray* ArraySink::array(Output output) const
{
  const auto found = arrays_.find(output);
  return found == arrays_.end() ? nullptr : found->second.Get();
}

void* ArraySink::memoryOf(Output output, NumberType type, std::size_t tuples)
{
  const auto count = static_cast<vtkIdType>(tuples);
  vtkSmartPointer<vtkDataArray>& array = arrays_[output];
  if (output == Output::inside)
  {
    array = makeResultArray(VTK_UNSIGNED_CHAR, nameOf(output), count);
  }
  else
  {
    array = makeArray(type);
    array->SetName(nameOf(output));
    array->SetNumberOfComponents(componentsOf(output));
    array->SetNumberOfTuples(count);
  }
  return array->GetVoidPointer(0);
}

void ArraySink::addTo(vtkPolyData* surface) const
{
  vtkNew<vtkPoints> points;
  points->SetData(this->array(Output::points));
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(vtkTypeInt64Array::SafeDownCast(this->array(Output::offsets)),
    vtkTypeInt64Array::SafeDownCast(this->array(Output::corners)));
  surface->SetPolys(polygons);
  if (vtkDataArray* const normals = this->array(Output::pointNormals))
  {
    surface->GetPointData()->SetNormals(normals);
  }
  if (vtkDataArray* const normals = this->array(Output::polygonNormals))
  {
    surface->GetCellData()->SetNormals(normals);
  }
  if (vtkDataArray* const operands = this->array(Output::operands))
  {
    surface->GetCellData()->AddArray(operands);
  }
  for (const Output single : {Output::isClosed, Output::parts, Output::volume, Output::inputVolume})
  {
    if (vtkDataArray* const number = this->array(single))
    {
      surface->GetFieldData()->AddArray(number);
    }
  }
}

} // namespace winding
