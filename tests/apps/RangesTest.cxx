// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

/// Numbers that are finite but out of range end every command in one line that has the value and
/// the number of the point.

namespace
{

class Ranges : public testing::Test
{
protected:
  /// Runs every command on a file, and expects a refusal that has the text and leaves no output.
  void expectRefused(
    const std::string& in, const std::string& mention, const std::vector<std::string>& options = {})
  {
    const std::string queries = folder.write("q.csv", "x,y,z\n0,0,0\n5,0,0\n");
    const std::size_t files = folder.names().size();
    const std::vector<std::vector<std::string>> commands = {
      {"field", in, "-o", folder.path("o.vti"), "--verify", "100"},
      {"field", in, "-o", folder.path("o.vti"), "--distance", "--pieces", "3"},
      {"surface", in, "-o", folder.path("o.vtp")}, {"surface", in, "-o", folder.path("o.stl")},
      {"voxels", in, "-o", folder.path("o.vtp")},
      {"probe", in, queries, "-o", folder.path("o.csv")}, {"check", in}};
    for (std::vector<std::string> command : commands)
    {
      if (command[0] != "check")
      {
        command.insert(command.end(), options.begin(), options.end());
      }
      else if (!options.empty())
      {
        continue; // check takes no areas
      }
      const Outcome run = runProgram(command);
      EXPECT_EQ(run.status, 2) << command[0] << "\n" << run;
      EXPECT_TRUE(run.saysInOneLine({in, mention})) << command[0] << "\n" << run;
      EXPECT_EQ(folder.names().size(), files) << command[0];
    }
  }

  TemporaryFolder folder;
};

} // namespace

TEST_F(Ranges, CoordinatesOfAMesh)
{
  Mesh mesh = sphere(2);
  mesh.points[5][1] = 1e200;
  expectRefused(folder.write("a.off", asOff(mesh)), "point 5 lies at ");
  expectRefused(folder.write("b.off", asOff(mesh)), " 1e+200 ");
  for (auto& point : mesh.points)
  {
    point = {1e-200 * point[0], 1e-200, 0};
  }
  expectRefused(folder.write("c.off", asOff(mesh)), "e-200 along its longest side;");
}

TEST_F(Ranges, CoordinatesOfACloud)
{
  std::string cloud = asXyz(sphere(2));
  expectRefused(folder.write("a.xyz", "1e300 0 0 1 0 0\n" + cloud), "point 0 lies at 1e+300 0 0;");
}

TEST_F(Ranges, AreasOfACloud)
{
  const std::string in = folder.write("a.csv",
    "x,y,z,nx,ny,nz,area\n1,0,0,1,0,0,1\n-1,0,0,-1,0,0,1e250\n0,1,0,0,1,0,1\n0,-1,0,0,-1,0,1\n");
  expectRefused(in, "point 1 has the area 1e+250;", {"--areas", "array"});
  expectRefused(in, "--area is 1e+250;", {"--areas", "constant", "--area", "1e250"});
}

TEST_F(Ranges, FarQueriesGetNothing)
{
  const std::string queries =
    folder.write("q.csv", "x,y,z\n1e300,0,0\n0,-1.7e308,1.7e308\n1e101,1e101,1e101\n0,0,0\n");
  for (const std::string& in :
    {folder.write("a.off", asOff(sphere(2))), folder.write("a.xyz", asXyz(sphere(3)))})
  {
    for (const char* const method : {"auto", "hierarchical", "direct"})
    {
      const Outcome run = runProgram(
        {"probe", in, queries, "-o", folder.path("o.csv"), "--distance", "--method", method});
      ASSERT_EQ(run.status, 0) << run;
      std::istringstream lines(contentsOf(folder.path("o.csv")));
      std::string line;
      std::getline(lines, line);
      for (int row = 0; std::getline(lines, line); ++row)
      {
        EXPECT_EQ(line.find("nan"), std::string::npos) << line;
        EXPECT_EQ(line.find("inf"), std::string::npos) << line;
        std::istringstream fields(line);
        std::vector<double> numbers;
        for (std::string field; std::getline(fields, field, ',');)
        {
          numbers.push_back(std::stod(field));
        }
        EXPECT_NEAR(numbers[3], row < 3 ? 0 : 1, row < 3 ? 1e-30 : 0.05) << line;
      }
    }
  }
}
