#include "filters/MovingSphere.h"
#include "filters/ErrorLog.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

class Probe : public testing::Test
{
protected:
  Probe()
  {
    sphere->SetThetaResolution(20);
    sphere->SetPhiResolution(20);
    probe->SetSourceConnection(sphere->GetOutputPort());
    probe->SetOutputScalarTypeToDouble();
  }

  vtkNew<vtkSphereSource> sphere; // radius 0.5
  vtkNew<vtkWindingNumberProbe> probe;
};

TEST_F(Probe, OutputIsTheQueriesWithArraysAdded)
{
  vtkNew<vtkImageData> queries;
  queries->SetExtent(-2, 2, -2, 2, -2, 2);
  vtkNew<vtkFloatArray> mine;
  mine->SetName("mine");
  mine->SetNumberOfTuples(queries->GetNumberOfPoints());
  mine->Fill(3);
  queries->GetPointData()->AddArray(mine);
  probe->SetInputData(queries);
  probe->GenerateInsideOn();
  probe->Update();
  auto* image = vtkImageData::SafeDownCast(probe->GetOutput());
  ASSERT_NE(image, nullptr) << "the output is of the class of the queries";
  EXPECT_NE(image->GetPointData()->GetArray("mine"), nullptr) << "arrays are kept";
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const bool isCenter = i == image->GetNumberOfPoints() / 2;
    EXPECT_NEAR(image->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), isCenter, 1e-13);
    EXPECT_EQ(image->GetPointData()->GetArray("Inside")->GetTuple1(i), isCenter);
  }
}

TEST_F(Probe, CellsAreProbedAtTheirCentres)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->SetOrigin(-1.5, -1.5, -1.5);
  probe->SetInputData(image);
  probe->SetProbeAssociationToCells();
  probe->Update();
  vtkDataArray* values = probe->GetOutput()->GetCellData()->GetArray("WindingNumber");
  ASSERT_EQ(values->GetNumberOfTuples(), 27);
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  for (vtkIdType i = 0; i < 27; ++i)
  {
    EXPECT_NEAR(values->GetTuple1(i), i == 13, 1e-13) << "only the middle cell is in the sphere";
  }
}

TEST_F(Probe, EqualsTheDirectFieldToTheBit)
{
  probe->SetMethod(vtkWindingNumberProbe::DIRECT);
  vtkNew<vtkWindingNumberField> field;
  field->SetMethod(vtkWindingNumberField::DIRECT);
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(13);
  field->SetOutputScalarTypeToDouble();
  field->SetResultArrayName("expected");
  probe->SetInputConnection(field->GetOutputPort());
  probe->Update();
  vtkPointData* data = probe->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < data->GetArray("expected")->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(
      data->GetArray("WindingNumber")->GetTuple1(i), data->GetArray("expected")->GetTuple1(i));
  }
}

TEST_F(Probe, PointsThatAreNowhereGetNaNAndAreNotInside)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  points->InsertNextPoint(0, std::numeric_limits<double>::infinity(), 0);
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1e300, 0, 0);
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  for (int method : {vtkWindingNumberProbe::DIRECT, vtkWindingNumberProbe::PARITY})
  {
    probe->SetMethod(method);
    probe->SetInputData(queries);
    probe->GenerateInsideOn();
    probe->Update();
    vtkPointData* data = probe->GetOutput()->GetPointData();
    EXPECT_TRUE(std::isnan(data->GetArray("WindingNumber")->GetTuple1(0)));
    EXPECT_TRUE(std::isnan(data->GetArray("WindingNumber")->GetTuple1(1)));
    EXPECT_NEAR(data->GetArray("WindingNumber")->GetTuple1(2), 1, 1e-13);
    EXPECT_NEAR(data->GetArray("WindingNumber")->GetTuple1(3), 0, 1e-13);
    const double inside[4] = {0, 0, 1, 0};
    for (vtkIdType i = 0; i < 4; ++i)
    {
      EXPECT_EQ(data->GetArray("Inside")->GetTuple1(i), inside[i]) << i;
    }
  }
}

TEST_F(Probe, NoQueriesGiveNoValues)
{
  vtkNew<vtkUnstructuredGrid> none;
  ErrorLog log(probe);
  probe->SetInputData(none);
  probe->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetNumberOfTuples(), 0);
}

TEST_F(Probe, SourceThatMovesInTimeIsFollowed)
{
  vtkNew<MovingSphere> moving;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(10, 0, 0);
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  probe->SetInputData(queries);
  probe->SetSourceConnection(moving->GetOutputPort());
  for (int time : {0, 1, 0})
  {
    probe->UpdateTimeStep(time);
    vtkDataArray* values = probe->GetOutput()->GetPointData()->GetArray("WindingNumber");
    EXPECT_NEAR(values->GetTuple1(0), time == 0, 1e-13);
    EXPECT_NEAR(values->GetTuple1(1), time == 1, 1e-13);
  }
}

TEST_F(Probe, CompositeQueriesAreProbedLeafByLeaf)
{
  vtkNew<vtkSphereSource> small;
  small->SetRadius(0.1);
  small->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, small->GetOutput());
  probe->SetInputDataObject(blocks);
  probe->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  auto* leaf = vtkPolyData::SafeDownCast(output->GetBlock(0));
  EXPECT_NEAR(leaf->GetPointData()->GetArray("WindingNumber")->GetTuple1(0), 1, 1e-13);
}

} // namespace
