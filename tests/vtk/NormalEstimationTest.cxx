// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Normals estimated through the filters: orders of points and threads, clouds that are hard or
/// nothing at all, progress and abort.

#include "vtk/ErrorLog.h"
#include "vtk/PointProbe.h"
#include "vtk/ProgressLog.h"
#include "vtk/SphereCloud.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using Place = std::array<double, 3>;

constexpr int estimations[] = {vtkWindingNumberAlgorithm::ESTIMATION_AUTOMATIC,
  vtkWindingNumberAlgorithm::SPANNING_TREE, vtkWindingNumberAlgorithm::WINDING_CONSISTENT};

vtkSmartPointer<vtkPolyData> cloudOf(const std::vector<Place>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  return cloud;
}

/// A sphere with a cavity, on which the spanning tree fails.
std::vector<Place> shell(double x = 0, double size = 1)
{
  std::vector<Place> places;
  for (const auto& [count, radius] : {std::pair(3000, 1.0), std::pair(1500, 0.7)})
  {
    const auto sphere = sphereCloud(count, 0);
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      const double* at = sphere->GetPoint(i);
      places.push_back({x + size * radius * at[0], size * radius * at[1], size * radius * at[2]});
    }
  }
  return places;
}

class NormalEstimation : public PointProbe
{
protected:
  NormalEstimation() { probe->EstimateNormalsOn(); }

  /// Expects the shell to be solid between its spheres only.
  void expectShell(const std::vector<Place>& places, double x = 0)
  {
    const auto cloud = cloudOf(places);
    EXPECT_NEAR(this->windingNumber(cloud, x), 0, 0.02);
    EXPECT_NEAR(this->windingNumber(cloud, x + 0.85), 1, 0.05);
    EXPECT_NEAR(this->windingNumber(cloud, x, 0, -0.85), 1, 0.05);
    EXPECT_NEAR(this->windingNumber(cloud, x, 1.3), 0, 0.02);
  }
};

std::vector<double> fieldOf(const std::vector<Place>& places, int estimation, int threads)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(cloudOf(places));
  field->SetResolution(10);
  field->EstimateNormalsOn();
  field->SetNormalEstimation(estimation);
  field->SetNumberOfThreads(threads);
  field->SetOutputScalarTypeToDouble();
  field->Update();
  auto* values = vtkDoubleArray::SafeDownCast(field->GetOutput()->GetPointData()->GetScalars());
  return {values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfTuples()};
}

} // namespace

TEST_F(NormalEstimation, HasTheSameBitsForAnyOrderOfPointsAndThreads)
{
  std::vector<Place> places = shell();
  places.insert(places.end(), places.begin(), places.begin() + 500); // twice at one place
  std::vector<Place> shuffled = places;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  for (const int estimation : estimations)
  {
    const std::vector<double> expected = fieldOf(places, estimation, 1);
    EXPECT_EQ(fieldOf(shuffled, estimation, 2), expected) << estimation;
    EXPECT_EQ(fieldOf(places, estimation, 3), expected) << estimation;
  }
}

/// A scanner in the middle of a hollow sphere: normals look at it, and so w is -1 inside.
TEST_F(NormalEstimation, LooksTowardWhereThePointsWereSeenFrom)
{
  const auto sphere = sphereCloud(2000, 0);
  std::vector<Place> places;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double* at = sphere->GetPoint(i);
    places.push_back({at[0], at[1], at[2]});
  }
  const auto cloud = cloudOf(places);
  EXPECT_NEAR(this->windingNumber(cloud, 0), 1, 0.02);
  probe->SetToward("0.1 0 0");
  EXPECT_NEAR(this->windingNumber(cloud, 0), -1, 0.02);
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "viewpoint");
  probe->SetToward("9 0 0; -9 0 0; 0 9 0; 0 -9 0; 0 0 9; 0 0 -9");
  EXPECT_NEAR(this->windingNumber(cloud, 0), 1, 0.02);

  vtkNew<vtkWindingNumberNormals> areas;
  areas->SetInputData(cloud);
  areas->EstimateNormalsOn();
  areas->SetToward("0 0 0");
  {
    const ErrorLog log(areas);
    areas->Update();
    EXPECT_EQ(log.errors(), "");
  }
  vtkDataArray* const normals =
    vtkPointSet::SafeDownCast(areas->GetOutput())->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double* const normal = normals->GetTuple3(static_cast<vtkIdType>(i));
    EXPECT_LT(normal[0] * places[i][0] + normal[1] * places[i][1] + normal[2] * places[i][2], 0);
  }
  for (vtkAlgorithm* const filter :
    {static_cast<vtkAlgorithm*>(probe), static_cast<vtkAlgorithm*>(areas)})
  {
    const ErrorLog log(filter);
    areas->SetToward("upward");
    probe->SetToward("1 2");
    filter->Update();
    EXPECT_NE(log.errors().find("is no position and no direction"), std::string::npos)
      << log.errors();
  }
}

TEST_F(NormalEstimation, IsNotSpoiledByStraysEqualPointsAndBadOnes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Place> places = shell();
  {
    SCOPED_TRACE("a stray a million sizes away");
    places.push_back({2e6, -1e6, 3e5});
    this->expectShell(places);
  }
  places.pop_back();
  {
    SCOPED_TRACE("equal points");
    const std::vector<Place> once = places;
    for (int i = 0; i < 2; ++i)
    {
      places.insert(places.end(), once.begin(), once.begin() + 2000);
    }
    this->expectShell(places);
  }
  {
    SCOPED_TRACE("NaN");
    places.push_back({nan, 0, 0});
    this->expectShell(places);
  }
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "winding consistent");
}

TEST_F(NormalEstimation, OrientsTwoCloudsFarFromEachOther)
{
  std::vector<Place> places = shell();
  const std::vector<Place> other = shell(1000);
  places.insert(places.end(), other.begin(), other.end());
  this->expectShell(places);
  this->expectShell(places, 1000);
}

TEST_F(NormalEstimation, OfCloudsThatEncloseNothingIsAWarningAtMost)
{
  std::vector<std::vector<Place>> clouds(7);
  clouds[0] = {{1, 2, 3}};
  clouds[1] = {{0, 0, 0}, {1, 0, 0}};
  clouds[2] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  clouds[3].assign(50, {1, 1, 1});
  for (int i = 0; i < 300; ++i)
  {
    clouds[4].push_back({1.0 * i, 2.0 * i, 3.0 * i});
    clouds[5].push_back({1.0 * (i % 20), 1.0 * (i / 20), 0});
    clouds[6].push_back({1e-160 * i, 0, i % 2 ? 1.0 : 0.0}); // squared distances vanish
  }
  for (std::size_t i = 0; i < clouds.size(); ++i)
  {
    for (const int estimation : estimations)
    {
      SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(estimation));
      probe->SetNormalEstimation(estimation);
      ErrorLog log(probe);
      EXPECT_TRUE(std::isfinite(this->windingNumber(cloudOf(clouds[i]), 0.3, 0.2, 0.1)));
      EXPECT_EQ(log.errors(), "");
      EXPECT_NE(log.warnings(), "");
    }
  }
}

namespace
{

/// Aborts a filter at an event of progress.
struct Stopper
{
  vtkAlgorithm* filter;
  int at, events = 0;

  Stopper(vtkAlgorithm* stopped, int event)
    : filter(stopped)
    , at(event)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*)
      {
        auto* self = static_cast<Stopper*>(data);
        if (++self->events == self->at)
        {
          self->filter->SetAbortExecute(1);
        }
      });
    tag_ = filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~Stopper() { filter->RemoveObserver(tag_); }
  Stopper(const Stopper&) = delete;
  void operator=(const Stopper&) = delete;

private:
  unsigned long tag_;
};

} // namespace

TEST_F(NormalEstimation, IsAbortedWhereverItIs)
{
  const auto cloud = cloudOf(shell());
  vtkNew<vtkWindingNumberNormals> filter;
  filter->SetInputData(cloud);
  filter->EstimateNormalsOn();
  filter->SetNormalEstimation(vtkWindingNumberAlgorithm::WINDING_CONSISTENT);
  int events = 0;
  {
    Stopper counter(filter, 0);
    filter->Update();
    events = counter.events;
  }
  EXPECT_GT(events, 100); // 500
  // The last event comes when all is done.
  for (int at = 1; at < events - 1; at += events / 5)
  {
    SCOPED_TRACE(std::to_string(at) + " of " + std::to_string(events));
    Stopper stopper(filter, at);
    filter->Modified();
    filter->Update();
    filter->SetAbortExecute(0);
    EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutput())->GetNumberOfPoints(), 0);
    EXPECT_STREQ(filter->GetNormalEstimationUsed(), "");
  }
  filter->Modified();
  filter->Update();
  EXPECT_GT(filter->GetClearShare(), 0.95);
}

TEST_F(NormalEstimation, LeavesProgressToWhatComesAfterIt)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(cloudOf(shell()));
  field->SetResolution(10);
  field->EstimateNormalsOn();
  field->SetNormalEstimation(vtkWindingNumberAlgorithm::WINDING_CONSISTENT);
  for (const double scale : {1.0, 0.5}) // a filter may be a part of another one
  {
    field->SetProgressShiftScale(0, scale);
    field->Modified();
    const ProgressLog progress(field);
    field->Update();
    EXPECT_TRUE(progress.isRising());
    EXPECT_EQ(progress.last(), scale);
    EXPECT_EQ(field->GetProgressScale(), scale);
  }
}

TEST_F(NormalEstimation, ShowsProgress)
{
  for (const int estimation : estimations)
  {
    SCOPED_TRACE(estimation);
    vtkNew<vtkWindingNumberNormals> areas;
    areas->SetInputData(cloudOf(shell()));
    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(cloudOf(shell()));
    field->SetResolution(4);
    areas->EstimateNormalsOn();
    field->EstimateNormalsOn();
    areas->SetNormalEstimation(estimation);
    field->SetNormalEstimation(estimation);
    for (vtkAlgorithm* filter :
      {static_cast<vtkAlgorithm*>(areas), static_cast<vtkAlgorithm*>(field)})
    {
      // Normals take the first half of the progress of a field, and nearly all of that of areas.
      const double whole = filter == areas ? 1 : 0.5;
      for (const double share : {0.05, 0.3, 0.6})
      {
        const ProgressLog log(filter, share * whole);
        filter->Modified();
        filter->Update();
        EXPECT_TRUE(log.isRising());
        EXPECT_GE(log.abortedAt(), share * whole);
        EXPECT_LT(log.abortedAt(), (share + 0.1) * whole); // measured: 0.002 to 0.044 more
      }
      const ProgressLog log(filter);
      filter->Modified();
      filter->Update();
      EXPECT_TRUE(log.isRising());
      EXPECT_EQ(log.last(), 1);
      EXPECT_GT(log.events(), 50); // measured: 108 to 372
    }
    EXPECT_EQ(areas->GetStatus(), vtkWindingNumberAlgorithm::DONE);
  }
}
