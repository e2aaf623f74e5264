// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/Backends.h"
#include "vtk/ErrorLog.h"
#include "vtk/SphereCloud.h"
#include "vtk/Spheres.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using Filter = vtkWindingNumberBoolean;

vtkSmartPointer<vtkPolyData> boxOf(double x0, double x1, double y0, double y1, double z0, double z1)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(x0, x1, y0, y1, z0, z1);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> sphereAt(double x, double radius = 1, double endPhi = 180)
{
  return sphereOf(80, 60, radius, {x, 0, 0}, endPhi);
}

class Boolean : public testing::Test
{
protected:
  Boolean()
  {
    filter->SetResolution(64);
    filter->GenerateTrianglesOn();
  }

  /// Makes the result of an operation on two sources.
  vtkPolyData* made(vtkDataObject* a, vtkDataObject* b, int operation)
  {
    filter->SetInputDataObject(0, a);
    filter->SetInputDataObject(1, b);
    filter->SetOperation(operation);
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.errors(), "");
    return filter->GetOutput();
  }

  void expectClosed()
  {
    const EdgeCounts edges = countEdges(filter->GetOutput());
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.nonManifold, 0);
  }

  double volume() { return signedVolume(filter->GetOutput()); }

  vtkNew<Filter> filter;
};

/// Whether places are inside of a source.
std::vector<bool> insideOf(vtkDataObject* source, vtkPolyData* places, int rule = 0)
{
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(places);
  probe->SetSourceData(source);
  probe->SetInsideRule(rule);
  probe->GenerateInsideOn();
  probe->Update();
  vtkDataArray* inside =
    vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0))->GetPointData()->GetArray("Inside");
  std::vector<bool> result;
  for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
  {
    result.push_back(inside->GetTuple1(i) != 0);
  }
  return result;
}

vtkSmartPointer<vtkPolyData> randomPlaces(int count, double reach, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-reach, reach);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    const double x = anywhere(random), y = anywhere(random);
    points->InsertNextPoint(x, y, anywhere(random));
  }
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->SetPoints(points);
  return places;
}

bool resultOf(int operation, bool a, bool b)
{
  switch (operation)
  {
  case Filter::UNION:
    return a || b;
  case Filter::INTERSECTION:
    return a && b;
  case Filter::DIFFERENCE:
    return a && !b;
  default:
    return a != b;
  }
}

} // namespace

/// Faces lie between samples, edges where both boxes' faces are seen: the sharp surface is exact
/// but in cells with more than one piece of surface.
TEST_F(Boolean, OfBoxesHasTheirVolumes)
{
  const auto a = boxOf(0, 1, 0, 1, 0, 1), b = boxOf(0.3, 1.4, 0.2, 1.3, 0.4, 1.2);
  const double volumeOfB = 1.1 * 1.1 * 0.8, common = 0.7 * 0.8 * 0.6;
  filter->SetFeatures(Filter::SHARP);
  for (const auto& [operation, expected] :
    {std::pair<int, double>(Filter::UNION, 1 + volumeOfB - common), {Filter::INTERSECTION, common},
      {Filter::DIFFERENCE, 1 - common}, {Filter::SYMMETRIC_DIFFERENCE, 1 + volumeOfB - 2 * common}})
  {
    SCOPED_TRACE(operation);
    this->made(a, b, operation);
    this->expectClosed();
    // Measured: 3e-8 at most, and 4e-7 for the last operation, whose parts meet along edges.
    EXPECT_NEAR(this->volume() / expected, 1, 2e-6);
  }
}

TEST_F(Boolean, OfSpheresFollowsTheOperandOfEachFace)
{
  const vtkSmartPointer<vtkPolyData> spheres[] = {sphereAt(0), sphereAt(0.9, 0.8)};
  for (const int features : {Filter::SMOOTH, Filter::SHARP})
  {
    filter->SetFeatures(features);
    for (int operation = 0; operation < 4; ++operation)
    {
      SCOPED_TRACE(std::to_string(features) + " " + std::to_string(operation));
      vtkPolyData* output = this->made(spheres[0], spheres[1], operation);
      this->expectClosed();
      vtkDataArray* operand = output->GetCellData()->GetArray("Operand");
      ASSERT_NE(operand, nullptr);
      const double voxel = voxelOf(filter);
      vtkIdType count[2] = {}, far = 0;
      for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
      {
        double bounds[6];
        output->GetCellBounds(cell, bounds);
        const auto own = static_cast<int>(operand->GetTuple1(cell));
        ASSERT_TRUE(own == 0 || own == 1);
        const double x = 0.5 * (bounds[0] + bounds[1]) - (own == 0 ? 0 : 0.9);
        const double distance =
          std::abs(std::hypot(x, 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5])) -
                   (own == 0 ? 1 : 0.8));
        ++count[own];
        far += distance > 0.5 * voxel;
      }
      EXPECT_GT(count[0], 1000);
      EXPECT_GT(count[1], 1000);
      // Faces where both meet are cut off by less than a voxel. Measured: at most 0.13 % of them.
      EXPECT_LT(far, (count[0] + count[1]) / 200);
    }
  }
}

/// Any kind of operand, by what the fields of both say at random places.
TEST_F(Boolean, HasTheRightSideForBrokenOperands)
{
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(sphereAt(0.5));
  reversed->Update();
  struct Pair
  {
    std::string name;
    vtkSmartPointer<vtkDataObject> a, b;
    int ruleOfB;
  };
  const Pair pairs[] = {
    {"a scan and a box", sphereAt(0, 1, 140), boxOf(-0.2, 1.3, -0.4, 1.1, -1.2, 0.3),
      Filter::SIGNED},
    {"two scans", sphereAt(0, 1, 150), sphereAt(0.7, 0.9, 120), Filter::SIGNED},
    {"a cloud and a box", sphereCloud(2000, 1), boxOf(-0.2, 1.3, -0.4, 1.1, -1.2, 0.3),
      Filter::SIGNED},
    {"one inside out", sphereAt(0), reversed->GetOutput(), Filter::ABSOLUTE},
  };
  for (const Pair& pair : pairs)
  {
    const auto places = randomPlaces(2000, 1.3, 5);
    const std::vector<bool> inA = insideOf(pair.a, places);
    const std::vector<bool> inB = insideOf(pair.b, places, pair.ruleOfB);
    filter->ClearOperandInsideRules();
    filter->SetOperandInsideRule(1, pair.ruleOfB);
    for (int operation = 0; operation < 4; ++operation)
    {
      SCOPED_TRACE(pair.name + ", operation " + std::to_string(operation));
      vtkPolyData* output = this->made(pair.a, pair.b, operation);
      this->expectClosed();
      const std::vector<bool> inside = insideOf(output, places);
      int wrong = 0;
      for (std::size_t i = 0; i < inside.size(); ++i)
      {
        wrong += inside[i] != resultOf(operation, inA[i], inB[i]);
      }
      // Places nearer to a surface than voxels see. Measured: 4 of 2000 at most.
      EXPECT_LT(wrong, 10);
    }
  }
}

TEST_F(Boolean, TakesTheGridThatTheResultNeeds)
{
  const auto a = boxOf(0, 1, 0, 1, 0, 1), b = boxOf(0.5, 3, 0, 1, 0, 1);
  filter->SetPadding(0);
  const double length[] = {3, 0.5, 1, 3};
  for (int operation = 0; operation < 4; ++operation)
  {
    this->made(a, b, operation);
    int dimensions[3];
    double first[3], spacing[3];
    filter->GetGrid(dimensions, first, spacing);
    EXPECT_NEAR(dimensions[0] * spacing[0], length[operation], spacing[0]) << operation;
  }
}

TEST_F(Boolean, TakesTheGridOfWhatDoesNotReachBeyondItsSource)
{
  const auto a = boxOf(0, 1, 0, 1, 0, 1), b = boxOf(0.5, 3, 0, 1, 0, 1);
  filter->SetPadding(0);
  const auto lengthOf = [&]
  {
    this->made(a, b, Filter::INTERSECTION);
    int dimensions[3];
    double first[3], spacing[3];
    filter->GetGrid(dimensions, first, spacing);
    return dimensions[0] * spacing[0];
  };
  // The second solid reaches beyond its source with a threshold below 0.5, unless parity counts.
  for (const auto& [threshold, length] : {std::pair(0.5, 0.5), {0.49, 1.0}, {0.41, 1.0}})
  {
    filter->SetOperandThreshold(1, threshold);
    EXPECT_NEAR(lengthOf(), length, 0.02) << threshold;
  }
  filter->SetOperandInsideRule(1, Filter::ODD);
  EXPECT_NEAR(lengthOf(), 0.5, 0.02);
  filter->ClearOperandThresholds();
  filter->ClearOperandInsideRules();
  EXPECT_NEAR(lengthOf(), 0.5, 0.02);
  filter->SetSheetSide("down");
  EXPECT_NEAR(lengthOf(), 3, 0.1) << "both of them reach beyond their sources";
}

TEST_F(Boolean, TimesAllOperands)
{
  // The first one takes longer to prepare, and to evaluate.
  const auto large = sphereOf(500, 400);
  const auto small = boxOf(0, 0.1, 0, 0.1, 0, 0.1);
  double asSecond = 1e300, asFirst = 1e300; // the least, for other programs may be in the way
  for (int run = 0; run < 3; ++run)
  {
    this->made(small, large, Filter::UNION);
    asSecond = std::min(asSecond, filter->GetPrepareSeconds());
    this->made(large, small, Filter::UNION);
    asFirst = std::min(asFirst, filter->GetPrepareSeconds());
  }
  EXPECT_GT(asSecond, 0);
  EXPECT_GT(asFirst, 0.2 * asSecond);
}

TEST_F(Boolean, ComparesUnitsOfInputsAndNotOfBlocks)
{
  const auto large = boxOf(0, 100, 0, 100, 0, 100), small = boxOf(0.1, 0.2, 0, 0.1, 0, 0.1);
  filter->SetUseInputBounds(false);
  filter->SetSamplingBounds(-0.1, 0.3, -0.1, 0.3, -0.1, 0.3);
  filter->SetResolution(16);
  ErrorLog ofInputs(filter);
  filter->SetInputDataObject(0, large);
  filter->SetInputDataObject(1, small);
  filter->Update();
  EXPECT_NE(ofInputs.warnings().find("another unit"), std::string::npos) << ofInputs.warnings();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, large);
  blocks->SetBlock(1, small);
  vtkNew<Filter> other;
  ErrorLog ofBlocks(other);
  other->SetInputDataObject(blocks);
  other->SetUseInputBounds(false);
  other->SetSamplingBounds(-0.1, 0.3, -0.1, 0.3, -0.1, 0.3);
  other->SetResolution(16);
  other->Update();
  EXPECT_EQ(ofBlocks.warnings().find("another unit"), std::string::npos) << ofBlocks.warnings();
}

TEST_F(Boolean, HasTheSameBitsForBlocksThreadsAndAgain)
{
  const auto a = sphereAt(0, 1, 140), b = sphereAt(0.7, 0.9);
  vtkNew<vtkPolyData> first;
  first->DeepCopy(this->made(a, b, Filter::DIFFERENCE));
  const auto expectSame = [&first](vtkPolyData* other)
  {
    ASSERT_EQ(other->GetNumberOfPoints(), first->GetNumberOfPoints());
    for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      first->GetPoint(i, p);
      other->GetPoint(i, q);
      ASSERT_TRUE(std::equal(p, p + 3, q));
    }
  };
  filter->SetNumberOfThreads(1);
  filter->Update();
  expectSame(filter->GetOutput());

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, a);
  blocks->SetBlock(1, b);
  vtkNew<Filter> ofBlocks;
  ofBlocks->SetInputDataObject(blocks);
  ofBlocks->SetResolution(64);
  ofBlocks->SetOperationToDifference();
  ofBlocks->Update();
  expectSame(ofBlocks->GetOutput());

  vtkNew<Filter> ofOnePort;
  ofOnePort->AddInputDataObject(0, a);
  ofOnePort->AddInputDataObject(0, b);
  ofOnePort->SetResolution(64);
  ofOnePort->SetOperationToDifference();
  ofOnePort->SetInputName(1, "tool");
  ofOnePort->Update();
  expectSame(ofOnePort->GetOutput());
  auto* names = vtkStringArray::SafeDownCast(
    ofOnePort->GetOutput()->GetFieldData()->GetAbstractArray("OperandNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(0), "Input 1");
  EXPECT_EQ(names->GetValue(1), "tool");
  EXPECT_STREQ(ofOnePort->GetOperandLegend(), "0\tInput 1\n1\ttool\n");
  EXPECT_EQ(std::string(ofOnePort->GetSolidInWords()).rfind("1 part, volume ", 0), 0u);
}

TEST_F(Boolean, OfMoreThanTwo)
{
  const std::vector<vtkSmartPointer<vtkPolyData>> boxes = {boxOf(0, 2, 0, 1, 0, 1),
    boxOf(0.25, 0.75, -1, 2, 0.25, 0.75), boxOf(1.25, 1.75, -1, 2, 0.25, 0.75)};
  for (const auto& box : boxes)
  {
    filter->AddInputDataObject(1, box);
  }
  filter->SetInputDataObject(0, boxes[0]);
  filter->RemoveInputConnection(1, 0);
  filter->SetFeatures(Filter::SHARP);
  filter->SetOperationToDifference();
  filter->Update();
  this->expectClosed();
  EXPECT_NEAR(this->volume(), 1.5, 1e-9); // measured: 6e-15
  filter->SetOperationToIntersection();
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_NE(log.warnings().find("nothing is inside of the result"), std::string::npos);
}

TEST_F(Boolean, OfAnOperandWithItselfLeavesNoSlivers)
{
  const auto a = sphereAt(0, 1, 140);
  EXPECT_EQ(this->made(a, a, Filter::DIFFERENCE)->GetNumberOfCells(), 0);
  EXPECT_EQ(this->made(a, a, Filter::SYMMETRIC_DIFFERENCE)->GetNumberOfCells(), 0);
  const vtkIdType whole = this->made(a, a, Filter::UNION)->GetNumberOfCells();
  EXPECT_GT(whole, 1000);
  EXPECT_EQ(this->made(a, a, Filter::INTERSECTION)->GetNumberOfCells(), whole);
}

TEST_F(Boolean, NeedsTwoSolids)
{
  filter->SetInputDataObject(0, sphereAt(0));
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(log.errors().find("there are fewer than two solids"), std::string::npos)
    << log.errors();
  EXPECT_EQ(filter->GetStatus(), Filter::REFUSED);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(Boolean, RefusesByTheNameOfTheOperand)
{
  filter->SetInputDataObject(0, sphereAt(0));
  filter->SetInputDataObject(1, sphereCloud(500, 0));
  filter->SetOtherName(0, "tool");
  filter->MendSourceOff();
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(log.errors().find("the points have no normals"), std::string::npos) << log.errors();
  EXPECT_NE(log.errors().find("solid 'tool'"), std::string::npos) << log.errors();
  EXPECT_EQ(filter->GetStatus(), Filter::REFUSED);
}

/// Blocks of VTK take no partitioned data sets, and booleans of them do.
TEST_F(Boolean, TakesPartitionedDataSets)
{
  const auto a = boxOf(0, 1, 0, 1, 0, 1), b = boxOf(0.5, 1.5, 0, 1, 0, 1);
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, b);
  vtkNew<vtkPartitionedDataSetCollection> both;
  both->SetPartition(0, 0, a);
  both->SetPartition(1, 0, b);
  both->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "tool");
  filter->SetFeatures(Filter::SHARP);
  this->made(a, parts, Filter::DIFFERENCE);
  EXPECT_NEAR(this->volume(), 0.5, 1e-4);
  this->made(a, both, Filter::DIFFERENCE); // one operand, of two parts
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  vtkNew<Filter> alone;
  alone->SetInputDataObject(both);
  alone->SetOperationToIntersection();
  alone->Update();
  auto* names = vtkStringArray::SafeDownCast(
    alone->GetOutput()->GetFieldData()->GetAbstractArray("OperandNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(0), "Input 1");
  EXPECT_EQ(names->GetValue(1), "tool");
  vtkNew<vtkWindingNumberLabels> labels;
  labels->AddInputData(parts);
  labels->AddInputData(a);
  labels->Update();
  EXPECT_EQ(labels->GetNumberOfSolids(), 2);
}

/// A threshold below 0 makes the complement of a solid that is inside out.
TEST_F(Boolean, IsNotCutOffWhereOperandsReachBeyondTheirSources)
{
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(boxOf(0.5, 1.5, 0.5, 1.5, 0.5, 1.5));
  reversed->Update();
  filter->MendSourceOff();
  filter->SetOperandThreshold(1, -0.5);
  filter->SetFeatures(Filter::SHARP);
  this->made(boxOf(0, 1, 0, 1, 0, 1), reversed->GetOutput(), Filter::INTERSECTION);
  this->expectClosed();
  EXPECT_NEAR(this->volume(), 0.875, 1e-4);
  const ErrorLog log(filter);
  filter->SetOperationToUnion();
  filter->Update();
  EXPECT_NE(log.warnings().find("the surface reaches the border of the grid"), std::string::npos)
    << log.warnings();
  filter->CloseBorderOn();
  filter->Update();
  this->expectClosed();
}

TEST_F(Boolean, WarnsOfOperandsThatTheGridDoesNotShow)
{
  const auto warningsOf = [this](vtkDataObject* tool, int operation)
  {
    filter->SetInputDataObject(0, boxOf(0, 1, 0, 1, 0, 1));
    filter->SetInputDataObject(1, tool);
    filter->SetOperation(operation);
    filter->SetOtherName(0, "tool");
    const ErrorLog log(filter);
    filter->Update();
    return log.warnings();
  };
  const auto thin = boxOf(-0.5, 1.5, -0.5, 1.5, 0.5, 0.501), far = boxOf(5, 6, 5, 6, 5, 6);
  EXPECT_NE(warningsOf(thin, Filter::DIFFERENCE).find("'tool': the source is thinner than three"),
    std::string::npos);
  EXPECT_EQ(warningsOf(far, Filter::DIFFERENCE), "");
  EXPECT_NE(
    warningsOf(far, Filter::INTERSECTION).find("see whether the solids meet"), std::string::npos);
  // A union is empty of its own accord alone.
  filter->SetUseInputBounds(false);
  filter->SetSamplingBounds(2, 3, 2, 3, 2, 3);
  const std::string ofUnion = warningsOf(far, Filter::UNION);
  EXPECT_NE(ofUnion.find("nothing is inside of the result"), std::string::npos) << ofUnion;
  EXPECT_EQ(ofUnion.find("see whether the solids meet"), std::string::npos) << ofUnion;
}

/// An option for one operand is right; that none has a use for it is said once.
TEST_F(Boolean, IsSilentAboutOptionsThatFitOneOperand)
{
  const auto warningsOf = [&](vtkDataObject* a, vtkDataObject* b)
  {
    filter->SetInputDataObject(0, a);
    filter->SetInputDataObject(1, b);
    filter->Modified();
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.errors(), "");
    return log.warnings();
  };
  const auto times = [](const std::string& text, const std::string& words)
  {
    int count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    {
      ++count;
    }
    return count;
  };
  const auto box = boxOf(-1, 1, -1, 1, -1, 1);
  vtkNew<vtkPlaneSource> sheet;
  sheet->SetOrigin(-2, -2, 0.1);
  sheet->SetPoint1(2, -2, 0.1);
  sheet->SetPoint2(-2, 2, 0.1);
  sheet->Update();
  filter->SetOperation(Filter::DIFFERENCE);
  filter->SetSheetSide("down");
  EXPECT_EQ(times(warningsOf(box, sheet->GetOutput()), "no use"), 0);
  EXPECT_NEAR(volume(), 4 * 0.9, 0.1);
  EXPECT_EQ(times(warningsOf(box, boxOf(0, 2, 0, 2, 0, 2)), "no use"), 1);
  filter->SetSheetSide(nullptr);
  filter->SetFlatBase("down");
  EXPECT_EQ(times(warningsOf(box, sphereAt(0, 1.2, 90)), "closes nothing"), 0);
  EXPECT_EQ(times(warningsOf(box, boxOf(0, 2, 0, 2, 0, 2)), "closes nothing"), 1);
}

TEST_F(Boolean, WarnsByTheNameOfTheOperand)
{
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(sphereAt(0.5));
  reversed->Update();
  filter->SetInputDataObject(0, sphereAt(0));
  filter->SetInputDataObject(1, reversed->GetOutput());
  filter->SetOtherName(0, "tool");
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(log.warnings().find("'tool': "), std::string::npos) << log.warnings();
  EXPECT_EQ(log.warnings().find("'Input 1'"), std::string::npos) << log.warnings();
}
