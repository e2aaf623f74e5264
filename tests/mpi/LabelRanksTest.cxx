// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/LabelScenes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

/**
 * @file
 * Labels of solids that are dealt out to the ranks of a parallel program are the same as on one
 * rank that has all of them.
 */

namespace
{

using Filter = vtkWindingNumberLabels;

int rank()
{
  return vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
}

int ranks()
{
  return vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses();
}

/// Every so manieth polygon of a surface, with its cell data.
vtkSmartPointer<vtkPolyData> ownPart(vtkPolyData* surface)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> cells;
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = rank(); i < surface->GetNumberOfPolys(); i += ranks())
  {
    surface->GetPolys()->GetCellAtId(i, size, ids);
    part->GetCellData()->CopyData(surface->GetCellData(), i, cells->InsertNextCell(size, ids));
  }
  part->SetPoints(surface->GetPoints());
  part->SetPolys(cells);
  return part;
}

std::vector<unsigned short> labelsOf(
  vtkDataObject* input, bool isAlone, int rule, const char* regions = nullptr)
{
  vtkNew<Filter> labels;
  if (isAlone)
  {
    labels->SetController(nullptr);
  }
  labels->SetInputData(input);
  labels->SetRegionArray(regions);
  labels->SetOverlapRule(rule);
  labels->SetResolution(20);
  const ErrorLog log(labels);
  labels->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(labels->GetNumberOfSolids(), 5);
  return shortsOf(labels->GetOutput()->GetPointData());
}

void expectRefusedOnAll(vtkDataObject* input, const std::string& words)
{
  vtkNew<Filter> labels;
  labels->SetInputData(input);
  const ErrorLog log(labels);
  labels->Update();
  EXPECT_EQ(labels->GetStatus(), Filter::REFUSED);
  EXPECT_NE(log.errors().find(words), std::string::npos) << log.errors();
}

TEST(LabelsOnRanks, OfBlocksInPartsAreThoseOfOneRank)
{
  const auto balls = fiveBalls();
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    // One solid is the first rank's alone, the others have an empty block there.
    const bool isHere = i != 3 || rank() == 0;
    const auto nothing = vtkSmartPointer<vtkPolyData>::New();
    parts.push_back(i != 3 ? ownPart(balls[i]) : isHere ? balls[i] : nothing);
  }
  for (const int rule : {Filter::FIRST, Filter::LARGEST_WINDING_NUMBER, Filter::SMALLEST_VOLUME})
  {
    const auto expected = labelsOf(asAssembly(balls), true, rule);
    EXPECT_EQ(labelsOf(asAssembly(parts), false, rule), expected);
  }
}

TEST(LabelsOnRanks, OfRegionsInPartsAreThoseOfOneRank)
{
  const auto balls = fiveBalls();
  vtkNew<vtkAppendPolyData> append;
  vtkNew<vtkIntArray> regions;
  regions->SetName("Region");
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    append->AddInputData(balls[i]);
    for (vtkIdType n = 0; n < balls[i]->GetNumberOfPolys(); ++n)
    {
      regions->InsertNextValue(3 + 2 * static_cast<int>(i));
    }
  }
  append->Update();
  vtkPolyData* surface = append->GetOutput();
  surface->GetCellData()->AddArray(regions);
  const auto expected = labelsOf(surface, true, Filter::SMALLEST_VOLUME, "Region");
  EXPECT_EQ(labelsOf(ownPart(surface), false, Filter::SMALLEST_VOLUME, "Region"), expected);
}

/// A surface of five parts that only the last rank has, as a reader of one rank gives it, or that
/// all have; the others have nothing, as polydata or as a grid.
TEST(LabelsOnRanks, OfPartsByConnectivityAreThoseOfOneRank)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& solid : fiveBalls())
  {
    append->AddInputData(solid);
  }
  append->Update();
  vtkPolyData* const surface = append->GetOutput();
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkUnstructuredGrid> emptyGrid;
  const auto expected = labelsOf(surface, true, Filter::LAST);
  EXPECT_EQ(labelsOf(surface, false, Filter::LAST), expected);
  const std::vector<vtkPointSet*> elsewhere = {nothing, emptyGrid};
  for (vtkPointSet* const other : elsewhere)
  {
    vtkPointSet* const own = rank() == ranks() - 1 ? surface : other;
    EXPECT_EQ(labelsOf(own, false, Filter::LAST), expected);
  }
}

TEST(LabelsOnRanks, WhatOneRankCannotTellIsRefusedOnAll)
{
  if (ranks() == 1)
  {
    return;
  }
  auto balls = fiveBalls();
  expectRefusedOnAll(ownPart(balls[0]), "several ranks cannot find solids that are in parts");
  if (rank() == 1)
  {
    balls.pop_back();
  }
  expectRefusedOnAll(asAssembly(balls), "give all ranks the same blocks");
}

} // namespace
