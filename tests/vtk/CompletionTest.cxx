// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Sources that are half, open on one side, or sheets: mirrors, bases, sides and welding.

#include "vtk/ErrorLog.h"
#include "vtk/ImageSamples.h"

#include "vtkAppendPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

/// A sphere of radius 1 that is cut at y = 0 and at z = −0.5, in double precision.
vtkSmartPointer<vtkPolyData> halfDome()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkSmartPointer<vtkPolyData> surface;
  sphere->Update();
  surface = sphere->GetOutput();
  for (const auto& [origin, normal] :
    {std::pair<std::array<double, 3>, std::array<double, 3>>{{0, 0, 0}, {0, 1, 0}},
      {{0, 0, -0.5}, {0, 0, 1}}})
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(normal.data());
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(surface);
    clip->SetClipFunction(plane);
    clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    clip->Update();
    surface = clip->GetOutput();
  }
  return surface;
}

/// A sheet at a height that looks up or down.
vtkSmartPointer<vtkPolyData> sheetAt(double height, bool looksUp, double size = 1)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-size, -size, height);
  plane->SetPoint1(looksUp ? size : -size, looksUp ? -size : size, height);
  plane->SetPoint2(looksUp ? -size : size, looksUp ? size : -size, height);
  plane->SetResolution(8, 8);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  return plane->GetOutput();
}

void complete(vtkWindingNumberAlgorithm* filter)
{
  filter->SetMirror("y=0");
  filter->SetFlatBase("z=-0.5");
  filter->SetWeldTolerance(1e-9);
}

/// The volume of the dome.
const double volumeOfDome = M_PI * (2.0 / 3 + 0.5 - std::pow(0.5, 3) / 3);

} // namespace

TEST(Completion, HasTextsAboutSpaceOnATurnedImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->SetOrigin(-0.3, 0.6, -0.65); // on either side of mirror and base
  image->SetSpacing(1, 1, 0.2);
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  vtkNew<vtkWindingNumberField> field;
  const ErrorLog log(field);
  field->SetInputData(halfDome());
  field->SetLikeData(image);
  complete(field);
  field->Update();
  EXPECT_EQ(log.errors(), "");
  ASSERT_EQ(field->GetOutput()->GetNumberOfPoints(), 8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    double at[3];
    field->GetOutput()->GetPoint(i, at);
    const bool isInside = std::hypot(at[0], at[1], at[2]) < 1 && at[2] > -0.5;
    EXPECT_NEAR(
      field->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0), isInside, 1e-6)
      << at[0] << ' ' << at[1] << ' ' << at[2];
  }
}

TEST(Completion, MakesTheWholeOfHalfADome)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(halfDome());
  complete(field);
  field->GenerateInsideOn();
  field->SetResolution(60);
  field->Update();
  double bounds[6];
  field->GetOutput()->GetBounds(bounds);
  EXPECT_LT(bounds[2], -1);
  EXPECT_EQ(field->GetNumberOfBoundaryEdges(), 0);
  // The grid reaches to the base, too.
  vtkNew<vtkWindingNumberField> tall;
  tall->SetInputData(halfDome());
  tall->SetFlatBase("z=-2");
  tall->SetPadding(0);
  tall->SetVoxelSize(0.25);
  tall->UpdateInformation();
  EXPECT_EQ(tall->GetOutputInformation(0)->Get(vtkDataObject::ORIGIN())[2], -2 + 0.125);
  vtkImageData* image = field->GetOutput();
  double voxel = 1;
  for (const double size : {image->GetSpacing()[0], image->GetSpacing()[1], image->GetSpacing()[2]})
  {
    voxel *= size;
  }
  vtkDataArray* inside = image->GetPointData()->GetArray("Inside");
  double count = 0;
  for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
  {
    count += inside->GetTuple1(i);
  }
  EXPECT_NEAR(count * voxel, volumeOfDome, 0.02 * volumeOfDome); // 0.6 %

  vtkNew<vtkWindingNumberReport> report;
  report->SetInputData(halfDome());
  EXPECT_EQ(report->GetMirror(), nullptr);
  report->Update();
  EXPECT_FALSE(report->GetClosed());
  report->SetMirror("y=0");
  report->SetFlatBase("z=-0.5");
  report->SetWeldTolerance(1e-9);
  report->Update();
  EXPECT_TRUE(report->GetClosed());
  EXPECT_NEAR(report->GetVolume(), volumeOfDome, 0.01 * volumeOfDome); // 0.5 %
  EXPECT_EQ(report->GetOutput()->GetNumberOfCells(), halfDome()->GetNumberOfCells());
}

TEST(Completion, IsTheSameForFieldsProbesFunctionsAndObliqueImages)
{
  constexpr double turned[9] = {0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1};
  const vtkSmartPointer<vtkPolyData> dome = halfDome(), sheet = sheetAt(0.1, false);
  for (const bool isSheet : {false, true})
  {
    const auto prepare = [isSheet](auto* object)
    {
      object->SetWeldTolerance(1e-9);
      object->SetMirror(isSheet ? nullptr : "y=0");
      object->SetFlatBase(isSheet ? nullptr : "down");
      object->SetSheetSide(isSheet ? "down" : nullptr);
    };
    const vtkSmartPointer<vtkImageData> image = imageAlong(turned);
    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(isSheet ? sheet : dome);
    field->SetLikeData(image);
    field->SetOutputScalarTypeToDouble();
    field->GenerateSignedDistanceOn();
    prepare(field.Get());
    field->Update();

    vtkNew<vtkWindingNumberProbe> probe;
    probe->SetInputData(pointsOf(image));
    probe->SetSourceData(isSheet ? sheet : dome);
    probe->SetOutputScalarTypeToDouble();
    probe->GenerateSignedDistanceOn();
    prepare(probe.Get());
    probe->Update();

    vtkNew<vtkImplicitWindingNumber> function;
    function->SetInput(isSheet ? sheet : dome);
    prepare(function->GetField());

    vtkPointData* found = field->GetOutput()->GetPointData();
    vtkPointData* expected = probe->GetOutput()->GetPointData();
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); i += 7)
    {
      for (const char* name : {"WindingNumber", "SignedDistance"})
      {
        ASSERT_NEAR(
          found->GetArray(name)->GetTuple1(i), expected->GetArray(name)->GetTuple1(i), 2e-3)
          << name << " at " << i;
      }
      double place[3];
      image->GetPoint(i, place);
      ASSERT_NEAR(0.5 - function->EvaluateFunction(place),
        expected->GetArray("WindingNumber")->GetTuple1(i), 2e-3);
    }
  }
}

TEST(Completion, DividesSpaceAtASheet)
{
  for (const bool looksUp : {false, true})
  {
    vtkNew<vtkWindingNumberSurface> surface;
    surface->SetInputData(sheetAt(0.1, looksUp));
    surface->SetSheetSide("down");
    surface->MendSourceOff();
    surface->SetUseInputBounds(0);
    const double bounds[6] = {-0.9, 0.9, -0.9, 0.9, -0.5, 0.5};
    surface->SetSamplingBounds(const_cast<double*>(bounds));
    surface->Update();
    double found[6];
    surface->GetOutput()->GetBounds(found);
    EXPECT_NEAR(found[4], 0.1, 1e-6);
    EXPECT_NEAR(found[5], 0.1, 1e-6);
    EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 100);
  }
}

TEST(Completion, LabelsLayersBetweenHorizons)
{
  // Given in any order; the deepest has the label of what lies below it.
  const double heights[] = {0.3, -0.4, 0};
  vtkNew<vtkWindingNumberLabels> labels;
  for (const double height : heights)
  {
    labels->AddInputDataObject(0, sheetAt(height, height > 0, 2));
  }
  labels->SetSheetSide("down");
  labels->SetOverlapRule(vtkWindingNumberLabels::SMALLEST_VOLUME);
  labels->SetUseInputBounds(0);
  const double bounds[6] = {-1, 1, -1, 1, -1, 1};
  labels->SetSamplingBounds(const_cast<double*>(bounds));
  labels->SetResolution(20);
  const ErrorLog log(labels);
  labels->Update();
  vtkImageData* image = labels->GetOutput();
  vtkDataArray* label = image->GetPointData()->GetArray("Label");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double z = image->GetPoint(i)[2];
    const int expected = z > 0.3 ? 0 : z > 0 ? 1 : z > -0.4 ? 3 : 2;
    ASSERT_EQ(label->GetTuple1(i), expected) << z;
  }
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 0) << "sheets are to be open";
  EXPECT_EQ(log.warnings().find("have holes"), std::string::npos) << log.warnings();
}

TEST(Completion, WeldsInputsOfOneBody)
{
  // Two halves of a sphere, one of which lies a little off.
  vtkNew<vtkSphereSource> lower, upper;
  for (vtkSphereSource* half : {lower.Get(), upper.Get()})
  {
    half->SetThetaResolution(24);
    half->SetPhiResolution(13);
    half->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }
  lower->SetStartPhi(90);
  upper->SetEndPhi(90);
  upper->SetCenter(0, 0, 1e-5);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(lower->GetOutputPort());
  both->AddInputConnection(upper->GetOutputPort());
  vtkNew<vtkWindingNumberReport> report;
  report->SetInputConnection(both->GetOutputPort());
  report->Update();
  EXPECT_EQ(report->GetNumberOfBoundaryEdges(), 48);
  report->SetWeldTolerance(2e-5);
  report->Update();
  EXPECT_TRUE(report->GetClosed());
  EXPECT_EQ(report->GetNumberOfComponents(), 1);
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(both->GetOutputPort());
  labels->SetResolution(8);
  for (const double tolerance : {0.0, 2e-5})
  {
    labels->SetWeldTolerance(tolerance);
    labels->Update();
    vtkDataArray* label = labels->GetOutput()->GetPointData()->GetArray("Label");
    EXPECT_EQ(label->GetRange()[1], tolerance > 0 ? 1 : 2);
  }
}

TEST(Completion, RefusesWrongWords)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(halfDome());
  const ErrorLog log(field);
  field->SetMirror("y");
  field->Update();
  EXPECT_NE(log.errors().find("Mirror is no plane"), std::string::npos) << log.errors();
  field->SetMirror(nullptr);
  field->SetFlatBase("sideways");
  field->Update();
  EXPECT_NE(log.errors().find("FlatBase is no side"), std::string::npos) << log.errors();
  field->SetFlatBase(nullptr);
  field->SetSheetSide("below");
  field->Update();
  EXPECT_NE(log.errors().find("SheetSide is no direction"), std::string::npos) << log.errors();
  field->SetSheetSide(nullptr);
  field->SetWeldTolerance(100);
  field->Update();
  EXPECT_NE(log.warnings().find("the source is empty, so its field is 0: give a surface or points, "
                                "or weld less ("),
    std::string::npos)
    << log.warnings();
  field->SetWeldTolerance(-1);
  field->Update();
  EXPECT_NE(log.errors().find("WeldTolerance is -1"), std::string::npos) << log.errors();
}
