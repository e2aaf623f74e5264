// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/NormalsOfSpheres.h"

#include "vtkAppendPolyData.h"
#include "vtkExtractSurface.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSignedDistance.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"

#include <cmath>
#include <limits>

namespace
{

using namespace spheres;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Two nested spheres, on which the spanning tree fails, without normals.
vtkSmartPointer<vtkPolyData> bareShell()
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(cloud());
  auto inner = cloud();
  for (vtkIdType i = 0; i < inner->GetNumberOfPoints(); ++i)
  {
    const double* at = inner->GetPoint(i);
    const double position[3] = {0.7 * at[0], 0.7 * at[1], 0.7 * at[2]};
    inner->GetPoints()->SetPoint(i, position);
  }
  append->AddInputData(inner);
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  vtkSmartPointer<vtkPolyData> shell = append->GetOutput();
  shell->GetPointData()->Initialize();
  return shell;
}

} // namespace

TEST_F(Normals, AreEstimatedOnRequest)
{
  auto input = cloud();
  input->GetPointData()->Initialize();
  this->expectRefused(input, "the points have no normals");
  filter->EstimateNormalsOn();
  this->areasOf(input);
  EXPECT_NEAR(filter->GetTotalArea(), 4 * pi, 0.01 * 4 * pi);
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "spanning tree");
  EXPECT_EQ(filter->GetClearShare(), 1);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 2);
  auto* normals = vtkFloatArray::SafeDownCast(output->GetPointData()->GetNormals());
  ASSERT_TRUE(normals);
  EXPECT_STREQ(normals->GetName(), "Normals");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* at = output->GetPoint(i);
    double normal[3];
    normals->GetTuple(i, normal);
    ASSERT_GT(normal[0] * at[0] + normal[1] * at[1] + normal[2] * at[2], 0.98); // 0.993
  }
  EXPECT_FALSE(input->GetPointData()->GetNormals()) << "the input is as it was";

  filter->SetNormalEstimation(vtkWindingNumberAlgorithm::WINDING_CONSISTENT);
  this->areasOf(input);
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "winding consistent");
  filter->SetNormalEstimation(3);
  this->expectRefused(input, "NormalEstimation is 3");
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "");
  EXPECT_EQ(filter->GetClearShare(), 0);

  // Normals that came with the points stay.
  filter->SetNormalEstimation(vtkWindingNumberAlgorithm::ESTIMATION_AUTOMATIC);
  auto oriented = cloud();
  this->areasOf(oriented);
  output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(output->GetPointData()->GetNormals(), oriented->GetPointData()->GetNormals());
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "");
}

TEST_F(Normals, EstimatedNormalsGiveTheFieldOfTheWindingFilters)
{
  const auto shell = bareShell();
  filter->EstimateNormalsOn();
  this->areasOf(shell);
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "winding consistent");
  EXPECT_GT(filter->GetClearShare(), 0.99); // 1
  vtkNew<vtkWindingNumberField> own, other;
  own->SetInputData(shell);
  own->EstimateNormalsOn();
  other->SetInputConnection(filter->GetOutputPort());
  other->SetPointAreaMethod(vtkWindingNumberAlgorithm::ARRAY);
  for (auto* field : {own.Get(), other.Get()})
  {
    field->SetResolution(12);
    field->Update();
  }
  EXPECT_FALSE(other->GetNormalsWereEstimated());
  auto* values = own->GetOutput()->GetPointData()->GetScalars();
  auto* others = other->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(others->GetTuple1(i), values->GetTuple1(i)) << i;
  }
  // Areas that are found once more are the same, too.
  other->SetPointAreaMethod(vtkWindingNumberAlgorithm::VORONOI);
  other->Update();
  others = other->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(others->GetTuple1(i), values->GetTuple1(i)) << i;
  }
}

TEST_F(Normals, PointsOfMeshesGetTheNormalsOfTheirTriangles)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->GenerateNormalsOff();
  sphere->Update();
  this->areasOf(sphere->GetOutput());
  EXPECT_FALSE(vtkPolyData::SafeDownCast(filter->GetOutput())->GetPointData()->GetNormals());
  filter->EstimateNormalsOn();
  this->areasOf(sphere->GetOutput());
  EXPECT_STREQ(filter->GetNormalEstimationUsed(), "");
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  vtkDataArray* const normals = output->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* at = output->GetPoint(i);
    double normal[3];
    normals->GetTuple(i, normal);
    ASSERT_GT(normal[0] * at[0] + normal[1] * at[1] + normal[2] * at[2], 0.49); // radius 0.5
  }
}

TEST_F(Normals, EstimatedNormalsAreTakenByFiltersOfVtk)
{
  filter->SetInputData(bareShell());
  filter->EstimateNormalsOn();
  vtkNew<vtkSignedDistance> distance;
  distance->SetInputConnection(filter->GetOutputPort());
  distance->SetDimensions(60, 60, 60);
  distance->SetBounds(-1.2, 1.2, -1.2, 1.2, -1.2, 1.2);
  distance->SetRadius(0.15);
  vtkNew<vtkExtractSurface> surface;
  surface->SetInputConnection(distance->GetOutputPort());
  surface->SetRadius(0.15);
  surface->HoleFillingOff();
  surface->Update();
  EXPECT_NEAR(surfaceOf(surface->GetOutput()), 4 * pi * 1.49, 0.05 * 4 * pi * 1.49);
}

TEST_F(Normals, EstimatedNormalsOfUnusablePointsAreZero)
{
  auto input = cloud();
  input->GetPointData()->Initialize();
  input->GetPoints()->SetPoint(5, 0, notANumber, 0);
  filter->EstimateNormalsOn();
  ErrorLog log(filter);
  EXPECT_EQ(this->areasOf(input)[5], 0);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(output->GetPointData()->GetNormals()->GetComponent(5, 0), 0);
  EXPECT_NE(output->GetPointData()->GetNormals()->GetComponent(6, 2), 0);
  EXPECT_NE(log.warnings().find("unusable"), std::string::npos) << log.warnings();
}

TEST_F(Normals, EstimatedNormalsAreThoseOfAllLeaves)
{
  // A half of a sphere in each leaf, one of which has normals, which all are inward.
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int half = 0; half < 2; ++half)
  {
    auto all = cloud();
    vtkNew<vtkPolyData> part;
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetName("Normals");
    for (vtkIdType i = 0; i < all->GetNumberOfPoints(); ++i)
    {
      const double* at = all->GetPoint(i);
      if ((at[0] > 0) == (half == 0))
      {
        points->InsertNextPoint(at);
        normals->InsertNextTuple3(-at[0], -at[1], -at[2]);
      }
    }
    part->SetPoints(points);
    if (half == 0)
    {
      part->GetPointData()->SetNormals(normals);
    }
    blocks->SetBlock(half, part);
  }
  filter->EstimateNormalsOn();
  filter->SetInputData(blocks);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  for (unsigned int half = 0; half < 2; ++half)
  {
    auto* part = vtkPolyData::SafeDownCast(output->GetBlock(half));
    EXPECT_EQ(part->GetPointData()->GetNumberOfArrays(), 2);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      double normal[3];
      part->GetPointData()->GetNormals()->GetTuple(i, normal);
      const double* at = part->GetPoint(i);
      ASSERT_GT(normal[0] * at[0] + normal[1] * at[1] + normal[2] * at[2], 0);
    }
  }
}

TEST_F(Normals, EstimatedNormalsThatTellNoInsideComeWithAWarning)
{
  vtkNew<vtkPolyData> input;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 400; ++i)
  {
    points->InsertNextPoint(i % 20, i / 20, 0); // a sheet encloses nothing
  }
  input->SetPoints(points);
  filter->EstimateNormalsOn();
  ErrorLog log(filter);
  this->areasOf(input);
  EXPECT_NE(log.warnings().find("estimated normals are not right everywhere"), std::string::npos);
}
