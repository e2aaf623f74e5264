// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/PointArrays.h"

#include "base/Refusal.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace winding
{

namespace
{

std::string nameOf(vtkDataArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

} // namespace

vtkDataArray* pointArray(vtkPointSet* points, const std::string& name, int components)
{
  vtkPointData* data = points->GetPointData();
  vtkDataArray* array = name.empty() ? data->GetNormals() : data->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != components)
  {
    throw Refusal("choose another array: the point array '" + nameOf(array) + "' has " +
                  std::to_string(array->GetNumberOfComponents()) + " components, not " +
                  std::to_string(components));
  }
  if (array && array->GetNumberOfTuples() < points->GetNumberOfPoints())
  {
    throw Refusal("choose another array: the point array '" + nameOf(array) + "' has " +
                  std::to_string(array->GetNumberOfTuples()) + " values for " +
                  std::to_string(points->GetNumberOfPoints()) + " points");
  }
  if (!array && !name.empty())
  {
    throw Refusal("choose another array: there is no point array '" + name + "'");
  }
  return array;
}

vtkDataArray* normalsOf(vtkPointSet* points, const std::string& name)
{
  // Lists of arrays in ParaView have this entry, and had the other one, which older states keep.
  const bool isActive =
    (name == "Active Normals" || name == "None") && !points->GetPointData()->HasArray(name.c_str());
  return pointArray(points, isActive ? std::string() : name, 3);
}

} // namespace winding
