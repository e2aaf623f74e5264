// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

/**
 * @file
 * Clouds of every kind that comes in, and the field, warning or refusal that each gets.
 */
namespace
{

using Point = std::array<double, 3>;

struct Cloud
{
  std::vector<Point> points;
  std::vector<Point> normals; ///< one for each point, or none
};

Cloud sphereCloud(int count)
{
  Cloud cloud;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), a = 2.39996322972865 * i;
    cloud.points.push_back({r * std::cos(a), r * std::sin(a), z});
  }
  cloud.normals = cloud.points;
  return cloud;
}

std::string asXyz(const Cloud& cloud)
{
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    for (const double x : cloud.points[i])
    {
      text << x << " ";
    }
    for (std::size_t axis = 0; axis < 3 && !cloud.normals.empty(); ++axis)
    {
      text << cloud.normals[i][axis] << " ";
    }
    text << "\n";
  }
  return text.str();
}

class Clouds : public testing::Test
{
protected:
  Outcome run(const Cloud& cloud, const std::vector<std::string>& options = {})
  {
    std::vector<std::string> arguments = {"field", folder.write("cloud.xyz", asXyz(cloud)), "-o",
      folder.path("out.vti"), "--resolution", "16", "--verify", "50", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runProgram(arguments);
  }

  /// Expects a field within the tolerance and a warning that has a text; none if that is empty.
  /// Returns the report.
  nlohmann::json expectField(
    const Cloud& cloud, const std::vector<std::string>& options, const std::string& warning)
  {
    const Outcome outcome = this->run(cloud, options);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.err.empty(), warning.empty()) << outcome;
    EXPECT_NE(outcome.err.find(warning), std::string::npos) << outcome;
    nlohmann::json report = outcome.json();
    EXPECT_LT(report["max_error"], 1e-3) << outcome;
    return report;
  }

  TemporaryFolder folder;
};

TEST_F(Clouds, OnOnePlaceAreRefusedForTheirGridOrWarnedOf)
{
  const Cloud equal{std::vector<Point>(50, {1, 1, 1}), std::vector<Point>(50, {0, 0, 1})};
  EXPECT_EQ(run(equal).status, 2);
  expectField(
    equal, {"--bounds", "0", "2", "0", "2", "0", "2"}, "points at one place have no areas");
}

TEST_F(Clouds, OfTwoPointsOrOnALineHaveAField)
{
  expectField({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}}, {}, "");
  Cloud line;
  for (int i = 0; i < 100; ++i)
  {
    line.points.push_back({1.0 * i, 2.0 * i, 3.0 * i});
  }
  expectField(line, {"--estimate-normals"}, "estimated normals are not right everywhere");
  line.normals.assign(100, {0, 0, 1});
  expectField(line, {}, "all normals are equal");
}

TEST_F(Clouds, WithDuplicatesHaveTheFieldOfThoseWithout)
{
  Cloud cloud = sphereCloud(1000);
  const double area = expectField(cloud, {}, "")["input"]["mean_area"];
  for (int i = 0; i < 100; ++i)
  {
    cloud.points.push_back(cloud.points[static_cast<std::size_t>(i)]);
    cloud.normals.push_back(cloud.normals[static_cast<std::size_t>(i)]);
  }
  const double smaller = expectField(cloud, {}, "")["input"]["mean_area"];
  EXPECT_NEAR(1100 * smaller, 1000 * area, 1e-9);
}

TEST_F(Clouds, WithBadPointsOrNormalsDoWithoutThem)
{
  Cloud cloud = sphereCloud(1000);
  cloud.points[3][1] = std::nan("");
  cloud.normals[5][2] = std::nan("");
  cloud.normals[7] = {0, 0, 0};
  EXPECT_EQ(
    expectField(cloud, {}, "3 of 1000 points were unusable and left out")["input"]["dropped"], 3);
}

TEST_F(Clouds, WithNormalsInwardAreMinusOne)
{
  Cloud cloud = sphereCloud(1000);
  for (Point& normal : cloud.normals)
  {
    normal = {-normal[0], -normal[1], -normal[2]};
  }
  expectField(cloud, {}, "normals look inward: use --rule absolute, or turn the normals");
}

TEST_F(Clouds, WithoutNormalsAreRefusedOrGetThem)
{
  Cloud cloud = sphereCloud(1000);
  cloud.normals.clear();
  const Outcome refused = run(cloud);
  EXPECT_EQ(refused.status, 2) << refused;
  EXPECT_TRUE(refused.saysInOneLine({"the points have no normals: use --estimate-normals"}))
    << refused;
  const nlohmann::json report = expectField(cloud, {"--estimate-normals"}, "");
  EXPECT_EQ(report["input"]["normals_estimated"], true);
  EXPECT_EQ(report["input"]["normal_estimation"], "spanning tree");
  EXPECT_EQ(report["input"]["clear_share"], 1);
  const nlohmann::json other =
    expectField(cloud, {"--estimate-normals", "--normal-estimation", "consistent"}, "");
  EXPECT_EQ(other["input"]["normal_estimation"], "winding consistent");
  EXPECT_EQ(other["input"]["clear_share"], 1);
}

TEST_F(Clouds, WithAFarOutlierKeepTheirField)
{
  Cloud cloud = sphereCloud(3000);
  const double area = expectField(cloud, {}, "")["input"]["mean_area"];
  cloud.points.push_back({3e6, 0, 0});
  const std::vector<std::string> aroundSphere = {
    "--bounds", "-1.5", "1.5", "-1.5", "1.5", "-1.5", "1.5"};
  for (const bool withNormals : {true, false})
  {
    std::vector<std::string> options = aroundSphere;
    if (withNormals)
    {
      cloud.normals.push_back({1, 0, 0});
    }
    else
    {
      cloud.normals.clear();
      options.push_back("--estimate-normals");
    }
    const nlohmann::json report = expectField(cloud, options, "");
    EXPECT_NEAR(report["input"]["mean_area"], area, 0.02 * area);
#ifndef WINDING_SANITIZED // sanitizers need memory of their own
    EXPECT_LT(report["peak_memory"], 200e6);
#endif
  }
  expectField(cloud, {"--estimate-normals"}, "the source is thinner than three voxels");
}

TEST_F(Clouds, MayBeSpread)
{
  const Cloud cloud = sphereCloud(1000);
  const Outcome outcome = run(cloud, {"--regularization", "1"});
  EXPECT_EQ(outcome.status, 0) << outcome;
  EXPECT_LT(outcome.json()["near_max_error"], 1e-3) << outcome;
}

TEST_F(Clouds, OfTablesHaveColumnsByAnyUsualName)
{
  for (const std::string header :
    {"x,y,z,nx,ny,nz,area", "X,Y,Z,NX,NY,NZ,Area",
      "\"Points:0\",\"Points:1\",\"Points:2\",\"Normals:0\",\"Normals:1\",\"Normals:2\",\"Area\""})
  {
    const std::string cloud =
      folder.write("cloud.csv", header + "\n0,0,1,0,0,1,0.25\n1,0,0,1,0,0,0.75\n");
    const Outcome outcome = runProgram({"field", cloud, "-o", folder.path("out.vti"),
      "--resolution", "4", "--areas", "array", "--json"});
    ASSERT_EQ(outcome.status, 0) << header << outcome;
    EXPECT_DOUBLE_EQ(outcome.json()["input"]["mean_area"], 0.5) << header;
  }
}

/// A wall that two scanners see: the rows say which one.
TEST_F(Clouds, OfTablesMaySayWhereEachPointWasSeenFrom)
{
  Cloud scan = sphereCloud(1000);
  const auto rowsOf = [&scan](const char* separator, double from)
  {
    std::ostringstream rows;
    for (const Point& p : scan.points)
    {
      for (const double x : p)
      {
        rows << x << separator;
      }
      rows << from * p[0] << separator << from * p[1] << separator << from * p[2] << "\n";
    }
    return rows.str();
  };
  const auto windingOf = [this](const std::string& cloud, const std::vector<std::string>& more)
  {
    const std::string answer = folder.path("answer.csv");
    std::vector<std::string> arguments = {"probe", cloud,
      folder.write("queries.csv", "x,y,z\n0.1,0.2,0\n"), "-o", answer, "--estimate-normals",
      "--rule", "absolute"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "") << run;
    const std::string text = contentsOf(answer);
    const std::size_t row = text.find('\n') + 1;
    return std::stod(text.substr(text.find(',', text.find(',', text.find(',', row) + 1) + 1) + 1));
  };
  const std::string named = "x,y,z,vp_x,vp_y,vp_z\n", other = "x,y,z,a,b,c\n";
  // Seen from inside, the points look inward, as no field would have them.
  EXPECT_NEAR(windingOf(folder.write("out.csv", named + rowsOf(",", 3)), {}), 1, 0.05);
  EXPECT_NEAR(windingOf(folder.write("in.csv", named + rowsOf(",", 0.5)), {}), -1, 0.05);
  EXPECT_NEAR(
    windingOf(
      folder.write("in.xyz", "x y z viewpoint_x viewpoint_y viewpoint_z\n" + rowsOf(" ", 0.5)), {}),
    -1, 0.05);
  EXPECT_NEAR(windingOf(folder.write("other.csv", other + rowsOf(",", 0.5)),
                {"--columns", "vx=a", "vy=b", "vz=6"}),
    -1, 0.05);
  EXPECT_NEAR(windingOf(folder.path("other.csv"), {}), 1, 0.05);
  EXPECT_NEAR(windingOf(folder.path("in.csv"), {"--toward", "0", "0", "0"}), -1, 0.05);
  EXPECT_NEAR(windingOf(folder.path("out.csv"), {"--toward", "0", "0", "0"}), -1, 0.05);
  const Outcome normals =
    runProgram({"normals", folder.path("in.csv"), "-o", folder.path("in.ply")});
  EXPECT_EQ(normals.status, 0) << normals;
  EXPECT_NEAR(windingOf(folder.path("in.ply"), {"--quiet"}), -1, 0.05);
}

TEST_F(Clouds, OfHalfAThingKeepTheReportOnTheirNormals)
{
  Cloud half = sphereCloud(2000);
  half.normals.clear();
  half.points.erase(
    std::remove_if(half.points.begin(), half.points.end(), [](const Point& p) { return p[1] < 0; }),
    half.points.end());
  const auto report =
    expectField(half, {"--estimate-normals", "--mirror", "y=0", "--toward", "0", "9", "0"}, "");
  EXPECT_TRUE(report["input"]["normals_estimated"].get<bool>()) << report;
  EXPECT_GT(report["input"]["clear_share"].get<double>(), 0.9) << report;
}

/// Zeros for normals, in every format that has any.
TEST_F(Clouds, WithZerosForNormalsGetThemEstimated)
{
  Cloud zeros = sphereCloud(200);
  std::string table = "x;y;z;nx;ny;nz\n", ply = "ply\nformat ascii 1.0\nelement vertex 200\n";
  for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"})
  {
    ply += std::string("property double ") + name + "\n";
  }
  ply += "end_header\n";
  zeros.normals.assign(200, {0, 0, 0});
  std::string rows = asXyz(zeros);
  ply += rows;
  std::replace(rows.begin(), rows.end(), ' ', ';');
  for (std::size_t end = rows.find(";\n"); end != std::string::npos; end = rows.find(";\n"))
  {
    rows.erase(end, 1);
  }
  zeros.normals.clear();
  const std::string bare = folder.write("bare.xyz", asXyz(zeros));
  zeros.normals.assign(200, {0, 0, 0});
  const auto fieldOf = [this](const std::string& file)
  {
    return runProgram({"field", file, "-o", folder.path("w.vti"), "--resolution", "8", "--json",
      "--estimate-normals"});
  };
  const auto expected = fieldOf(bare).json()["input"]["mean_area"];
  for (const std::string& file : {folder.write("zeros.xyz", asXyz(zeros)),
         folder.write("zeros.ply", ply), folder.write("zeros.csv", table + rows)})
  {
    const Outcome run = fieldOf(file);
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    EXPECT_TRUE(run.json()["input"]["normals_estimated"].get<bool>()) << run;
    EXPECT_NEAR(run.json()["input"]["mean_area"].get<double>(), expected, 1e-6);
    EXPECT_TRUE(runProgram({"field", file, "-o", folder.path("w.vti")})
                  .saysInOneLine({"all normals have length 0: use --estimate-normals"}));
    EXPECT_EQ(runProgram({"normals", file, "-o", folder.path("n.ply"), "--quiet"}).status, 0);
  }
}

TEST_F(Clouds, NormalsThatAreAllEqualAreTold)
{
  const char* const words = "all normals are equal: estimate others (winding normals IN -o OUT "
                            "--replace); the points lie in no plane";
  Cloud ball = sphereCloud(200);
  for (Point& normal : ball.normals)
  {
    normal = {0.577, 0.577, 0.577};
  }
  const Outcome told = run(ball);
  EXPECT_EQ(told.status, 0);
  EXPECT_NE(told.err.find(words), std::string::npos) << told;
  const Outcome checked = runProgram({"check", folder.path("cloud.xyz")});
  EXPECT_NE(checked.out.find(words), std::string::npos) << checked;

  const Cloud equal = ball;
  ball.normals[7] = {1, 0, 0};
  const std::string except =
    "all normals except 1 are equal: estimate others (winding normals IN -o "
    "OUT --replace); the points lie in no plane";
  const Outcome exceptOne = run(ball);
  EXPECT_NE(exceptOne.err.find(except), std::string::npos) << exceptOne;
  EXPECT_EQ(std::count(exceptOne.err.begin(), exceptOne.err.end(), '\n'), 1) << exceptOne;
  EXPECT_NE(runProgram({"check", folder.path("cloud.xyz")}).out.find(except), std::string::npos);
  ball.normals[8] = {0, 1, 0};
  EXPECT_NE(run(ball).err.find("all normals except 2 are equal"), std::string::npos);
  ball.normals[9] = {0, 0, 1};
  EXPECT_EQ(run(ball).err.find("normals except"), std::string::npos) << "more than a hundredth";

  Cloud plane = equal;
  for (Point& point : plane.points)
  {
    point[2] = -point[0] - point[1];
  }
  EXPECT_EQ(run(plane).err.find(words), std::string::npos);
}

TEST_F(Clouds, OptionsForThemAreIdleForSurfacesAndThatIsSaid)
{
  const std::string mesh = folder.write("mesh.off", asOff(sphere(2)));
  const std::string out = folder.path("out.vti");
  const std::string csv = folder.path("out.csv");
  const std::vector<std::string> options[] = {{"--estimate-normals"},
    {"--normal-estimation", "tree"}, {"--regularization", "1"}, {"--areas", "constant"},
    {"--neighbors", "10"}};
  for (const std::vector<std::string>& option : options)
  {
    for (std::vector<std::string> command : {std::vector<std::string>{"field", mesh, "-o", out},
           std::vector<std::string>{"probe", mesh, mesh, "-o", csv}})
    {
      command.insert(command.end(), option.begin(), option.end());
      const Outcome outcome = runProgram(command);
      EXPECT_EQ(outcome.status, 0) << outcome;
      EXPECT_NE(outcome.err.find(option[0] + " is for points and the input is a surface"),
        std::string::npos)
        << outcome;
    }
  }
  EXPECT_EQ(runProgram({"boolean", mesh, mesh, "-o", folder.path("out.ply"), "--estimate-normals"})
              .err.empty(),
    false);
  Cloud bare = sphereCloud(500);
  bare.normals.clear();
  EXPECT_EQ(runProgram({"boolean", mesh, folder.write("bare.xyz", asXyz(bare)), "-o",
                         folder.path("out.ply"), "--estimate-normals"})
              .err,
    "");
  EXPECT_EQ(runProgram({"field", mesh, "-o", out}).err, "");
  EXPECT_EQ(runProgram({"field", mesh, "-o", out, "--points", "--regularization", "1"}).err, "");
}

TEST_F(Clouds, AreDescribedForPeople)
{
  Cloud cloud = sphereCloud(1000);
  cloud.normals.clear();
  const Outcome outcome = runProgram({"field", folder.write("cloud.xyz", asXyz(cloud)), "-o",
    folder.path("out.vti"), "--resolution", "8", "--estimate-normals"});
  EXPECT_NE(outcome.out.find("1000 points, mean area 0.01"), std::string::npos) << outcome;
  EXPECT_NE(outcome.out.find("normals by spanning tree, clear at 100 %"), std::string::npos)
    << outcome;
}

} // namespace
