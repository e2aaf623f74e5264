// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/MovingSphere.h"

#include "vtkContourFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceReport.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberHyperTree.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace
{

std::size_t countOf(const std::string& word, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    ++count;
  }
  return count;
}

/// Sources that move and grow with time are followed by the filters that sample grids.
class Time : public testing::Test
{
protected:
  vtkNew<MovingSphere> sphere;

  static double centerAt(double time) { return 10 * time; }
  static double radiusAt(double time) { return 0.5 + 0.25 * time; }

  /// Checks that a box is that of the sphere at a time, within so much.
  static void expectSphere(const double* bounds, double time, double margin)
  {
    const double radius = radiusAt(time);
    EXPECT_NEAR(bounds[0], centerAt(time) - radius, margin) << time;
    EXPECT_NEAR(bounds[1], centerAt(time) + radius, margin) << time;
    EXPECT_NEAR(bounds[3], radius, margin) << time;
    EXPECT_NEAR(bounds[4], -radius, margin) << time;
  }
};

TEST_F(Time, GridOfTheFieldFollowsTheSource)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(20);
  std::vector<std::vector<float>> values(3);
  for (int time : {0, 2, 1, 0, 2})
  {
    field->UpdateTimeStep(time);
    vtkImageData* image = field->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], 20);
    EXPECT_EQ(image->GetDimensions()[2], 20);
    const double* spacing = image->GetSpacing();
    EXPECT_NEAR(spacing[0], 2.2 * radiusAt(time) / 20, 1e-3) << time;
    EXPECT_EQ(spacing[0], spacing[1]);
    EXPECT_EQ(spacing[0], spacing[2]);
    expectSphere(image->GetBounds(), time, 0.1 * radiusAt(time));
    vtkDataArray* array = image->GetPointData()->GetScalars();
    EXPECT_NEAR(array->GetTuple1(0), 0, 1e-6) << "the corner of the grid is outside, at " << time;
    std::vector<float> now;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      now.push_back(static_cast<float>(array->GetTuple1(i)));
    }
    const auto inside = std::count(now.begin(), now.end(), 1.0f);
    // The ball fills π/6 of its box, and the box 1/1.1³ of the grid.
    EXPECT_NEAR(static_cast<double>(inside) / 8000, 0.39, 0.03) << time;
    std::vector<float>& before = values[static_cast<std::size_t>(time)];
    EXPECT_TRUE(before.empty() || before == now) << "another time came in between, at " << time;
    before = now;
  }
}

TEST_F(Time, GivenDimensionsFillTheBoundsOfEveryTime)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetSamplingDimensions(10, 20, 30);
  field->SetPadding(0);
  field->SetOutputAssociation(vtkWindingNumberField::CELLS);
  for (int time : {0, 2, 1})
  {
    field->UpdateTimeStep(time);
    EXPECT_EQ(field->GetOutput()->GetDimensions()[2], 31);
    expectSphere(field->GetOutput()->GetBounds(), time, 0.02);
  }
}

TEST_F(Time, FixedBoundsAreThoseOfAllTimes)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 21, -1, 1, -1, 1);
  field->SetSamplingDimensions(22, 2, 2);
  for (int time : {0, 2, 1})
  {
    field->UpdateTimeStep(time);
    EXPECT_EQ(field->GetOutput()->GetOrigin()[0], -0.5);
    EXPECT_EQ(field->GetOutput()->GetSpacing()[0], 1);
  }
}

/// The grid covers all three spheres at each time, and follows a change.
TEST_F(Time, BoundsOverAllTimesLayOneGrid)
{
  vtkNew<vtkTransform> transform;
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputConnection(sphere->GetOutputPort());
  moved->SetTransform(transform);
  vtkNew<vtkWindingNumberField> field;
  vtkNew<vtkWindingNumberSurface> surface;
  vtkNew<vtkWindingNumberHyperTree> trees;
  for (vtkWindingNumberGridAlgorithm* filter :
    {static_cast<vtkWindingNumberGridAlgorithm*>(field.Get()),
      static_cast<vtkWindingNumberGridAlgorithm*>(surface.Get()),
      static_cast<vtkWindingNumberGridAlgorithm*>(trees.Get())})
  {
    filter->SetInputConnection(moved->GetOutputPort());
    filter->BoundsOverAllTimesOn();
    filter->SetPadding(0);
    filter->SetResolution(100);
    for (const double shift : {0.0, 5.0})
    {
      transform->Identity();
      transform->Translate(shift, 0, 0);
      for (int time : {1, 2, 0})
      {
        filter->UpdateTimeStep(time);
        int dimensions[3];
        double first[3], spacing[3];
        filter->GetGrid(dimensions, first, spacing);
        EXPECT_EQ(dimensions[0], 100);
        EXPECT_NEAR(spacing[0], 21.5 / 100, 1e-3); // from -0.5 to 21
        EXPECT_NEAR(first[0] - 0.5 * spacing[0], shift - 0.5, 0.005);
        if (filter == surface)
        {
          const double* bounds = surface->GetOutput()->GetBounds();
          EXPECT_NEAR(0.5 * (bounds[0] + bounds[1]), shift + centerAt(time), 0.1) << time;
        }
      }
    }
  }
}

/// Looking at all times does not change which one is evaluated.
TEST_F(Time, BoundsOverAllTimesLeaveTheTimeAlone)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->BoundsOverAllTimesOn();
  surface->SetResolution(100);
  surface->Update();
  expectSphere(surface->GetOutput()->GetBounds(), 0, 0.05);
}

/// The volume that the sphere sweeps: every array is that of the times together, whatever the rule.
TEST_F(Time, UnionOverAllTimesIsTheSweptVolume)
{
  for (const int rule :
    {vtkWindingNumberField::SIGNED, vtkWindingNumberField::ABSOLUTE, vtkWindingNumberField::ODD})
  {
    vtkNew<vtkWindingNumberField> swept, single;
    for (vtkWindingNumberField* field : {swept.Get(), single.Get()})
    {
      field->SetInputConnection(sphere->GetOutputPort());
      field->SetInsideRule(rule);
      field->GenerateInsideOn();
      field->GenerateSignedDistanceOn();
      field->SetCoverageToFraction();
      field->SetResolution(60);
      field->BoundsOverAllTimesOn();
    }
    swept->BoundsOverAllTimesOff(); // they are taken anyway
    swept->UnionOverAllTimesOn();
    swept->Update();
    EXPECT_FALSE(
      swept->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
    const std::vector<std::string> names = {
      "WindingNumber", "Inside", "Coverage", "SignedDistance"};
    std::map<std::string, std::vector<double>> expected;
    for (const int time : {0, 1, 2})
    {
      single->UpdateTimeStep(time);
      for (const std::string& name : names)
      {
        vtkDataArray* values = single->GetOutput()->GetPointData()->GetArray(name.c_str());
        std::vector<double>& all = expected[name];
        all.resize(static_cast<std::size_t>(values->GetNumberOfTuples()),
          name == "SignedDistance" ? 1e300 : 0);
        for (std::size_t n = 0; n < all.size(); ++n)
        {
          const double value = values->GetComponent(static_cast<vtkIdType>(n), 0);
          all[n] = name == "SignedDistance" ? std::min(all[n], value) : std::max(all[n], value);
        }
      }
    }
    ASSERT_EQ(swept->GetOutput()->GetBounds()[1], single->GetOutput()->GetBounds()[1]);
    for (const std::string& name : names)
    {
      vtkDataArray* values = swept->GetOutput()->GetPointData()->GetArray(name.c_str());
      ASSERT_NE(values, nullptr) << name;
      std::size_t wrong = 0;
      for (std::size_t n = 0; n < expected[name].size(); ++n)
      {
        wrong += values->GetComponent(static_cast<vtkIdType>(n), 0) != expected[name][n];
      }
      EXPECT_EQ(wrong, 0) << name << " by rule " << rule;
    }
    const std::vector<double>& inside = expected["Inside"];
    EXPECT_EQ(swept->GetNumberOfInsideSamples(), std::count(inside.begin(), inside.end(), 1));
    // Three spheres, which do not meet, of radii 0.5, 0.75 and 1: (0.125 + 0.422 + 1) 4π/3.
    const double voxel = std::pow(swept->GetOutput()->GetSpacing()[0], 3);
    EXPECT_NEAR(voxel * swept->GetNumberOfInsideSamples(), 6.48, 0.3); // 6.4 measured
  }
}

TEST_F(Time, UnionOverAllTimesKeepsLabelsOfEveryTime)
{
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(sphere->GetOutputPort());
  labels->SetCoverageToFraction();
  labels->GenerateSolidCountOn();
  labels->UnionOverAllTimesOn();
  labels->SetResolution(60);
  labels->Update();
  vtkPointData* data = labels->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetScalars(), data->GetArray("Label"));
  int found[3] = {0, 0, 0};
  for (vtkIdType n = 0; n < labels->GetOutput()->GetNumberOfPoints(); ++n)
  {
    const double label = data->GetArray("Label")->GetComponent(n, 0);
    EXPECT_EQ(data->GetArray("SolidCount")->GetComponent(n, 0), label) << "one solid, label 1";
    EXPECT_EQ(data->GetArray("FirstLabel")->GetComponent(n, 0) != 0,
      data->GetArray("FirstShare")->GetComponent(n, 0) > 0);
    if (label != 0)
    {
      ++found[std::lround(labels->GetOutput()->GetPoint(n)[0] / 10)];
    }
  }
  EXPECT_GT(found[0], 5);
  EXPECT_GT(found[1], found[0]);
  EXPECT_GT(found[2], found[1]);
}

/// The sphere leaves the box: that is said once, not at two times, and no more than the one line.
TEST_F(Time, UnionOverAllTimesWarnsOnce)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
  field->SetResolution(20);
  field->UnionOverAllTimesOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_GT(field->GetNumberOfInsideSamples(), 0);
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(countOf("Warning: ", log.warnings()), 1) << log.warnings();
  const double before = field->GetOutput()->GetScalarRange()[1];
  field->Modified();
  field->UpdateTimeStep(2);
  EXPECT_EQ(field->GetOutput()->GetScalarRange()[1], before) << "no time of the output's own";
}

TEST_F(Time, UnionOverAllTimesIsRefusedWithNearestCells)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->UnionOverAllTimesOn();
  field->GenerateNearestCellsOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_NE(log.errors().find("UnionOverAllTimesOff()"), std::string::npos) << log.errors();
}

/// A source without times is the only one there is.
TEST_F(Time, UnionOverAllTimesOfOneTimeIsThat)
{
  vtkNew<vtkSphereSource> still;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(still->GetOutputPort());
  field->SetResolution(10);
  field->Update();
  const vtkIdType inside = field->GetNumberOfInsideSamples();
  field->UnionOverAllTimesOn();
  field->Update();
  EXPECT_GT(inside, 0);
  EXPECT_EQ(field->GetNumberOfInsideSamples(), inside);
}

TEST_F(Time, ContoursDownstreamAreThoseOfTheTime)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(field->GetOutputPort());
  contour->SetValue(0, 0.5);
  for (int time : {0, 1, 2, 0})
  {
    contour->UpdateTimeStep(time);
    expectSphere(contour->GetOutput()->GetBounds(), time, 0.05);
  }
}

TEST_F(Time, SurfaceFollowsTheSource)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  for (int time : {0, 2, 1, 0})
  {
    surface->UpdateTimeStep(time);
    expectSphere(surface->GetOutput()->GetBounds(), time, 0.02);
  }
}

TEST_F(Time, ReportIsThatOfTheTime)
{
  vtkNew<vtkSurfaceReport> report;
  report->SetInputConnection(sphere->GetOutputPort());
  for (int time : {0, 2, 1, 0})
  {
    report->UpdateTimeStep(time);
    const double radius = radiusAt(time);
    EXPECT_NEAR(report->GetArea(), 4 * 3.1416 * radius * radius, 0.05 * report->GetArea()) << time;
  }
}

TEST_F(Time, PropertiesUpstreamMoveTheGrid)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(source->GetOutputPort());
  for (double radius : {0.5, 3.0, 0.1})
  {
    source->SetRadius(radius);
    field->Update();
    const double* bounds = field->GetOutput()->GetBounds();
    EXPECT_NEAR(bounds[5], radius, 0.1 * radius);
    EXPECT_NEAR(field->GetOutput()->GetPointData()->GetScalars()->GetTuple1(0), 0, 1e-6);
  }
}

} // namespace
