// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/MovingSphere.h"
#include "vtk/OneByOne.h"

#include "vtkContourFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace
{

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
  field->SetResolution(22);
  std::vector<std::vector<float>> values(3);
  for (int time : {0, 2, 1, 0, 2})
  {
    field->UpdateTimeStep(time);
    vtkImageData* image = field->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], 22);
    EXPECT_EQ(image->GetDimensions()[2], 22);
    const double* spacing = image->GetSpacing();
    EXPECT_NEAR(spacing[0], 2.2 * radiusAt(time) / 22, 1e-3) << time;
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
    EXPECT_NEAR(static_cast<double>(inside) / (22 * 22 * 22), 0.39, 0.03) << time;
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
  for (vtkWindingNumberGridAlgorithm* filter :
    {static_cast<vtkWindingNumberGridAlgorithm*>(field.Get()),
      static_cast<vtkWindingNumberGridAlgorithm*>(surface.Get())})
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

TEST_F(Time, BoundsOverAllTimesAreThoseOfTheSourceAsItIsTaken)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->BoundsOverAllTimesOn();
  field->SetPadding(0);
  field->SetResolution(50);
  for (const auto& [mirror, width] : {std::pair("", 21.5), std::pair("x=-1", 44.0)})
  {
    field->SetMirror(mirror);
    field->UpdateTimeStep(1);
    EXPECT_NEAR(field->GetOutput()->GetSpacing()[0], width / 50, 1e-3) << mirror;
  }
}

/// The bounds of a result depend on the operation, and on the rules and thresholds of operands.
TEST_F(Time, BoundsOverAllTimesFollowTheOperation)
{
  vtkNew<vtkSphereSource> around;
  around->SetRadius(50);
  around->SetThetaResolution(24);
  around->SetPhiResolution(24);
  vtkNew<vtkWindingNumberBoolean> solids;
  solids->SetInputConnection(0, sphere->GetOutputPort());
  solids->SetInputConnection(1, around->GetOutputPort());
  solids->BoundsOverAllTimesOn();
  solids->SetPadding(0);
  solids->SetResolution(40);
  const auto widthFor = [&](int operation)
  {
    solids->SetOperation(operation);
    solids->UpdateTimeStep(1);
    int dimensions[3];
    double first[3], spacing[3];
    solids->GetGrid(dimensions, first, spacing);
    return dimensions[0] * spacing[0];
  };
  constexpr double moving = 21.5, all = 100;
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::DIFFERENCE), moving, 0.01);
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::UNION), all, 0.01);
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::INTERSECTION), moving, 0.01);
  solids->SetOperandThreshold(0, 0.4);
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::INTERSECTION), all, 0.01);
  solids->SetOperandInsideRule(0, vtkWindingNumberBoolean::ODD);
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::INTERSECTION), moving, 0.01);
  solids->ClearOperandInsideRules();
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::INTERSECTION), all, 0.01);
  solids->ClearOperandThresholds();
  EXPECT_NEAR(widthFor(vtkWindingNumberBoolean::INTERSECTION), moving, 0.01);
}

/// Two outputs of one filter: a sphere of radius 1 that moves, and one of radius 5.
class TwoSpheres : public vtkPolyDataAlgorithm
{
public:
  static TwoSpheres* New() { VTK_STANDARD_NEW_BODY(TwoSpheres); }
  vtkTypeMacro(TwoSpheres, vtkPolyDataAlgorithm);

protected:
  TwoSpheres()
  {
    this->SetNumberOfInputPorts(0);
    this->SetNumberOfOutputPorts(2);
  }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[2] = {0, 1};
    for (int port = 0; port < 2; ++port)
    {
      vtkInformation* info = outputs->GetInformationObject(port);
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 2);
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    }
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    for (int port = 0; port < 2; ++port)
    {
      vtkNew<vtkSphereSource> made;
      made->SetRadius(port == 0 ? 1 : 5);
      made->Update();
      vtkPolyData::GetData(outputs, port)->ShallowCopy(made->GetOutput());
    }
    return 1;
  }
};

TEST_F(Time, BoundsOverAllTimesFollowAnotherOutputOfTheSource)
{
  vtkNew<TwoSpheres> source;
  vtkNew<vtkWindingNumberField> field;
  field->BoundsOverAllTimesOn();
  field->SetPadding(0);
  field->SetResolution(20);
  for (const auto& [port, width] : {std::pair(0, 2.0), {1, 10.0}, {0, 2.0}})
  {
    field->SetInputConnection(source->GetOutputPort(port));
    field->Update();
    const double* const bounds = field->GetOutput()->GetBounds();
    EXPECT_NEAR(bounds[5] - bounds[4], width, 0.051 * width) << port;
  }
}

/// The grid reaches beyond the bounds of all times by the offset.
TEST_F(Time, BoundsOverAllTimesReachToTheOffset)
{
  constexpr double offset = 0.75;
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->BoundsOverAllTimesOn();
  surface->SetPadding(0);
  surface->SetResolution(100);
  double widths[2];
  for (const bool isOffset : {false, true})
  {
    surface->SetOffset(isOffset ? offset : 0);
    surface->UpdateTimeStep(2);
    int dimensions[3];
    double first[3], spacing[3];
    surface->GetGrid(dimensions, first, spacing);
    widths[isOffset] = dimensions[0] * spacing[0];
  }
  // Without an offset it is 21.5 wide.
  EXPECT_NEAR(widths[1] - widths[0], 2 * offset, 0.02);
  // 0.12 less, in voxels of 0.23
  EXPECT_NEAR(surface->GetOutput()->GetBounds()[1], centerAt(2) + radiusAt(2) + offset, 0.15);
}

/// The times are those of all sources together, of which the second has one of its own.
TEST_F(Time, AllTimesAreThoseOfEverySource)
{
  vtkNew<MovingSphere> other;
  other->SetTimes({3});
  other->SetStep(-10);
  vtkNew<vtkWindingNumberLabels> labels;
  labels->AddInputConnection(sphere->GetOutputPort());
  labels->AddInputConnection(other->GetOutputPort());
  labels->SetPadding(0);
  labels->SetResolution(100);
  for (const bool isUnion : {false, true})
  {
    labels->SetBoundsOverAllTimes(!isUnion);
    labels->SetUnionOverAllTimes(isUnion);
    labels->Update();
    // At time 3 the spheres have a radius of 1.25, and lie at -30 and 30.
    EXPECT_NEAR(labels->GetOutput()->GetSpacing()[0], 62.5 / 100, 1e-3);
    EXPECT_NEAR(labels->GetOutput()->GetOrigin()[0], 0.5 * 62.5 / 100 - 31.25, 0.01);
  }
  vtkImageData* const image = labels->GetOutput();
  std::map<int, int> found; // labels by their place
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    const int label = static_cast<int>(image->GetPointData()->GetScalars()->GetTuple1(n));
    const int place = static_cast<int>(std::lround(image->GetPoint(n)[0] / 10));
    found[place] = std::max(found[place], label);
  }
  EXPECT_EQ(found, (std::map<int, int>{{-3, 2}, {-2, 2}, {-1, 2}, {0, 1}, {1, 1}, {2, 1}, {3, 1}}));
}

/// Sources that move by themselves have the time of the first one.
TEST_F(Time, BoundsOverAllTimesKeepTheTimeOfTheFirstSource)
{
  vtkNew<MovingSphere> other;
  other->SetTimes({0, 1, 2, 3});
  other->SetStep(-10);
  vtkNew<vtkWindingNumberLabels> labels;
  labels->AddInputConnection(sphere->GetOutputPort());
  labels->AddInputConnection(other->GetOutputPort());
  labels->BoundsOverAllTimesOn();
  labels->SetResolution(100);
  sphere->UpdateTimeStep(1);
  other->UpdateTimeStep(3);
  labels->Update();
  for (const auto& [source, center] : {std::pair(sphere.Get(), 10.0), {other.Get(), -10.0}})
  {
    const double* bounds = source->GetOutput()->GetBounds();
    EXPECT_NEAR(0.5 * (bounds[0] + bounds[1]), center, 0.01);
  }
}

/// The source gives a probe its times, or the queries do where the source has none.
TEST_F(Time, ProbeHasTheTimesOfItsSource)
{
  vtkNew<MovingSphere> queries;
  queries->SetTimes({4, 5});
  vtkNew<vtkSphereSource> still;
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputConnection(queries->GetOutputPort());
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (const bool isMoving : {true, false})
  {
    probe->SetSourceConnection(isMoving ? sphere->GetOutputPort() : still->GetOutputPort());
    probe->UpdateInformation();
    vtkInformation* info = probe->GetOutputInformation(0);
    ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), isMoving ? 3 : 2);
    EXPECT_EQ(info->Get(Pipeline::TIME_STEPS())[0], isMoving ? 0 : 4);
    EXPECT_EQ(info->Get(Pipeline::TIME_RANGE())[1], isMoving ? 2 : 5);
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

/// A grid that was laid without a source is laid over one as the properties say.
TEST_F(Time, GridFollowsASourceThatComes)
{
  for (const double padding : {0.05, 0.5})
  {
    vtkNew<OneByOne> source;
    source->SetRadii({0, 1});
    vtkNew<vtkWindingNumberField> field;
    field->SetInputConnection(source->GetOutputPort());
    field->SetResolution(25);
    field->SetPadding(padding);
    field->UpdateTimeStep(0);
    EXPECT_EQ(field->GetOutput()->GetSpacing()[0], 0.04) << "of the bounds that are given";
    field->UpdateTimeStep(1);
    EXPECT_EQ(field->GetOutput()->GetDimensions()[2], 25);
    EXPECT_NEAR(field->GetOutput()->GetSpacing()[2], 2 * (1 + 2 * padding) / 25, 1e-6);
  }
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
  vtkNew<vtkWindingNumberReport> report;
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
