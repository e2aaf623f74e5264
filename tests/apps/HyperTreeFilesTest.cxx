// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLHyperTreeGridReader.h"
#include "vtkXMLImageDataReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <fstream>

namespace
{

vtkSmartPointer<vtkHyperTreeGrid> readTrees(const std::string& fileName)
{
  vtkNew<vtkXMLHyperTreeGridReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return vtkHyperTreeGrid::SafeDownCast(reader->GetOutputDataObject(0));
}

/// The leaf in which a position lies, or −1 where there is none that is not masked.
vtkIdType leafAt(vtkHyperTreeGrid* trees, const double position[3])
{
  vtkDataArray* const planes[] = {
    trees->GetXCoordinates(), trees->GetYCoordinates(), trees->GetZCoordinates()};
  vtkIdType number = 0;
  double place[3]; // in the brick, from 0 to 1
  for (int axis = 2; axis >= 0; --axis)
  {
    const double side = planes[axis]->GetTuple1(1) - planes[axis]->GetTuple1(0);
    const double at = (position[axis] - planes[axis]->GetTuple1(0)) / side;
    number = number * (planes[axis]->GetNumberOfTuples() - 1) + static_cast<vtkIdType>(at);
    place[axis] = at - std::floor(at);
  }
  vtkHyperTree* const tree = trees->GetTree(number);
  vtkIdType vertex = 0;
  while (!tree->IsLeaf(vertex))
  {
    vtkIdType child = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const bool isSecond = place[axis] >= 0.5;
      child = 2 * child + isSecond;
      place[axis] = 2 * place[axis] - isSecond;
    }
    vertex = tree->GetElderChildIndex(static_cast<unsigned int>(vertex)) + child;
  }
  const vtkIdType leaf = tree->GetGlobalIndexFromLocal(vertex);
  return trees->GetMask() && trees->GetMask()->GetValue(leaf) ? -1 : leaf;
}

class HyperTreeFiles : public testing::Test
{
protected:
  Outcome run(const std::vector<std::string>& arguments, const std::vector<std::string>& more)
  {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    Outcome result = runProgram(all);
    EXPECT_EQ(result.status, 0) << result;
    EXPECT_EQ(result.err, "") << "nothing but errors when piped";
    return result;
  }

  /// Makes the field as a hyper tree grid and as an image, which are to have the same arrays, and
  /// the same numbers at every sample; values of w may differ by `tolerance`.
  void expectTheImage(const std::string& input, const std::vector<std::string>& options,
    const std::vector<std::string>& ofTrees, double tolerance)
  {
    std::vector<std::string> forTrees = options;
    forTrees.insert(forTrees.end(), ofTrees.begin(), ofTrees.end());
    const nlohmann::json report =
      run({"field", input, "-o", folder.path("a.htg"), "--json"}, forTrees).json();
    run({"field", input, "-o", folder.path("a.vti"), "--quiet"}, options);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(folder.path("a.vti").c_str());
    reader->Update();
    vtkImageData* const image = reader->GetOutput();
    const auto trees = readTrees(folder.path("a.htg"));
    ASSERT_EQ(
      trees->GetCellData()->GetNumberOfArrays(), image->GetPointData()->GetNumberOfArrays());
    EXPECT_EQ(report["grid"]["association"], "cells");
    EXPECT_EQ(report["output"]["merge_tolerance"] > 0, tolerance > 0);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(report["grid"]["dimensions"][axis], image->GetDimensions()[axis]);
    }
    std::size_t wrong = 0;
    for (vtkIdType sample = 0; sample < image->GetNumberOfPoints(); ++sample)
    {
      const vtkIdType leaf = leafAt(trees, image->GetPoint(sample));
      ASSERT_GE(leaf, 0);
      for (int i = 0; i < trees->GetCellData()->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* const array = trees->GetCellData()->GetArray(i);
        vtkDataArray* const dense = image->GetPointData()->GetArray(array->GetName());
        ASSERT_TRUE(dense) << array->GetName();
        const double most = std::string(array->GetName()) == "WindingNumber" ? tolerance : 0;
        wrong += !(std::abs(array->GetTuple1(leaf) - dense->GetTuple1(sample)) <= most);
      }
    }
    EXPECT_EQ(wrong, 0u);
  }

  TemporaryFolder folder;
  std::string closed = folder.write("sphere.off", asOff(sphere(3)));
  std::string open = folder.write("open.off",
    []
    {
      Mesh mesh = sphere(3);
      mesh.triangles.resize(400);
      return asOff(mesh);
    }());
};

TEST_F(HyperTreeFiles, ClosedSurfacesHaveTheNumbersOfImages)
{
  expectTheImage(closed, {"--resolution", "40", "--inside"}, {}, 0);
  expectTheImage(closed, {"--dims", "16", "32", "48", "--inside-only"}, {}, 0);
  expectTheImage(closed, {"--resolution", "20", "--coverage", "fraction"}, {}, 0);
  expectTheImage(
    closed, {"--resolution", "20", "--coverage", "fraction", "--coverage-samples", "3"}, {}, 0);
  expectTheImage(closed, {"--resolution", "20", "--coverage", "any", "--double"}, {}, 0);
}

TEST_F(HyperTreeFiles, OpenSurfacesAreWithinTheTolerance)
{
  expectTheImage(open, {"--resolution", "40", "--inside"}, {}, 0.005 + 1e-6);
  // The file tells the tolerance. VTK's reader leaves out the field data of hyper tree grids.
  EXPECT_NE(contentsOf(folder.path("a.htg")).find("\"MergeTolerance\""), std::string::npos);
  const auto before = contentsOf(folder.path("a.htg")).size();
  expectTheImage(
    open, {"--resolution", "40", "--inside"}, {"--merge-tolerance", "0.1"}, 0.05 + 1e-6);
  EXPECT_LT(contentsOf(folder.path("a.htg")).size(), before);
  expectTheImage(open, {"--resolution", "40"}, {"--merge-tolerance", "0"}, 0);
  expectTheImage(open, {"--resolution", "30", "--coverage", "fraction"}, {}, 0.005 + 1e-6);
}

TEST_F(HyperTreeFiles, PointsHaveTheNumbersOfImages)
{
  expectTheImage(
    folder.write("points.xyz", asXyz(sphere(3))), {"--resolution", "30"}, {}, 0.005 + 1e-5);
}

TEST_F(HyperTreeFiles, VoxelsAreTheInsideOnly)
{
  const nlohmann::json made =
    run({"voxels", closed, "-o", folder.path("v.htg"), "--resolution", "20", "--json"}, {}).json();
  const auto trees = readTrees(folder.path("v.htg"));
  EXPECT_EQ(trees->GetCellData()->GetNumberOfArrays(), 1);
  EXPECT_STREQ(trees->GetCellData()->GetArray(0)->GetName(), "Inside");
  run(
    {"field", closed, "-o", folder.path("v.vti"), "--resolution", "20", "--inside-only", "--quiet"},
    {});
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(folder.path("v.vti").c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  vtkIdType inside = 0;
  for (vtkIdType sample = 0; sample < image->GetNumberOfPoints(); ++sample)
  {
    const bool isInside = image->GetPointData()->GetScalars()->GetTuple1(sample) != 0;
    ASSERT_EQ(leafAt(trees, image->GetPoint(sample)) >= 0, isInside);
    inside += isInside;
  }
  EXPECT_EQ(made["output"]["file"], folder.path("v.htg"));
  EXPECT_GT(made["output"]["cells"], 100);
  EXPECT_LT(made["output"]["cells"], inside);
  EXPECT_EQ(made["inside"], inside);
}

TEST_F(HyperTreeFiles, ReportsForPeopleAndVerificationWork)
{
  const Outcome words = runProgram(
    {"field", closed, "-o", folder.path("a.htg"), "--resolution", "20", "--verify", "50"});
  EXPECT_EQ(words.status, 0) << words;
  EXPECT_NE(words.out.find(" cells"), std::string::npos) << words;
  EXPECT_NE(words.out.find("error max"), std::string::npos) << words;
  const nlohmann::json report = run(
    {"field", open, "-o", folder.path("a.htg"), "--resolution", "20", "--verify", "200", "--json"},
    {})
                                  .json();
  EXPECT_LT(report["max_error"], 0.007);
  EXPECT_GT(report["expected"]["memory"], 1000);
}

TEST_F(HyperTreeFiles, EmptyResultsAreWarnedOf)
{
  const Outcome beside = runProgram({"voxels", closed, "-o", folder.path("a.htg"), "--bounds", "5",
    "6", "5", "6", "5", "6", "--resolution", "4"});
  EXPECT_EQ(beside.status, 0) << beside;
  EXPECT_NE(beside.err.find("the grid misses the source"), std::string::npos) << beside;
  const auto trees = readTrees(folder.path("a.htg"));
  EXPECT_EQ(trees->GetNumberOfNonEmptyTrees(), 1);
}

TEST_F(HyperTreeFiles, OptionsThatMakeNoSenseAreRefusedInOneLine)
{
  const std::string out = folder.path("a.htg");
  const auto refused = [&](const std::vector<std::string>& options,
                         const std::vector<std::string>& parts, const std::string& output)
  {
    std::vector<std::string> arguments = {"field", closed, "-o", output, "--resolution", "8"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_TRUE(outcome.saysInOneLine(parts)) << outcome;
    EXPECT_EQ(folder.names().size(), 2u) << "nothing was written";
  };
  refused({"--distance"}, {"--distance", ".vti"}, out);
  refused({"--pieces", "2"}, {"--pieces", "leave it out"}, out);
  refused({"--merge-tolerance", "-1"}, {"--merge-tolerance is -1", "give 0 or more"}, out);
  refused({"--merge-tolerance", "nan"}, {"--merge-tolerance is nan"}, out);
  refused(
    {"--merge-tolerance", "0.1", "--inside-only"}, {"--merge-tolerance", "leave one out"}, out);
  refused({"--merge-tolerance", "0.1"}, {"--merge-tolerance", ".htg"}, folder.path("a.vti"));
  const Outcome surface = runProgram({"surface", closed, "-o", out});
  EXPECT_EQ(surface.status, 1) << surface;
}

TEST_F(HyperTreeFiles, OutputsFollowTheRulesOfAllOutputs)
{
  const Outcome missing = runProgram({"field", closed, "-o", folder.path("none/a.htg")});
  EXPECT_EQ(missing.status, 2) << missing;
  EXPECT_TRUE(missing.saysInOneLine({"none/a.htg", "cannot be written"})) << missing;
  const Outcome full = runProgram(
    {"field", closed, "-o", folder.path("a.htg"), "--resolution", "100"}, "ulimit -f 1;");
  EXPECT_EQ(full.status, 2) << full;
  EXPECT_EQ(folder.names().size(), 2u) << "nothing is left of a file that was not written whole";
  const Outcome large = runProgram(
    {"field", open, "-o", folder.path("a.htg"), "--resolution", "30000", "--merge-tolerance", "0"});
  EXPECT_EQ(large.status, 3) << large;
  EXPECT_TRUE(large.saysInOneLine({"choose larger voxels (--resolution, --voxel-size)", "GiB"}))
    << large;
  EXPECT_EQ(folder.names().size(), 2u);
}

} // namespace
