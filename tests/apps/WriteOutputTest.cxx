// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <chrono>

#include <unistd.h>

namespace
{

class WriteOutput : public testing::Test
{
protected:
  TemporaryFolder folder;
  std::string in = folder.write("in.off", asOff(sphere(2)));
};

TEST_F(WriteOutput, UnwritableFolder)
{
  for (const std::string& out : {folder.path("nowhere/out.vti"), std::string("/proc/out.vti")})
  {
    const Outcome run = runProgram({"field", in, "-o", out, "--resolution", "4"});
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({out, "cannot be written"})) << run;
  }
}

TEST_F(WriteOutput, AFolderIsNotReplaced)
{
  ASSERT_EQ(std::system(("mkdir " + folder.path("out.vti")).c_str()), 0);
  const Outcome run = runProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "4"});
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"out.vti"})) << run;
}

/// A limit on the size of files stands in for a full disk, since it stops writing in the middle,
/// too.
TEST_F(WriteOutput, FullDisk)
{
  const std::string queries = folder.write("queries.csv", asCsv(sphere(4)));
  const std::vector<std::vector<std::string>> commands = {
    {"field", in, "-o", folder.path("out.vti"), "--resolution", "40"},
    {"field", in, "-o", folder.path("out.vti"), "--resolution", "40", "--pieces", "3"},
    {"surface", in, "-o", folder.path("out.vtp"), "--resolution", "40"},
    {"surface", in, "-o", folder.path("out.ply"), "--resolution", "40"},
    {"surface", in, "-o", folder.path("out.stl"), "--resolution", "40"},
    {"surface", in, "-o", folder.path("out.obj"), "--resolution", "40"},
    {"voxels", in, "-o", folder.path("out.obj"), "--resolution", "40"},
    {"probe", in, queries, "-o", folder.path("out.csv")},
    {"probe", in, queries, "-o", folder.path("out.vtu")},
  };
  for (const auto& command : commands)
  {
    const std::string& out = command[command[0] == "probe" ? 4 : 3];
    const std::string name = out.substr(out.rfind('/') + 1);
    folder.write(name, "what was there before");
    const Outcome run = runProgram(command, "ulimit -f 8; ");
    EXPECT_EQ(run.status, 2) << name << run;
    EXPECT_TRUE(run.saysInOneLine({name, "cannot be written"})) << run;
    EXPECT_EQ(contentsOf(out), "what was there before");
    for (const std::string& left : folder.names())
    {
      EXPECT_EQ(left.find(".part"), std::string::npos) << left;
    }
  }
}

TEST_F(WriteOutput, NothingIsLeftBesideTheOutput)
{
  const Outcome run = runProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "4"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST_F(WriteOutput, TooLargeForMemoryIsRefusedAtOnce)
{
  const auto start = std::chrono::steady_clock::now();
  const Outcome run =
    runProgram({"field", in, "-o", folder.path("out.vti"), "--dims", "100000", "100000", "1000"});
  EXPECT_EQ(run.status, 3) << run;
  EXPECT_TRUE(run.saysInOneLine({"in.off", "10000000000000 samples", "memory"})) << run;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.off"});
}

TEST_F(WriteOutput, FormatsOfSinglePrecisionAreNotTrustedWithMore)
{
  const auto moved = [this](const std::string& name, double factor, double shift)
  {
    Mesh mesh = sphere(2);
    for (auto& point : mesh.points)
    {
      for (double& x : point)
      {
        x = factor * x + shift;
      }
    }
    return folder.write(name, asOff(mesh));
  };
  const std::string far = moved("far.off", 1, 1e6);
  const std::string large = moved("large.off", 1e90, 0);
  const std::string small = moved("small.off", 1e-90, 0);
  const std::string beyond = moved("beyond.off", 1, 1e8);
  const std::string below = moved("below.off", 1, -1e6);
  for (const std::string suffix : {".stl", ".ply"})
  {
    const std::string out = folder.path("out" + suffix);
    const std::vector<std::string> commands[] = {{"surface", far, "-o", out, "--resolution", "16"},
      {"surface", below, "-o", out, "--resolution", "16"},
      {"check", far, "--fix-orientation", "-o", out}};
    for (const auto& command : commands)
    {
      const Outcome warned = runProgram(command);
      EXPECT_EQ(warned.status, 0) << warned;
      EXPECT_NE(warned.err.find("the format keeps single precision"), std::string::npos) << warned;
    }
    for (const std::string& mesh : {large, small, beyond})
    {
      const Outcome refused = runProgram({"surface", mesh, "-o", out, "--resolution", "16"});
      EXPECT_EQ(refused.status, 2) << refused;
      EXPECT_TRUE(refused.saysInOneLine({out, "single precision", ".vtp"})) << refused;
    }
  }
  for (const std::string& mesh : {far, large, small})
  {
    const Outcome whole =
      runProgram({"surface", mesh, "-o", folder.path("out.vtp"), "--resolution", "16"});
    EXPECT_EQ(whole.status, 0) << whole;
    EXPECT_EQ(whole.err, "");
  }
}

TEST_F(WriteOutput, LinksAreFollowed)
{
  const std::string file = folder.write("file.vti", "what was there before");
  ASSERT_EQ(symlink("file.vti", folder.path("link.vti").c_str()), 0);
  const Outcome run = runProgram({"field", in, "-o", folder.path("link.vti"), "--resolution", "4"});
  EXPECT_EQ(run.status, 0) << run;
  char target[100];
  EXPECT_EQ(readlink(folder.path("link.vti").c_str(), target, sizeof target), 8) << "still a link";
  EXPECT_NE(contentsOf(file).find("ImageData"), std::string::npos);

  ASSERT_EQ(symlink("there.vti", folder.path("early.vti").c_str()), 0);
  EXPECT_EQ(
    runProgram({"field", in, "-o", folder.path("early.vti"), "--resolution", "4"}).status, 0);
  EXPECT_NE(contentsOf(folder.path("there.vti")).find("ImageData"), std::string::npos);

  ASSERT_EQ(symlink("circle.vti", folder.path("circle.vti").c_str()), 0);
  const Outcome circle =
    runProgram({"field", in, "-o", folder.path("circle.vti"), "--resolution", "4"});
  EXPECT_EQ(circle.status, 2) << circle;
  EXPECT_TRUE(circle.saysInOneLine({"circle.vti", "leads to itself"})) << circle;
}

TEST_F(WriteOutput, CloudWithoutNormalsNamesTheCommandThatMakesThem)
{
  const std::string cloud = folder.write("cloud.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const Outcome run = runProgram({"field", cloud, "-o", folder.path("out.vti")});
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"cloud.xyz", "normals", "winding normals"})) << run;
}

TEST_F(WriteOutput, StandardOutputThatCannotBeWrittenIsAnError)
{
  using Words = std::vector<std::string>;
  for (const Words& words :
    {Words{"check", in, "--json"}, {"--help"}, {"--version"}, {"field", "--help"}})
  {
    const Outcome run = runProgram(words, "full() { \"$@\" >/dev/full; }; full ");
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"standard output cannot be written to"})) << run;
  }
}

} // namespace
