// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/LabelScenes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace
{

using Filter = vtkWindingNumberLabels;
using Surfaces = std::vector<vtkSmartPointer<vtkPolyData>>;

class LabelInputs : public testing::Test
{
protected:
  LabelInputs() { labels->SetResolution(24); }

  std::vector<unsigned short> made(vtkDataObject* input)
  {
    const ErrorLog log(labels);
    labels->SetInputData(input);
    labels->Update();
    EXPECT_EQ(log.errors(), "");
    warnings = log.warnings();
    return shortsOf(labels->GetOutput()->GetPointData());
  }

  std::vector<std::string> names() const
  {
    vtkAbstractArray* array = labels->GetOutput()->GetFieldData()->GetAbstractArray("LabelNames");
    std::vector<std::string> result;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      result.push_back(array->GetVariantValue(i).ToString());
    }
    return result;
  }

  void expectRefused(vtkDataObject* input, const std::string& words)
  {
    const ErrorLog log(labels);
    labels->SetInputData(input);
    labels->Modified();
    labels->Update();
    EXPECT_EQ(labels->GetStatus(), Filter::REFUSED);
    EXPECT_NE(log.errors().find(words), std::string::npos) << log.errors();
    EXPECT_EQ(log.errors().find("ERROR: ", 1), std::string::npos) << log.errors();
  }

  vtkNew<Filter> labels;
  std::string warnings;
};

vtkSmartPointer<vtkPolyData> appended(const Surfaces& solids)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& solid : solids)
  {
    append->AddInputData(solid);
  }
  append->Update();
  return append->GetOutput();
}

/// One surface of several, with an array of their numbers from `first` on, by steps.
vtkSmartPointer<vtkPolyData> withRegions(const Surfaces& solids, int first, int step = 1)
{
  const auto surface = appended(solids);
  vtkNew<vtkIntArray> regions;
  regions->SetName("Region");
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    for (vtkIdType n = 0; n < solids[i]->GetNumberOfPolys(); ++n)
    {
      regions->InsertNextValue(first + step * static_cast<int>(i));
    }
  }
  surface->GetCellData()->AddArray(regions);
  return surface;
}

vtkSmartPointer<vtkPolyData> reversed(vtkPolyData* surface)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> cells;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = surface->GetNumberOfPolys(); i-- > 0;)
  {
    surface->GetPolys()->GetCellAtId(i, size, ids);
    cells->InsertNextCell({ids[0], ids[2], ids[1]});
  }
  result->SetPoints(surface->GetPoints());
  result->SetPolys(cells);
  return result;
}

TEST_F(LabelInputs, CompositesOfEveryKindGiveTheSame)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly(balls));
  EXPECT_EQ(names()[2], "solid 2");
  EXPECT_EQ(std::set<unsigned short>(expected.begin(), expected.end()).size(), 5u)
    << "the fourth is hidden by the first";

  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int i = 0; i < balls.size(); ++i)
  {
    collection->SetPartition(i, 0, balls[i]);
  }
  EXPECT_EQ(made(collection), expected);
  EXPECT_EQ(names()[2], "Block 3");

  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, asAssembly({balls[0], balls[1]}));
  outer->SetBlock(1, asAssembly({balls[2], balls[3], balls[4]}));
  EXPECT_EQ(made(outer), expected);
  EXPECT_EQ(names()[3], "solid 1 (2)");
  EXPECT_NE(
    warnings.find("solids have equal names: give them different ones; 2 of 5"), std::string::npos)
    << warnings;
}

/// A name that is given stays, even where it looks like one with a number.
TEST_F(LabelInputs, EqualNamesGetNumbersThatNoOtherHas)
{
  const Surfaces balls = fiveBalls();
  const auto blocks = asAssembly(balls);
  const char* const given[] = {"a", "a", "a (2)", "a", "a (2)"};
  for (unsigned int i = 0; i < balls.size(); ++i)
  {
    blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), given[i]);
  }
  made(blocks);
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "a (3)", "a (2)", "a (4)", "a (2) (2)"}));
  EXPECT_NE(warnings.find("; 3 of 5 got a number"), std::string::npos) << warnings;
}

TEST_F(LabelInputs, RegionsOfACellArrayAreSolids)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly(balls));
  labels->SetRegionArray("None");
  made(withRegions(balls, 1));
  EXPECT_EQ(names()[0], "Part 1") << "the way in which ParaView says that there is no array";
  labels->SetRegionArray("Region");
  EXPECT_EQ(made(withRegions(balls, 1)), expected);
  EXPECT_EQ(names()[4], "Region 5");
  EXPECT_EQ(labels->GetNumberOfSolids(), 5);
  labels->SetLabelOffset(1);
  EXPECT_EQ(made(withRegions(balls, 0)), expected);
  EXPECT_EQ(names()[4], "Region 4");
  labels->SetLabelOffset(0);
  auto far = made(withRegions(balls, 13107, 13107));
  EXPECT_EQ(*std::max_element(far.begin(), far.end()), 65535);
  std::transform(far.begin(), far.end(), far.begin(),
    [](unsigned short label) { return static_cast<unsigned short>(label / 13107); });
  EXPECT_EQ(far, expected);
}

TEST_F(LabelInputs, RegionsThatAreNoLabelsAreCounted)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly(balls));
  labels->SetRegionArray("Region");
  for (const int first : {0, -3, 65533, -1'000'000})
  {
    EXPECT_EQ(made(withRegions(balls, first, 2)), expected) << first;
    EXPECT_EQ(names()[4], "Region " + std::to_string(first + 8));
    EXPECT_NE(warnings.find("labels are counted from 1, for regions are not all 1 to 65535"),
      std::string::npos)
      << warnings;
  }
}

TEST_F(LabelInputs, TextsAreNamesOfRegions)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly(balls));
  EXPECT_EQ(warnings.find("counted from 1"), std::string::npos) << warnings;
  labels->SetLabelOffset(3);
  EXPECT_EQ(made(asAssembly(balls)), expected) << "blocks have no numbers";
  EXPECT_NE(warnings.find("labels are counted from 1, for solids have no numbers: leave the offset "
                          "out (" +
                          howTo(winding::Parameter::labelOffset) + ")"),
    std::string::npos)
    << warnings;
  labels->SetLabelOffset(0);
  const auto surface = appended(balls);
  vtkNew<vtkStringArray> bones;
  bones->SetName("Bone");
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    for (vtkIdType n = 0; n < balls[i]->GetNumberOfPolys(); ++n)
    {
      bones->InsertNextValue(std::string(1, static_cast<char>('a' + i)) + " bone");
    }
  }
  surface->GetCellData()->AddArray(bones);
  labels->SetRegionArray("Bone");
  EXPECT_EQ(made(surface), expected);
  EXPECT_EQ(names()[3], "d bone");
  EXPECT_EQ(warnings.find("counted"), std::string::npos) << warnings;
}

/// A surface of several, with the names that a file gives them.
vtkSmartPointer<vtkPolyData> withNames(
  const Surfaces& solids, const std::string& kind, const std::vector<int>& ids)
{
  const auto surface = appended(solids);
  vtkNew<vtkIntArray> ofCells;
  vtkNew<vtkStringArray> names;
  ofCells->SetName((kind + "Ids").c_str());
  names->SetName((kind + "Names").c_str());
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    for (vtkIdType n = 0; n < solids[i]->GetNumberOfPolys(); ++n)
    {
      ofCells->InsertNextValue(ids[i]);
    }
  }
  for (const std::string name : {"skin", "bone", ""})
  {
    names->InsertNextValue(name);
  }
  surface->GetCellData()->AddArray(ofCells);
  surface->GetFieldData()->AddArray(names);
  return surface;
}

TEST_F(LabelInputs, AreNamedByTheirFile)
{
  const Surfaces balls = {ball(0, 0, 0, 1), ball(3, 0, 0, 0.7), ball(5, 0, 0, 0.5)};
  for (const std::string kind : {"Object", "Solid", "Group", "Material"})
  {
    const auto expected = made(asAssembly({balls[2], balls[0], balls[1]}));
    EXPECT_EQ(made(withNames(balls, kind, {1, 2, 0})), expected) << kind;
    EXPECT_EQ(names(), (std::vector<std::string>{"skin", "bone", kind + " 2"}));
    EXPECT_EQ(warnings, "");
  }
  const auto both = appended({balls[0], balls[2]});
  const auto expected = made(asAssembly({balls[1], both}));
  EXPECT_EQ(made(withNames(balls, "Group", {1, 0, 1})), expected);
  EXPECT_EQ(names(), (std::vector<std::string>{"skin", "bone"}));
  made(withNames(balls, "Material", {1, 0, 1}));
  EXPECT_EQ(names()[2], "bone 2") << "bodies of one material are apart";
  labels->SetRegionArray("MaterialIds");
  EXPECT_EQ(made(withNames(balls, "Material", {1, 0, 1})), expected);
  EXPECT_EQ(names(), (std::vector<std::string>{"skin", "bone"}));
}

/// One name for all is none that distinguishes the parts.
TEST_F(LabelInputs, AreNotNamedByANameThatAllHave)
{
  const Surfaces balls = {ball(0, 0, 0, 1), ball(3, 0, 0, 0.7), ball(5, 0, 0, 0.5)};
  const auto expected = made(asAssembly(balls));
  for (const std::string kind : {"Object", "Solid", "Group", "Material"})
  {
    const auto surface = withNames(balls, kind, {1, 1, 1});
    EXPECT_EQ(made(surface), expected) << kind;
    EXPECT_EQ(names(), (std::vector<std::string>{"Part 1", "Part 2", "Part 3"})) << kind;
    EXPECT_EQ(warnings, "");
    if (kind != "Material")
    {
      const auto others = withNames(balls, "Material", {2, 1, 0});
      surface->GetCellData()->AddArray(others->GetCellData()->GetArray("MaterialIds"));
      surface->GetFieldData()->AddArray(others->GetFieldData()->GetAbstractArray("MaterialNames"));
      made(surface);
      EXPECT_EQ(names(), (std::vector<std::string>{"skin", "bone", "Material 2"})) << kind;
    }
  }
}

/// An open part counts as an open solid, unless open parts are ignored.
TEST_F(LabelInputs, OpenPartsInsideOfOthersAreCounted)
{
  const auto surface = appended({ball(0, 0, 0, 1), ball(0, 0, 0, 0.5, 30), ball(3, 0, 0, 0.6)});
  made(surface);
  EXPECT_EQ(labels->GetNumberOfSolids(), 3);
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 1);
  EXPECT_NE(warnings.find("they bound nothing; 1 of 3 solids ("), std::string::npos) << warnings;
  EXPECT_EQ(warnings.find("have holes"), std::string::npos) << warnings;
  labels->IgnoreOpenPartsOn();
  made(surface);
  EXPECT_EQ(labels->GetNumberOfSolids(), 2);
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 0);
}

TEST_F(LabelInputs, NamesThatDividePartsAreTold)
{
  const auto surface = withNames({ball(0, 0, 0, 1), ball(3, 0, 0, 0.7)}, "Object", {1, 0});
  vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("ObjectIds"))->SetValue(0, 0);
  made(surface);
  EXPECT_EQ(names()[1], "Part 2");
  EXPECT_NE(warnings.find("the file's own names divide solids, which are parts by connectivity: "
                          "label what has names (SetRegionArray()); the names belong to "
                          "'ObjectIds'"),
    std::string::npos)
    << warnings;
}

TEST_F(LabelInputs, SeveralInputsAreSolids)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly(balls));
  labels->RemoveAllInputs();
  for (const auto& one : balls)
  {
    labels->AddInputData(one);
  }
  labels->SetInputName(1, "skull");
  labels->Update();
  EXPECT_EQ(shortsOf(labels->GetOutput()->GetPointData()), expected);
  EXPECT_EQ(names()[0], "Input 1");
  EXPECT_EQ(names()[1], "skull");
  labels->SetInputName(1, "jaw");
  labels->Update();
  EXPECT_EQ(names()[1], "jaw");
  labels->ClearInputNames();
  labels->Update();
  EXPECT_EQ(names()[1], "Input 2");

  // Blocks of an input are solids, too.
  labels->RemoveAllInputs();
  labels->AddInputData(asAssembly({balls[0], balls[1], balls[2]}));
  labels->AddInputData(balls[3]);
  labels->AddInputData(balls[4]);
  labels->Update();
  EXPECT_EQ(shortsOf(labels->GetOutput()->GetPointData()), expected);
  EXPECT_EQ(names()[2], "solid 2");
  EXPECT_EQ(names()[3], "Input 2");
}

TEST_F(LabelInputs, SeveralInputsInAnotherUnitAreTold)
{
  const auto box = [](double from, double to, double side)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(from, to, 0, side, 0, side);
    cube->Update();
    vtkSmartPointer<vtkPolyData> made = cube->GetOutput();
    return made;
  };
  const auto warningsOf = [this](const Surfaces& inputs)
  {
    ErrorLog log(labels);
    labels->RemoveAllInputs();
    for (const auto& input : inputs)
    {
      labels->AddInputData(input);
    }
    labels->SetInputName(1, "right.stl");
    labels->Update();
    return log.warnings();
  };
  const auto left = box(0, 100, 100);
  EXPECT_EQ(warningsOf({left, box(100, 200, 100)}), "");
  for (const double unit : {1000.0, 25.4})
  {
    const std::string told = warningsOf({left, box(100 / unit, 200 / unit, 100 / unit)});
    EXPECT_NE(told.find("'right.stl' seems to be in another unit"), std::string::npos) << told;
  }
  // The blocks of one data set have one unit.
  labels->RemoveAllInputs();
  ErrorLog log(labels);
  labels->SetInputData(asAssembly({left, box(0.1, 0.2, 0.1)}));
  labels->Update();
  EXPECT_EQ(log.warnings().find("another unit"), std::string::npos) << log.warnings();
}

/// The parts by connectivity have labels by their triangles, most first; of as many, by their
/// lowest vertices.
TEST_F(LabelInputs, PartsByConnectivityAreSolids)
{
  const Surfaces balls = fiveBalls();
  const auto expected = made(asAssembly({balls[0], balls[1], balls[2], balls[4], balls[3]}));
  EXPECT_EQ(made(appended(balls)), expected);
  EXPECT_EQ(made(appended({balls[4], balls[2], balls[3], balls[1], balls[0]})), expected);
  EXPECT_EQ(names()[1], "Part 2");
}

TEST_F(LabelInputs, ACavityBelongsToThePartAroundIt)
{
  const auto shell = ball(0, 0, 0, 1), wall = reversed(ball(0, 0, 0, 0.6));
  const auto core = ball(0, 0, 0, 0.3), other = ball(2.5, 0, 0, 0.7);
  const auto hollow = appended({shell, wall});
  const auto expected = made(asAssembly({hollow, other, core}));
  EXPECT_GT(std::count(expected.begin(), expected.end(), 3), 10);
  EXPECT_EQ(made(appended({core, wall, other, shell})), expected);
  EXPECT_EQ(labels->GetNumberOfSolids(), 3);
}

TEST_F(LabelInputs, RegionsOfVolumeMeshesHaveSurfacesOfTheirOwn)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 3 * 4; ++i)
  {
    points->InsertNextPoint(i / 4, i % 4 / 2, i % 2);
  }
  grid->SetPoints(points);
  vtkNew<vtkIntArray> regions;
  regions->SetName("Material");
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    const vtkIdType o = 4 * cell;
    const vtkIdType ids[8] = {o, o + 4, o + 6, o + 2, o + 1, o + 5, o + 7, o + 3};
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
    regions->InsertNextValue(cell == 0 ? 7 : 3);
  }
  grid->GetCellData()->AddArray(regions);
  labels->SetRegionArray("Material");
  labels->SetPadding(0);
  labels->SetResolution(8);
  const auto label = made(grid);
  ASSERT_EQ(label.size(), 8u * 4 * 4);
  for (std::size_t i = 0; i < label.size(); ++i)
  {
    ASSERT_EQ(label[i], i % 8 < 4 ? 7 : 3);
  }
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 0);
}

TEST_F(LabelInputs, EmptyBlocksKeepTheirLabelsAndAreCounted)
{
  const Surfaces balls = fiveBalls();
  const auto blocks = asAssembly(balls);
  blocks->SetBlock(0, vtkSmartPointer<vtkPolyData>::New());
  blocks->SetBlock(3, nullptr);
  const auto label = made(blocks);
  EXPECT_EQ(
    (std::set<unsigned short>(label.begin(), label.end())), (std::set<unsigned short>{0, 2, 3, 5}));
  EXPECT_EQ(labels->GetNumberOfEmptySolids(), 2);
  EXPECT_NE(
    warnings.find("leave them out; 2 of 5 solids ('solid 0', 'solid 3')"), std::string::npos)
    << warnings;
  vtkNew<vtkMultiBlockDataSet> nothing;
  labels->SetUseInputBounds(false);
  for (const unsigned short none : made(nothing))
  {
    ASSERT_EQ(none, 0);
  }
  EXPECT_NE(warnings.find("there is no solid"), std::string::npos) << warnings;
}

TEST_F(LabelInputs, PiecesOfABlockAreOneSolid)
{
  const auto whole = ball(0, 0, 0, 1);
  vtkNew<vtkPolyData> halves[2];
  vtkIdType size;
  const vtkIdType* ids;
  for (int half = 0; half < 2; ++half)
  {
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = half; i < whole->GetNumberOfPolys(); i += 2)
    {
      whole->GetPolys()->GetCellAtId(i, size, ids);
      cells->InsertNextCell(size, ids);
    }
    halves[half]->SetPoints(whole->GetPoints());
    halves[half]->SetPolys(cells);
  }
  const auto other = ball(1, 0, 0, 0.8);
  const auto expected = made(asAssembly({whole, other}));
  vtkNew<vtkMultiPieceDataSet> pieces;
  pieces->SetPiece(0, halves[0]);
  pieces->SetPiece(1, halves[1]);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, pieces);
  blocks->SetBlock(1, other);
  EXPECT_EQ(made(blocks), expected);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, halves[0]);
  collection->SetPartition(0, 1, halves[1]);
  collection->SetPartition(1, 0, other);
  EXPECT_EQ(made(collection), expected);
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 0);
  vtkNew<vtkPartitionedDataSet> inPieces;
  inPieces->SetPartition(0, halves[0]);
  inPieces->SetPartition(1, halves[1]);
  const auto found = made(inPieces);
  EXPECT_EQ(std::set<unsigned short>(found.begin(), found.end()), std::set<unsigned short>({0, 1}));
  EXPECT_EQ(names(), std::vector<std::string>({"Block 1"}));
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 0);
}

/// A side is for the open one of two solids, and is only told where none is open.
TEST_F(LabelInputs, OptionsThatFitOneSolidAreNotTold)
{
  const Surfaces balls = fiveBalls();
  labels->SetSheetSide("down");
  made(asAssembly({balls[0], sphereOf(20, 20, 1, {9, 0, 0}, 90)}));
  EXPECT_EQ(warnings.find("no part is open"), std::string::npos) << warnings;
  made(asAssembly({balls[0], balls[1]}));
  EXPECT_NE(warnings.find("has no use: no part is open"), std::string::npos) << warnings;
  EXPECT_EQ(
    warnings.find("no part is open", warnings.find("no part is open") + 1), std::string::npos)
    << warnings;
}

/// Ids of 64 bits are told from each other by their last one.
TEST_F(LabelInputs, RegionsMayBeBeyondWhatDoublesHold)
{
  const Surfaces balls = fiveBalls();
  const auto surface = withRegions(balls, 1);
  labels->SetRegionArray("Region");
  const auto expected = made(surface);
  constexpr vtkTypeInt64 first = (vtkTypeInt64(1) << 62) - 2;
  vtkNew<vtkTypeInt64Array> large;
  large->SetName("Region");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    const double region = surface->GetCellData()->GetArray("Region")->GetTuple1(cell);
    large->InsertNextValue(first + static_cast<vtkTypeInt64>(region));
  }
  surface->GetCellData()->AddArray(large);
  EXPECT_EQ(made(surface), expected);
  EXPECT_EQ(names()[0], "Region " + std::to_string(first + 1));
  EXPECT_EQ(names()[4], "Region " + std::to_string(first + 5));
}

TEST_F(LabelInputs, WhatGivesNoLabelsIsRefusedInOneLine)
{
  const Surfaces balls = fiveBalls();
  const auto blocks = asAssembly({balls[0], balls[1]});
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  blocks->SetBlock(2, image);
  expectRefused(blocks, "block 'Block 3' is a ");
  vtkNew<vtkPolyData> points;
  points->SetPoints(balls[0]->GetPoints());
  blocks->SetBlock(2, points);
  expectRefused(blocks, "leave block 'Block 3' out");
  expectRefused(points, "give blocks or files, one for each solid");

  labels->SetRegionArray("Nothing");
  expectRefused(withRegions(balls, 1), "'Nothing' is no array of the cells");
  labels->SetRegionArray("Region");
  labels->SetLabelOffset(-1);
  expectRefused(withRegions(balls, 0), "labels are 1 to 65535: choose another offset (" +
                                         howTo(winding::Parameter::labelOffset) + "); ");
  labels->SetLabelOffset(1);
  expectRefused(withRegions(balls, 65531), "; region 65535 of 'Region'");
  labels->SetLabelOffset(0);
  const auto broken = withRegions(balls, 1);
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("Region");
  numbers->SetNumberOfTuples(broken->GetNumberOfCells());
  numbers->Fill(1.5);
  broken->GetCellData()->AddArray(numbers);
  expectRefused(broken, "has the value 1.5");
  vtkNew<vtkTypeUInt64Array> large;
  large->SetName("Region");
  large->SetNumberOfTuples(broken->GetNumberOfCells());
  large->FillValue(std::numeric_limits<vtkTypeUInt64>::max());
  broken->GetCellData()->AddArray(large);
  expectRefused(broken, "has the value 1.84467e+19 at cell 0, which is too large");
  numbers->Fill(1e17);
  broken->GetCellData()->AddArray(numbers);
  expectRefused(broken, "at cell 0, which is too large");

  labels->SetRegionArray(nullptr);
  vtkNew<vtkMultiBlockDataSet> many;
  many->SetNumberOfBlocks(65536);
  many->SetBlock(0, balls[0]);
  expectRefused(many, "labels are 1 to 65535: extract fewer blocks");
}

TEST_F(LabelInputs, ASoupOfLooseTrianglesIsTooManyParts)
{
  vtkNew<vtkPolyData> soup;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < 65536; ++i)
  {
    const double x = static_cast<double>(i % 256), y = static_cast<double>(i / 256);
    points->InsertNextPoint(x, y, 0);
    points->InsertNextPoint(x + 0.5, y, 0);
    points->InsertNextPoint(x, y + 0.5, 0);
    cells->InsertNextCell({3 * i, 3 * i + 1, 3 * i + 2});
  }
  soup->SetPoints(points);
  soup->SetPolys(cells);
  expectRefused(soup, "; it has 65536 by connectivity");
}

TEST_F(LabelInputs, SayWhichLabelsHaveNoVoxelsAndWhy)
{
  const auto nested = asAssembly({ball(0, 0, 0, 1), ball(0, 0, 0, 0.5), ball(0, 0, 0.1, 0.3)});
  this->made(nested);
  EXPECT_NE(warnings.find("others hide all voxels of some solids"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("2 of 3 solids ('solid 1', 'solid 2')"), std::string::npos) << warnings;
  labels->SetOverlapRule(Filter::SMALLEST_VOLUME);
  this->made(nested);
  EXPECT_EQ(warnings, "");

  this->made(asAssembly({ball(0, 0, 0, 1), ball(0.011, 0.012, 0.013, 0.001)}));
  EXPECT_NE(warnings.find("some solids have no voxel inside"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("1 of 2 solids ('solid 1')"), std::string::npos) << warnings;
  EXPECT_EQ(warnings.find("others hide"), std::string::npos) << warnings;

  labels->UseInputBoundsOff();
  labels->SetSamplingBounds(-1.1, 1.1, -1.1, 1.1, -1.1, 1.1);
  this->made(asAssembly({ball(0, 0, 0, 1), ball(5, 0, 0, 0.5)}));
  EXPECT_NE(warnings.find("the grid misses some solids"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("1 of 2 solids ('solid 1')"), std::string::npos) << warnings;
  EXPECT_EQ(warnings.find("others hide"), std::string::npos) << warnings;
  this->made(asAssembly({ball(4, 0, 0, 1), ball(5, 0, 0, 0.5)}));
  EXPECT_NE(warnings.find("2 of 2 solids ('solid 0', 'solid 1')"), std::string::npos) << warnings;
  EXPECT_EQ(warnings.rfind("Warning: "), warnings.find("Warning: ")) << "one line: " << warnings;
}

TEST_F(LabelInputs, PartsAsCloudsKeepTheNormalsOfTheirPoints)
{
  const auto inside = [&](vtkDataObject* input)
  {
    const std::vector<unsigned short> found = made(input);
    return std::count_if(
      found.begin(), found.end(), [](unsigned short label) { return label > 0; });
  };
  const auto both = withRegions({ball(0, 0, 0, 1), ball(4, 0, 0, 1)}, 1);
  labels->SourceAsPointsOn();
  labels->MendSourceOff();
  for (const char* array : {"", "Region"})
  {
    labels->SetRegionArray(array);
    EXPECT_GT(inside(both), 0) << array;
  }
  vtkDataArray* const normals = both->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double* normal = normals->GetTuple3(i);
    normals->SetTuple3(i, -normal[0], -normal[1], -normal[2]);
  }
  both->Modified();
  for (const char* array : {"", "Region"})
  {
    labels->SetRegionArray(array);
    EXPECT_EQ(inside(both), 0) << array;
  }
}

TEST_F(LabelInputs, LinesNextToFacesAreCounted)
{
  const auto solids = ball(0, 0, 0, 1);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({0, 1, 2});
  solids->SetLines(line);
  solids->GetCellData()->Initialize();
  this->made(solids);
  EXPECT_NE(warnings.find("lines and single points bound nothing"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("1 are left out"), std::string::npos) << warnings;
}

} // namespace
