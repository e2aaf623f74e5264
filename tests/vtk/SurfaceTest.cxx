// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/Backends.h"
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"
#include "vtk/SphereCloud.h"
#include "vtk/Spheres.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{

class Surfaces : public testing::Test
{
protected:
  Surfaces()
  {
    sphere->SetRadius(1);
    sphere->SetThetaResolution(32);
    sphere->SetPhiResolution(32);
    filter->SetInputConnection(sphere->GetOutputPort());
    filter->SetResolution(20);
  }

  void expectRefused(const std::string& part)
  {
    ErrorLog log(filter);
    filter->Update();
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberSurface::REFUSED);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    filter->RemoveAllObservers();
  }

  vtkPolyData* update()
  {
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberSurface::DONE);
    return filter->GetOutput();
  }

  void expectClosed(vtkPolyData* surface)
  {
    EXPECT_GT(surface->GetNumberOfCells(), 0);
    const EdgeCounts edges = countEdges(surface);
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.nonManifold, 0);
    EXPECT_EQ(countDuplicatePoints(surface), 0);
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberSurface> filter;
};

TEST_F(Surfaces, DefaultsAreTheDocumentedOnes)
{
  vtkNew<vtkWindingNumberSurface> fresh;
  EXPECT_EQ(fresh->GetResolution(), 0);
  EXPECT_EQ(fresh->GetUseInputBounds(), 1);
  EXPECT_EQ(fresh->GetPadding(), 0.05);
  EXPECT_EQ(fresh->GetWindingThreshold(), 0.5);
  EXPECT_EQ(fresh->GetCloseBorder(), 0);
  EXPECT_EQ(fresh->GetGenerateNormals(), 1);
  EXPECT_EQ(fresh->GetFeatures(), vtkWindingNumberSurface::SMOOTH);
  EXPECT_EQ(fresh->GetGenerateTriangles(), 0);
  EXPECT_EQ(fresh->GetFidelitySamples(), 0);
  EXPECT_EQ(fresh->GetGenerateDistanceToInput(), 0);
  EXPECT_EQ(fresh->GetOutputPointsPrecision(), vtkAlgorithm::DEFAULT_PRECISION);
}

TEST_F(Surfaces, HaveTheVoxelsThatWallsAskFor)
{
  vtkNew<vtkCubeSource> plate;
  plate->SetZLength(0.008);
  filter->SetInputConnection(plate->GetOutputPort());
  filter->SetResolution(0);
  int voxels[3];
  double first[3], spacing[3];
  for (const bool isImageMade : {false, true, false})
  {
    filter->SetGenerateImage(isImageMade);
    this->expectClosed(this->update());
    filter->GetGrid(voxels, first, spacing);
    EXPECT_EQ(voxels[0], 210);
    EXPECT_EQ(std::string(filter->GetResolutionReason()),
      "resolution 210, since about 98 % of the surface has walls thinner than 1.5 of 128 voxels");
  }
  filter->SetResolution(50);
  this->update();
  filter->GetGrid(voxels, first, spacing);
  EXPECT_EQ(voxels[0], 50);
  EXPECT_EQ(std::string(filter->GetResolutionReason()), "");
  filter->SetResolution(0);
  filter->SetSamplingDimensions(30, 30, 5);
  this->update();
  filter->GetGrid(voxels, first, spacing);
  EXPECT_EQ(voxels[2], 5);
  filter->SetSamplingDimensions(0, 0, 0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  filter->SetInputConnection(sphere->GetOutputPort());
  this->update();
  filter->GetGrid(voxels, first, spacing);
  EXPECT_EQ(voxels[0], 128);
}

TEST_F(Surfaces, OfAClosedMeshLieOnIt)
{
  vtkPolyData* surface = this->update();
  this->expectClosed(surface);
  // Measured: 2e-6, the locator's own error included.
  EXPECT_LT(distances(surface, sphere->GetOutput(), voxelOf(filter)).back(), 1e-3);
  EXPECT_NEAR(signedVolume(surface), signedVolume(sphere->GetOutput()), 0.03);
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_FLOAT);
  vtkFieldData* data = surface->GetFieldData();
  EXPECT_EQ(data->GetArray("Closed")->GetTuple1(0), 1);
  EXPECT_EQ(data->GetArray("Parts")->GetTuple1(0), 1);
  EXPECT_NEAR(data->GetArray("Volume")->GetTuple1(0), signedVolume(surface), 1e-5);
  EXPECT_NEAR(data->GetArray("InputVolume")->GetTuple1(0), signedVolume(sphere->GetOutput()), 1e-5);
  EXPECT_EQ(std::string(filter->GetSolidInWords()).rfind("1 part, volume ", 0), 0u)
    << filter->GetSolidInWords();
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(data->GetAbstractArray("WindingNumberMethod"))->GetValue(0),
    "rows");

  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    EXPECT_GT(vtkMath::Dot(normals->GetTuple3(i), surface->GetPoint(i)), 0.95);
    EXPECT_NEAR(vtkMath::Norm(normals->GetTuple3(i)), 1, 1e-6);
  }
  filter->GenerateNormalsOff();
  EXPECT_EQ(this->update()->GetPointData()->GetNormals(), nullptr);
}

/// Distances are 0 where the surface follows the sphere. Where half of it is missing they are those
/// that the probe finds.
TEST_F(Surfaces, HaveTheirDistancesFromTheInput)
{
  EXPECT_EQ(this->update()->GetPointData()->GetArray("DistanceToInput"), nullptr);
  filter->GenerateDistanceToInputOn();
  for (const double end : {360.0, 180.0})
  {
    sphere->SetEndTheta(end);
    for (const int precision : {vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION})
    {
      filter->SetOutputPointsPrecision(precision);
      vtkPolyData* surface = this->update();
      vtkDataArray* found = surface->GetPointData()->GetArray("DistanceToInput");
      ASSERT_NE(found, nullptr);
      EXPECT_EQ(found, surface->GetPointData()->GetScalars());
      EXPECT_EQ(found->GetDataType(), surface->GetPoints()->GetDataType());
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(surface);
      probe->SetSourceConnection(sphere->GetOutputPort());
      probe->GenerateSignedDistanceOn();
      probe->SetOutputScalarType(found->GetDataType());
      probe->Update();
      vtkDataArray* expected = probe->GetOutput()->GetPointData()->GetArray("SignedDistance");
      for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
      {
        ASSERT_EQ(found->GetTuple1(i), std::abs(expected->GetTuple1(i))) << i;
      }
      const double largest = found->GetRange()[1];
      EXPECT_GT(surface->GetNumberOfPoints(), 100);
      // Measured: 3e-8 and 0.6.
      EXPECT_TRUE(end == 360 ? largest < 1e-5 : largest > 0.3) << largest;
    }
  }
}

/// Samples lie on the faces of the cube, and whole rows of samples in them.
TEST_F(Surfaces, OfFacesInPlanesOfTheGridAreClosedAndLieOnThem)
{
  vtkNew<vtkCubeSource> cube;
  filter->SetInputConnection(cube->GetOutputPort());
  filter->SetPadding(0.15);
  filter->SetResolution(13); // voxels of 0.1, samples at -0.5 and 0.5
  for (const int method : {vtkWindingNumberSurface::ROWS, vtkWindingNumberSurface::HIERARCHICAL,
         vtkWindingNumberSurface::DIRECT, vtkWindingNumberSurface::PARITY})
  {
    filter->SetMethod(method);
    vtkPolyData* surface = this->update();
    this->expectClosed(surface);
    EXPECT_LT(distances(surface, cube->GetOutput(), voxelOf(filter)).back(), 3e-4) << method;
    EXPECT_NEAR(signedVolume(surface), 1, 0.04) << "only the cube's edges are cut off";
  }
}

TEST_F(Surfaces, HaveTheNormalsOfTheSourceWhereTheyLieOnIt)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(cube->GetOutputPort());
  filter->SetInsideRule(vtkWindingNumberSurface::ABSOLUTE);
  const std::array<vtkAlgorithmOutput*, 2> sources = {
    cube->GetOutputPort(), reversed->GetOutputPort()};
  for (vtkAlgorithmOutput* source : sources)
  {
    filter->SetInputConnection(source);
    vtkPolyData* surface = this->update();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* point = surface->GetPoint(i);
      const double* normal = surface->GetPointData()->GetNormals()->GetTuple3(i);
      const int axis =
        static_cast<int>(std::max_element(normal, normal + 3,
                           [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                         normal);
      EXPECT_EQ(std::abs(normal[axis]), 1) << "near edges, too";
      EXPECT_NEAR(point[axis], 0.5 * normal[axis], 1e-6);
    }
  }

  // The ball's lower half fills half of all directions when seen from the plane of its rim, so that
  // the surface is closed there.
  filter->SetInputConnection(sphere->GetOutputPort());
  sphere->SetStartPhi(90);
  vtkPolyData* surface = this->update();
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  int offSource = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* point = surface->GetPoint(i);
    EXPECT_NEAR(vtkMath::Norm(normals->GetTuple3(i)), 1, 1e-6);
    if (std::hypot(point[0], point[1]) < 0.9 && point[2] > -0.1)
    {
      ++offSource;
      EXPECT_NEAR(point[2], 0, 1e-3); // measured: 5e-5
      EXPECT_GT(normals->GetComponent(i, 2), 0.999);
    }
  }
  EXPECT_GT(offSource, 50);
}

TEST_F(Surfaces, OfAnOpenMeshLieOnItOrAtTheLevel)
{
  sphere->SetEndPhi(120);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const double tolerance : {1e-3, 0.0})
  {
    filter->SetTolerance(tolerance);
    vtkPolyData* surface = this->update();
    this->expectClosed(surface);
    EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(countOffLevel(filter, sphere->GetOutput(), 2000, 1e-3), 0);
    const double exact = 2 * vtkMath::Pi() / 3 * (1 + 0.5 + 0.5 * 0.25); // volume of the part
    EXPECT_GT(signedVolume(surface), exact);
  }
}

TEST_F(Surfaces, OfACloudLieAtTheLevel)
{
  const vtkSmartPointer<vtkPolyData> cloud = sphereCloud(2000, 1);
  filter->SetInputData(cloud);
  filter->SetRegularization(1); // without it, w is steep near points
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkPolyData* surface = this->update();
  EXPECT_FALSE(filter->GetSourceIsSurface());
  this->expectClosed(surface);
  EXPECT_NEAR(signedVolume(surface), 4.19, 0.5);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(surface);
  probe->SetSourceData(cloud);
  probe->SetRegularization(1);
  probe->SetMethod(vtkWindingNumberProbe::DIRECT);
  probe->Update();
  vtkDataArray* values = probe->GetOutput()->GetPointData()->GetArray("WindingNumber");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(values->GetTuple1(i), 0.5, 1e-3);
  }
}

TEST_F(Surfaces, FollowRuleAndThreshold)
{
  const auto inner = sphereOf(32, 32);
  sphere->Update();
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, sphere->GetOutput());
  both->SetBlock(1, inner);
  filter->SetInputData(both);
  filter->SetResolution(30);
  const double outerVolume = signedVolume(sphere->GetOutput());
  const double innerVolume = signedVolume(inner);
  EXPECT_NEAR(signedVolume(this->update()), outerVolume, 0.03);
  filter->SetWindingThreshold(1.5);
  EXPECT_NEAR(signedVolume(this->update()), innerVolume, 0.03);
  filter->SetInsideRule(vtkWindingNumberSurface::ODD);
  EXPECT_NEAR(signedVolume(this->update()), outerVolume - innerVolume, 0.03);
  this->expectClosed(filter->GetOutput());

  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(sphere->GetOutputPort());
  filter->SetInputConnection(reversed->GetOutputPort());
  filter->SetWindingThreshold(0.5);
  filter->SetInsideRule(vtkWindingNumberSurface::ABSOLUTE);
  EXPECT_NEAR(signedVolume(this->update()), outerVolume, 0.03) << "outward all the same";
  filter->SetInsideRule(vtkWindingNumberSurface::SIGNED);
  filter->MendSourceOff();
  EXPECT_EQ(this->update()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(Surfaces, EndAtTheBorderOfTheGridOrAreClosedThere)
{
  filter->MendSourceOff();
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(-1.1, 1.1, -1.1, 1.1, 0, 1.1);
  const ErrorLog border(filter);
  vtkPolyData* surface = this->update();
  EXPECT_GT(countEdges(surface).open, 0);
  EXPECT_LT(distances(surface, sphere->GetOutput(), voxelOf(filter)).back(), 1e-3);
  const std::string isOpen = "the surface reaches the border of the grid, where it is open";
  EXPECT_NE(border.warnings().find(isOpen), std::string::npos) << border.warnings();
  // A shell reaches the border where its solid does.
  filter->SetShell(0.5);
  const ErrorLog ofShell(filter);
  EXPECT_GT(countEdges(this->update()).open, 0);
  EXPECT_NE(ofShell.warnings().find(isOpen), std::string::npos) << ofShell.warnings();
  filter->SetShell(0);

  const ErrorLog closed(filter);
  filter->CloseBorderOn();
  surface = this->update();
  EXPECT_EQ(closed.warnings(), "");
  this->expectClosed(surface);
  EXPECT_NEAR(surface->GetBounds()[4], 0, 1e-7) << "on the outer faces of the voxels";
  EXPECT_NEAR(signedVolume(surface), 0.5 * signedVolume(sphere->GetOutput()), 0.05);

  filter->SetSamplingBounds(-0.1, 0.1, -0.1, 0.1, -0.1, 0.1);
  surface = this->update();
  this->expectClosed(surface);
  EXPECT_NEAR(signedVolume(surface), 0.008, 0.0008) << "all is inside";
  filter->CloseBorderOff();
  ErrorLog log(filter);
  EXPECT_EQ(this->update()->GetNumberOfCells(), 0);
  EXPECT_NE(
    log.warnings().find("all samples are inside, so the surface is empty"), std::string::npos)
    << log.warnings();
  EXPECT_EQ(log.warnings().find("no sample is inside"), std::string::npos) << log.warnings();
}

TEST_F(Surfaces, WithNoSampleInsideAreEmptyWithAWarning)
{
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(2, 3, 2, 3, 2, 3);
  for (const int rule : {vtkWindingNumberSurface::SIGNED, vtkWindingNumberSurface::ABSOLUTE,
         vtkWindingNumberSurface::ODD})
  {
    filter->SetInsideRule(rule);
    ErrorLog log(filter);
    EXPECT_EQ(this->update()->GetNumberOfCells(), 0);
    EXPECT_NE(log.warnings().find("the grid misses the source"), std::string::npos)
      << log.warnings();
    EXPECT_EQ(log.warnings().find("all samples are inside"), std::string::npos) << log.warnings();
    filter->RemoveAllObservers();
  }
}

TEST_F(Surfaces, GridsOfOneLayerNeedABorder)
{
  filter->SetSamplingDimensions(8, 1, 8);
  this->expectRefused("the grid has one voxel along y");
  filter->CloseBorderOn();
  this->expectClosed(this->update());
}

TEST_F(Surfaces, PointsAreSingleUnlessThatLosesThem)
{
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  EXPECT_EQ(this->update()->GetPoints()->GetDataType(), VTK_FLOAT);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  EXPECT_EQ(this->update()->GetPoints()->GetDataType(), VTK_DOUBLE);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);

  sphere->SetCenter(1e5, 0, 0);
  vtkPolyData* surface = this->update();
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
  this->expectClosed(surface);
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  EXPECT_EQ(this->update()->GetPoints()->GetDataType(), VTK_FLOAT);
}

TEST_F(Surfaces, AreTheSameInAnyUnitOfLength)
{
  const vtkIdType points = this->update()->GetNumberOfPoints();
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const double unit : {1e-30, 1e-100, 1e30, 1e100})
  {
    vtkNew<vtkTransform> scaling;
    scaling->Scale(unit, unit, unit);
    vtkNew<vtkTransformPolyDataFilter> scaled;
    scaled->SetInputConnection(sphere->GetOutputPort());
    scaled->SetTransform(scaling);
    scaled->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->SetInputConnection(scaled->GetOutputPort());
    vtkPolyData* surface = this->update();
    EXPECT_EQ(surface->GetNumberOfPoints(), points) << unit;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double* p = surface->GetPoint(i);
      ASSERT_NEAR(std::hypot(p[0] / unit, p[1] / unit, p[2] / unit), 1, 0.01);
      ASSERT_NEAR(vtkMath::Norm(surface->GetPointData()->GetNormals()->GetTuple3(i)), 1, 1e-6);
    }
  }
}

TEST_F(Surfaces, HaveTheSameBitsOnAnyThreads)
{
  sphere->SetEndPhi(120); // leaves an opening, in which the level is searched for
  const auto bits = [this]()
  {
    vtkPolyData* surface = this->update();
    vtkDataArray* points = surface->GetPoints()->GetData();
    vtkDataArray* ids = surface->GetPolys()->GetConnectivityArray();
    std::vector<double> all;
    for (vtkIdType i = 0; i < points->GetNumberOfValues(); ++i)
    {
      all.push_back(points->GetVariantValue(i).ToDouble());
      all.push_back(surface->GetPointData()->GetNormals()->GetVariantValue(i).ToDouble());
    }
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      all.push_back(ids->GetVariantValue(i).ToDouble());
    }
    return all;
  };
  filter->SetNumberOfThreads(1);
  const std::vector<double> expected = bits();
  onEachBackend(
    [&](const char* backend)
    {
      for (const int threads : {0, 2, 3})
      {
        filter->SetNumberOfThreads(threads);
        filter->Modified();
        EXPECT_EQ(bits(), expected) << backend << " " << threads;
      }
    });
}

TEST_F(Surfaces, AreInTheFirstPieceAndOfTheWholeSource)
{
  const vtkIdType cells = this->update()->GetNumberOfCells();
  filter->Modified();
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), cells);
  EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), 0) << "half a sphere would be open";
}

TEST_F(Surfaces, KeepWhatWasBuiltAndFollowTheirSource)
{
  this->update();
  filter->SetResolution(25);
  this->update();
  EXPECT_EQ(filter->GetPrepareSeconds(), 0) << "nothing was built";
  sphere->SetRadius(3);
  EXPECT_NEAR(this->update()->GetBounds()[1], 3, 0.1) << "and so does the grid";
  EXPECT_GT(filter->GetPrepareSeconds(), 0);
}

TEST_F(Surfaces, ProgressRisesToOneAndAbortLeavesAnEmptyOutput)
{
  sphere->SetEndPhi(120);
  {
    const ProgressLog log(filter);
    this->update();
    EXPECT_TRUE(log.isRising());
    EXPECT_EQ(log.last(), 1);
  }
  for (const double share : {0.0, 0.2, 0.6})
  {
    const ProgressLog log(filter, share);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberSurface::ABORTED) << share;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  filter->Modified();
  EXPECT_GT(this->update()->GetNumberOfCells(), 0);
}

TEST_F(Surfaces, BadInputIsRefusedAndTheFilterGoesOnWorking)
{
  filter->SetResolution(-1);
  this->expectRefused("Resolution is -1");
  filter->SetResolution(8);
  filter->SetPadding(-1);
  this->expectRefused("Padding is -1");
  filter->SetPadding(0.05);
  filter->SetMethod(17);
  this->expectRefused("Method is 17");
  filter->SetMethod(vtkWindingNumberSurface::PARITY);
  filter->SetVerifySamples(10);
  this->expectRefused("parity is no winding number");
  filter->SetMethod(vtkWindingNumberSurface::AUTOMATIC);
  filter->SetWindingThreshold(std::nan(""));
  this->expectRefused("WindingThreshold is nan");
  filter->SetWindingThreshold(0.5);
  vtkNew<vtkPolyData> cloud;
  sphere->Update();
  cloud->SetPoints(sphere->GetOutput()->GetPoints());
  filter->SetInputData(cloud);
  filter->MendSourceOff();
  this->expectRefused("normals");
  filter->SetInputConnection(sphere->GetOutputPort());
  {
    ErrorLog log(filter);
    filter->SetResolution(60000);
    filter->Update();
    EXPECT_NE(log.errors().find("GiB"), std::string::npos) << log.errors();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberSurface::OUT_OF_MEMORY);
    filter->RemoveAllObservers();
  }
  filter->SetResolution(8);
  EXPECT_GT(this->update()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetNumberOfVerifiedSamples(), 10);
  EXPECT_LT(filter->GetMaxError(), 1e-6);
}

TEST_F(Surfaces, OfNothingAreEmptyWithAWarning)
{
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  ErrorLog log(filter);
  EXPECT_EQ(this->update()->GetNumberOfCells(), 0);
  EXPECT_EQ(log.errors(), "");
  EXPECT_NE(log.warnings().find("the source is empty"), std::string::npos) << log.warnings();
  EXPECT_EQ(log.warnings().find("no sample is inside"), std::string::npos) << log.warnings();
}

} // namespace
