// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/SphereCloud.h"
#include "vtk/Spheres.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using Filter = vtkWindingNumberSurface;

double volumeOfBall(double radius)
{
  return 4.0 / 3 * vtkMath::Pi() * radius * radius * radius;
}

vtkSmartPointer<vtkPolyData> ball(double radius, double endPhi = 180)
{
  return sphereOf(160, 120, radius, {}, endPhi);
}

vtkSmartPointer<vtkPolyData> box(double x0, double x1)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(x0, x1, 0, 1, 0, 1);
  cube->Update();
  return cube->GetOutput();
}

vtkSmartPointer<vtkPolyData> together(vtkPolyData* a, vtkPolyData* b, bool isReversed)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(b);
  reverse->SetReverseCells(isReversed);
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(a);
  append->AddInputConnection(reverse->GetOutputPort());
  append->Update();
  return append->GetOutput();
}

class Shape : public testing::Test
{
protected:
  Shape()
  {
    filter->SetResolution(64);
    filter->GenerateTrianglesOn();
  }

  double volumeOf(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.errors(), "");
    const EdgeCounts edges = countEdges(filter->GetOutput());
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.nonManifold, 0);
    return signedVolume(filter->GetOutput());
  }

  std::string base()
  {
    auto* names = vtkStringArray::SafeDownCast(
      filter->GetOutput()->GetFieldData()->GetAbstractArray("DistancesFrom"));
    return names ? names->GetValue(0) : "";
  }

  vtkNew<Filter> filter;
};

} // namespace

TEST_F(Shape, IsTheSolidUnlessItIsToldOtherwise)
{
  EXPECT_EQ(filter->GetOffset(), 0);
  EXPECT_EQ(filter->GetShell(), 0);
  EXPECT_EQ(filter->GetShellSide(), Filter::INWARD);
  EXPECT_EQ(filter->GetFillCavities(), 0);
  EXPECT_NEAR(this->volumeOf(ball(1)), volumeOfBall(1), 0.005 * volumeOfBall(1));
  EXPECT_EQ(this->base(), "");
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("FilledCavities"));
}

TEST_F(Shape, HasTheVolumeOfItsOffsetOrShell)
{
  const auto expect = [&](double offset, double shell, int side, double volume)
  {
    SCOPED_TRACE(testing::Message() << offset << " " << shell << " " << side);
    filter->SetOffset(offset);
    filter->SetShell(shell);
    filter->SetShellSide(side);
    for (const int features : {Filter::SMOOTH, Filter::SHARP})
    {
      filter->SetFeatures(features);
      // Measured: 0.4 % at most, as the sphere has faces.
      EXPECT_NEAR(this->volumeOf(ball(1)), volume, 0.006 * volume);
      EXPECT_EQ(this->base(), "source");
    }
  };
  expect(0.5, 0, Filter::INWARD, volumeOfBall(1.5));
  expect(-0.5, 0, Filter::INWARD, volumeOfBall(0.5));
  expect(0, 0.25, Filter::INWARD, volumeOfBall(1) - volumeOfBall(0.75));
  expect(0, 0.25, Filter::OUTWARD, volumeOfBall(1.25) - volumeOfBall(1));
  expect(0, 0.5, Filter::CENTERED, volumeOfBall(1.25) - volumeOfBall(0.75));
  expect(0.5, 0.25, Filter::INWARD, volumeOfBall(1.5) - volumeOfBall(1.25));
  expect(-0.25, 0.25, Filter::OUTWARD, volumeOfBall(1) - volumeOfBall(0.75));
}

/// Edges that move inward stay sharp.
TEST_F(Shape, OfABoxIsExact)
{
  filter->SetFeatures(Filter::SHARP);
  filter->SetOffset(-0.2);
  EXPECT_NEAR(this->volumeOf(box(0, 1)), 0.6 * 0.6 * 0.6, 1e-5); // measured: 1e-8
  filter->SetOffset(0.2);
  const double round = 1 + 6 * 0.2 + 3 * vtkMath::Pi() * 0.2 * 0.2 + volumeOfBall(0.2);
  EXPECT_NEAR(this->volumeOf(box(0, 1)), round, 2e-3 * round);
}

/// The rim of a half sphere that is thickened is half of a torus tube.
TEST_F(Shape, OfAnOpenSheetIsThickenedWithItsRim)
{
  const double radius = 1, half = 0.15;
  filter->SetShell(2 * half);
  filter->SetShellSide(Filter::CENTERED);
  const ErrorLog log(filter);
  const double walls = (volumeOfBall(radius + half) - volumeOfBall(radius - half)) / 2;
  const double tube = vtkMath::Pi() * half * half * vtkMath::Pi() * radius;
  EXPECT_NEAR(this->volumeOf(ball(radius, 90)), walls + tube, 0.01 * (walls + tube));
  EXPECT_EQ(log.warnings(), "");
  EXPECT_EQ(this->base(), "source");
}

/// A sheet has no outside that it could move to: with an offset the surface of its solid moves.
TEST_F(Shape, OfAnOpenSheetIsThickenedOnlyWhereItLies)
{
  filter->SetShell(0.3);
  filter->SetShellSide(Filter::CENTERED);
  for (const auto& [offset, base] : {std::pair(0.0, "source"), {0.05, "surface"}, {0.0, "source"}})
  {
    filter->SetOffset(offset);
    this->volumeOf(ball(1, 90));
    EXPECT_EQ(this->base(), base) << offset;
  }
  for (const int side : {Filter::INWARD, Filter::OUTWARD})
  {
    filter->SetShellSide(side);
    this->volumeOf(ball(1, 90));
    EXPECT_EQ(this->base(), "surface");
  }
}

TEST_F(Shape, OfSolidsThatOverlapComesFromWhatBoundsThem)
{
  filter->SetFeatures(Filter::SHARP);
  filter->SetOffset(-0.2);
  for (const double start : {0.6, 1.0})
  {
    EXPECT_NEAR(this->volumeOf(together(box(0, 1), box(start, 2), false)), 1.6 * 0.6 * 0.6, 1e-3);
    EXPECT_EQ(this->base(), "surface");
  }
}

TEST_F(Shape, OfACloudComesFromItsSurface)
{
  filter->SetOffset(0.5);
  const double volume = this->volumeOf(sphereCloud(2000, 1));
  EXPECT_NEAR(volume, volumeOfBall(1.5), 0.02 * volumeOfBall(1.5));
  EXPECT_EQ(this->base(), "surface");
}

TEST_F(Shape, FillsCavities)
{
  const auto hollow = together(ball(1), ball(0.5), true);
  EXPECT_NEAR(this->volumeOf(hollow), volumeOfBall(1) - volumeOfBall(0.5), 0.03);
  filter->FillCavitiesOn();
  EXPECT_NEAR(this->volumeOf(hollow), volumeOfBall(1), 0.03);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("FilledCavities")->GetTuple1(0), 1);
  filter->SetShell(0.7);
  EXPECT_NEAR(this->volumeOf(hollow), volumeOfBall(1) - volumeOfBall(0.3), 0.03);
  EXPECT_EQ(this->base(), "surface");
}

TEST_F(Shape, TellsItsLargestError)
{
  filter->SetShell(0.2);
  filter->SetFidelitySamples(2000);
  this->volumeOf(ball(1));
  vtkFieldData* found = filter->GetOutput()->GetFieldData();
  const double largest = found->GetArray("LargestShapeError")->GetTuple1(0);
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.002); // measured: 6e-4, a sagitta of triangles
  EXPECT_LE(found->GetArray("MeanShapeError")->GetTuple1(0), largest);
  EXPECT_NE(std::string(filter->GetFidelityInWords()).find("off the distance"), std::string::npos);
  filter->SetShell(0);
  this->volumeOf(ball(1));
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("LargestShapeError"));
}

TEST_F(Shape, SaysWhatIsLost)
{
  const auto warnings = [&]
  {
    filter->SetInputData(ball(1));
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.errors(), "");
    return log.warnings();
  };
  filter->SetShell(0.01);
  EXPECT_NE(warnings().find("the shell is thinner than a voxel"), std::string::npos);
  filter->SetShell(1.2 * voxelOf(filter)); // as a voxel's diagonal is longer
  EXPECT_NE(warnings().find("the shell is thinner than a voxel's diagonal"), std::string::npos);
  filter->SetShell(1.8 * voxelOf(filter));
  EXPECT_EQ(warnings(), "");
  filter->SetShell(0);
  filter->SetOffset(-1.5);
  EXPECT_NE(warnings().find("move its surface less far inward"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

/// Where the grid is all inside, the advice is that of a plain surface, once.
TEST_F(Shape, SaysWhereAllIsInside)
{
  filter->SetInputData(ball(1));
  filter->MendSourceOff();
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  const auto count = [&]
  {
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.warnings().find("nothing is left"), std::string::npos) << log.warnings();
    const std::string fact = "all samples are inside";
    const auto at = log.warnings().find(fact);
    return at == std::string::npos                                  ? 0
           : log.warnings().find(fact, at + 1) == std::string::npos ? 1
                                                                    : 2;
  };
  filter->SetOffset(0.5);
  EXPECT_EQ(count(), 1);
  filter->SetOffset(0);
  filter->FillCavitiesOn();
  EXPECT_EQ(count(), 1);
  filter->GenerateImageOn();
  EXPECT_EQ(count(), 0);
}

TEST_F(Shape, SaysHowToThickenASheet)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(10, 10);
  plane->Update();
  filter->SetInputData(plane->GetOutput());
  filter->SetShell(0.1);
  filter->MendSourceOff();
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(log.warnings().find("thicken an open sheet on both sides (SetShellSide(CENTERED))"),
    std::string::npos)
    << log.warnings();
}

TEST_F(Shape, RefusesValuesOutOfRange)
{
  filter->SetInputData(ball(1));
  const auto errorOf = [&]
  {
    const ErrorLog log(filter);
    filter->Update();
    return log.errors();
  };
  filter->SetShell(-1);
  EXPECT_NE(errorOf().find("Shell is -1"), std::string::npos);
  filter->SetShell(0);
  filter->SetShellSide(3);
  EXPECT_NE(errorOf().find("ShellSide is 3"), std::string::npos);
  filter->SetShellSide(0);
  filter->SetOffset(std::nan(""));
  EXPECT_NE(errorOf().find("Offset is"), std::string::npos);
}

/// The grid grows by what the shape reaches beyond the source.
TEST_F(Shape, HasAGridThatHoldsIt)
{
  filter->SetInputData(ball(1));
  filter->SetOffset(2);
  filter->SetShell(1);
  filter->SetShellSide(Filter::OUTWARD);
  filter->Update();
  double bounds[6];
  filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 4, 0.02);
  EXPECT_EQ(countEdges(filter->GetOutput()).open, 0);
}
