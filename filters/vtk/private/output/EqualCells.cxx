// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/EqualCells.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"

namespace winding
{

vtkSmartPointer<vtkCellArray> cellsOf(vtkTypeInt64Array* ids, vtkIdType size)
{
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(ids->GetNumberOfValues() / size + 1);
  for (vtkIdType n = 0; n < offsets->GetNumberOfValues(); ++n)
  {
    offsets->SetValue(n, size * n);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

} // namespace winding
