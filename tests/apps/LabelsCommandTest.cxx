// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

Mesh moved(Mesh mesh, double x, double size = 1)
{
  for (auto& point : mesh.points)
  {
    point = {size * point[0] + x, size * point[1], size * point[2]};
  }
  return mesh;
}

Mesh together(Mesh first, const Mesh& second)
{
  const auto points = static_cast<int>(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (auto triangle : second.triangles)
  {
    for (int& id : triangle)
    {
      id += points;
    }
    first.triangles.push_back(triangle);
  }
  return first;
}

std::vector<int> labelsIn(const std::string& fileName, const char* name = "Label")
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkDataArray* array = reader->GetOutput()->GetPointData()->GetArray(name);
  std::vector<int> result;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    result.push_back(static_cast<int>(array->GetTuple1(i)));
  }
  return result;
}

class LabelsCommand : public testing::Test
{
protected:
  Outcome run(const std::vector<std::string>& inputs, const std::vector<std::string>& more = {})
  {
    std::vector<std::string> arguments = {"labels", "-o", out, "--resolution", "20", "--json"};
    arguments.insert(arguments.end(), inputs.begin(), inputs.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  }

  TemporaryFolder folder;
  std::string left = folder.write("left.off", asOff(sphere(3)));
  std::string right = folder.write("right.stl", asBinaryStl(moved(sphere(2), 1.5, 0.9)));
  std::string out = folder.path("out.vti");
};

TEST_F(LabelsCommand, GivesSeveralFilesALabelEach)
{
  const Outcome outcome = run({left, right}, {"--count"});
  EXPECT_EQ(outcome.status, 0) << outcome;
  const nlohmann::json report = outcome.json();
  ASSERT_EQ(report["labels"].size(), 2u) << report;
  EXPECT_EQ(report["labels"][0]["name"], "left");
  EXPECT_EQ(report["labels"][1]["label"], 2);
  EXPECT_EQ(report["solids"]["open"], 0);
  EXPECT_EQ(report["input"]["primitives"], 512 + 128);
  const auto labels = labelsIn(out), counts = labelsIn(out, "SolidCount");
  for (const int label : {1, 2})
  {
    EXPECT_EQ(
      report["labels"][label - 1]["voxels"], std::count(labels.begin(), labels.end(), label));
  }
  EXPECT_GT(std::count(counts.begin(), counts.end(), 2), 0);
}

TEST_F(LabelsCommand, GivesThePartsOfOneFileALabelEach)
{
  EXPECT_EQ(run({left, right}).status, 0);
  const auto expected = labelsIn(out);
  const Mesh both = together(moved(sphere(2), 1.5, 0.9), sphere(3));
  const std::string one = folder.write("both.off", asOff(both));
  const Outcome outcome = run({one});
  EXPECT_EQ(outcome.status, 0) << outcome;
  EXPECT_EQ(outcome.json()["labels"][0]["name"], "Part 1");
  const auto labels = labelsIn(out);
  // .stl has single precision, which moves the grid a little.
  EXPECT_EQ(labels.size(), expected.size());
  for (const int label : {1, 2})
  {
    EXPECT_NEAR(static_cast<double>(std::count(labels.begin(), labels.end(), label)),
      static_cast<double>(std::count(expected.begin(), expected.end(), label)), 20);
  }
}

TEST_F(LabelsCommand, PiecesAndThreadsMakeNoDifference)
{
  EXPECT_EQ(run({left, right}, {"--overlap", "smallest", "--coverage", "fraction"}).status, 0);
  const auto expected = labelsIn(out), shares = labelsIn(out, "FirstLabel");
  EXPECT_EQ(run({left, right}, {"--overlap", "smallest", "--coverage", "fraction", "--pieces", "3",
                                 "--threads", "1"})
              .status,
    0);
  EXPECT_EQ(labelsIn(out), expected);
  EXPECT_EQ(labelsIn(out, "FirstLabel"), shares);
  EXPECT_FALSE(shares.empty());
}

TEST_F(LabelsCommand, WritesTheSurfaceBetweenLabels)
{
  for (const char* suffix : {"vtp", "stl", "ply", "obj"})
  {
    out = folder.path(std::string("out.") + suffix);
    const Outcome outcome = run({left, right});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_GT(outcome.json()["output"]["cells"], 100);
    EXPECT_EQ(runProgram({"check", out, "--json"}).status, 0);
  }
}

TEST_F(LabelsCommand, WarnsInOneLineOfWhatIsNotClosedOrHasOneName)
{
  Mesh open = sphere(3);
  open.triangles.resize(open.triangles.size() - 20);
  left = folder.write("left.off", asOff(open));
  Outcome outcome = run({left, right});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("close them where labels are not right; 1 of 2 solids ('left')"),
    std::string::npos)
    << outcome;
  outcome = run({right, right});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("solids have equal names: give them different ones; 1 of 2"),
    std::string::npos)
    << outcome;
  EXPECT_EQ(outcome.json()["labels"][1]["name"], "right (2)");
}

TEST_F(LabelsCommand, RefusesInOneLine)
{
  EXPECT_TRUE(run({left, folder.path("none.stl")}).saysInOneLine({"none.stl"}));
  EXPECT_TRUE(run({left, right}, {"--region-array", "Part"}).saysInOneLine({"--region-array"}));
  EXPECT_TRUE(
    run({left}, {"--region-array", "Part"}).saysInOneLine({"'Part' is no array of the cells"}));
  EXPECT_TRUE(run({left}, {"--label-offset", "1"}).saysInOneLine({"--region-array"}));
  EXPECT_TRUE(run({left}, {"--shares", "each"}).saysInOneLine({"--coverage fraction"}));
  EXPECT_TRUE(run({left}, {"--overlap", "best"}).saysInOneLine({"first | last | largest"}));
  EXPECT_TRUE(runProgram({"labels", "-o", out}).saysInOneLine({"IN is required"}));
  EXPECT_TRUE(
    runProgram({"labels", left, right, "-o", right}).saysInOneLine({"right.stl", "--overwrite"}));
  EXPECT_TRUE(runProgram({"labels", left, "-o", folder.path("a.vtu")}).saysInOneLine({".vti"}));
}

} // namespace
