// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/SmpExecutor.h"
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPointSource.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>
#include <utility>
#include <vector>

namespace
{

using winding::Parameter;

/// A field that sources before it have taken time from.
class LaterField : public vtkWindingNumberField
{
public:
  static vtkSmartPointer<LaterField> make(double earlierSeconds)
  {
    auto* const made = new LaterField;
    made->InitializeObjectBase();
    made->EarlierSeconds = earlierSeconds;
    return vtkSmartPointer<LaterField>::Take(made);
  }
};

/// Work that is expected to take long is announced, or refused when it has begun.
class ExpectedTime : public testing::Test
{
protected:
  ExpectedTime()
  {
    sphere->SetThetaResolution(400);
    sphere->SetPhiResolution(400);
  }

  static void expectRefused(vtkWindingNumberAlgorithm* filter,
    const std::vector<std::string>& remedies, double longestExpectedTime = 600)
  {
    ErrorLog log(filter);
    filter->SetLongestExpectedTime(longestExpectedTime);
    const std::clock_t start = std::clock();
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberAlgorithm::REFUSED);
    std::string::size_type last = log.errors().find("this takes about ");
    for (const std::string& remedy : remedies)
    {
      const std::string::size_type place = log.errors().find(remedy);
      EXPECT_NE(place, std::string::npos) << remedy << " in " << log.errors();
      EXPECT_LT(last, place) << "the easiest remedy comes first";
      last = place;
    }
    EXPECT_NE(log.errors().find(howTo(Parameter::longestExpectedTime)), std::string::npos)
      << log.errors();
    // A second after preparing, which takes a tenth of one; the work itself would take hours.
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 200); // with sanitizers
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
    filter->RemoveAllObservers();
  }

  const std::string automatic = howTo({Parameter::method, vtkWindingNumberAlgorithm::AUTOMATIC});
  vtkNew<vtkSphereSource> sphere; ///< 318 000 triangles
};

TEST_F(ExpectedTime, DirectSumsOfManySamplesAreRefused)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(512);
  field->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(field, {automatic, howTo(Parameter::resolution)});
  EXPECT_GT(field->GetExpectedSeconds(), 3600);
  field->SetTolerance(0);
  field->Modified();
  expectRefused(field, {automatic, howTo(Parameter::tolerance), howTo(Parameter::resolution)});
}

TEST_F(ExpectedTime, SurfacesAndProbesAreRefusedLikewise)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->SetResolution(512);
  surface->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(surface, {automatic});
  vtkNew<vtkPointSource> points;
  points->SetNumberOfPoints(3'000'000);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputConnection(points->GetOutputPort());
  probe->SetSourceConnection(sphere->GetOutputPort());
  probe->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(probe, {automatic, "choose fewer samples"});
}

TEST_F(ExpectedTime, ALimitBelowWhatIsFastHoldsToo)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetMethod(vtkWindingNumberField::HIERARCHICAL);
  expectRefused(field, {howTo(Parameter::tolerance), howTo(Parameter::resolution)}, 1e-3);
  ErrorLog log(field);
  field->SetLongestExpectedTime(0);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  EXPECT_EQ(log.errors() + log.warnings(), "");
}

TEST_F(ExpectedTime, IsWhatTheClockSaysOfTheFirstBlocks)
{
  using Clock = std::chrono::steady_clock;
  winding::SmpExecutor executor(sphere, 1);
  std::vector<double> expected;
  const Clock::time_point start = Clock::now();
  const auto run = [&executor](double first, double last, std::size_t blocks)
  {
    executor.setShare(first, last);
    executor.run(
      blocks, [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(10)); });
  };
  const auto runAll = [&]
  {
    run(0, 0, 20); // takes no progress
    run(0, 0.5, 40);
    run(0.5, 1, 40);
  };
  executor.runByClock(runAll, [&](double, double seconds) { expected.push_back(seconds); });
  const double taken = std::chrono::duration<double>(Clock::now() - start).count();
  ASSERT_GE(expected.size(), 6u);
  EXPECT_NEAR(expected.back(), taken, 0.1 * taken);
  // The first run says nothing of the others. Sleeping may take longer at one time than another.
  for (const double seconds : expected)
  {
    EXPECT_LT(seconds, 2 * taken);
    EXPECT_GT(seconds, 0.05 * taken);
  }
  EXPECT_GT(expected[expected.size() / 2], 0.4 * taken);
}

TEST_F(ExpectedTime, IsAnnouncedFromAMinuteOn)
{
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  for (const auto& [earlier, isAnnounced] : {std::pair(40.0, false), {60.0, true}})
  {
    const auto field = LaterField::make(earlier);
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetMethod(vtkWindingNumberField::DIRECT);
    field->SetResolution(40);
    ErrorLog log(field);
    field->Update();
    const double own = field->GetExpectedSeconds() - earlier;
    if (own > 20 || own < 1)
    {
      GTEST_SKIP() << own << " s, where 1.8 s were measured";
    }
    EXPECT_EQ(log.warnings().find("this takes about ") != std::string::npos, isAnnounced)
      << log.warnings();
    EXPECT_EQ(log.errors(), "");
  }
}

TEST_F(ExpectedTime, AMinuteIsAnnouncedWhenTheWorkBegins)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(512);
  field->SetMethod(vtkWindingNumberField::DIRECT);
  field->SetLongestExpectedTime(0);
  ErrorLog log(field);
  // The first sign of progress after the announcement ends the work.
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&log);
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void* data, void*)
    {
      const bool isAnnounced = !static_cast<ErrorLog*>(data)->warnings().empty();
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(isAnnounced);
    });
  field->AddObserver(vtkCommand::ProgressEvent, stop);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::ABORTED);
  EXPECT_EQ(log.errors(), "");
  EXPECT_NE(log.warnings().find("this takes about "), std::string::npos) << log.warnings();
  EXPECT_GT(field->GetExpectedSeconds(), 3600);
}

} // namespace
