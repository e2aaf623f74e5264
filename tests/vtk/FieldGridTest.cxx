// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// A unit cube around the origin.
class FieldGrid : public testing::Test
{
protected:
  FieldGrid() { field->SetInputConnection(cube->GetOutputPort()); }

  void expectRefused(const std::string& part)
  {
    ErrorLog log(field);
    field->Update();
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
    EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkWindingNumberField> field;
};

TEST_F(FieldGrid, DefaultsAreTheDocumentedOnes)
{
  EXPECT_EQ(field->GetResolution(), 128);
  EXPECT_EQ(field->GetVoxelSize(), 0);
  EXPECT_EQ(field->GetUseInputBounds(), 1);
  EXPECT_EQ(field->GetPadding(), 0.05);
  EXPECT_EQ(field->GetOutputAssociation(), vtkWindingNumberField::POINTS);
  EXPECT_EQ(field->GetMethod(), vtkWindingNumberField::AUTOMATIC);
  EXPECT_EQ(field->GetTolerance(), 1e-3);
  EXPECT_EQ(field->GetWindingThreshold(), 0.5);
  EXPECT_EQ(field->GetInsideRule(), vtkWindingNumberField::SIGNED);
  EXPECT_EQ(field->GetGenerateInside(), 0);
  EXPECT_STREQ(field->GetResultArrayName(), "WindingNumber");
  EXPECT_EQ(field->GetOutputScalarType(), VTK_FLOAT);
  EXPECT_EQ(field->GetNumberOfThreads(), 0);
}

TEST_F(FieldGrid, VoxelsAreCubicAndCoverThePaddedBounds)
{
  cube->SetYLength(0.4);
  field->SetResolution(24);
  field->Update();
  vtkImageData* image = field->GetOutput();
  int dimensions[3];
  image->GetDimensions(dimensions);
  const double size = 1.1 / 24;
  EXPECT_EQ(dimensions[0], 24);
  EXPECT_EQ(dimensions[1], 11) << "0.4 and twice 0.05 are 10.9 voxels";
  EXPECT_EQ(dimensions[2], 24);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(image->GetSpacing()[axis], size);
    // The samples are the voxels' centres, and the grid is centred on the input.
    EXPECT_NEAR(image->GetOrigin()[axis], -0.5 * (dimensions[axis] - 1) * size, 1e-15);
  }
}

TEST_F(FieldGrid, PointsAndCellsHoldTheSameValues)
{
  field->SetResolution(11);
  field->Update();
  vtkNew<vtkImageData> points;
  points->DeepCopy(field->GetOutput());
  field->SetOutputAssociationToCells();
  field->Update();
  vtkImageData* cells = field->GetOutput();
  ASSERT_EQ(points->GetNumberOfPoints(), cells->GetNumberOfCells());
  EXPECT_EQ(cells->GetPointData()->GetNumberOfArrays(), 0);
  vtkDataArray* a = points->GetPointData()->GetScalars();
  vtkDataArray* b = cells->GetCellData()->GetScalars();
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(a->GetTuple1(i), b->GetTuple1(i)) << i;
  }
  EXPECT_NEAR(cells->GetBounds()[0], -11. / 18, 1e-15) << "cells are the voxels";
  EXPECT_NEAR(points->GetBounds()[0], -10. / 18, 1e-15) << "points are their centres";
}

TEST_F(FieldGrid, ValuesAreThoseOfTheCube)
{
  field->SetResolution(11); // voxels of 0.1: every sample is off the surface but those at ±0.5
  field->GenerateInsideOn();
  field->Update();
  vtkImageData* image = field->GetOutput();
  auto* inside = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray("Inside"));
  ASSERT_NE(inside, nullptr);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double distance = std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    if (std::abs(distance - 0.5) < 1e-6)
    {
      continue;
    }
    const double w = image->GetPointData()->GetScalars()->GetTuple1(i);
    ASSERT_FLOAT_EQ(static_cast<float>(w + 1), distance < 0.5 ? 2.0F : 1.0F);
    ASSERT_EQ(inside->GetValue(i), distance < 0.5);
  }
}

TEST_F(FieldGrid, DimensionsFillTheGivenBounds)
{
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 1, -1, 2, 0, 1);
  field->SetSamplingDimensions(4, 6, 5);
  field->SetOutputAssociationToCells();
  field->Update();
  double bounds[6];
  field->GetOutput()->GetBounds(bounds);
  const double expected[6] = {-1, 1, -1, 2, 0, 1};
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_DOUBLE_EQ(bounds[i], expected[i]);
  }
  EXPECT_EQ(field->GetOutput()->GetNumberOfCells(), 4 * 6 * 5);
}

TEST_F(FieldGrid, VoxelSizeWinsOverResolution)
{
  field->SetResolution(1000);
  field->SetVoxelSize(0.25);
  field->Update();
  EXPECT_EQ(field->GetOutput()->GetDimensions()[0], 6); // (1 + 2 * 0.25) / 0.25
  EXPECT_EQ(field->GetOutput()->GetSpacing()[0], 0.25);
}

TEST_F(FieldGrid, InsideFollowsRuleAndThreshold)
{
  // The winding number is 1 at the centre of the sphere.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetSamplingDimensions(3, 3, 3);
  field->GenerateInsideOn();
  const auto centerIsInside = [this]()
  {
    field->Update();
    return field->GetOutput()->GetPointData()->GetArray("Inside")->GetTuple1(13) == 1;
  };
  EXPECT_TRUE(centerIsInside());
  field->SetWindingThreshold(1.5);
  EXPECT_FALSE(centerIsInside());
  field->SetInsideRule(vtkWindingNumberField::ODD);
  EXPECT_TRUE(centerIsInside()) << "the odd rule knows no threshold";
  field->SetInsideRule(vtkWindingNumberField::ABSOLUTE);
  EXPECT_FALSE(centerIsInside());
  field->SetWindingThreshold(0.5);
  EXPECT_TRUE(centerIsInside());
}

TEST_F(FieldGrid, ArrayNameAndTypeAreTheUsers)
{
  field->SetResolution(8);
  field->SetResultArrayName("w");
  field->SetOutputScalarTypeToDouble();
  field->Update();
  vtkDataArray* array = field->GetOutput()->GetPointData()->GetArray("w");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(field->GetOutput()->GetPointData()->GetScalars(), array);
}

TEST_F(FieldGrid, OutputSaysHowItWasMade)
{
  EXPECT_STREQ(field->GetMethodUsed(), "") << "nothing is made yet";
  field->SetResolution(8);
  field->Update();
  vtkFieldData* data = field->GetOutput()->GetFieldData();
  auto* method = vtkStringArray::SafeDownCast(data->GetAbstractArray("WindingNumberMethod"));
  ASSERT_NE(method, nullptr);
  EXPECT_EQ(method->GetValue(0), "rows") << "a cube is closed";
  EXPECT_STREQ(field->GetMethodUsed(), "rows");
  EXPECT_EQ(field->GetNumberOfCapTriangles(), 0);
  EXPECT_NE(data->GetAbstractArray("WindingNumberMethodReason"), nullptr);
  EXPECT_TRUE(field->GetSourceIsSurface());
  EXPECT_EQ(field->GetNumberOfPrimitives(), 12);
  EXPECT_EQ(field->GetNumberOfWeldedVertices(), 8);
  EXPECT_EQ(field->GetNumberOfBoundaryEdges(), 0);
}

TEST_F(FieldGrid, ParityEqualsTheDirectSumOnAClosedSurface)
{
  vtkNew<vtkSphereSource> sphere;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(16);
  field->Update();
  vtkNew<vtkImageData> direct;
  direct->DeepCopy(field->GetOutput());
  field->SetMethod(vtkWindingNumberField::PARITY);
  field->Update();
  EXPECT_STREQ(field->GetMethodUsed(), "parity");
  for (vtkIdType i = 0; i < direct->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(std::round(direct->GetPointData()->GetScalars()->GetTuple1(i)),
      field->GetOutput()->GetPointData()->GetScalars()->GetTuple1(i))
      << i;
  }
}

TEST_F(FieldGrid, VerificationFindsTheSumsToBeEqual)
{
  field->SetResolution(20);
  field->SetVerifySamples(100);
  field->SetOutputScalarTypeToDouble();
  field->Update();
  EXPECT_EQ(field->GetNumberOfVerifiedSamples(), 100);
  EXPECT_EQ(field->GetNumberOfNearVerifiedSamples(), 100);
  EXPECT_EQ(field->GetNumberOfSamplesOnSurface(), 0);
  EXPECT_LT(field->GetMaxError(), 1e-14); // measured 3e-16
  EXPECT_LT(field->GetNearMaxError(), 1e-14);
  EXPECT_LE(field->GetRMSError(), field->GetMaxError());
}

TEST_F(FieldGrid, VerificationCountsSamplesOnTheSurfaceApart)
{
  field->SetUseInputBounds(false);
  const double bounds[6] = {-0.75, 0.75, -0.75, 0.75, -0.75, 0.75};
  field->SetSamplingBounds(bounds);
  field->SetSamplingDimensions(3, 3, 3); // at −0.5, 0 and 0.5, so that only the middle is not on it
  field->SetVerifySamples(100);
  for (const int method : {vtkWindingNumberField::ROWS, vtkWindingNumberField::HIERARCHICAL,
         vtkWindingNumberField::DIRECT})
  {
    field->SetMethod(method);
    field->Update();
    EXPECT_GT(field->GetNumberOfSamplesOnSurface(), 150);
    EXPECT_EQ(field->GetNumberOfSamplesOnSurface() + field->GetNumberOfVerifiedSamples() +
                field->GetNumberOfNearVerifiedSamples(),
      200);
    EXPECT_LT(field->GetMaxError(), 1e-3);
    EXPECT_LT(field->GetNearMaxError(), 1e-3);
  }
}

/// All threads look at the same values, which are 0 or 1 here. When they shared a place to look at
/// them, one run in ten to fifty took the value of another sample for its own.
TEST_F(FieldGrid, VerificationIsTheSameAsOftenAsItIsMade)
{
  field->SetUseInputBounds(false);
  const double bounds[6] = {-0.8125, 0.8125, -0.8125, 0.8125, -0.8125, 0.8125};
  field->SetSamplingBounds(bounds);
  field->SetSamplingDimensions(13, 13, 13);
  field->SetVerifySamples(500);
  for (int run = 0; run < 200; ++run)
  {
    field->Modified();
    field->Update();
    ASSERT_LT(field->GetMaxError(), 1e-6) << "run " << run;
    ASSERT_LT(field->GetNearMaxError(), 1e-6) << "run " << run;
  }
}

TEST_F(FieldGrid, PropertiesThatMakeNoGridAreRefused)
{
  field->SetResolution(-1);
  expectRefused("Resolution is -1");
  field->SetResolution(-5);
  expectRefused("Resolution is -5");
  field->SetResolution(8);
  field->SetVoxelSize(-1);
  expectRefused("VoxelSize is -1");
  field->SetVoxelSize(0);
  field->SetPadding(-0.1);
  expectRefused("Padding is -0.1");
  field->SetPadding(0);
  field->SetSamplingDimensions(4, 0, 4);
  expectRefused("SamplingDimensions is 0 along y");
  field->SetSamplingDimensions(0, 0, 0);
  field->UseInputBoundsOff();
  field->SetSamplingBounds(1, 0, 0, 1, 0, 1);
  expectRefused("inverted or not finite");
  field->SetSamplingBounds(0, std::numeric_limits<double>::quiet_NaN(), 0, 1, 0, 1);
  expectRefused("inverted or not finite");
  field->SetSamplingBounds(0, 1, 0, 1, 0, 1);
  field->SetMethod(17);
  expectRefused("Method is 17");
  field->SetMethod(vtkWindingNumberField::AUTOMATIC);
  field->SetOutputScalarType(VTK_INT);
  expectRefused("OutputScalarType is 6");
}

TEST_F(FieldGrid, ParityIsNotVerified)
{
  field->SetResolution(8);
  field->SetMethod(vtkWindingNumberField::PARITY);
  field->SetVerifySamples(10);
  expectRefused("parity is no winding number");
}

TEST_F(FieldGrid, ResultBeyondTheMemoryIsRefusedBeforeItIsAllocated)
{
  ErrorLog log(field);
  field->SetResolution(60000); // 2e14 samples
  field->Update();
  EXPECT_NE(log.errors().find("GiB"), std::string::npos) << log.errors();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::OUT_OF_MEMORY);
  field->SetResolution(8);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE)
    << "and the filter goes on working: " << log.errors();
}

} // namespace
