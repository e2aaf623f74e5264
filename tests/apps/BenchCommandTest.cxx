// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

class BenchCommand : public testing::Test
{
protected:
  /// The tables of a run with --json, which warns once of each fault.
  static nlohmann::json tables(
    std::vector<std::string> arguments, const std::vector<std::string>& faults = {})
  {
    arguments.insert(arguments.begin(), "bench");
    arguments.emplace_back("--json");
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    for (const std::string& fault : faults)
    {
      EXPECT_NE(run.err.find(fault), std::string::npos) << run;
    }
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), faults.size()) << run;
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
    const double largest = i % 4 == 1 ? 1e-3 : 1e-6; // hierarchical has the tolerance
    EXPECT_LT(rows[i]["max error"], largest) << rows[i];
    if (i % 4 == 3) // no filter verifies parity
    {
      EXPECT_TRUE(rows[i]["near max error"].is_null()) << rows[i];
    }
    else
    {
      EXPECT_LT(rows[i]["near max error"], largest) << rows[i];
    }
    for (const char* name : {"prepare s", "evaluate s", "ns/voxel"})
    {
      EXPECT_GE(rows[i][name], 0) << name;
    }
  }
  EXPECT_EQ(rows[0]["cap triangles"], 0);
}

TEST_F(BenchCommand, OpenSurfacesAndSoups)
{
  Mesh open = sphere(2);
  open.triangles.pop_back();
  Mesh soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const nlohmann::json found = tables({folder.write("open.off", asOff(open)),
                                        folder.write("soup.off", asOff(soup)), "--resolution", "8"},
    {"the surface is open on a whole side", "no sample is inside"});
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
