// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/MeshArrays.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Gives the memory of an array to one of VTK's, whose integers of 64 bits may have another name.
template <class Array, class Number>
vtkSmartPointer<Array> handedArray(PlainArray<Number>& numbers, int components)
{
  using Value = typename Array::ValueType;
  static_assert(sizeof(Value) == sizeof(Number), "the numbers stay as they are");
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  const auto size = static_cast<vtkIdType>(numbers.size());
  if (size > 0)
  {
    array->SetArray(
      reinterpret_cast<Value*>(numbers.release()), size, 0, Array::VTK_DATA_ARRAY_FREE);
  }
  return array;
}

/// Hands the arrays of a mesh over to VTK's data: points, cells, and the arrays of points
/// "Normals", "RGB" or "RGBA", "TCoords", "Area" and other numbers by their names, and of cells,
/// with names in the field data, "ObjectIds", "GroupIds", "MaterialIds" and "SolidIds", colours and
/// other numbers, as far as the mesh has them.
void handOver(MeshArrays& mesh, vtkPolyData* output);

} // namespace winding
