#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

namespace
{

class BenchCommand : public testing::Test
{
protected:
  /// The tables of a run with --json.
  static nlohmann::json tables(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), "bench");
    arguments.emplace_back("--json");
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    return run.json()["tables"];
  }

  TemporaryFolder folder;
  std::string in = folder.write("sphere.off", asOff(sphere(3)));
};

TEST_F(BenchCommand, ClosedSurface)
{
  const nlohmann::json found = tables({in, "--resolution", "8", "16"});
  ASSERT_EQ(found.size(), 1u);
  const nlohmann::json& rows = found[0]["rows"];
  ASSERT_EQ(rows.size(), 8u) << "four methods at two resolutions";
  const char* methods[] = {"rows", "hierarchical", "direct", "parity"};
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i]["method"], methods[i % 4]);
    EXPECT_EQ(rows[i]["voxels"], i < 4 ? "8 x 8 x 8" : "16 x 16 x 16");
    EXPECT_EQ(rows[i]["boundary edges"], 0);
    const double largest = i % 4 == 1 ? 1e-3 : 1e-6; // hierarchical keeps the tolerance
    EXPECT_LT(rows[i]["max error"], largest) << rows[i];
    EXPECT_LT(rows[i]["near max error"], largest) << rows[i];
    EXPECT_EQ(rows[i]["crossings"].is_null(), i % 4 != 0);
    for (const char* name : {"prepare s", "evaluate s", "ns/voxel", "fill s", "times fill"})
    {
      EXPECT_GE(rows[i][name], 0) << name;
    }
  }
  EXPECT_EQ(rows[0]["cap triangles"], 0);
  EXPECT_EQ(rows[0]["crossings"].get<int>() % 2, 0) << "what goes in comes out";
  EXPECT_GT(rows[0]["crossings"], 0);
}

TEST_F(BenchCommand, OpenSurfacesAndSoups)
{
  Mesh open = sphere(2);
  open.triangles.pop_back();
  Mesh soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const nlohmann::json found = tables({folder.write("open.off", asOff(open)),
    folder.write("soup.off", asOff(soup)), "--resolution", "8"});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0]["rows"][0]["method"], "rows");
  EXPECT_EQ(found[0]["rows"][0]["cap triangles"], 1);
  EXPECT_LT(found[0]["rows"][0]["near max error"], 2e-6);
  ASSERT_EQ(found[1]["rows"].size(), 3u) << "automatic is direct here";
  EXPECT_EQ(found[1]["rows"][0]["method"], "direct");
  EXPECT_EQ(found[1]["rows"][0]["boundary edges"], 3);
}

TEST_F(BenchCommand, TextHasALineForEachRow)
{
  const Outcome run = runProgram({"bench", in, "--resolution", "8", "--threads", "1"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.out.rfind(in + ": 512 triangles, 1 threads\n", 0), 0u) << run;
  for (const char* part : {"\nvoxels", "  rows  ", "  direct  ", "  parity  "})
  {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << run;
  }
}

TEST_F(BenchCommand, SeedMeasuresWhatThereIs)
{
  folder.write("bunny_1k.obj", asObj(sphere(1)));
  const nlohmann::json found = tables({"seed", "--data", folder.path("")});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0]["rows"].size(), 6u);
  EXPECT_EQ(found[1]["rows"].size(), 6u);
  EXPECT_EQ(found[2]["rows"].size(), 7u);
  int measured = 0;
  for (const nlohmann::json& table : found)
  {
    for (const nlohmann::json& row : table["rows"])
    {
      EXPECT_GT(row["published ms"], 0);
      if (row.contains("ours ms"))
      {
        ++measured;
        EXPECT_EQ(row["file"], "bunny_1k.obj");
        EXPECT_GT(row["naive ms"], 0);
        EXPECT_LT(row["max error"], 1e-5) << "floats, larger beside points";
      }
      else
      {
        EXPECT_NE(row["file"].get<std::string>().find("is missing"), std::string::npos);
      }
    }
  }
  EXPECT_EQ(measured, 7);
}

TEST_F(BenchCommand, Kernels)
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

TEST_F(BenchCommand, RefusesWhatItCannotMeasure)
{
  const Outcome missing = runProgram({"bench", folder.path("none.off")});
  EXPECT_EQ(missing.status, 2) << missing;
  EXPECT_TRUE(missing.saysInOneLine({"none.off"})) << missing;
  const Outcome cloud = runProgram({"bench", folder.write("a.xyz", asXyz(sphere(1)))});
  EXPECT_EQ(cloud.status, 2) << cloud;
  EXPECT_TRUE(cloud.saysInOneLine({"a.xyz", "no triangles"})) << cloud;
}

} // namespace
