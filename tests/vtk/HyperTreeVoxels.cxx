// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/HyperTreeVoxels.h"

#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridNonOrientedGeometryCursor.h"
#include "vtkNew.h"
#include "vtkWindingNumberGridAlgorithm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

std::vector<vtkIdType> leavesOfVoxels(
  vtkHyperTreeGrid* trees, const vtkWindingNumberGridAlgorithm* filter)
{
  int dimensions[3];
  double first[3], spacing[3];
  filter->GetGrid(dimensions, first, spacing);
  std::vector<vtkIdType> leaves(
    static_cast<std::size_t>(dimensions[0]) * dimensions[1] * dimensions[2], -1);
  vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
  const auto addLeaf = [&]
  {
    int begin[3], end[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low =
        (cursor->GetOrigin()[axis] - (first[axis] - spacing[axis] / 2)) / spacing[axis];
      const double side = cursor->GetSize()[axis] / spacing[axis];
      begin[axis] = static_cast<int>(std::lround(low));
      end[axis] = static_cast<int>(std::lround(low + side));
      EXPECT_NEAR(low, begin[axis], 1e-6);
      EXPECT_NEAR(side, std::exp2(std::round(std::log2(side))), 1e-6);
      ASSERT_LE(end[axis], dimensions[axis]);
    }
    for (int k = begin[2]; k < end[2]; ++k)
    {
      for (int j = begin[1]; j < end[1]; ++j)
      {
        for (int i = begin[0]; i < end[0]; ++i)
        {
          vtkIdType& leaf =
            leaves[(static_cast<std::size_t>(k) * dimensions[1] + j) * dimensions[0] + i];
          ASSERT_EQ(leaf, -1) << "cells overlap";
          leaf = cursor->GetGlobalNodeIndex();
        }
      }
    }
  };
  const std::function<void()> descend = [&]
  {
    if (cursor->IsMasked())
    {
      return;
    }
    if (cursor->IsLeaf())
    {
      addLeaf();
      return;
    }
    for (unsigned char child = 0; child < 8; ++child)
    {
      cursor->ToChild(child);
      descend();
      cursor->ToParent();
    }
  };
  vtkHyperTreeGrid::vtkHyperTreeGridIterator iterator;
  trees->InitializeTreeIterator(iterator);
  for (vtkIdType index; iterator.GetNextTree(index);)
  {
    trees->InitializeNonOrientedGeometryCursor(cursor, index);
    descend();
  }
  return leaves;
}
