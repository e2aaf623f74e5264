// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SourceUnits.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

namespace winding
{

namespace
{

void addPoints(vtkPointSet* leaf, Bounds& bounds)
{
  vtkPoints* points = leaf ? leaf->GetPoints() : nullptr;
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d point;
    points->GetPoint(i, point.data());
    if (point.allFinite())
    {
      bounds.extend(point);
    }
  }
}

} // namespace

Bounds pointBoundsOf(vtkDataObject* data)
{
  Bounds bounds;
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    addPoints(vtkPointSet::SafeDownCast(data), bounds);
    return bounds;
  }
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    addPoints(vtkPointSet::SafeDownCast(leaves->GetCurrentDataObject()), bounds);
  }
  return bounds;
}

} // namespace winding
