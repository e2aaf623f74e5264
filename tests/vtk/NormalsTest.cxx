// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/HowTo.h"
#include "vtk/NormalsOfSpheres.h"
#include "vtk/ProgressLog.h"

#include "vtkAppendFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace
{

using namespace spheres;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkUnsignedCharArray> ghosts(vtkIdType count, unsigned char flag)
{
  auto flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(count);
  flags->Fill(flag);
  return flags;
}

} // namespace

TEST_F(Normals, AreasOfACloudAreThatOfItsSurface)
{
  const std::vector<double> areas = this->areasOf(cloud());
  EXPECT_NEAR(filter->GetTotalArea(), 4 * pi, 0.01 * 4 * pi); // measured 0.9987
  EXPECT_EQ(sumOf(areas), filter->GetTotalArea());
  for (const double area : areas)
  {
    ASSERT_GT(area, 0);
  }
}

TEST_F(Normals, OutputIsTheInputWithAnArrayAdded)
{
  auto input = cloud();
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  heat->SetNumberOfTuples(input->GetNumberOfPoints());
  heat->Fill(1);
  input->GetPointData()->SetScalars(heat);
  const int arrays = input->GetPointData()->GetNumberOfArrays();
  this->areasOf(input);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), arrays + 1);
  EXPECT_EQ(output->GetPointData()->GetScalars(), heat.Get());
  EXPECT_EQ(output->GetPointData()->GetNormals(), input->GetPointData()->GetNormals());
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), arrays) << "the input is as it was";

  filter->SetResultArrayName("Size");
  filter->Update();
  EXPECT_GT(sumOf(areasIn(filter->GetOutput(), "Size")), 0);
  filter->SetResultArrayName("");
  filter->Update();
  EXPECT_GT(sumOf(areasIn(filter->GetOutput(), "Area")), 0);
}

TEST_F(Normals, AreasOfAMeshAreThirdsOfItsTriangles)
{
  filter->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
  this->areasOf(sphere());
  EXPECT_NEAR(filter->GetTotalArea(), surfaceOf(sphere()), 1e-12);

  // The normals of a mesh that has none are its triangles'.
  auto bare = sphere();
  bare->GetPointData()->Initialize();
  this->areasOf(bare);
  EXPECT_NEAR(filter->GetTotalArea(), surfaceOf(sphere()), 1e-12);
  filter->SetPointAreaMethod(vtkWindingNumberNormals::VORONOI);
  this->areasOf(bare);
  EXPECT_NEAR(filter->GetTotalArea(), 4 * pi, 0.01 * 4 * pi);
}

TEST_F(Normals, ConstantAreaIsThePropertyOrTheMean)
{
  const double total = sumOf(this->areasOf(cloud()));
  filter->SetPointAreaMethod(vtkWindingNumberNormals::CONSTANT);
  const std::vector<double> mean = this->areasOf(cloud());
  EXPECT_NEAR(mean[0], total / static_cast<double>(mean.size()), 1e-15);
  EXPECT_EQ(mean, std::vector<double>(mean.size(), mean[0]));
  filter->SetPointArea(0.25);
  EXPECT_EQ(this->areasOf(cloud()), std::vector<double>(mean.size(), 0.25));
}

TEST_F(Normals, NeighborsAndNormalsAreThoseAskedFor)
{
  auto input = cloud();
  const std::vector<double> areas = this->areasOf(input);
  filter->SetNumberOfNeighbors(6);
  EXPECT_NE(this->areasOf(input), areas);
  filter->SetNumberOfNeighbors(20);

  // One normal for all points makes everything flat.
  vtkNew<vtkDoubleArray> up;
  up->SetName("Up");
  up->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    up->InsertNextTuple3(0, 0, 7);
  }
  input->GetPointData()->AddArray(up);
  EXPECT_EQ(this->areasOf(input), areas) << "the active normals";
  filter->SetNormalsArray("Up");
  EXPECT_NE(this->areasOf(input), areas);
  filter->SetNormalsArray("Down");
  this->expectRefused(input, "there is no point array 'Down'");
}

TEST_F(Normals, WhatCannotBeIsRefused)
{
  filter->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
  this->expectRefused(cloud(), "areas from the mesh need triangles");
  for (const int method : {-1, 3})
  {
    filter->SetPointAreaMethod(method);
    this->expectRefused(cloud(), "PointAreaMethod is " + std::to_string(method));
  }
  filter->SetPointAreaMethod(vtkWindingNumberNormals::CONSTANT);
  for (const double area : {-1.0, notANumber})
  {
    filter->SetPointArea(area);
    this->expectRefused(cloud(), "PointArea is");
  }
  filter->SetPointAreaMethod(vtkWindingNumberNormals::VORONOI);
  filter->SetPointArea(0);
  auto flat = cloud();
  flat->GetPointData()->GetNormals()->Fill(0);
  this->expectRefused(flat, "all normals have length 0");
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, vtkSmartPointer<vtkImageData>::New());
  this->expectRefused(images, "is a vtkImageData");
  this->areasOf(cloud());
  EXPECT_NEAR(filter->GetTotalArea(), 4 * pi, 0.01 * 4 * pi) << "the next input is worked with";
}

TEST_F(Normals, UnusablePointsHaveNoAreaAndAreCounted)
{
  // The unusable points are put between the others, to find that these keep their areas.
  const std::vector<double> areas = this->areasOf(cloud());
  auto clean = cloud();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  std::vector<double> expected;
  for (vtkIdType i = 0; i < clean->GetNumberOfPoints(); ++i)
  {
    const double zero[3] = {0, 0, 0}, bad[3] = {0, notANumber, 0};
    if (i % 100 == 7)
    {
      points->InsertNextPoint(bad);
      normals->InsertNextTuple(clean->GetPointData()->GetNormals()->GetTuple(i));
      points->InsertNextPoint(clean->GetPoint(i));
      normals->InsertNextTuple(zero);
      expected.insert(expected.end(), {0, 0});
    }
    points->InsertNextPoint(clean->GetPoint(i));
    normals->InsertNextTuple(clean->GetPointData()->GetNormals()->GetTuple(i));
    expected.push_back(areas[static_cast<std::size_t>(i)]);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->GetPointData()->SetNormals(normals);
  ErrorLog log(filter);
  EXPECT_EQ(this->areasOf(input), expected);
  EXPECT_EQ(log.errors(), "");
  EXPECT_NE(log.warnings().find("70 of 3552 points are unusable and have area 0 (35 with NaN or "
                                "infinite values, 35 with normals of length 0)"),
    std::string::npos)
    << log.warnings();
}

TEST_F(Normals, PointsAtOnePlaceHaveNoAreaAndAWarning)
{
  auto input = cloud();
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoints()->SetPoint(i, 1, 2, 3);
  }
  ErrorLog log(filter);
  const std::vector<double> areas = this->areasOf(input);
  EXPECT_EQ(areas, std::vector<double>(areas.size(), 0.0));
  EXPECT_NE(log.warnings().find(
              "points at one place have no areas: use " + howTo(winding::Parameter::pointArea)),
    std::string::npos)
    << log.warnings();
}

TEST_F(Normals, OfNothingAreNone)
{
  ErrorLog log(filter);
  EXPECT_TRUE(this->areasOf(vtkSmartPointer<vtkPolyData>::New()).empty());
  vtkNew<vtkMultiBlockDataSet> blocks;
  filter->SetInputData(blocks);
  filter->Update();
  EXPECT_EQ(log.errors() + log.warnings(), "");
}

TEST_F(Normals, GhostPointsHaveNoArea)
{
  const std::vector<double> areas = this->areasOf(cloud());
  auto input = cloud();
  const vtkIdType own = input->GetNumberOfPoints();
  auto flags = ghosts(own, 0);
  for (vtkIdType i = 0; i < own; ++i)
  {
    input->GetPoints()->InsertNextPoint(0.9, 0, 0);
    input->GetPointData()->GetNormals()->InsertNextTuple3(1, 0, 0);
    flags->InsertNextValue(vtkDataSetAttributes::DUPLICATEPOINT);
  }
  input->GetPointData()->AddArray(flags);
  std::vector<double> expected = areas;
  expected.resize(2 * areas.size());
  EXPECT_EQ(this->areasOf(input), expected);
}

TEST_F(Normals, PointsOfGhostCellsHaveNoArea)
{
  // The cells of the lower half are another piece's.
  auto input = sphere();
  auto flags = ghosts(input->GetNumberOfCells(), 0);
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    input->GetCellBounds(i, bounds);
    flags->SetValue(i, bounds[4] < 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  input->GetCellData()->AddArray(flags);
  filter->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
  const std::vector<double> areas = this->areasOf(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const double z = input->GetPoint(i)[2];
    ASSERT_EQ(areas[static_cast<std::size_t>(i)] > 0, z > 0) << z;
  }
  EXPECT_GT(filter->GetTotalArea(), 0.4 * surfaceOf(sphere()));
}

TEST_F(Normals, LeavesOfCompositeDataAreOneCloud)
{
  const std::vector<double> areas = this->areasOf(cloud());
  const double alone = filter->GetTotalArea();
  vtkNew<vtkMultiBlockDataSet> nested, blocks;
  nested->SetBlock(0, cloud(9)); // far away
  blocks->SetBlock(1, cloud());
  blocks->SetBlock(2, vtkSmartPointer<vtkPolyData>::New());
  blocks->SetBlock(3, nested);
  blocks->SetBlock(4, cloud()); // in the place of block 1: they share the area
  vtkNew<vtkDoubleArray> note;
  note->SetName("Note");
  blocks->GetFieldData()->AddArray(note);
  filter->SetInputData(blocks);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  ASSERT_TRUE(output);
  EXPECT_TRUE(output->GetFieldData()->GetArray("Note"));
  ASSERT_EQ(output->GetNumberOfBlocks(), 5u);
  EXPECT_EQ(output->GetBlock(0), nullptr);
  EXPECT_TRUE(areasIn(output->GetBlock(2)).empty());
  const std::vector<double> once = areasIn(output->GetBlock(1));
  EXPECT_EQ(areasIn(output->GetBlock(4)), once);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    ASSERT_NEAR(2 * once[i], areas[i], 0.2 * areas[i]); // neighbours are at fewer places than alone
  }
  const auto far = areasIn(vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(3))->GetBlock(0));
  EXPECT_NEAR(sumOf(far), alone, 1e-5 * alone);
  EXPECT_NEAR(filter->GetTotalArea(), 2 * alone, 0.01 * alone);
  auto* block = vtkPolyData::SafeDownCast(blocks->GetBlock(1));
  EXPECT_FALSE(block->GetPointData()->HasArray("Area")) << "the input is as it was";
}

TEST_F(Normals, PartitionedDataStaysWhatItIs)
{
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, cloud());
  parts->SetPartition(1, cloud(9));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, parts);
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{parts, collection})
  {
    filter->SetInputData(input);
    filter->Update();
    EXPECT_STREQ(filter->GetOutput()->GetClassName(), input->GetClassName());
    EXPECT_NEAR(filter->GetTotalArea(), 8 * pi, 0.01 * 8 * pi);
  }
}

TEST_F(Normals, MeshesAndCloudsTogetherAreOneCloud)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere());
  blocks->SetBlock(1, cloud(9));
  filter->SetInputData(blocks);
  filter->Update();
  EXPECT_NEAR(filter->GetTotalArea(), 8 * pi, 0.01 * 8 * pi);
}

TEST_F(Normals, OutputIsOfTheInputsType)
{
  const std::vector<double> areas = this->areasOf(cloud());
  vtkNew<vtkAppendFilter> append; // makes an unstructured grid
  append->SetInputData(cloud());
  append->Update();
  EXPECT_EQ(this->areasOf(append->GetOutput()), areas);
  EXPECT_TRUE(filter->GetOutput()->IsA("vtkUnstructuredGrid"));
  EXPECT_EQ(this->areasOf(cloud()), areas);
  EXPECT_TRUE(filter->GetOutput()->IsA("vtkPolyData"));
}

TEST_F(Normals, PointsInsideOfVolumeMeshesHaveNoArea)
{
  constexpr int n = 11;
  vtkNew<vtkImageData> box;
  box->SetDimensions(n, n, n);
  box->SetSpacing(0.1, 0.1, 0.1);
  vtkNew<vtkAppendFilter> hexahedra;
  hexahedra->SetInputData(box);
  hexahedra->Update();
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(n, n, n);
  structured->SetPoints(hexahedra->GetOutput()->GetPoints());
  filter->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
  for (vtkPointSet* input :
    std::initializer_list<vtkPointSet*>{hexahedra->GetOutput(), structured.Get()})
  {
    SCOPED_TRACE(input->GetClassName());
    const std::vector<double> areas = this->areasOf(input);
    ASSERT_EQ(areas.size(), static_cast<std::size_t>(n * n * n));
    EXPECT_NEAR(filter->GetTotalArea(), 6, 1e-6);
    const auto at = [&areas](int i, int j, int k)
    {
      return areas[static_cast<std::size_t>(i + n * (j + n * k))];
    };
    EXPECT_EQ(at(5, 5, 5), 0);
    EXPECT_EQ(at(1, 9, 4), 0);
    EXPECT_NEAR(at(5, 5, 0), 0.01, 1e-8);
    EXPECT_NEAR(at(0, 4, 7), 0.01, 1e-8);
    EXPECT_NEAR(at(4, 0, 10), 0.01, 1e-8) << "on an edge";
  }
}

TEST_F(Normals, NodesOfCurvedCellsHaveAreas)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (int i = 0; i < 20; ++i)
  {
    points->InsertNextPoint(std::sin(3 * i), std::sin(5 * i), std::sin(7 * i));
    ids.push_back(i);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_LAGRANGE_TETRAHEDRON, 20, ids.data());
  ErrorLog log(filter);
  filter->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
  const double sum = sumOf(this->areasOf(grid));
  EXPECT_EQ(sum, filter->GetTotalArea());
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(log.warnings(), "") << "every point of its triangles is a node";
}

TEST_F(Normals, HaveTheSameBitsForAnyNumberOfThreads)
{
  filter->SetNumberOfThreads(1);
  const std::vector<double> areas = this->areasOf(cloud());
  for (const int threads : {0, 2, 3})
  {
    filter->SetNumberOfThreads(threads);
    EXPECT_EQ(this->areasOf(cloud()), areas) << threads;
  }
}

TEST_F(Normals, AreasGiveTheFieldThatTheirMethodGives)
{
  auto unoriented = cloud();
  unoriented->GetPointData()->Initialize();
  vtkNew<vtkAppendFilter> grid;
  grid->SetInputData(sphere());
  grid->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud());
  blocks->SetBlock(1, cloud(1));
  auto spoilt = cloud();
  spoilt->GetPoints()->SetPoint(77, notANumber, 0, 0);
  const std::vector<vtkSmartPointer<vtkDataObject>> inputs = {
    cloud(), sphere(), unoriented, grid->GetOutput(), blocks.Get(), spoilt};
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    for (const int method : {vtkWindingNumberNormals::VORONOI, vtkWindingNumberNormals::MESH,
           vtkWindingNumberNormals::CONSTANT})
    {
      if (method == vtkWindingNumberNormals::MESH && i != 1 && i != 3)
      {
        continue; // this input has no triangles
      }
      SCOPED_TRACE(std::to_string(i) + ", method " + std::to_string(method));
      filter->SetInputData(inputs[i]);
      filter->SetPointAreaMethod(method);
      filter->EstimateNormalsOn();
      vtkNew<vtkWindingNumberField> direct, downstream;
      for (vtkWindingNumberField* field : {direct.Get(), downstream.Get()})
      {
        field->SetResolution(20);
        field->SourceAsPointsOn();
        field->EstimateNormalsOn();
        field->SetOutputScalarTypeToDouble();
      }
      ErrorLog log(filter), directLog(direct), downstreamLog(downstream);
      direct->SetInputData(inputs[i]);
      direct->SetPointAreaMethod(method);
      downstream->SetInputConnection(filter->GetOutputPort());
      downstream->SetPointAreaMethod(vtkWindingNumberField::ARRAY);
      direct->Update();
      downstream->Update();
      EXPECT_EQ(log.errors() + directLog.errors() + downstreamLog.errors(), "");
      vtkDataArray* expected = direct->GetOutput()->GetPointData()->GetScalars();
      vtkDataArray* found = downstream->GetOutput()->GetPointData()->GetScalars();
      ASSERT_EQ(found->GetNumberOfTuples(), expected->GetNumberOfTuples());
      for (vtkIdType j = 0; j < found->GetNumberOfTuples(); ++j)
      {
        ASSERT_EQ(found->GetTuple1(j), expected->GetTuple1(j)) << j;
      }
      EXPECT_GT(expected->GetRange()[1], 0.5);
    }
  }
}

TEST_F(Normals, AreFoundAnewWhenSomethingChangedOnly)
{
  vtkNew<vtkSphereSource> source;
  filter->SetInputConnection(source->GetOutputPort());
  int executions = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&executions);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkCommand::EndEvent, counter);
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1);
  filter->SetNumberOfNeighbors(20);
  filter->SetResultArrayName("Area");
  filter->Update();
  EXPECT_EQ(executions, 1) << "as it was";
  filter->SetNumberOfNeighbors(10);
  filter->Update();
  EXPECT_EQ(executions, 2);
  source->SetRadius(2);
  filter->Update();
  EXPECT_EQ(executions, 3);
}

TEST_F(Normals, AbortLeavesAnEmptyOutputAndTheNextUpdateStartsAfresh)
{
  auto stopper = std::make_unique<ProgressLog>(filter, 0);
  ErrorLog log(filter);
  filter->SetInputData(cloud());
  filter->Update();
  EXPECT_EQ(vtkPointSet::SafeDownCast(filter->GetOutput())->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetTotalArea(), 0);
  EXPECT_EQ(log.errors() + log.warnings(), "");

  stopper.reset();
  filter->Modified();
  filter->Update();
  EXPECT_GT(filter->GetTotalArea(), 0);
}
