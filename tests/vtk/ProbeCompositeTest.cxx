// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

#include "vtkAMRBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStructuredData.h"
#include "vtkTable.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

vtkSmartPointer<vtkPolyData> somePoints(int count, int seed)
{
  vtkNew<vtkPointSource> source;
  source->SetNumberOfPoints(count);
  source->SetCenter(0.1 * seed, 0, 0);
  source->SetRadius(0.7);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> someImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 5, 4);
  image->SetSpacing(0.21, 0.22, 0.23);
  image->SetOrigin(-0.5, -0.5, -0.3);
  return image;
}

class ProbeComposite : public testing::Test
{
protected:
  ProbeComposite()
  {
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(30);
    probe->SetSourceConnection(sphere->GetOutputPort());
    probe->GenerateInsideOn();
    probe->SetMethod(vtkWindingNumberProbe::DIRECT); // its bits depend on the point only

    inner->SetBlock(0, somePoints(50, 1));
    inner->SetBlock(2, someImage());
    blocks->SetBlock(0, someImage());
    blocks->SetBlock(1, inner);
    blocks->SetBlock(2, nullptr);
    blocks->SetBlock(3, table);
    blocks->SetBlock(4, vtkSmartPointer<vtkPolyData>::New());
    blocks->SetBlock(5, somePoints(20, 2));
    blocks->GetMetaData(5u)->Set(vtkCompositeDataSet::NAME(), "the last");
  }

  /// The filter's output for a data set that comes alone.
  vtkSmartPointer<vtkDataSet> alone(vtkDataSet* queries)
  {
    vtkNew<vtkWindingNumberProbe> other;
    other->SetSourceConnection(sphere->GetOutputPort());
    other->SetMethod(probe->GetMethod());
    other->SetInsideOut(probe->GetInsideOut());
    other->SetExtractInside(probe->GetExtractInside());
    other->SetProbeAssociation(probe->GetProbeAssociation());
    other->GenerateInsideOn();
    other->SetInputData(queries);
    other->Update();
    return other->GetOutput();
  }

  void expectLeafByLeaf(vtkDataObjectTree* queries)
  {
    probe->SetInputDataObject(queries);
    probe->Update();
    EXPECT_EQ(probe->GetOutput(), nullptr);
    auto* output = vtkDataObjectTree::SafeDownCast(probe->GetOutputDataObject(0));
    ASSERT_NE(output, nullptr);
    EXPECT_STREQ(output->GetClassName(), queries->GetClassName());
    EXPECT_NE(output->GetFieldData()->GetAbstractArray("WindingNumberMethod"), nullptr);
    auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(queries->NewTreeIterator());
    iterator->SkipEmptyNodesOff();
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkDataObject* data = iterator->GetCurrentDataObject();
      vtkDataObject* answer = output->GetDataSet(iterator);
      auto* leaf = vtkDataSet::SafeDownCast(data);
      if (!leaf)
      {
        EXPECT_EQ(answer, data) << "stays as it is";
        continue;
      }
      auto* found = vtkDataSet::SafeDownCast(answer);
      ASSERT_NE(found, nullptr);
      const auto expected = this->alone(leaf);
      EXPECT_STREQ(found->GetClassName(), expected->GetClassName());
      EXPECT_EQ(found->GetNumberOfCells(), expected->GetNumberOfCells());
      EXPECT_NE(found->GetFieldData()->GetAbstractArray("WindingNumberMethodReason"), nullptr);
      for (const char* name : {"WindingNumber", "Inside"})
      {
        vtkDataArray* values = found->GetPointData()->GetArray(name);
        vtkDataArray* ones = expected->GetPointData()->GetArray(name);
        ASSERT_EQ(values == nullptr, ones == nullptr);
        if (values)
        {
          ASSERT_EQ(values->GetNumberOfTuples(), found->GetNumberOfPoints());
          ASSERT_EQ(values->GetNumberOfTuples(), ones->GetNumberOfTuples());
          for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
          {
            ASSERT_EQ(values->GetTuple1(i), ones->GetTuple1(i));
          }
        }
      }
      EXPECT_EQ(leaf->GetPointData()->GetArray("Inside"), nullptr) << "the input is left alone";
    }
  }

  vtkNew<vtkSphereSource> sphere; // radius 0.5
  vtkNew<vtkWindingNumberProbe> probe;
  vtkNew<vtkMultiBlockDataSet> blocks, inner;
  vtkNew<vtkTable> table;
};

TEST_F(ProbeComposite, GivesEachDataSetItsArraysAndKeepsTheRest)
{
  this->expectLeafByLeaf(blocks);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfBlocks(), 6u);
  EXPECT_STREQ(output->GetMetaData(5u)->Get(vtkCompositeDataSet::NAME()), "the last");
  EXPECT_EQ(vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1))->GetNumberOfBlocks(), 3u);
}

TEST_F(ProbeComposite, NumbersQueriesOn)
{
  this->expectLeafByLeaf(blocks);
  const auto first = this->alone(someImage());
  const vtkIdType firstSize = first->GetNumberOfPoints();
  const auto second = this->alone(vtkDataSet::SafeDownCast(inner->GetBlock(0)));
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(
      probe->IsInside(firstSize + i), second->GetPointData()->GetArray("Inside")->GetTuple1(i));
  }
  EXPECT_EQ(probe->IsInside(-1), 0);
  EXPECT_EQ(probe->IsInside(1'000'000), 0);
}

TEST_F(ProbeComposite, CellsInsideOutAndExtraction)
{
  for (const bool atCells : {false, true})
  {
    for (const bool insideOut : {false, true})
    {
      for (const bool extract : {false, true})
      {
        probe->SetProbeAssociation(atCells);
        probe->SetInsideOut(insideOut);
        probe->SetExtractInside(extract);
        this->expectLeafByLeaf(blocks);
      }
    }
  }
}

TEST_F(ProbeComposite, Partitions)
{
  vtkNew<vtkPartitionedDataSet> first, second;
  first->SetPartition(0, somePoints(30, 1));
  first->SetPartition(1, somePoints(40, 2));
  second->SetPartition(1, someImage());
  this->expectLeafByLeaf(first);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, first);
  collection->SetPartitionedDataSet(1, second);
  this->expectLeafByLeaf(collection);
  probe->ExtractInsideOn();
  this->expectLeafByLeaf(collection);
}

TEST_F(ProbeComposite, WithoutDataSetsStaysAsItIs)
{
  vtkNew<vtkMultiBlockDataSet> empty;
  ErrorLog log(probe);
  this->expectLeafByLeaf(empty);
  empty->SetBlock(1, table);
  this->expectLeafByLeaf(empty);
  EXPECT_EQ(log.errors(), "");
}

/// A thousand small data sets are one list of samples for a cap and its far field, too, and so take
/// no longer.
TEST_F(ProbeComposite, ManySmallDataSetsAreOneEvaluation)
{
  probe->SetMethod(vtkWindingNumberProbe::AUTOMATIC);
  sphere->SetThetaResolution(300);
  sphere->SetPhiResolution(300);
  sphere->SetEndPhi(150);
  const auto all = somePoints(1000, 0);
  probe->SetInputData(all);
  probe->Update();
  const vtkSmartPointer<vtkDataArray> expected =
    probe->GetOutput()->GetPointData()->GetArray("WindingNumber");
  EXPECT_STREQ(probe->GetMethodUsed(), "rows");
  vtkNew<vtkMultiBlockDataSet> many;
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    vtkNew<vtkPoints> point;
    point->InsertNextPoint(all->GetPoint(i));
    vtkNew<vtkPolyData> query;
    query->SetPoints(point);
    many->SetBlock(static_cast<unsigned>(i), query);
  }
  probe->SetInputDataObject(many);
  probe->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  for (unsigned i = 0; i < 1000; ++i)
  {
    vtkDataArray* value =
      vtkDataSet::SafeDownCast(output->GetBlock(i))->GetPointData()->GetArray("WindingNumber");
    ASSERT_EQ(value->GetTuple1(0), expected->GetTuple1(i)) << "the very bits";
  }
}

/// The executive takes AMR data sets apart and puts them together again.
TEST_F(ProbeComposite, AmrGoesBlockByBlock)
{
  vtkNew<vtkOverlappingAMR> amr;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  amr->Initialize(std::vector<unsigned int>{1});
#else
  const int blocksPerLevel[] = {1};
  amr->Initialize(1, blocksPerLevel);
#endif
  const double origin[3] = {-1, -1, -1}, spacing[3] = {0.5, 0.5, 0.5};
  const int dimensions[3] = {5, 5, 5};
  amr->SetOrigin(origin);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  amr->SetGridDescription(vtkStructuredData::VTK_STRUCTURED_XYZ_GRID);
#else
  amr->SetGridDescription(VTK_XYZ_GRID);
#endif
  amr->SetSpacing(0, spacing);
  amr->SetAMRBox(0, 0, vtkAMRBox(origin, dimensions, spacing, origin));
  vtkNew<vtkUniformGrid> grid;
  grid->SetOrigin(origin);
  grid->SetSpacing(spacing);
  grid->SetDimensions(dimensions);
  amr->SetDataSet(0, 0, grid);
  probe->SetInputDataObject(amr);
  probe->Update();
  auto* output = vtkCompositeDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(output->NewIterator());
  iterator->InitTraversal();
  ASSERT_FALSE(iterator->IsDoneWithTraversal());
  auto* leaf = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
  EXPECT_EQ(leaf->GetPointData()->GetArray("Inside")->GetTuple1(62), 1) << "the middle";
}

} // namespace
