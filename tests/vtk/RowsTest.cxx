// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

/// The method that finds whole rows at once, on a sphere with a part cut off.
class Rows : public testing::Test
{
protected:
  Rows()
  {
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(20);
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetResolution(22);
    field->SetOutputScalarTypeToDouble();
  }

  vtkSmartPointer<vtkImageData> output(int method)
  {
    field->SetMethod(method);
    field->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(field->GetOutput());
    return copy;
  }

  double largestDifference(vtkImageData* a, vtkImageData* b)
  {
    double largest = 0;
    for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
    {
      largest = std::max(largest, std::abs(a->GetPointData()->GetScalars()->GetTuple1(i) -
                                           b->GetPointData()->GetScalars()->GetTuple1(i)));
    }
    return largest;
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> field;
};

TEST_F(Rows, GiveNothingButIntegersForAClosedSurface)
{
  auto image = this->output(vtkWindingNumberField::ROWS);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(values->GetTuple1(i), std::round(values->GetTuple1(i)));
  }
  EXPECT_EQ(field->GetNumberOfCapTriangles(), 0);
  // Measured 4e-16.
  EXPECT_LT(largestDifference(image, this->output(vtkWindingNumberField::DIRECT)), 1e-13);
}

TEST_F(Rows, EqualTheDirectSumForAnOpenSurface)
{
  sphere->SetEndPhi(120);
  field->SetTolerance(0);
  auto image = this->output(vtkWindingNumberField::ROWS);
  EXPECT_EQ(field->GetNumberOfNetBoundaryEdges(), 30);
  EXPECT_EQ(field->GetNumberOfCapTriangles(), 28);
  // Measured 1.0e-13, at a sample near the rim; 7e-15 elsewhere.
  auto direct = this->output(vtkWindingNumberField::DIRECT);
  EXPECT_LT(largestDifference(image, direct), 5e-13);
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
  {
    field->SetTolerance(tolerance);
    // Measured: a tenth of the tolerance.
    EXPECT_LT(largestDifference(this->output(vtkWindingNumberField::ROWS), direct), tolerance);
  }
}

TEST_F(Rows, AndOtherMethodsSayWhatTheyAreExpectedToTake)
{
  for (const int method : {vtkWindingNumberField::ROWS, vtkWindingNumberField::HIERARCHICAL,
         vtkWindingNumberField::DIRECT})
  {
    auto image = this->output(method);
    EXPECT_GE(field->GetExpectedSeconds(), field->GetEvaluateSeconds())
      << "what took less than a second took what it took";
    EXPECT_GT(field->GetExpectedMemory(), image->GetNumberOfPoints() * 8) << "doubles, and a field";
    EXPECT_LT(field->GetExpectedMemory(), image->GetNumberOfPoints() * 8 + 1'000'000);
  }
}

TEST_F(Rows, AreChosenForSurfacesWithSmallCaps)
{
  this->output(vtkWindingNumberField::AUTOMATIC);
  EXPECT_STREQ(field->GetMethodUsed(), "rows");
  EXPECT_NE(std::string(field->GetMethodReason()).find("closed"), std::string::npos);
  sphere->SetEndPhi(120);
  this->output(vtkWindingNumberField::AUTOMATIC);
  EXPECT_STREQ(field->GetMethodUsed(), "rows");
  EXPECT_NE(std::string(field->GetMethodReason()).find("28 triangles over 30 boundary edges"),
    std::string::npos)
    << field->GetMethodReason();
  field->SetVerifySamples(10);
  field->Update();
  EXPECT_LT(field->GetMaxError(), 1e-3); // measured: 2.4e-5
}

TEST_F(Rows, AreNotChosenWhereTheCapIsNoSmallerThanTheSurface)
{
  // The cap of a single triangle is the same triangle turned round.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0.2);
  points->InsertNextPoint(0, 1, 0.3);
  vtkNew<vtkCellArray> polys;
  const vtkIdType ids[3] = {0, 1, 2};
  polys->InsertNextCell(3, ids);
  vtkNew<vtkPolyData> triangle;
  triangle->SetPoints(points);
  triangle->SetPolys(polys);
  field->SetInputData(triangle);
  auto direct = this->output(vtkWindingNumberField::AUTOMATIC);
  EXPECT_STREQ(field->GetMethodUsed(), "direct");
  EXPECT_LT(largestDifference(direct, this->output(vtkWindingNumberField::ROWS)), 1e-13)
    << "nor where they are asked for";
  EXPECT_STREQ(field->GetMethodUsed(), "direct");
}

TEST_F(Rows, GiveTheSideOfFacesOnGridPlanesEverywhereAlike)
{
  // Voxels have sides of 1/4, and samples lie in all six planes of the unit cube.
  vtkNew<vtkCubeSource> cube;
  field->SetInputConnection(cube->GetOutputPort());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1.125, 1.125, -1.125, 1.125, -1.125, 1.125);
  field->SetSamplingDimensions(9, 9, 9);
  auto image = this->output(vtkWindingNumberField::ROWS);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    // A sample on a face counts as moved towards +x, +y and +z.
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = inside && p[axis] >= -0.5 && p[axis] < 0.5;
    }
    ASSERT_EQ(image->GetPointData()->GetScalars()->GetTuple1(i), inside)
      << p[0] << " " << p[1] << " " << p[2];
  }
}

TEST_F(Rows, ThreadsAndPiecesGiveTheSameBits)
{
  sphere->SetEndPhi(120);
  auto whole = this->output(vtkWindingNumberField::ROWS);
  for (const char* backend : {"Sequential", "STDThread"})
  {
    const std::string before = vtkSMPTools::GetBackend();
    vtkSMPTools::SetBackend(backend);
    for (int piece = 0; piece < 7; ++piece)
    {
      field->Modified();
      field->UpdatePiece(piece, 7, 0);
      vtkImageData* part = field->GetOutput();
      for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
      {
        ASSERT_EQ(part->GetPointData()->GetScalars()->GetTuple1(i),
          whole->GetPointData()->GetScalars()->GetTuple1(whole->FindPoint(part->GetPoint(i))));
      }
    }
    vtkSMPTools::SetBackend(before.c_str());
  }
}

TEST_F(Rows, InsideAloneIsThatOfTheValues)
{
  sphere->SetEndPhi(120);
  field->GenerateInsideOn();
  field->SetOutputScalarTypeToFloat();
  for (int rule : {vtkWindingNumberField::SIGNED, vtkWindingNumberField::ODD})
  {
    field->SetInsideRule(rule);
    for (int method : {vtkWindingNumberField::ROWS, vtkWindingNumberField::DIRECT})
    {
      field->GenerateWindingNumberOn();
      auto both = this->output(method);
      field->GenerateWindingNumberOff();
      auto alone = this->output(method);
      EXPECT_EQ(alone->GetPointData()->GetArray("WindingNumber"), nullptr);
      vtkDataArray* inside = alone->GetPointData()->GetArray("Inside");
      EXPECT_EQ(alone->GetPointData()->GetScalars(), inside);
      for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(inside->GetTuple1(i), both->GetPointData()->GetArray("Inside")->GetTuple1(i));
      }
    }
  }
}

TEST_F(Rows, NothingToGenerateIsRefused)
{
  ErrorLog log(field);
  field->GenerateWindingNumberOff();
  field->Update();
  EXPECT_NE(log.errors().find("nothing is to be generated"), std::string::npos) << log.errors();
  field->GenerateInsideOn();
  field->SetVerifySamples(5);
  field->Update();
  EXPECT_NE(log.errors().find("only winding numbers can be verified"), std::string::npos)
    << log.errors();
}

TEST_F(Rows, TakeGridsAndScatteredSamplesAndNeedTriangles)
{
  vtkNew<vtkWindingNumberProbe> probe;
  ErrorLog log(probe);
  probe->SetMethod(vtkWindingNumberProbe::ROWS);
  probe->SetInputConnection(sphere->GetOutputPort());
  probe->SetSourceConnection(sphere->GetOutputPort());
  probe->Update();
  sphere->SetEndPhi(150); // which opens it
  probe->Update();
  EXPECT_STREQ(probe->GetMethodUsed(), "rows");
  EXPECT_EQ(log.errors(), "");
  field->SetSourceAsPoints(1);
  ErrorLog fieldLog(field);
  this->output(vtkWindingNumberField::ROWS);
  EXPECT_NE(fieldLog.errors().find("rows needs triangles"), std::string::npos) << fieldLog.errors();
}

} // namespace
