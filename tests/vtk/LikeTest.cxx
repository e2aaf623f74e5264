// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Fields and labels that lie on an image.

#include "vtk/ErrorLog.h"
#include "vtk/ImageSamples.h"

#include "vtkCellData.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

class Like : public testing::Test
{
protected:
  Like()
  {
    sphere->SetThetaResolution(20);
    sphere->SetPhiResolution(20);
    open->SetThetaResolution(40);
    open->SetPhiResolution(40);
    open->SetEndPhi(120);
    field->SetOutputScalarTypeToDouble();
    field->GenerateInsideOn();
    field->GenerateSignedDistanceOn();
  }

  vtkNew<vtkSphereSource> sphere, open;
  vtkNew<vtkWindingNumberField> field;
};

void expectEqualDirections(vtkImageData* found, vtkImageData* expected)
{
  for (int n = 0; n < 9; ++n)
  {
    EXPECT_EQ(
      found->GetDirectionMatrix()->GetData()[n], expected->GetDirectionMatrix()->GetData()[n]);
  }
}

void expectSamePlace(vtkImageData* found, vtkImageData* expected)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(found->GetExtent()[2 * axis], expected->GetExtent()[2 * axis]);
    EXPECT_EQ(found->GetExtent()[2 * axis + 1], expected->GetExtent()[2 * axis + 1]);
    EXPECT_EQ(found->GetOrigin()[axis], expected->GetOrigin()[axis]);
    EXPECT_EQ(found->GetSpacing()[axis], expected->GetSpacing()[axis]);
  }
  expectEqualDirections(found, expected);
}

/// The arrays of a probe at the image, by the direct sum at scattered points.
vtkSmartPointer<vtkPointData> directly(vtkImageData* image, vtkPolyData* source, bool atCells)
{
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(pointsOf(image, atCells));
  probe->SetSourceData(source);
  probe->SetOutputScalarTypeToDouble();
  probe->GenerateInsideOn();
  probe->GenerateSignedDistanceOn();
  probe->SetMethod(vtkWindingNumberProbe::DIRECT);
  probe->Update();
  return probe->GetOutput()->GetPointData();
}

TEST_F(Like, FieldsLieOnTheVeryImage)
{
  constexpr double straight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const vtkSmartPointer<vtkImageData> images[] = {imageAlong(oblique), imageAlong(mirrored),
    imageAlong(straight), imageAlong(mirrored, {-0.04, 0.05, -0.06})};
  for (vtkSphereSource* source : {sphere.Get(), open.Get()})
  {
    source->Update();
    field->SetInputData(source->GetOutput());
    for (const bool atCells : {false, true})
    {
      field->SetOutputAssociation(
        atCells ? vtkWindingNumberField::CELLS : vtkWindingNumberField::POINTS);
      for (const auto& image : images)
      {
        field->SetLikeData(image);
        field->Update();
        ASSERT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
        vtkImageData* const result = field->GetOutput();
        expectSamePlace(result, image);
        vtkDataSetAttributes* found = result->GetPointData();
        if (atCells)
        {
          found = result->GetCellData();
        }
        const auto expected = directly(image, source->GetOutput(), atCells);
        for (const char* name : {"WindingNumber", "SignedDistance", "Inside"})
        {
          EXPECT_LT(largestDifference(found->GetArray(name), expected->GetArray(name)), 1e-10)
            << name;
        }
        EXPECT_EQ(found->GetArray("Inside")->GetRange()[1], 1);
      }
    }
  }
}

TEST_F(Like, AStraightImageGivesTheBitsOfItsGrid)
{
  field->SetInputConnection(open->GetOutputPort());
  field->SetResolution(20);
  field->Update();
  vtkNew<vtkImageData> expected;
  expected->DeepCopy(field->GetOutput());
  vtkNew<vtkWindingNumberField> again;
  again->SetInputConnection(open->GetOutputPort());
  again->SetLikeData(expected);
  again->SetOutputScalarTypeToDouble();
  again->Update();
  expectSamePlace(again->GetOutput(), expected);
  EXPECT_EQ(largestDifference(again->GetOutput()->GetPointData()->GetArray("WindingNumber"),
              expected->GetPointData()->GetArray("WindingNumber")),
    0);
}

TEST_F(Like, PiecesHaveTheBitsOfTheWhole)
{
  field->SetInputConnection(open->GetOutputPort());
  field->SetMethod(vtkWindingNumberField::HIERARCHICAL);
  for (const auto association : {vtkWindingNumberField::POINTS, vtkWindingNumberField::CELLS})
  {
    field->SetOutputAssociation(association);
    field->SetLikeData(imageAlong(mirrored));
    field->Update();
    vtkNew<vtkImageData> whole;
    whole->DeepCopy(field->GetOutput());
    const bool asCells = association == vtkWindingNumberField::CELLS;
    const auto valuesOf = [asCells](vtkImageData* image)
    {
      return asCells ? image->GetCellData()->GetArray("WindingNumber")
                     : image->GetPointData()->GetArray("WindingNumber");
    };
    vtkIdType done = 0; // values of the layers before
    for (const int first : {5, 11, 24})
    {
      const int next = first == 5 ? 11 : 24; // cells share points with the next layer's
      int extent[6] = {3, 30, -2, 22, first, first == 24 ? 25 : next - (asCells ? 0 : 1)};
      field->GetOutput()->ReleaseData();
      field->UpdateExtent(extent);
      expectEqualDirections(field->GetOutput(), whole);
      vtkDataArray* const part = valuesOf(field->GetOutput());
      for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(part->GetTuple1(i), valuesOf(whole)->GetTuple1(done + i)) << first << " " << i;
      }
      done += part->GetNumberOfTuples();
    }
    EXPECT_EQ(done, valuesOf(whole)->GetNumberOfTuples());
  }
}

TEST_F(Like, WithoutItTheGridIsThePropertiesAgain)
{
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(8);
  field->Update();
  vtkNew<vtkImageData> before;
  before->DeepCopy(field->GetOutput());
  field->SetLikeData(imageAlong(oblique));
  field->Update();
  field->SetLikeConnection(nullptr);
  field->Update();
  expectSamePlace(field->GetOutput(), before);
  EXPECT_EQ(largestDifference(field->GetOutput()->GetPointData()->GetArray("WindingNumber"),
              before->GetPointData()->GetArray("WindingNumber")),
    0);
}

TEST_F(Like, FlatImagesHaveALayer)
{
  vtkNew<vtkImageData> flat;
  flat->SetExtent(-5, 5, 2, 2, -4, 4);
  flat->SetSpacing(0.1, 0, 0.1);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetLikeData(flat);
  field->Update();
  vtkDataArray* const w = field->GetOutput()->GetPointData()->GetArray("WindingNumber");
  ASSERT_EQ(w->GetNumberOfTuples(), 99);
  EXPECT_EQ(w->GetTuple1(49), 1);
  EXPECT_EQ(w->GetTuple1(0), 0);
  field->SetOutputAssociationToCells();
  field->Update();
  EXPECT_EQ(field->GetOutput()->GetCellData()->GetArray("WindingNumber")->GetNumberOfTuples(), 80);
}

TEST_F(Like, ASliceIsAsThickAsItsSpacing)
{
  // The sphere ends at 0.5. The layer goes from 0.4 to 0.8, and its samples lie outside.
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(21, 21, 1);
  slice->SetOrigin(-0.5, -0.5, 0.6);
  slice->SetSpacing(0.05, 0.05, 0.4);
  vtkNew<vtkImageData> thin;
  thin->CopyStructure(slice);
  thin->SetSpacing(0.05, 0.05, 0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetCoverage(vtkWindingNumberField::ANY);
  const auto insideOf = [&](vtkImageData* image)
  {
    field->SetLikeData(image);
    field->Update();
    vtkDataArray* const inside = field->GetOutput()->GetPointData()->GetArray("Inside");
    int count = 0;
    for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
    {
      count += inside->GetTuple1(i) > 0;
    }
    return count;
  };
  // Squares of 0.05 that come into the disc of radius 0.3 at 0.4.
  EXPECT_NEAR(insideOf(slice), 129, 8);
  EXPECT_EQ(insideOf(thin), 0) << "no thicker than it is wide";
  field->SetCoverage(vtkWindingNumberField::FRACTION);
  insideOf(slice);
  // The ball fills at most a quarter of the layer.
  const double most = field->GetOutput()->GetPointData()->GetArray("Coverage")->GetRange()[1];
  EXPECT_NEAR(most, 0.25, 0.03);
  // A slice of points has no thickness, and no warning says that the source is too thin.
  const ErrorLog log(field);
  field->SetCoverage(vtkWindingNumberField::CENTER);
  slice->SetOrigin(-0.5, -0.5, 0.1);
  slice->SetSpacing(0.05, 0.05, 2);
  EXPECT_GT(insideOf(slice), 0);
  EXPECT_EQ(log.warnings(), "");
}

TEST_F(Like, LabelsLieOnTheVeryImage)
{
  const auto image = imageAlong(mirrored);
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(sphere->GetOutputPort());
  labels->SetLikeData(image);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetLikeData(image);
  for (const int coverage : {vtkWindingNumberLabels::CENTER, vtkWindingNumberLabels::ANY})
  {
    labels->SetCoverage(coverage);
    field->SetCoverage(coverage);
    labels->Update();
    field->Update();
    expectSamePlace(labels->GetOutput(), image);
    EXPECT_EQ(largestDifference(labels->GetOutput()->GetPointData()->GetArray("Label"),
                field->GetOutput()->GetPointData()->GetArray("Inside")),
      0);
  }
}

TEST_F(Like, SurfacesOfVoxelsLookOutward)
{
  for (const auto& image : {imageAlong(oblique), imageAlong(mirrored)})
  {
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetLikeData(image);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputConnection(field->GetOutputPort());
    voxels->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Inside");
    vtkNew<vtkPolyData> center;
    vtkNew<vtkPoints> origin;
    origin->InsertNextPoint(0, 0, 0);
    center->SetPoints(origin);
    vtkNew<vtkWindingNumberProbe> probe;
    probe->SetInputData(center);
    probe->SetSourceConnection(voxels->GetOutputPort());
    probe->Update();
    EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetTuple1(0), 1);
  }
}

TEST_F(Like, ImagesThatAreNoGridAreRefused)
{
  field->SetInputConnection(sphere->GetOutputPort());
  const ErrorLog log(field);
  const auto refuses = [&](vtkImageData* image, const std::string& words)
  {
    field->SetLikeData(image);
    field->Update();
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
    EXPECT_NE(log.errors().find(words), std::string::npos) << words << "\n" << log.errors();
    EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
  };
  constexpr double askew[9] = {1, 0.1, 0, 0, 1, 0, 0, 0, 1};
  refuses(imageAlong(askew), "not at right angles");
  vtkNew<vtkImageData> empty, pointlike;
  refuses(empty, "is empty");
  pointlike->SetDimensions(3, 3, 3);
  pointlike->SetSpacing(0, 1, 1);
  refuses(pointlike, "vtkWindingNumberField");
}

TEST_F(Like, DirectionsOfFourDigitsAreRightAngles)
{
  // Rounded as exporters of DICOM do it. Products of axes differ from 0 and 1 by up to 5e-5.
  constexpr double rounded[9] = {
    0.7045, -0.7035, -0.0942, 0.5934, 0.6565, -0.4657, 0.3894, 0.2722, 0.8799};
  // By up to 9e-4.
  constexpr double skewed[9] = {1, 9e-4, 0, 0, 1, 0, 0, 0, 1};
  sphere->Update();
  for (const auto& image : {imageAlong(rounded), imageAlong(skewed)})
  {
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetLikeData(image);
    field->Update();
    ASSERT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
    expectSamePlace(field->GetOutput(), image);
    vtkPointData* const found = field->GetOutput()->GetPointData();
    const auto expected = directly(image, sphere->GetOutput(), false);
    for (const char* name : {"WindingNumber", "Inside"})
    {
      EXPECT_LT(largestDifference(found->GetArray(name), expected->GetArray(name)), 1e-10) << name;
    }
    vtkDataArray* const distances = expected->GetArray("SignedDistance");
    for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
    {
      ASSERT_NEAR(found->GetArray("SignedDistance")->GetTuple1(i), distances->GetTuple1(i),
        1e-3 * std::abs(distances->GetTuple1(i)) + 1e-12);
    }
    EXPECT_TRUE(vtkWindingNumberField::HasRightAngles(image));
  }
  constexpr double askew[9] = {1, 2e-3, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_FALSE(vtkWindingNumberField::HasRightAngles(imageAlong(askew)));
}

TEST_F(Like, AnImageOfAnotherExtentThanAnnouncedIsRefused)
{
  const auto image = imageAlong(oblique);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  int extent[6];
  image->GetExtent(extent);
  producer->SetWholeExtent(extent[0], extent[1] - 3, extent[2], extent[3], extent[4], extent[5]);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetLikeConnection(producer->GetOutputPort());
  const ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_NE(log.errors().find("lies elsewhere than announced"), std::string::npos) << log.errors();
}

/// Announces the place of an image, and gives another.
class OtherImage : public vtkImageAlgorithm
{
public:
  static OtherImage* New() { VTK_STANDARD_NEW_BODY(OtherImage); }
  vtkTypeMacro(OtherImage, vtkImageAlgorithm);

  vtkNew<vtkImageData> announced, given;

protected:
  OtherImage() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), announced->GetExtent(), 6);
    info->Set(vtkDataObject::ORIGIN(), announced->GetOrigin(), 3);
    info->Set(vtkDataObject::SPACING(), announced->GetSpacing(), 3);
    info->Set(vtkDataObject::DIRECTION(), announced->GetDirectionMatrix()->GetData(), 9);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkImageData::GetData(outputs)->ShallowCopy(given);
    return 1;
  }
};

TEST_F(Like, AnImageOfAnotherPlaceThanAnnouncedIsRefused)
{
  const auto image = imageAlong(oblique);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(4);
  const auto statusOf = [&](vtkImageData* given)
  {
    vtkNew<OtherImage> source;
    source->announced->ShallowCopy(image);
    source->given->ShallowCopy(given);
    field->SetLikeConnection(source->GetOutputPort());
    const ErrorLog log(field);
    field->Update();
    const bool isTold = log.errors().find("lies elsewhere than announced") != std::string::npos;
    EXPECT_EQ(isTold, field->GetStatus() == vtkWindingNumberField::REFUSED) << log.errors();
    return field->GetStatus();
  };
  EXPECT_EQ(statusOf(image), vtkWindingNumberField::DONE);
  vtkNew<vtkImageData> other;
  for (int axis = 0; axis < 3; ++axis)
  {
    double origin[3], spacing[3];
    image->GetOrigin(origin);
    image->GetSpacing(spacing);
    origin[axis] += 0.01;
    spacing[axis] *= 1.01;
    other->ShallowCopy(image);
    other->SetOrigin(origin);
    EXPECT_EQ(statusOf(other), vtkWindingNumberField::REFUSED) << "origin " << axis;
    other->ShallowCopy(image);
    other->SetSpacing(spacing);
    EXPECT_EQ(statusOf(other), vtkWindingNumberField::REFUSED) << "spacing " << axis;
  }
  for (int n = 0; n < 9; ++n)
  {
    other->ShallowCopy(image);
    vtkNew<vtkMatrix3x3> directions;
    directions->DeepCopy(image->GetDirectionMatrix());
    directions->GetData()[n] += 1e-4;
    other->SetDirectionMatrix(directions);
    EXPECT_EQ(statusOf(other), vtkWindingNumberField::REFUSED) << "direction " << n;
  }
}

} // namespace
