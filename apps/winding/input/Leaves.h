// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkSmartPointer.h"

/// Calls visit(leaf) for the data itself, which may be null, or for each leaf of blocks that is
/// there.
template <class Visit> void forEachLeaf(vtkDataObject* data, const Visit& visit)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    visit(data);
    return;
  }
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    visit(leaves->GetCurrentDataObject());
  }
}
