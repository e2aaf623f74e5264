// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/SphereCloud.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/**
 * @file
 * Filters from which solids come out make one of a source that bounds nothing, and say so.
 */
namespace
{

const std::string asItCame =
  "if that is wrong, leave it as it came (" + howTo({winding::Parameter::mendSource, 0});

/// The unit cube, its faces outward or inward.
vtkSmartPointer<vtkPolyData> box(bool looksInward, double x = 0)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(x, 0, 0);
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(cube->GetOutputPort());
  reversed->SetReverseCells(looksInward);
  reversed->SetReverseNormals(looksInward);
  reversed->Update();
  return reversed->GetOutput();
}

/// A square of side 1 in the plane z = 0.
vtkSmartPointer<vtkPolyData> sheet()
{
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> both(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(first);
  append->AddInputData(second);
  append->Update();
  return append->GetOutput();
}

/// Executes a filter and expects that it says `fault` first, or nothing if that is empty.
void expectNote(vtkWindingNumberAlgorithm* filter, const std::string& fault)
{
  ErrorLog log(filter);
  filter->Update();
  filter->RemoveAllObservers();
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(log.warnings().empty(), fault.empty()) << log.warnings();
  EXPECT_NE(log.warnings().find(fault), std::string::npos) << log.warnings();
  if (!fault.empty())
  {
    EXPECT_NE(log.warnings().find(asItCame), std::string::npos) << log.warnings();
  }
}

vtkIdType countInside(vtkImageData* image)
{
  vtkDataArray* const inside = image->GetPointData()->GetArray("Inside");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
  {
    count += inside->GetComponent(i, 0) != 0;
  }
  return count;
}

} // namespace

TEST(MendSource, OfSurfacesGivesTheSolid)
{
  struct Case
  {
    vtkSmartPointer<vtkPolyData> source;
    std::string note;
    double volume, tolerance;
  };
  const double pi = std::acos(-1), sphere = 4 * pi / 3;
  const Case cases[] = {{box(false), "", 1, 0.01}, {box(true), "faces were turned", 1, 0.01},
    {both(box(false), box(true, 2)), "faces were turned", 2, 0.06},
    {both(box(false), box(true)), "faces were turned", 1, 0.01},
    {sphereCloud(3000, 1), "", sphere, 0.05},
    {sphereCloud(3000, -1), "normals were turned", sphere, 0.05},
    {sphereCloud(3000, 0), "normals were estimated", sphere, 0.1}};
  for (const Case& one : cases)
  {
    SCOPED_TRACE(&one - cases);
    vtkNew<vtkWindingNumberSurface> filter;
    filter->SetInputData(one.source);
    filter->SetResolution(32);
    expectNote(filter, one.note);
    EXPECT_NEAR(signedVolume(filter->GetOutput()), one.volume, one.tolerance);
    EXPECT_FALSE(filter->GetSourceIsInsideOut());
    EXPECT_EQ(countEdges(filter->GetOutput()).open, 0);
  }
}

TEST(MendSource, MakesPlatesOfOpenSheetsThreeVoxelsThick)
{
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetInputData(sheet());
  for (const int resolution : {40, 64})
  {
    filter->SetResolution(resolution);
    expectNote(filter, "open sheets became a plate of three voxels");
    double bounds[6];
    filter->GetOutput()->GetBounds(bounds);
    EXPECT_NEAR(bounds[5] - bounds[4], 3 * voxelOf(filter), 0.02 * voxelOf(filter));
    EXPECT_EQ(countEdges(filter->GetOutput()).open, 0);
  }
  filter->MendSourceOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MendSource, ClosesSurfacesAtTheBorder)
{
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetInputData(box(false));
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(0, 1, -1, 1, -1, 1);
  expectNote(filter, "the surface reaches the border, and was closed there");
  EXPECT_NEAR(signedVolume(filter->GetOutput()), 0.5, 0.01);
  filter->CloseBorderOn();
  expectNote(filter, "");
}

TEST(MendSource, OfOperandsAndOfSolidsIsForEach)
{
  vtkNew<vtkWindingNumberBoolean> difference;
  vtkNew<vtkMultiBlockDataSet> operands;
  operands->SetBlock(0, box(false));
  operands->SetBlock(1, box(true, 0.5));
  difference->SetInputData(operands);
  difference->SetOperation(vtkWindingNumberBoolean::DIFFERENCE);
  difference->SetResolution(32);
  expectNote(difference, "faces were turned");
  EXPECT_NEAR(signedVolume(difference->GetOutput()), 0.5, 0.02);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, box(true));
  blocks->SetBlock(1, box(true, 2));
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputData(blocks);
  labels->SetVoxelSize(0.05);
  expectNote(labels, "faces were turned");
  vtkDataArray* const values = labels->GetOutput()->GetPointData()->GetArray("Label");
  vtkIdType counts[3] = {};
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(values->GetComponent(i, 0))];
  }
  EXPECT_NEAR(counts[1] * std::pow(0.05, 3), 1, 0.16);
  EXPECT_NEAR(counts[2] * std::pow(0.05, 3), 1, 0.16);
}

/// It has to be asked for.
TEST(MendSource, OfFieldsIsOffAndChangesWhatIsInside)
{
  vtkNew<vtkWindingNumberField> filter;
  EXPECT_FALSE(filter->GetMendSource());
  filter->GenerateInsideOn();
  filter->SetResolution(20);
  filter->SetInputData(box(true));
  filter->Update();
  EXPECT_EQ(countInside(filter->GetOutput()), 0);
  filter->MendSourceOn();
  expectNote(filter, "faces were turned");
  const vtkIdType whole = countInside(filter->GetOutput());
  EXPECT_GT(whole, 18 * 18 * 18 - 1);
  filter->UpdateInformation();
  vtkIdType parts = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    filter->UpdatePiece(piece, 3, 0);
    parts += countInside(filter->GetOutput());
  }
  EXPECT_GE(parts, whole); // pieces share samples

  filter->SetInputData(sheet());
  filter->SetResolution(40);
  expectNote(filter, "open sheets became a plate of three voxels");
  // Two to four layers of 36 by 36 voxels, by where they lie, and the rim around them.
  EXPECT_GT(countInside(filter->GetOutput()), 2 * 36 * 36);
  EXPECT_LT(countInside(filter->GetOutput()), 4 * 40 * 40);
}
