// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

namespace
{

using Arguments = std::vector<std::string>;

TEST(CommandLine, HelpAndVersionGoToStandardOutput)
{
  for (const Arguments& arguments :
    {Arguments{"--help"}, {"--version"}, {"field", "--help"}, {"check", "-h"}})
  {
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_FALSE(run.out.empty());
    EXPECT_EQ(run.err, "");
  }
}

/// Each ends with exit status 1 and one line, which names what is wrong.
TEST(CommandLine, UsageErrors)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const std::string vti = folder.path("out.vti");
  const std::string vtp = folder.path("out.vtp");
  const std::pair<Arguments, std::string> cases[] = {
    {{}, "subcommand"},
    {{"nonsense"}, "\"nonsense\" is no subcommand"},
    {{"bench"}, "FILE is required"},
    {{"bench", in, "--resolution", "8", "0"}, "--resolution is 0"},
    {{"bench", in, "--threads", "-1"}, "--threads is -1"},
    {{"field"}, "IN is required"},
    {{"field", in}, "--output is required"},
    {{"field", in, "-o", vti, "--nonsense"}, "--nonsense"},
    {{"field", in, "-o", vti, "--resolution", "1e6"},
      "--resolution is 1e6; give a whole number, like 1000000; see"},
    {{"field", in, "-o", vti, "--threads", "2.6"}, "give a whole number, like 3; see"},
    {{"field", in, "-o", vti, "--resolution", "99999999999"}, "give a smaller number; see"},
    {{"field", in, "-o", vti, "--dims", "8", "8", "all"}, "--dims is 8,8,all; give a number; see"},
    {{"field", in, "-o", vti, "--padding", "5%"}, "--padding is 5%; give a number; see"},
    {{"surface", in, "-o", folder.path("out.stl"), "--distance"}, "--distance is for outputs .vtp"},
    {{"field", in, "-o", vti, "--distance-band", "3"}, "--distance-band is for --distance"},
    {{"field", in, "-o", vti, "--distance", "--distance-band", "-1"}, "--distance-band is -1"},
    {{"field", in, "-o", vti, "--distance", "--distance-band", "inf"}, "--distance-band is inf"},
    {{"field", in, "-o", vtp}, ".vti"},
    {{"surface", in, "-o", folder.path("out.pvti")}, ".stl"},
    {{"probe", in, in, "-o", folder.path("out.stl")}, ".csv"},
    {{"field", in, "-o", vti, "--resolution", "-7"}, "--resolution is -7"},
    {{"field", in, "-o", vti, "--resolution", "many"}, "--resolution"},
    {{"field", in, "-o", vti, "--voxel-size", "-0.5"}, "--voxel-size is -0.5"},
    {{"field", in, "-o", vti, "--voxel-size", "0"}, "--voxel-size is 0"},
    {{"field", in, "-o", vti, "--dims", "4", "0", "4"}, "--dims has 0"},
    {{"field", in, "-o", vti, "--dims", "4", "4"}, "--dims"},
    {{"field", in, "-o", vti, "--bounds", "0", "1", "3", "2", "0", "1"}, "along y are 3 to 2"},
    {{"field", in, "-o", vti, "--bounds", "0", "1", "2", "2", "0", "1"}, "along y are 2 to 2"},
    {{"field", in, "-o", vti, "--padding", "-1"}, "--padding is -1"},
    {{"field", in, "-o", vti, "--resolution", "8", "--voxel-size", "1"}, "excludes"},
    {{"field", in, "-o", vti, "--method", "tree"}, "auto | rows | hierarchical | direct | parity"},
    {{"field", in, "-o", vti, "--coverage", "all"}, "center | any | fraction"},
    {{"surface", in, "-o", vtp, "--coverage", "any"}, "--coverage"},
    {{"field", in, "-o", vti, "--coverage-samples", "5"}, "is for --coverage fraction"},
    {{"voxels", in, "-o", vtp, "--coverage", "fraction", "--coverage-samples", "11"},
      "--coverage-samples is 11"},
    {{"field", in, "-o", vti, "--areas", "delaunay"}, "voronoi | mesh | constant | array"},
    {{"field", in, "-o", vti, "--areas", "array", "--area", "1"}, "--area"},
    {{"field", in, "-o", vti, "--area", "1"}, "--areas constant"},
    {{"field", in, "-o", vti, "--areas", "mesh"}, "--points"},
    {{"field", in, "-o", vti, "--tolerance", "inf"}, "--tolerance is inf"},
    {{"field", in, "-o", vti, "--neighbors", "2"}, "3 to 1000"},
    {{"field", in, "-o", vti, "--neighbors", "1001"}, "3 to 1000"},
    {{"field", in, "-o", vti, "--regularization", "4.5"}, "--regularization is 4.5; give 0 to 4"},
    {{"field", in, "-o", vti, "--regularization", "-1"}, "--regularization is -1; give 0 to 4"},
    {{"normals", in}, "--output is required"},
    {{"normals", in, "-o", "out.stl"}, "normals writes .vtp .vtu .ply .xyz .pwn .csv .tsv"},
    {{"normals", in, "-o", vtp, "--areas", "array"}, "voronoi | mesh | constant"},
    {{"normals", in, "-o", "out.xyz", "--areas", "constant"}, "which .xyz does not"},
    {{"normals", in, "-o", vtp, "--areas", "mesh", "--replace"}, "--replace"},
    {{"normals", in, "-o", vtp, "--area", "1"}, "--areas constant"},
    {{"normals", in, "-o", vtp, "--neighbors", "2"}, "3 to 1000"},
    {{"normals", in, "-o", vtp, "--normal-estimation", "best"}, "auto | tree | consistent"},
    {{"field", in, "-o", vti, "--tolerance", "-1"}, "--tolerance is -1"},
    {{"field", in, "-o", vti, "--pieces", "0"}, "--pieces is 0"},
    {{"field", in, "-o", vti, "--threads", "-1"}, "--threads is -1"},
    {{"surface", in, "-o", "s.vtp", "--longest-expected-time", "-1"},
      "--longest-expected-time is -1"},
    {{"field", in, "-o", vti, "--verify", "-1"}, "--verify is -1"},
    {{"field", in, "-o", vti, "--verify", "9", "--method", "parity"}, "--method parity"},
    {{"field", in, "-o", vti, "--verify", "9", "--inside-only"}, "--inside-only"},
    {{"field", in, "-o", vti, "--double", "--inside-only"}, "excludes"},
    {{"field", in, "-o", vti, "--array", "w", "--inside-only"}, "--array names"},
    {{"field", in, "-o", vti, "--rule", "odd", "--threshold", "1"}, "odd has no threshold"},
    {{"field", in, "-o", vti, "--close-border"}, "--close-border"},
    {{"voxels", in, "-o", vtp, "--inside-only"}, "--inside-only"},
    {{"surface", in, "-o", vtp, "--rule", "even"}, "signed | absolute | odd"},
  };
  for (const auto& [arguments, part] : cases)
  {
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 1) << run;
    EXPECT_TRUE(run.saysInOneLine({part})) << part << "\n" << run;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.off"});
}

TEST(CommandLine, MoreThreadsThanTheMachineHasAreAsManyAsItHas)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const Outcome run = runProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "8",
    "--threads", "100000", "--json"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err, "");
  EXPECT_LT(run.json()["threads"], 100000);
}

TEST(CommandLine, NegativeNumbersAreValuesOfOptions)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const Outcome run =
    runProgram({"field", in, "-o", folder.path("out.vti"), "--json", "--resolution", "4",
      "--bounds", "-.5", ".5", "-1e0", "1.", "-.2e1", "2", "--threshold", "-0.5"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["grid"]["dimensions"], nlohmann::json({1, 2, 4}));
}

} // namespace
