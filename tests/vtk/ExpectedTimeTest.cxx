#include "vtk/ErrorLog.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPointSource.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <chrono>

namespace
{

/// Work that is expected to take long is announced, or refused before it begins.
class ExpectedTime : public testing::Test
{
protected:
  ExpectedTime()
  {
    sphere->SetThetaResolution(400);
    sphere->SetPhiResolution(400);
  }

  static void expectRefused(vtkWindingNumberAlgorithm* filter, const std::string& words)
  {
    ErrorLog log(filter);
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberAlgorithm::REFUSED);
    EXPECT_NE(log.errors().find(words), std::string::npos) << log.errors();
    EXPECT_NE(log.errors().find("raise Longest Expected Time"), std::string::npos) << log.errors();
    // Building the field takes a tenth of a second; the work itself would take hours.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
    filter->RemoveAllObservers();
  }

  vtkNew<vtkSphereSource> sphere; ///< 318 000 triangles
};

TEST_F(ExpectedTime, DirectSumsOfManySamplesAreRefused)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(512);
  field->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(field, "choose the method automatic (Method; --method), or larger voxels: method "
                       "direct takes about ");
  EXPECT_GT(field->GetExpectedSeconds(), 3600);
  field->SetTolerance(0);
  field->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(field, "choose a tolerance of 1e-6 or more (Tolerance; --tolerance)");
}

TEST_F(ExpectedTime, SurfacesAndProbesAreRefusedLikewise)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->SetResolution(512);
  surface->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(surface, "method direct takes about");
  vtkNew<vtkPointSource> points;
  points->SetNumberOfPoints(3'000'000);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputConnection(points->GetOutputPort());
  probe->SetSourceConnection(sphere->GetOutputPort());
  probe->SetMethod(vtkWindingNumberField::DIRECT);
  expectRefused(probe, "or fewer samples: method direct takes about");
}

TEST_F(ExpectedTime, ALimitBelowWhatIsFastHoldsToo)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetMethod(vtkWindingNumberField::HIERARCHICAL);
  field->SetLongestExpectedTime(1e-3);
  expectRefused(
    field, "choose larger voxels or a larger tolerance (Tolerance; --tolerance): method hier");
  ErrorLog log(field);
  field->SetLongestExpectedTime(0);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  EXPECT_EQ(log.errors() + log.warnings(), "");
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
  EXPECT_NE(log.warnings().find("method direct takes about"), std::string::npos) << log.warnings();
  EXPECT_NE(log.warnings().find("hours for"), std::string::npos) << log.warnings();
}

} // namespace
