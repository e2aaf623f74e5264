// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"
#include "vtk/ReadMesh.h"
#include "vtk/SphereCloud.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStaticPointLocator.h"
#include "vtkTriangleFilter.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

/**
 * Tests of the array SignedDistance that filters write.
 */
namespace
{

vtkDataArray* distancesOf(vtkDataSet* data)
{
  return data->GetPointData()->GetArray("SignedDistance");
}

std::vector<double> numbersOf(vtkDataArray* array)
{
  std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  return numbers;
}

class SignedDistance : public testing::Test
{
protected:
  SignedDistance()
  {
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(20);
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetResolution(22);
    field->GenerateSignedDistanceOn();
  }

  vtkNew<vtkSphereSource> sphere; // radius 0.5
  vtkNew<vtkWindingNumberField> field;
};

/// Tests on meshes that are closed, open, badly damaged, and flat.
class SignedDistanceOf : public testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(SignedDistanceOf, SharedMeshIsTheDistanceOfVTKWithTheSignOfInside)
{
  vtkNew<vtkTriangleFilter> mesh;
  mesh->SetInputData(readMesh(shapes::realMesh(GetParam())));
  mesh->Update();
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(mesh->GetOutputPort());
  field->SetSamplingDimensions(60, 41, 33);
  field->GenerateSignedDistanceOn();
  field->GenerateInsideOn();
  field->Update();
  vtkImageData* image = field->GetOutput();
  vtkDataArray* distances = distancesOf(image);
  vtkDataArray* inside = image->GetPointData()->GetArray("Inside");
  ASSERT_EQ(distances->GetDataType(), VTK_FLOAT);
  vtkNew<vtkImplicitPolyDataDistance> expected;
  expected->SetInput(mesh->GetOutput());
  const double size = image->GetLength();
  double worst = 0;
  vtkIdType onSurface = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double distance = distances->GetTuple1(i);
    // A distance of 0 has no sign, and its sample may count as inside.
    ASSERT_TRUE(distance == 0 || (distance < 0) == (inside->GetTuple1(i) == 1)) << i;
    onSurface += distance == 0;
    if (i % 173 == 0)
    {
      // The boxes of cells and the tolerances of VTK's function are of single precision.
      const double other = std::abs(expected->EvaluateFunction(image->GetPoint(i)));
      worst = std::max(worst, std::abs(std::abs(distance) - other) / size);
    }
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(onSurface, image->GetNumberOfPoints() / 20);
  RecordProperty("samples on the surface", std::to_string(onSurface));
  RecordProperty("largest difference", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Some, SignedDistanceOf,
  testing::ValuesIn(shapes::present(
    {"armadillo_86k.obj", "bunny_10k.obj", "teapot.obj", "tray_thin_cad.stl", "truck_soup.obj",
      "conrod_flipped.stl", "fractures_dfn2.vtp", "bunny_res2_nonmanifold.ply"})));

TEST_F(SignedDistance, IsOffUnlessAskedFor)
{
  vtkNew<vtkWindingNumberField> plain;
  EXPECT_EQ(plain->GetGenerateSignedDistance(), 0);
  EXPECT_EQ(plain->GetDistanceBand(), 0);
  plain->SetInputConnection(sphere->GetOutputPort());
  plain->SetResolution(8);
  plain->Update();
  EXPECT_EQ(distancesOf(plain->GetOutput()), nullptr);
}

TEST_F(SignedDistance, EveryCombinationOfArraysHasTheSameOne)
{
  field->Update();
  const std::vector<double> expected = numbersOf(distancesOf(field->GetOutput()));
  for (const bool withValues : {false, true})
  {
    for (const bool withInside : {false, true})
    {
      field->SetGenerateWindingNumber(withValues);
      field->SetGenerateInside(withInside);
      field->Update();
      vtkPointData* data = field->GetOutput()->GetPointData();
      EXPECT_EQ(data->GetNumberOfArrays(), 1 + withValues + withInside);
      EXPECT_EQ(numbersOf(data->GetArray("SignedDistance")), expected);
      EXPECT_STREQ(data->GetScalars()->GetName(), withValues   ? "WindingNumber"
                                                  : withInside ? "Inside"
                                                               : "SignedDistance");
    }
  }
}

TEST_F(SignedDistance, PiecesThreadsAndCellsHaveTheBitsOfTheWhole)
{
  sphere->SetEndPhi(120);
  for (const double band : {0.0, 2.5})
  {
    field->SetDistanceBand(band);
    field->SetNumberOfThreads(1);
    field->SetOutputAssociationToPoints();
    field->Update();
    vtkNew<vtkImageData> whole;
    whole->DeepCopy(field->GetOutput());
    const std::vector<double> expected = numbersOf(distancesOf(whole));
    field->SetNumberOfThreads(0);
    field->SetOutputAssociationToCells();
    field->Update();
    EXPECT_EQ(numbersOf(field->GetOutput()->GetCellData()->GetArray("SignedDistance")), expected);
    field->SetOutputAssociationToPoints();
    for (int piece = 0; piece < 5; ++piece)
    {
      field->Modified();
      field->UpdatePiece(piece, 5, 0);
      vtkImageData* part = field->GetOutput();
      const std::vector<double> found = numbersOf(distancesOf(part));
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const vtkIdType same = whole->FindPoint(part->GetPoint(static_cast<vtkIdType>(i)));
        ASSERT_EQ(found[i], expected[static_cast<std::size_t>(same)]);
      }
    }
  }
}

TEST_F(SignedDistance, BandIsInVoxelsOfTheirLongestSide)
{
  field->SetSamplingDimensions(40, 10, 25);
  field->Update();
  const std::vector<double> full = numbersOf(distancesOf(field->GetOutput()));
  const double longest = field->GetOutput()->GetSpacing()[1];
  field->SetDistanceBand(1.5);
  field->Update();
  EXPECT_EQ(field->GetPrepareSeconds(), 0) << "nothing was built";
  const std::vector<double> band = numbersOf(distancesOf(field->GetOutput()));
  const auto limit = static_cast<float>(1.5 * longest);
  int limited = 0;
  for (std::size_t i = 0; i < full.size(); ++i)
  {
    EXPECT_EQ(band[i], std::clamp<double>(full[i], -limit, limit));
    limited += std::abs(full[i]) > limit;
  }
  EXPECT_GT(limited, 1000);
}

TEST_F(SignedDistance, IsThatOfTheCentresWhateverTheCoverage)
{
  field->Update();
  const std::vector<double> expected = numbersOf(distancesOf(field->GetOutput()));
  for (const int coverage : {vtkWindingNumberField::ANY, vtkWindingNumberField::FRACTION})
  {
    for (const bool withValues : {true, false})
    {
      field->SetCoverage(coverage);
      field->SetGenerateWindingNumber(withValues);
      field->Update();
      EXPECT_EQ(numbersOf(distancesOf(field->GetOutput())), expected);
    }
  }
}

TEST_F(SignedDistance, CloudsAndMeshesAsPointsHaveThatOfTheirPoints)
{
  sphere->Update();
  for (const bool isCloud : {false, true})
  {
    const vtkSmartPointer<vtkPolyData> source =
      isCloud ? sphereCloud(700, 1) : vtkSmartPointer<vtkPolyData>(sphere->GetOutput());
    field->SetInputData(source);
    field->SourceAsPointsOn();
    field->GenerateInsideOn();
    field->SetOutputScalarTypeToDouble();
    field->Update();
    vtkImageData* image = field->GetOutput();
    ASSERT_EQ(distancesOf(image)->GetDataType(), VTK_DOUBLE);
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(source);
    locator->BuildLocator();
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double at[3], nearest[3];
      image->GetPoint(i, at);
      source->GetPoint(locator->FindClosestPoint(at), nearest);
      const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(at, nearest));
      const double sign = image->GetPointData()->GetArray("Inside")->GetTuple1(i) == 1 ? -1 : 1;
      ASSERT_NEAR(distancesOf(image)->GetTuple1(i), sign * distance, 1e-14);
    }
  }
}

TEST_F(SignedDistance, ProbeHasTheFields)
{
  field->SetOutputScalarTypeToDouble();
  field->Update();
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(field->GetOutput());
  probe->SetSourceConnection(sphere->GetOutputPort());
  probe->SetOutputScalarTypeToDouble();
  probe->GenerateSignedDistanceOn();
  probe->GenerateWindingNumberOff();
  probe->Update();
  const std::vector<double> expected = numbersOf(distancesOf(field->GetOutput()));
  const std::vector<double> found = numbersOf(distancesOf(probe->GetOutput()));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_NEAR(found[i], expected[i], 1e-15);
  }
  probe->InsideOutOn();
  probe->Update();
  EXPECT_EQ(numbersOf(distancesOf(probe->GetOutput())), found) << "the other side is no distance's";
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("Inside"), nullptr);
  vtkNew<vtkPoints> nowhere;
  nowhere->SetDataTypeToDouble();
  nowhere->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(nowhere);
  probe->SetInputData(queries);
  probe->Update();
  EXPECT_TRUE(std::isnan(distancesOf(probe->GetOutput())->GetTuple1(0)));
}

TEST_F(SignedDistance, ProgressRisesToOneAndAbortLeavesNothing)
{
  field->SetResolution(60);
  {
    const ProgressLog log(field);
    field->Update();
    EXPECT_TRUE(log.isRising());
    EXPECT_EQ(log.last(), 1);
  }
  // Values are a hundredth of all work, so this progress lies among the distances.
  const ProgressLog log(field, 0.05);
  field->Modified();
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::ABORTED);
  EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(SignedDistance, BadOptionsAreRefusedInOneLine)
{
  const auto expectRefused = [this](const std::string& part)
  {
    ErrorLog log(field);
    field->Update();
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  };
  field->SetDistanceBand(-1);
  expectRefused("DistanceBand is -1;");
  field->SetDistanceBand(std::numeric_limits<double>::quiet_NaN());
  expectRefused("DistanceBand is nan;");
  field->SetDistanceBand(std::numeric_limits<double>::infinity());
  expectRefused("DistanceBand is inf;");
  field->SetDistanceBand(0);
  field->SetResultArrayName("SignedDistance");
  expectRefused("two arrays of the result are named 'SignedDistance'");
  field->GenerateWindingNumberOff();
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE) << "there is one of that name only";
  field->GenerateSignedDistanceOff();
  expectRefused("nothing is to be generated");
}

TEST_F(SignedDistance, MemoryIsExpectedAndRefused)
{
  const auto expected = [this]
  {
    field->Update();
    return field->GetExpectedMemory();
  };
  const vtkIdType with = expected();
  const vtkIdType samples = field->GetOutput()->GetNumberOfPoints();
  field->GenerateWindingNumberOff();
  EXPECT_EQ(expected(), with - 3 * samples) << "signs take a byte";
  field->GenerateWindingNumberOn();
  field->GenerateSignedDistanceOff();
  EXPECT_LT(expected(), with - 4 * samples - 100 * field->GetNumberOfPrimitives());
  field->GenerateSignedDistanceOn();
  field->SetResolution(60000);
  ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::OUT_OF_MEMORY) << log.errors();
}

TEST_F(SignedDistance, NothingIsFarFromAll)
{
  vtkNew<vtkPolyData> nothing;
  field->SetInputData(nothing);
  field->UseInputBoundsOff();
  ErrorLog log(field);
  field->Update();
  EXPECT_NE(log.warnings().find("the source is empty"), std::string::npos);
  EXPECT_EQ(distancesOf(field->GetOutput())->GetTuple1(0), std::numeric_limits<float>::max());
}
