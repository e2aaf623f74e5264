// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/Backends.h"
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberReader.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string>

namespace
{

/// A sphere with a part cut off, so that its values are no mere integers.
class FieldPipeline : public testing::Test
{
protected:
  FieldPipeline()
  {
    sphere->SetEndPhi(120);
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(20);
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetResolution(22);
  }

  std::string bitsOf(vtkImageData* image)
  {
    vtkDataArray* values = image->GetPointData()->GetScalars();
    return {static_cast<const char*>(values->GetVoidPointer(0)),
      static_cast<std::size_t>(values->GetNumberOfTuples()) * sizeof(float)};
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> field;
};

TEST_F(FieldPipeline, InformationTellsTheWholeGridBeforeAnyData)
{
  field->UpdateInformation();
  vtkInformation* info = field->GetOutputInformation(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  EXPECT_EQ(whole[1], 21);
  double origin[3], spacing[3];
  info->Get(vtkDataObject::ORIGIN(), origin);
  info->Get(vtkDataObject::SPACING(), spacing);
  field->Update();
  int extent[6];
  field->GetOutput()->GetExtent(extent);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(extent[i], whole[i]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(field->GetOutput()->GetOrigin()[axis], origin[axis]);
    EXPECT_EQ(field->GetOutput()->GetSpacing()[axis], spacing[axis]);
  }
}

TEST_F(FieldPipeline, SubExtentsHaveTheBitsOfTheWhole)
{
  field->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(field->GetOutput());
  int last[6];
  whole->GetExtent(last);
  int extents[3][6] = {
    {3, 9, 4, 4, 0, 7}, {0, 0, 0, 0, 0, 0}, {5, last[1], 7, last[3], 11, last[5]}};
  for (auto& extent : extents)
  {
    field->Modified(); // else the pipeline would be content with the whole that it has
    field->UpdateExtent(extent);
    vtkImageData* part = field->GetOutput();
    int got[6];
    part->GetExtent(got);
    ASSERT_EQ(0, std::memcmp(got, extent, sizeof got)) << "just the extent that was asked for";
    for (int z = extent[4]; z <= extent[5]; ++z)
    {
      for (int y = extent[2]; y <= extent[3]; ++y)
      {
        for (int x = extent[0]; x <= extent[1]; ++x)
        {
          ASSERT_EQ(part->GetScalarComponentAsFloat(x, y, z, 0),
            whole->GetScalarComponentAsFloat(x, y, z, 0));
        }
      }
    }
  }
}

TEST_F(FieldPipeline, PiecesOfPointsAndCellsHaveTheBitsOfTheWhole)
{
  for (int association : {vtkWindingNumberField::POINTS, vtkWindingNumberField::CELLS})
  {
    field->SetOutputAssociation(association);
    const bool asCells = association == vtkWindingNumberField::CELLS;
    field->Update();
    vtkNew<vtkImageData> whole;
    whole->DeepCopy(field->GetOutput());
    vtkDataArray* expected =
      asCells ? whole->GetCellData()->GetScalars() : whole->GetPointData()->GetScalars();
    for (int pieces : {4, 7})
    {
      vtkIdType cells = 0;
      for (int piece = 0; piece < pieces; ++piece)
      {
        field->Modified();
        field->UpdatePiece(piece, pieces, 0);
        vtkImageData* part = field->GetOutput();
        cells += part->GetNumberOfCells();
        vtkDataArray* values =
          asCells ? part->GetCellData()->GetScalars() : part->GetPointData()->GetScalars();
        for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
        {
          double center[3];
          if (asCells)
          {
            const double* bounds = part->GetCell(i)->GetBounds();
            for (int axis = 0; axis < 3; ++axis)
            {
              center[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
            }
          }
          else
          {
            part->GetPoint(i, center);
          }
          double pcoords[3], weights[8];
          int subId;
          const vtkIdType same =
            asCells ? whole->FindCell(center, nullptr, -1, 1e-12, subId, pcoords, weights)
                    : whole->FindPoint(center);
          ASSERT_EQ(values->GetTuple1(i), expected->GetTuple1(same));
        }
      }
      EXPECT_EQ(cells, whole->GetNumberOfCells()) << pieces << " pieces";
    }
  }
}

TEST_F(FieldPipeline, BackendsAndThreadsGiveTheSameBits)
{
  field->SetNumberOfThreads(1);
  field->Update();
  const std::string expected = this->bitsOf(field->GetOutput());
  onEachBackend(
    [&](const char* backend)
    {
      for (int threads : {0, 1, 2, 3})
      {
        field->SetNumberOfThreads(threads);
        field->Modified();
        field->Update();
        EXPECT_EQ(this->bitsOf(field->GetOutput()), expected) << backend << " " << threads;
      }
    });
}

TEST_F(FieldPipeline, GridAndThresholdKeepWhatWasBuilt)
{
  field->Update();
  EXPECT_GT(field->GetPrepareSeconds(), 0);
  field->SetWindingThreshold(0.3);
  field->GenerateInsideOn();
  field->Update();
  EXPECT_EQ(field->GetPrepareSeconds(), 0) << "nothing was built";
  field->SetTolerance(0);
  field->Update();
  EXPECT_GT(field->GetPrepareSeconds(), 0) << "another tolerance";
  field->SetResolution(10);
  field->Update();
  EXPECT_EQ(field->GetPrepareSeconds(), 0) << "the cap suits every grid where it is not cut";
  EXPECT_EQ(field->GetOutput()->GetDimensions()[0], 10);

  sphere->SetRadius(2);
  field->Update();
  EXPECT_GT(field->GetPrepareSeconds(), 0) << "another source";
  field->SetMethod(vtkWindingNumberField::PARITY);
  field->Update();
  EXPECT_GT(field->GetPrepareSeconds(), 0) << "another method";
}

TEST_F(FieldPipeline, NewDataObjectsOfTheSameMeshKeepWhatWasBuilt)
{
  // Readers of time series whose mesh stays the same give other objects, and perhaps other arrays.
  sphere->Update();
  for (int step = 0; step < 3; ++step)
  {
    vtkNew<vtkPolyData> fresh;
    if (step == 1)
    {
      fresh->ShallowCopy(sphere->GetOutput());
    }
    else
    {
      fresh->DeepCopy(sphere->GetOutput());
    }
    field->SetInputData(fresh);
    field->Update();
    EXPECT_EQ(field->GetPrepareSeconds() > 0, step == 0);
  }
  field->SetInputData(sphere->GetOutput());
  sphere->GetOutput()->GetPoints()->SetPoint(0, 0, 0, 0.75);
  sphere->GetOutput()->Modified();
  field->Update();
  EXPECT_GT(field->GetPrepareSeconds(), 0) << "a point was moved";
}

/// Turns all triangles round within the array of their ids, without a word to what holds it.
void turnInPlace(vtkCellArray* cells)
{
  vtkDataArray* ids = cells->GetConnectivityArray();
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); i += 3)
  {
    const double second = ids->GetComponent(i + 1, 0);
    ids->SetComponent(i + 1, 0, ids->GetComponent(i + 2, 0));
    ids->SetComponent(i + 2, 0, second);
  }
  ids->Modified();
}

TEST_F(FieldPipeline, FollowsIdsThatChangeInPlace)
{
  sphere->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(sphere->GetOutput()->GetPoints());
  grid->SetCells(VTK_TRIANGLE, sphere->GetOutput()->GetPolys());
  field->SetUseSurfaceCells(true);
  for (vtkPointSet* source : std::initializer_list<vtkPointSet*>{sphere->GetOutput(), grid})
  {
    field->SetInputData(source);
    for (int run = 0; run < 3; ++run)
    {
      field->SetResolution(22 + run % 2); // the filter runs again
      field->Update();
      double range[2];
      field->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
      EXPECT_GT(run % 2 == 0 ? range[1] : -range[0], 0.7) << source->GetClassName();
      turnInPlace(sphere->GetOutput()->GetPolys());
    }
    turnInPlace(sphere->GetOutput()->GetPolys());
  }
}

TEST_F(FieldPipeline, SameIdsInCellsOfAnotherSizeAreAnotherMesh)
{
  const vtkIdType ids[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  vtkNew<vtkPoints> points;
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
  {
    points->InsertNextPoint(x, y, z);
  }
  field->SetResolution(6);
  std::string bits[2];
  for (const int size : {3, 4})
  {
    vtkNew<vtkCellArray> cells;
    for (int first = 0; first < 12; first += size)
    {
      cells->InsertNextCell(size, ids + first);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    field->SetInputData(mesh);
    field->Update();
    bits[size - 3] = this->bitsOf(field->GetOutput());
  }
  EXPECT_NE(bits[0], bits[1]);
}

TEST_F(FieldPipeline, WholeSourceIsAskedForWhateverThePiece)
{
  // vtkSphereSource gives a piece of the sphere for a piece of its pipeline.
  sphere->SetEndPhi(180);
  field->UpdatePiece(1, 2, 0);
  EXPECT_EQ(field->GetNumberOfBoundaryEdges(), 0) << "half a sphere would be open";
}

TEST_F(FieldPipeline, ProgressRisesToOne)
{
  const ProgressLog log(field);
  field->Update();
  EXPECT_TRUE(log.isRising());
  EXPECT_EQ(log.last(), 1);
  EXPECT_GT(log.events(), 1);
}

TEST_F(FieldPipeline, AbortLeavesAnEmptyOutputAndTheNextUpdateStartsAfresh)
{
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  field->SetResolution(40);
  auto stopper = std::make_unique<ProgressLog>(field, 0.001);
  ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::ABORTED);
  EXPECT_EQ(field->GetErrorCode(), 0u);
  EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(log.errors(), "");

  stopper.reset();
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  EXPECT_EQ(field->GetOutput()->GetDimensions()[0], 40);
}

TEST_F(FieldPipeline, AbortWhilePreparingLeavesAnEmptyOutputAndTheNextUpdateStartsAfresh)
{
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  // The first event says that nothing is done yet, the next ones are from preparing.
  auto stopper = std::make_unique<ProgressLog>(field, 0);
  ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::ABORTED);
  EXPECT_EQ(field->GetErrorCode(), 0u);
  EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(field->GetNumberOfPrimitives(), 0) << "there is no field";
  EXPECT_EQ(field->GetEvaluateSeconds(), 0) << "nothing was evaluated";
  EXPECT_EQ(log.errors(), "");

  stopper.reset();
  field->Modified();
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  EXPECT_GT(field->GetNumberOfPrimitives(), 0);
  EXPECT_GT(field->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(FieldPipeline, FailedSourceIsAnErrorAndNoZeroField)
{
  vtkNew<vtkWindingNumberReader> reader;
  reader->SetFileName("no such file.off");
  ErrorLog readerLog(reader);
  field->SetInputConnection(reader->GetOutputPort());
  ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_NE(log.errors().find("failed"), std::string::npos) << log.errors();
}

TEST_F(FieldPipeline, DataAskedForWithoutAGridIsRefused)
{
  // ParaView asks for data even where the information failed, after a good run and before any. A
  // property may be wrong in itself, or only for this source. What the pipeline hands on of the
  // image behind a contour is no grid of ours.
  vtkNew<vtkRTAnalyticSource> image;
  image->SetWholeExtent(-5, 5, -5, 5, -5, 5);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(image->GetOutputPort());
  contour->SetValue(0, 200);
  for (const bool ranBefore : {false, true})
  {
    for (const bool isProperty : {false, true})
    {
      vtkNew<vtkWindingNumberField> fresh;
      fresh->SetInputConnection(contour->GetOutputPort());
      fresh->SetResolution(6);
      if (ranBefore)
      {
        fresh->Update();
      }
      fresh->SetResolution(isProperty ? -1 : 6);
      fresh->SetVoxelSize(isProperty ? 0 : 1e-10);
      const char* const fault = isProperty ? "Resolution is -1" : "too many voxels";
      {
        ErrorLog informationLog(fresh);
        fresh->UpdateInformation();
        fresh->RemoveAllObservers();
        EXPECT_NE(informationLog.errors().find(fault), std::string::npos)
          << informationLog.errors();
      }
      vtkInformation* info = fresh->GetOutputInformation(0);
      EXPECT_FALSE(info->Has(vtkDataObject::ORIGIN()) || info->Has(vtkDataObject::SPACING()));
      ErrorLog log(fresh);
      vtkNew<vtkInformation> request;
      request->Set(vtkDemandDrivenPipeline::REQUEST_DATA());
      vtkExecutive* executive = fresh->GetExecutive();
      EXPECT_EQ(fresh->ProcessRequest(
                  request, executive->GetInputInformation(), executive->GetOutputInformation()),
        1);
      EXPECT_EQ(log.errors(), "") << "which has been said";
      EXPECT_EQ(fresh->GetStatus(), vtkWindingNumberField::REFUSED);
      EXPECT_EQ(fresh->GetOutput()->GetNumberOfPoints(), 0);
    }
  }
}

TEST_F(FieldPipeline, ThreadLimitEndsWithTheFilter)
{
  onEachBackend(
    [&](const char* backend)
    {
      const int before = vtkSMPTools::GetEstimatedNumberOfThreads();
      field->SetNumberOfThreads(1);
      field->Modified();
      field->Update();
      EXPECT_EQ(vtkSMPTools::GetEstimatedNumberOfThreads(), before) << backend;
    });
}

TEST_F(FieldPipeline, ErrorLeavesTheFilterUsable)
{
  ErrorLog log(field);
  field->SetResolution(-1);
  field->Update();
  EXPECT_FALSE(log.errors().empty());
  field->SetResolution(6);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  EXPECT_EQ(field->GetOutput()->GetDimensions()[0], 6);
}

TEST_F(FieldPipeline, RefusedSourceIsRefusedAgainAndDoesNotGetTheFieldBeforeIt)
{
  field->SetUseInputBounds(0);
  field->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
  field->SetResolution(6);
  field->Update();
  ASSERT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, std::nan(""), 0);
  const vtkIdType ids[3] = {0, 1, 2};
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(3, ids);
  vtkNew<vtkPolyData> unusable;
  unusable->SetPoints(points);
  unusable->SetPolys(cells);
  field->SetInputData(unusable);
  for (int time = 0; time < 2; ++time)
  {
    ErrorLog log(field);
    field->Modified();
    field->Update();
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED) << time;
    EXPECT_NE(log.errors().find("unusable"), std::string::npos) << log.errors();
  }
}

TEST_F(FieldPipeline, PiecesTogetherVerifyWhatTheWholeDoes)
{
  field->SetVerifySamples(200);
  field->SetOutputAssociationToCells(); // pieces of cells do not overlap
  field->Update();
  EXPECT_EQ(field->GetNumberOfVerifiedSamples(), 200);
  const vtkIdType near = field->GetNumberOfNearVerifiedSamples();
  vtkIdType everywhere = 0, nearInPieces = 0;
  for (int piece = 0; piece < 5; ++piece)
  {
    field->Modified();
    field->UpdatePiece(piece, 5, 0);
    everywhere += field->GetNumberOfVerifiedSamples();
    nearInPieces += field->GetNumberOfNearVerifiedSamples();
  }
  EXPECT_EQ(everywhere, 200);
  EXPECT_EQ(nearInPieces, near);
}

} // namespace
