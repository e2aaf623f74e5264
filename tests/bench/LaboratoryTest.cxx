// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

namespace
{

class Laboratory : public testing::Test
{
protected:
  /// The tables of a run with --json.
  static nlohmann::json tables(std::vector<std::string> arguments)
  {
    arguments.emplace_back("--json");
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    return run.json()["tables"];
  }

  TemporaryFolder folder;
  std::string in = folder.write("sphere.off", asOff(sphere(3)));
};

TEST_F(Laboratory, BesideTheFiltersOfVtk)
{
  Mesh open = sphere(3);
  open.triangles.resize(open.triangles.size() / 2);
  const nlohmann::json found = tables({"vtk", in, folder.write("open.off", asOff(open)), "--points",
    "100", "300", "--resolution", "8"});
  ASSERT_EQ(found.size(), 2u);
  const char* filters[] = {"vtkWindingNumberProbe", "vtkSelectEnclosedPoints",
    "vtkWindingNumberProbe", "vtkSelectEnclosedPoints", "vtkWindingNumberProbe",
    "vtkExtractEnclosedPoints", "vtkWindingNumberProbe", "vtkImplicitPolyDataDistance",
    "vtkWindingNumberField", "vtkPolyDataToImageStencil"};
  const char* samples[] = {"100 points", "300 points", "300 points", "300 points"};
  const char* questions[] = {"inside", "inside", "extract", "distance", "inside"};
  for (std::size_t table = 0; table < 2; ++table)
  {
    const nlohmann::json& rows = found[table]["rows"];
    ASSERT_EQ(rows.size(), 10u);
    int wrong = 0;
    for (std::size_t i = 0; i < 10; ++i)
    {
      EXPECT_EQ(rows[i]["filter"], filters[i]);
      EXPECT_EQ(rows[i]["question"], questions[i / 2]);
      if (i < 8) // the last question is about a grid, not points
      {
        EXPECT_EQ(rows[i]["samples"], samples[i / 2]);
      }
      EXPECT_GT(rows[i]["s"], 0);
      EXPECT_EQ(rows[i]["times ours"].is_null(), i % 2 == 0);
      EXPECT_GE(rows[i]["checked"], 100);
      const int ofThis = rows[i]["wrong"];
      EXPECT_TRUE(i % 2 == 1 || ofThis == 0) << rows[i];
      wrong += ofThis;
    }
    EXPECT_EQ(wrong > 0, table == 1) << "half a sphere is no closed surface";
  }
}

TEST_F(Laboratory, AsksForFiles)
{
  const Outcome none = runProgram({"orientation"});
  EXPECT_EQ(none.status, 1) << none;
  EXPECT_NE(none.err.find("FILE is required"), std::string::npos) << none;
}

TEST_F(Laboratory, EstimatedNormalsBesideTrueOnes)
{
  const nlohmann::json found = tables({"orientation", in, "--points", "1000"});
  ASSERT_EQ(found.size(), 1u);
  const nlohmann::json& rows = found[0]["rows"];
  ASSERT_EQ(rows.size(), 6u) << "three draws without noise, and three with it";
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i]["points"], 1000);
    EXPECT_EQ(rows[i]["noise %"], i < 3 ? 0 : 0.5);
    for (const char* normals : {"true", "spanning tree", "winding consistent", "automatic"})
    {
      EXPECT_GT(rows[i][normals], 0.9) << normals << rows[i]; // 0.95 and more
      EXPECT_LE(rows[i][normals], 1) << normals << rows[i];
    }
    EXPECT_GT(rows[i]["outward"], 0.9);
  }
  const Outcome none = runProgram({"orientation"});
  EXPECT_EQ(none.status, 1) << none;
  EXPECT_NE(none.err.find("FILE is required"), std::string::npos) << none;
}

TEST_F(Laboratory, Kernels)
{
  const nlohmann::json found = tables({"kernels"});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GE(found[0]["rows"].size(), 10u);
  for (const nlohmann::json& row : found[0]["rows"])
  {
    EXPECT_GT(row["value"], 0) << row;
    EXPECT_NE(row["unit"], "");
  }
}

/// Expects the three tables of hierarchical to agree with each other, for `fields` far fields.
void expectExplained(const nlohmann::json& tables, std::size_t fields, double tolerance)
{
  ASSERT_EQ(tables.size(), 3u);
  const nlohmann::json& times = tables[0]["rows"];
  const nlohmann::json& parts = tables[1]["rows"];
  const nlohmann::json& counts = tables[2]["rows"];
  ASSERT_EQ(times.size(), 2 * fields) << "on one thread and on two";
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    EXPECT_EQ(times[i]["threads"], i % 2 + 1);
    EXPECT_EQ(times[i]["speed-up"].is_null(), i % 2 == 0);
    for (const char* name :
      {"prepare s", "evaluate s", "CPU s", "ns/voxel", "fill s", "times fill"})
    {
      EXPECT_GE(times[i][name], 0) << name;
    }
    if (i % 2 == 0)
    {
      EXPECT_LT(times[i]["max error"], tolerance) << times[i];
      EXPECT_LT(times[i]["near max error"], tolerance) << times[i];
    }
  }
  ASSERT_EQ(parts.size(), fields);
  for (const nlohmann::json& row : parts)
  {
    double sum = 0;
    for (const char* part : {"tests", "translations", "shifts", "rows", "blocks", "moments",
           "exact", "crossings", "output"})
    {
      EXPECT_GE(row[part], 0) << part << row;
      sum += row[part].get<double>();
    }
    EXPECT_NEAR(sum + row["rest"].get<double>(), row["CPU"], 1e-9 * sum) << row;
  }
  ASSERT_EQ(counts.size(), fields);
  for (const nlohmann::json& row : counts)
  {
    EXPECT_GT(row["exact pairs"], 0) << row;
    EXPECT_LE(row["near leaves"], row["leaves"]) << row;
  }
}

TEST_F(Laboratory, HierarchicalExplainsFiles)
{
  const nlohmann::json closed = tables(
    {"hierarchical", in, "--resolution", "8", "16", "--threads", "2", "--tolerance", "1e-3"});
  expectExplained(closed, 4, 1e-3);
  EXPECT_EQ(closed[2]["rows"][0]["of"], "triangles");
  EXPECT_EQ(closed[2]["rows"][0]["sources"], 512);
  EXPECT_EQ(closed[2]["rows"][1]["voxels"], "16 x 16 x 16");
  EXPECT_EQ(closed[2]["rows"][2]["of"], "points");
  EXPECT_EQ(closed[2]["rows"][2]["sources"], 258);
  for (const nlohmann::json& row : closed[2]["rows"])
  {
    const std::size_t n = row["voxels"] == "8 x 8 x 8" ? 8 : 16;
    EXPECT_EQ(row["row samples"].get<std::size_t>() + row["block samples"].get<std::size_t>() +
                row["near samples"].get<std::size_t>(),
      n * n * n)
      << row;
  }

  Mesh open = sphere(3);
  open.triangles.resize(300);
  const nlohmann::json found = tables({"hierarchical", folder.write("open.off", asOff(open)),
    "--resolution", "16", "--threads", "2", "--tolerance", "1e-2", "1e-4"});
  expectExplained(found, 6, 1e-2);
  EXPECT_EQ(found[1]["rows"][4]["of"], "cap");
  EXPECT_EQ(found[1]["rows"][4]["tolerance"], 1e-2);
  EXPECT_EQ(found[1]["rows"][4]["order"], 3);
  EXPECT_EQ(found[1]["rows"][5]["order"], 5);
  EXPECT_GT(found[1]["rows"][4]["crossings"], 0);
}

TEST_F(Laboratory, HierarchicalScalesWithTheSources)
{
  const nlohmann::json found =
    tables({"hierarchical", "--sources", "200", "1000", "--resolution", "12", "--threads", "2"});
  expectExplained(found, 4, 1e-3);
  const char* of[] = {"triangles", "triangles", "points", "points"};
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(found[2]["rows"][i]["of"], of[i]);
    EXPECT_NEAR(found[2]["rows"][i]["sources"], i % 2 == 0 ? 200 : 1000, 60);
  }
}

} // namespace
