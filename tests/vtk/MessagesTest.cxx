// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"

#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkGeometryFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

namespace
{

using winding::Parameter;

/// Expects that a filter refuses its input in one line that begins with these words.
void expectRefused(vtkAlgorithm* filter, const std::string& words)
{
  ErrorLog log(filter);
  testing::internal::CaptureStderr();
  filter->Update();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "a second line";
  EXPECT_NE(log.errors().find("): " + words), std::string::npos) << log.errors();
  EXPECT_EQ(log.errors().find("ERROR"), log.errors().rfind("ERROR")) << log.errors();
  filter->RemoveAllObservers();
}

vtkSmartPointer<vtkPolyData> polyline()
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4);
  for (int i = 0; i < 4; ++i)
  {
    cells->InsertCellPoint(points->InsertNextPoint(i, i * i, i % 2));
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  return lines;
}

TEST(Messages, LinesAreCalledLines)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(polyline());
  const std::string words =
    "the input has only lines, which bound nothing: make a surface of them first (" +
    howTo(Parameter::tube) + ")";
  expectRefused(field, words);
  field->EstimateNormalsOn();
  expectRefused(field, words);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(polyline()->GetPoints());
  const vtkIdType ids[2] = {0, 1};
  grid->InsertNextCell(VTK_LINE, 2, ids);
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(grid);
  expectRefused(surface, words);
}

TEST(Messages, AnEmptyInputIsCalledEmpty)
{
  vtkNew<vtkPolyData> nothing;
  for (vtkWindingNumberGridAlgorithm* filter :
    {static_cast<vtkWindingNumberGridAlgorithm*>(vtkWindingNumberField::New()),
      static_cast<vtkWindingNumberGridAlgorithm*>(vtkWindingNumberSurface::New())})
  {
    filter->SetInputData(nothing);
    // ParaView fills the bounds of nothing in.
    const double bounds[6] = {1e299, -1e299, 1e299, -1e299, 1e299, -1e299};
    filter->SetSamplingBounds(bounds);
    expectRefused(
      filter, "the input is empty, and has no bounds: give an input with points, or give "
              "bounds (" +
                howTo(Parameter::samplingBounds) + ")");
    filter->Delete();
  }
}

TEST(Messages, PointsWithoutNormalsGetTheEasiestRemedyFirst)
{
  vtkNew<vtkPointSource> points;
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(points->GetOutputPort());
  surface->MendSourceOff();
  expectRefused(
    surface, "the points have no normals: use " + howTo({Parameter::estimateNormals, 1}) + ", or ");
}

TEST(Messages, AMissingSourceHasItsName)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputConnection(sphere->GetOutputPort());
  expectRefused(
    probe, "there is no source of winding numbers: give one (" + howTo(Parameter::source) + ")");
  EXPECT_EQ(probe->GetStatus(), vtkWindingNumberProbe::REFUSED);
  probe->SetSourceConnection(sphere->GetOutputPort());
  ErrorLog log(probe);
  probe->Update();
  EXPECT_EQ(log.errors(), "");
}

TEST(Messages, ImagesAreRefusedInOurWords)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(image);
  const std::string words = "the source is a vtkImageData, no surface or points: extract a surface "
                            "first (" +
                            howTo(Parameter::contour) + ")";
  expectRefused(field, words);
  vtkNew<vtkWindingNumberReport> report;
  report->SetInputData(image);
  expectRefused(report, words);
}

TEST(Messages, OtherErrorsOfAnExecutiveArePassedOn)
{
  vtkNew<vtkPointSource> points;
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(points->GetOutputPort());
  surface->MendSourceOff();
  expectRefused(surface, "the points have no normals");
  testing::internal::CaptureStderr();
  surface->SetInputConnection(nullptr);
  surface->Update(); // a required port without a connection is the executive's own error
  EXPECT_NE(testing::internal::GetCapturedStderr().find("has 0 connections"), std::string::npos);
}

/// ParaView updates filters behind with every picture. Neither these nor executives add anything.
TEST(Messages, AnErrorIsReportedOnceUntilSomethingChanges)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> refusedByInformation, refusedByData;
  refusedByInformation->SetVoxelSize(1e-10);
  refusedByData->SetMethod(vtkWindingNumberField::PARITY);
  refusedByData->SetVerifySamples(10);
  for (vtkWindingNumberField* field : {refusedByInformation.Get(), refusedByData.Get()})
  {
    field->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkGeometryFilter> behind;
    behind->SetInputConnection(field->GetOutputPort());
    for (const bool sourceChanges : {false, true})
    {
      ErrorLog ofField(field), ofExecutive(field->GetExecutive()), ofBehind(behind);
      testing::internal::CaptureStderr();
      for (int picture = 0; picture < 3; ++picture)
      {
        behind->Modified();
        behind->Update();
        EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
        EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
      }
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
      EXPECT_NE(ofField.errors(), "") << sourceChanges;
      EXPECT_EQ(ofField.errors().find("ERROR"), ofField.errors().rfind("ERROR"));
      EXPECT_EQ(ofExecutive.errors() + ofBehind.errors(), "");
      sphere->Modified();
    }
    field->SetVoxelSize(0);
    field->SetVerifySamples(0);
    field->Update();
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
    EXPECT_GT(field->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(Messages, FacesThatAreTurnedOnRequestAreNoWarning)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkReverseSense> inward;
  inward->SetInputConnection(sphere->GetOutputPort());
  inward->ReverseCellsOn();
  vtkNew<vtkWindingNumberReport> report;
  report->SetInputConnection(inward->GetOutputPort());
  report->FixOrientationOn();
  ErrorLog log(report);
  report->Update();
  EXPECT_EQ(log.warnings(), "");
  EXPECT_EQ(report->GetNumberOfFlippedTriangles(), 96);
}

} // namespace
