// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/HyperTreeVoxels.h"
#include "vtk/ProgressLog.h"
#include "vtk/ReadMesh.h"
#include "vtk/SphereCloud.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberHyperTree.h"
#include "vtkXMLHyperTreeGridReader.h"
#include "vtkXMLHyperTreeGridWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

namespace
{

using Filter = vtkWindingNumberHyperTree;

/// Writes a hyper tree grid and reads it again. Several arrays come back from binary data only.
vtkSmartPointer<vtkHyperTreeGrid> writtenAndRead(vtkHyperTreeGrid* trees)
{
  const std::string name =
    testing::TempDir() + "/" +
    testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
    testing::UnitTest::GetInstance()->current_test_info()->name() + ".htg";
  vtkNew<vtkXMLHyperTreeGridWriter> writer;
  writer->SetInputData(trees);
  writer->SetDataModeToBinary();
  writer->SetFileName(name.c_str());
  writer->Write();
  vtkNew<vtkXMLHyperTreeGridReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  std::remove(name.c_str());
  return vtkHyperTreeGrid::SafeDownCast(reader->GetOutputDataObject(0));
}

/// The filter at work, and the field on the same grid to compare with.
class HyperTree : public testing::Test
{
protected:
  HyperTree()
  {
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(20);
    trees->SetResolution(64);
    field->SetResolution(64);
  }

  void setInput(vtkDataObject* source)
  {
    trees->SetInputData(source);
    field->SetInputData(source);
  }

  /// Calls both filters: set(filter).
  template <class Set> void setBoth(const Set& set)
  {
    set(trees.Get());
    set(field.Get());
  }

  /// Compares the arrays of a hyper tree grid with the field's at every voxel. Values of w
  /// may differ by `tolerance`. Returns the largest difference of w.
  double expectTheField(vtkHyperTreeGrid* made, double tolerance)
  {
    field->Update();
    vtkPointData* wanted = field->GetOutput()->GetPointData();
    EXPECT_EQ(made->GetCellData()->GetNumberOfArrays(), wanted->GetNumberOfArrays());
    const std::vector<vtkIdType> leaves = leavesOfVoxels(made, trees);
    EXPECT_EQ(static_cast<vtkIdType>(leaves.size()), field->GetOutput()->GetNumberOfPoints());
    EXPECT_EQ(trees->GetNumberOfInsideSamples(), field->GetNumberOfInsideSamples());
    double largest = 0;
    for (int i = 0; i < wanted->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const dense = wanted->GetArray(i);
      vtkDataArray* const sparse = made->GetCellData()->GetArray(dense->GetName());
      if (!sparse)
      {
        ADD_FAILURE() << "there is no array " << dense->GetName();
        continue;
      }
      EXPECT_EQ(sparse->GetDataType(), dense->GetDataType());
      const bool mayDiffer = std::string(dense->GetName()) == "WindingNumber";
      std::size_t wrong = 0;
      for (std::size_t voxel = 0; voxel < leaves.size(); ++voxel)
      {
        if (leaves[voxel] < 0)
        {
          ++wrong;
          continue;
        }
        const double difference = std::abs(
          sparse->GetTuple1(leaves[voxel]) - dense->GetTuple1(static_cast<vtkIdType>(voxel)));
        wrong += !(difference <= (mayDiffer ? tolerance : 0));
        largest = std::max(largest, difference);
      }
      EXPECT_EQ(wrong, 0u) << dense->GetName();
    }
    return largest;
  }

  /// Makes the trees, and compares them before and after they were in a file.
  double expectTheFieldInMemoryAndInFiles(double tolerance)
  {
    trees->Update();
    const double largest = expectTheField(trees->GetOutput(), tolerance);
    EXPECT_EQ(expectTheField(writtenAndRead(trees->GetOutput()), tolerance), largest);
    return largest;
  }

  /// A sphere; with endPhi less than 180, a part is cut off.
  vtkSmartPointer<vtkPolyData> closed(double endPhi = 180)
  {
    sphere->SetEndPhi(endPhi);
    sphere->Update();
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(sphere->GetOutput());
    return copy;
  }
  vtkSmartPointer<vtkPolyData> open() { return closed(120); }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<Filter> trees;
  vtkNew<vtkWindingNumberField> field;
};

TEST_F(HyperTree, DefaultsAreTheDocumentedOnes)
{
  EXPECT_EQ(trees->GetCoverage(), 0);
  EXPECT_EQ(trees->GetCoverageSamples(), 4);
  EXPECT_EQ(trees->GetMergeTolerance(), 0.01);
  EXPECT_EQ(trees->GetMaskOutside(), 0);
}

TEST_F(HyperTree, AClosedSurfaceHasTheFieldsBitsAtEveryVoxel)
{
  setInput(closed());
  setBoth([](auto* filter) { filter->GenerateInsideOn(); });
  EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
  EXPECT_FALSE(trees->GetOutput()->GetFieldData()->HasArray("MergeTolerance"));
  EXPECT_STREQ(trees->GetMethodUsed(), "rows");
  EXPECT_LT(trees->GetNumberOfVertices(), 64 * 64 * 64 / 2); // measured: 23 680
}

TEST_F(HyperTree, InsideAloneHasTheFieldsBits)
{
  for (const auto& source : {closed(), open()})
  {
    setInput(source);
    setBoth(
      [](auto* filter)
      {
        filter->GenerateInsideOn();
        filter->GenerateWindingNumberOff();
      });
    EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
  }
}

TEST_F(HyperTree, CoverageHasTheFieldsBits)
{
  for (const auto& source : {closed(), open()})
  {
    setInput(source);
    for (const int coverage : {vtkWindingNumberField::ANY, vtkWindingNumberField::FRACTION})
    {
      setBoth(
        [coverage](auto* filter)
        {
          filter->SetCoverage(coverage);
          filter->SetCoverageSamples(2); // four would take eight times as long
        });
      trees->SetMergeTolerance(0.02);
      EXPECT_LE(expectTheFieldInMemoryAndInFiles(0.01 + 1e-6), 0.01 + 1e-6);
    }
  }
}

TEST_F(HyperTree, AnOpenSurfaceIsOffByHalfTheToleranceAtMost)
{
  setInput(open());
  setBoth([](auto* filter) { filter->GenerateInsideOn(); });
  vtkIdType before = 8 * 64 * 64 * 64;
  for (const double tolerance : {0.01, 0.03, 0.1})
  {
    trees->SetMergeTolerance(tolerance);
    const double largest = expectTheFieldInMemoryAndInFiles(tolerance / 2 + 1e-6);
    EXPECT_GT(largest, tolerance / 4);
    EXPECT_LT(trees->GetNumberOfVertices(), before);
    before = trees->GetNumberOfVertices();
    auto* told = trees->GetOutput()->GetFieldData()->GetArray("MergeTolerance");
    ASSERT_TRUE(told);
    EXPECT_EQ(told->GetTuple1(0), tolerance);
  }
  trees->SetMergeTolerance(0);
  EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
  EXPECT_FALSE(trees->GetOutput()->GetFieldData()->HasArray("MergeTolerance"));
}

TEST_F(HyperTree, CellsDoNotReachOverTheThreshold)
{
  setInput(open());
  for (const double threshold : {0.3, 0.5, 0.62})
  {
    for (const int rule : {Filter::SIGNED, Filter::ABSOLUTE, Filter::ODD})
    {
      setBoth(
        [&](auto* filter)
        {
          filter->SetWindingThreshold(threshold);
          filter->SetInsideRule(rule);
          filter->GenerateInsideOn();
          filter->SetResolution(20);
        });
      trees->SetMergeTolerance(0.5);
      trees->Update();
      expectTheField(trees->GetOutput(), 0.25 + 1e-6);
      vtkCellData* data = trees->GetOutput()->GetCellData();
      for (const vtkIdType leaf : leavesOfVoxels(trees->GetOutput(), trees))
      {
        const double w = data->GetArray("WindingNumber")->GetTuple1(leaf);
        const double nearest = std::round(std::abs(w));
        const bool isInside = rule == Filter::SIGNED     ? w >= threshold
                              : rule == Filter::ABSOLUTE ? std::abs(w) >= threshold
                                                         : std::fmod(nearest, 2.0) == 1;
        ASSERT_EQ(data->GetArray("Inside")->GetTuple1(leaf), isInside);
      }
    }
  }
}

TEST_F(HyperTree, OtherMethodsAndDoublesHaveTheFieldsValues)
{
  setInput(closed());
  for (const int method : {Filter::HIERARCHICAL, Filter::DIRECT, Filter::PARITY})
  {
    setBoth(
      [method](auto* filter)
      {
        filter->SetMethod(method);
        filter->SetOutputScalarTypeToDouble();
        filter->SetResolution(24);
      });
    EXPECT_LE(expectTheFieldInMemoryAndInFiles(0.005 + 1e-12), 0.005 + 1e-12);
  }
}

TEST_F(HyperTree, DoublesHaveAllBitsOfTheField)
{
  setInput(open());
  setBoth([](auto* filter) { filter->SetOutputScalarTypeToDouble(); });
  trees->SetMergeTolerance(0);
  EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
}

TEST_F(HyperTree, CloudsHaveTheFieldsValues)
{
  setInput(sphereCloud(2000, 1));
  setBoth([](auto* filter) { filter->GenerateInsideOn(); });
  expectTheFieldInMemoryAndInFiles(0.005 + 1e-6);
}

TEST_F(HyperTree, GridsOfAllShapesAreWhole)
{
  const int shapes[][3] = {{1, 1, 1}, {2, 3, 5}, {16, 16, 16}, {17, 33, 1}, {1, 40, 1}, {1, 1, 65},
    {100, 7, 31}, {64, 64, 64}};
  for (const auto& source : {closed(), open()})
  {
    setInput(source);
    for (const auto& shape : shapes)
    {
      SCOPED_TRACE(testing::PrintToString(shape));
      setBoth(
        [&shape](auto* filter)
        {
          filter->SetSamplingDimensions(shape[0], shape[1], shape[2]);
          filter->GenerateInsideOn();
        });
      expectTheFieldInMemoryAndInFiles(0.005 + 1e-6);
      const bool isWhole = shape[0] % 16 == 0 && shape[1] % 16 == 0 && shape[2] % 16 == 0;
      EXPECT_EQ(trees->GetOutput()->GetMask() == nullptr, isWhole);
    }
  }
}

TEST_F(HyperTree, BoundsMayCutTheSolid)
{
  setInput(closed());
  setBoth(
    [](auto* filter)
    {
      filter->UseInputBoundsOff();
      filter->SetSamplingBounds(-0.1, 0.3, -1, 0.1, 0.05, 0.45);
      filter->SetVoxelSize(0.021);
      filter->GenerateInsideOn();
    });
  EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
}

TEST_F(HyperTree, ParentsHaveTheMeansOfTheirVoxels)
{
  setInput(closed());
  setBoth(
    [](auto* filter)
    {
      filter->SetCoverage(vtkWindingNumberField::FRACTION);
      filter->SetSamplingDimensions(16, 16, 16); // one brick
    });
  trees->Update();
  field->Update();
  double value = 0, coverage = 0;
  for (vtkIdType i = 0; i < 4096; ++i)
  {
    value += field->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetTuple1(i) / 4096;
    coverage += field->GetOutput()->GetPointData()->GetArray("Coverage")->GetTuple1(i) / 4096;
  }
  vtkCellData* data = trees->GetOutput()->GetCellData();
  EXPECT_NEAR(data->GetArray("WindingNumber")->GetTuple1(0), value, 1e-6);
  EXPECT_NEAR(data->GetArray("Coverage")->GetTuple1(0), coverage, 1e-6);
  EXPECT_EQ(data->GetArray("Inside")->GetTuple1(0), 0) << "with padding, a sphere fills 0.39";
}

TEST_F(HyperTree, OutsideMayBeMasked)
{
  setInput(closed());
  setBoth([](auto* filter) { filter->GenerateInsideOn(); });
  trees->MaskOutsideOn();
  trees->Update();
  field->Update();
  vtkDataArray* inside = field->GetOutput()->GetPointData()->GetArray("Inside");
  const std::vector<vtkIdType> leaves = leavesOfVoxels(trees->GetOutput(), trees);
  std::vector<vtkIdType> different;
  for (std::size_t voxel = 0; voxel < leaves.size(); ++voxel)
  {
    ASSERT_EQ(leaves[voxel] >= 0, inside->GetTuple1(static_cast<vtkIdType>(voxel)) != 0);
    if (leaves[voxel] >= 0)
    {
      different.push_back(leaves[voxel]);
    }
  }
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  EXPECT_EQ(trees->GetNumberOfLeaves(), static_cast<vtkIdType>(different.size()));
}

TEST_F(HyperTree, ThreadsDoNotChangeTheBits)
{
  for (const auto& source : {closed(), open()})
  {
    setInput(source);
    trees->SetNumberOfThreads(1);
    trees->Update();
    vtkNew<vtkHyperTreeGrid> one;
    one->DeepCopy(trees->GetOutput());
    trees->SetNumberOfThreads(4);
    trees->Update();
    vtkDataArray* const a = one->GetCellData()->GetScalars();
    vtkDataArray* const b = trees->GetOutput()->GetCellData()->GetScalars();
    ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
    EXPECT_EQ(0, std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                   sizeof(float) * static_cast<std::size_t>(a->GetNumberOfTuples())));
  }
}

TEST_F(HyperTree, TheGridFollowsTheSource)
{
  setInput(closed());
  trees->Update();
  const double before = trees->GetOutput()->GetBounds()[1];
  sphere->SetRadius(2);
  setInput(closed());
  EXPECT_EQ(expectTheFieldInMemoryAndInFiles(0), 0);
  EXPECT_NEAR(trees->GetOutput()->GetBounds()[1], 4 * before, 1e-6);
}

TEST_F(HyperTree, TheFirstPieceHasEverything)
{
  setInput(closed());
  trees->UpdatePiece(1, 2, 0);
  EXPECT_EQ(trees->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
  trees->UpdatePiece(0, 2, 0);
  expectTheField(trees->GetOutput(), 0);
}

TEST_F(HyperTree, ValuesAreVerified)
{
  setInput(closed());
  trees->SetVerifySamples(500);
  trees->Update();
  EXPECT_GT(trees->GetNumberOfVerifiedSamples(), 400);
  EXPECT_LT(trees->GetMaxError(), 1e-6); // measured: 2.9e-15
  setInput(open());
  trees->SetMergeTolerance(0.1);
  trees->Update();
  EXPECT_LT(trees->GetMaxError(), 0.052); // measured: 0.044; half the tolerance, and Tolerance
  EXPECT_GT(trees->GetMaxError(), 0.02);
  ErrorLog log(trees);
  trees->GenerateWindingNumberOff();
  trees->GenerateInsideOn();
  trees->Update();
  EXPECT_NE(log.errors().find("only winding numbers can be verified"), std::string::npos)
    << log.errors();
}

TEST_F(HyperTree, ProgressRisesAndAbortIsObeyed)
{
  for (const auto& source : {closed(), open()})
  {
    setInput(source);
    trees->SetResolution(150);
    ProgressLog whole(trees);
    trees->Update();
    EXPECT_TRUE(whole.isRising());
    EXPECT_EQ(whole.last(), 1);
    trees->Modified();
    ProgressLog log(trees, 0.3);
    trees->Update();
    EXPECT_EQ(trees->GetStatus(), Filter::ABORTED);
    EXPECT_EQ(trees->GetOutput()->GetCellData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(trees->GetOutput()->GetNumberOfNonEmptyTrees(), 0);
    trees->SetAbortExecute(0);
  }
}

TEST_F(HyperTree, WhatDoesNotFitIntoMemoryIsRefusedAtOnce)
{
  setInput(open());
  trees->SetResolution(20000);
  trees->SetMergeTolerance(0);
  trees->SetLongestExpectedTime(0);
  ErrorLog log(trees);
  trees->Update();
  EXPECT_EQ(trees->GetStatus(), Filter::OUT_OF_MEMORY) << log.errors();
  EXPECT_NE(log.errors().find(howTo(winding::Parameter::mergeTolerance)), std::string::npos)
    << log.errors();
  EXPECT_NE(log.errors().find(" GiB, and "), std::string::npos) << log.errors();
}

TEST_F(HyperTree, NothingAndInsideOutSourcesAreTold)
{
  ErrorLog log(trees);
  vtkNew<vtkPolyData> nothing;
  trees->SetInputData(nothing);
  trees->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_NE(log.warnings().find("give a surface or points"), std::string::npos) << log.warnings();
  EXPECT_EQ(trees->GetOutput()->GetCellData()->GetScalars()->GetRange()[1], 0);
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(closed());
  vtkNew<vtkCellArray> faces;
  for (vtkIdType cell = 0; cell < turned->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    turned->GetCellPoints(cell, ids);
    std::reverse(ids->begin(), ids->end());
    faces->InsertNextCell(ids);
  }
  turned->SetPolys(faces);
  trees->SetInputData(turned);
  for (const bool withValues : {true, false})
  {
    trees->SetGenerateWindingNumber(withValues);
    trees->GenerateInsideOn();
    for (const int method : {Filter::AUTOMATIC, Filter::HIERARCHICAL})
    {
      trees->SetMethod(method);
      trees->Update();
      EXPECT_TRUE(trees->GetSourceIsInsideOut()) << withValues << method;
    }
  }
}

TEST_F(HyperTree, RealMeshesHaveTheFieldsValues)
{
  struct Case
  {
    const char* file;
    bool insideOnly;
  };
  const auto cases = shapes::present(
    {Case{"bunny_10k.obj", false}, Case{"bunny_10k.obj", true},
      Case{"maxplanck_open_90k.obj", false}, Case{"maxplanck_open_90k.obj", true},
      Case{"truck_soup.obj", true}, Case{"teapot.obj", false}, Case{"teapot.obj", true}},
    [](const Case& c) { return c.file; });
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.file);
    setInput(readMesh(shapes::realMesh(c.file)));
    setBoth(
      [&c](auto* filter)
      {
        filter->SetResolution(96);
        filter->SetGenerateWindingNumber(!c.insideOnly);
        filter->GenerateInsideOn();
      });
    expectTheFieldInMemoryAndInFiles(0.005 + 1e-6);
  }
}

} // namespace
