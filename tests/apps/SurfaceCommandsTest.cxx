// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{

class SurfaceCommands : public testing::TestWithParam<std::string>
{
protected:
  /// The report of `winding check` about the surface that a command has made of the sphere.
  nlohmann::json checked(const std::string& command, const std::string& suffix,
    const std::vector<std::string>& more = {})
  {
    const std::string out = folder.path("out." + suffix);
    std::vector<std::string> arguments = {command, in, "-o", out, "--resolution", "20", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    made = run.json();
    const Outcome check = runProgram({"check", out, "--json"});
    EXPECT_EQ(check.status, 0) << check;
    return check.json();
  }

  TemporaryFolder folder;
  std::string in = folder.write("sphere.off", asOff(sphere(3)));
  nlohmann::json made;
};

/// Without a parameter: it is about surfaces alone.
class ShapeCommand : public SurfaceCommands
{
};

constexpr double volumeOfSphere = 4.18879;

/// The results have outward faces and no boundary, in every format.
TEST_P(SurfaceCommands, AreClosedAndFaceOutward)
{
  for (const std::string suffix : {"vtp", "ply", "stl", "obj"})
  {
    const nlohmann::json report = checked(GetParam(), suffix);
    EXPECT_EQ(report["closed"], true) << suffix << report;
    EXPECT_EQ(report["boundary_edges"], 0);
    EXPECT_EQ(report["components_edge"], 1);
    EXPECT_NEAR(report["volume"], volumeOfSphere, 0.1 * volumeOfSphere) << suffix;
    EXPECT_EQ(made["output"]["file"], folder.path("out." + suffix));
    EXPECT_GT(made["output"]["points"], 100);
    EXPECT_GT(made["output"]["cells"], 100);
    EXPECT_TRUE(made.contains("grid") && made.contains("seconds"));
  }
}

TEST_P(SurfaceCommands, CellsMakeNoDifference)
{
  const nlohmann::json points = checked(GetParam(), "ply");
  const nlohmann::json cells = checked(GetParam(), "ply", {"--cells"});
  EXPECT_EQ(points["triangles"], cells["triangles"]);
  EXPECT_EQ(points["volume"], cells["volume"]);
}

TEST_P(SurfaceCommands, RuleAbsoluteTakesEitherOrientation)
{
  Mesh mesh = sphere(3);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  in = folder.write("inverted.off", asOff(mesh));
  const nlohmann::json report = checked(GetParam(), "ply", {"--rule", "absolute"});
  EXPECT_EQ(report["closed"], true);
  EXPECT_NEAR(report["volume"], volumeOfSphere, 0.1 * volumeOfSphere);
}

TEST_P(SurfaceCommands, RuleOddLeavesOutWhatIsInsideTwice)
{
  Mesh mesh = sphere(3);
  const auto points = mesh.points.size();
  for (std::size_t i = 0; i < points; ++i)
  {
    const std::array<double, 3> p = mesh.points[i];
    mesh.points.push_back({0.6 * p[0], 0.6 * p[1], 0.6 * p[2]});
  }
  for (std::size_t i = mesh.triangles.size(); i-- > 0;)
  {
    std::array<int, 3> inner = mesh.triangles[i];
    for (int& id : inner)
    {
      id += static_cast<int>(points);
    }
    mesh.triangles.push_back(inner);
  }
  in = folder.write("nested.off", asOff(mesh));
  const nlohmann::json report = checked(GetParam(), "ply", {"--rule", "odd"});
  EXPECT_EQ(report["closed"], true);
  const double volume = volumeOfSphere * (1 - 0.6 * 0.6 * 0.6);
  EXPECT_NEAR(report["volume"], volume, 0.1 * volume);
}

TEST_P(SurfaceCommands, EmptyResultsAreWarnedOf)
{
  const Outcome run = runProgram({GetParam(), in, "-o", folder.path("out.vtp"), "--resolution", "8",
    "--threshold", "5", "--json"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["output"]["cells"], 0);
  EXPECT_NE(run.err.find("winding: warning: "), std::string::npos) << run;
}

TEST_P(SurfaceCommands, FacesThatLookInwardAreToldWithTheRemedyFirst)
{
  Mesh mesh = sphere(3);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const auto messageOf = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = {
      GetParam(), in, "-o", folder.path("out.vtp"), "--resolution", "12", "--as-is"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    return run.err;
  };
  const std::string advice = " look inward: use --rule absolute, or turn the faces";
  const auto expectAdvice = [&](const std::vector<std::string>& more)
  {
    const std::string message = messageOf(more);
    EXPECT_EQ(message.rfind("winding: warning: " + in + ": faces", 0), 0u) << message;
    EXPECT_NE(message.find(advice), std::string::npos) << message;
    EXPECT_EQ(message.find("winding: warning: ", 1), std::string::npos) << message;
  };
  for (const int missing : {0, 100})
  {
    mesh.triangles.resize(mesh.triangles.size() - missing);
    in = folder.write("inward.off", asOff(mesh));
    expectAdvice({});
    expectAdvice({"--double"});
    expectAdvice({"--verify", "10"});
    EXPECT_EQ(messageOf({"--rule", "absolute"}), "");
    const std::string beside = messageOf({"--bounds", "2", "3", "-1", "1", "-1", "1"});
    EXPECT_EQ(beside.find("look inward"), std::string::npos) << beside;
    EXPECT_NE(beside.find("the grid misses the source"), std::string::npos) << beside;
  }
}

TEST(SurfaceCommand, EmptySurfacesAreToldWithRemedies)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(3)));
  const auto messageOf = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = {
      "surface", in, "-o", folder.path("out.vtp"), "--resolution", "8", "--as-is"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    return run.err;
  };
  const std::string start = "winding: warning: " + in + ": ";
  std::vector<std::string> within = {"--bounds", "-0.1", "0.1", "-0.1", "0.1", "-0.1", "0.1"};
  EXPECT_EQ(messageOf(within),
    start +
      "all samples are inside, so the surface is empty: close the border (--close-border), or "
      "choose a larger grid (--padding, --bounds)\n");
  within.emplace_back("--close-border");
  EXPECT_EQ(messageOf(within), "");
  EXPECT_EQ(messageOf({"--threshold", "5"}),
    start + "no sample is inside: choose a lower threshold (--threshold), or choose smaller voxels "
            "(--resolution, --voxel-size), or choose a grid around the source (--bounds), or look "
            "whether the source is closed (winding check)\n");
}

TEST_P(SurfaceCommands, TheOptionThatAWarningNamesTurnsFacesThatLookInward)
{
  Mesh mesh = sphere(3);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  in = folder.write("inward.off", asOff(mesh));
  const std::string out = folder.path("out.vtp");
  const std::string warning =
    runProgram({GetParam(), in, "-o", out, "--resolution", "16", "--as-is"}).err;
  const std::string before = "turn the faces (";
  const std::size_t begin = warning.find(before);
  ASSERT_NE(begin, std::string::npos) << warning;
  const std::string option =
    warning.substr(begin + before.size(), warning.find(')', begin) - begin - before.size());
  const Outcome run =
    runProgram({GetParam(), in, "-o", out, "--resolution", "16", "--json", option});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err, "");
  EXPECT_GT(run.json()["output"]["cells"], 0);
}

INSTANTIATE_TEST_SUITE_P(Both, SurfaceCommands, testing::Values("surface", "voxels"),
  [](const auto& parameter) { return parameter.param; });

/// Neither the array that is stored on the way nor its precision makes a difference.
TEST(VoxelsCommand, SameVoxelsFromInsideAndFromValues)
{
  const TemporaryFolder folder;
  Mesh mesh = sphere(3);
  mesh.triangles.resize(mesh.triangles.size() * 3 / 4);
  const std::string in = folder.write("open.off", asOff(mesh));
  const std::vector<std::string> rules[] = {
    {"--threshold", "0.3"}, {"--threshold", "0.3", "--rule", "absolute"}, {"--rule", "odd"}};
  for (const std::vector<std::string>& rule : rules)
  {
    std::vector<std::string> contents;
    for (const char* more : {"--json", "--double", "--verify=5"})
    {
      std::vector<std::string> arguments = {
        "voxels", in, "-o", folder.path("out.ply"), "--resolution", "20", more};
      arguments.insert(arguments.end(), rule.begin(), rule.end());
      const Outcome run = runProgram(arguments);
      EXPECT_EQ(run.status, 0) << run;
      contents.push_back(contentsOf(folder.path("out.ply")));
    }
    EXPECT_TRUE(contents[0] == contents[1] && contents[0] == contents[2]) << rule.back();
  }
}

/// Voxels of any overlap hold the whole sphere; voxels that are half inside are as large as it.
TEST(VoxelsCommand, CoverageSaysWhichVoxels)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(3)));
  const std::string out = folder.path("out.vtp");
  const double volumeOfMesh = runProgram({"check", in, "--json"}).json()["volume"];
  std::vector<double> volumes;
  for (const char* coverage : {"center", "any", "fraction"})
  {
    std::vector<nlohmann::json> reports;
    for (const char* more : {"--json", "--double", "--verify=5", "--cells"})
    {
      const Outcome run = runProgram(
        {"voxels", in, "-o", out, "--resolution", "12", "--coverage", coverage, more, "--quiet"});
      EXPECT_EQ(run.status, 0) << run;
      reports.push_back(runProgram({"check", out, "--json"}).json());
      EXPECT_EQ(reports.back()["triangles"], reports.front()["triangles"]) << coverage << more;
    }
    EXPECT_EQ(reports.front()["closed"], true);
    volumes.push_back(reports.front()["volume"]);
    EXPECT_EQ(contentsOf(out).find("\"Coverage\"") != std::string::npos,
      std::string(coverage) == "fraction")
      << "shares to colour faces by";
  }
  EXPECT_GT(volumes[1], 1.2 * volumeOfMesh);
  EXPECT_NEAR(volumes[2], volumeOfMesh, 0.05 * volumeOfMesh);
}

TEST(SurfaceCommand, NeedsTwoSamplesAlongEachAxis)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(1)));
  const Outcome run =
    runProgram({"surface", in, "-o", folder.path("out.vtp"), "--dims", "8", "1", "8"});
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"one voxel along y"})) << run;
}

/// A cube whose faces lie along the grid, by each way to say how many voxels there are.
TEST(SurfaceCommand, OfFewVoxelsIsClosed)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("cube.obj",
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const std::vector<std::string>& voxels :
    std::vector<std::vector<std::string>>{{"--resolution", "5"}, {"--resolution", "10"},
      {"--resolution", "21"}, {"--voxel-size", "0.2"}, {"--dims", "9", "7", "12"}})
  {
    const std::string out = folder.path("out.ply");
    std::vector<std::string> arguments = {"surface", in, "-o", out, "--features", "sharp"};
    arguments.insert(arguments.end(), voxels.begin(), voxels.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err.find("closed"), std::string::npos) << run;
    const nlohmann::json report = runProgram({"check", out, "--json"}).json();
    EXPECT_EQ(report["closed"], true) << run;
    EXPECT_NEAR(report["volume"].get<double>(), 1, 1e-6) << run;
  }
}

/// A contour of the array Inside would have steps of half a voxel, which add a tenth to the area.
TEST(SurfaceCommand, IsAsSmoothAsItsInput)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(3)));
  for (const char* more : {"--json", "--double"})
  {
    const std::string out = folder.path("out.vtp");
    const Outcome run = runProgram({"surface", in, "-o", out, "--resolution", "40", more});
    EXPECT_EQ(run.status, 0) << run;
    const nlohmann::json report = runProgram({"check", out, "--json"}).json();
    const nlohmann::json expected = runProgram({"check", in, "--json"}).json();
    EXPECT_NEAR(report["area"].get<double>() / expected["area"].get<double>(), 1, 0.01) << report;
    EXPECT_NEAR(report["volume"].get<double>() / expected["volume"].get<double>(), 1, 0.01)
      << report;
    const bool isDouble =
      contentsOf(out).find("type=\"Float64\" Name=\"Points\"") != std::string::npos;
    EXPECT_EQ(isDouble, std::string(more) == "--double");
  }
}

/// The corners of a cube that is not parallel to the grid.
TEST(SurfaceCommand, KeepsSharpEdgesAndTellsHowNearItIs)
{
  const TemporaryFolder folder;
  std::string cube = "OFF\n8 6 0\n";
  for (int corner = 0; corner < 8; ++corner)
  {
    const double x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    // A turn by a rational matrix.
    cube += std::to_string((x + 2 * y + 2 * z) / 3) + " " +
            std::to_string((2 * x + y - 2 * z) / 3) + " " +
            std::to_string((2 * x - 2 * y + z) / 3) + "\n";
  }
  cube += "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n";
  const std::string in = folder.write("cube.off", cube);
  nlohmann::json found[2];
  for (const bool isSharp : {false, true})
  {
    const std::string out = folder.path("out.vtp");
    const Outcome run = runProgram({"surface", in, "-o", out, "--resolution", "40", "--features",
      isSharp ? "sharp" : "smooth", "--fidelity", "5000", "--json"});
    EXPECT_EQ(run.status, 0) << run;
    found[isSharp] = run.json()["fidelity"];
    EXPECT_EQ(runProgram({"check", out, "--json"}).json()["closed"], true);
    EXPECT_EQ(found[isSharp]["lost_components"], 0);
    EXPECT_EQ(found[isSharp]["self_intersections"], 0);
    EXPECT_NEAR(found[isSharp]["input_volume"], 1, 1e-5);
  }
  // Measured: a fourteenth of the distance, a tenth of the volume that is cut off.
  EXPECT_LT(5 * found[1]["mean_distance_from_input"].get<double>(),
    found[0]["mean_distance_from_input"].get<double>());
  EXPECT_NEAR(found[1]["volume"], 1, 0.0005);
  const Outcome words = runProgram({"surface", in, "-o", folder.path("out.stl"), "--features",
    "sharp", "--fidelity", "100", "--resolution", "20"});
  EXPECT_EQ(words.status, 0) << words;
  EXPECT_NE(words.out.find("0 of 1 parts lost; 0 self-intersections"), std::string::npos) << words;
}

/// A wall, a grown solid and a hollow one that is filled.
TEST_F(ShapeCommand, MovesAndMakesShells)
{
  const auto volumeOfBall = [](double radius)
  {
    return volumeOfSphere * radius * radius * radius;
  };
  for (const std::string suffix : {"vtp", "stl"})
  {
    const nlohmann::json grown = checked("surface", suffix, {"--offset", "0.5"});
    EXPECT_EQ(grown["closed"], true);
    EXPECT_NEAR(grown["volume"], volumeOfBall(1.5), 0.04 * volumeOfBall(1.5));
    EXPECT_EQ(made["output"]["distances_from"], "source");
    const nlohmann::json wall =
      checked("surface", suffix, {"--shell", "0.5", "--shell-side", "outward"});
    const double volume = volumeOfBall(1.5) - volumeOfBall(1);
    EXPECT_NEAR(wall["volume"], volume, 0.04 * volume);
    EXPECT_EQ(wall["components_edge"], 2);
  }
  const std::string shell = folder.path("shell.ply");
  ASSERT_EQ(runProgram({"surface", in, "-o", shell, "--shell", "0.4"}).status, 0);
  const Outcome run =
    runProgram({"surface", shell, "-o", folder.path("solid.ply"), "--fill-cavities"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_NE(run.out.find("1 cavity filled"), std::string::npos) << run;
  const Outcome told = runProgram(
    {"surface", in, "-o", folder.path("o.ply"), "--offset", "0.1", "--fidelity", "100", "--json"});
  EXPECT_LT(told.json()["fidelity"]["largest_shape_error"], 0.02) << told;
}

TEST(SurfaceCommand, RefusesOptionsOfSharpSurfacesElsewhere)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(1))), out = folder.path("o.vtp");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& part)
  {
    std::vector<std::string> arguments = {"surface", in, "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 1) << run;
    EXPECT_NE(run.err.find(part), std::string::npos) << run;
  };
  refused({"--triangles"}, "--triangles is for --features sharp or voxels; say that, too");
  refused({"--fidelity", "-1"}, "--fidelity is -1; give 0 or more");
  refused({"--shell", "-1"}, "--shell is -1; give 0 or more");
  refused({"--shell-side", "outward"}, "--shell-side is for --shell; say that, too");
  refused({"--shell", "1", "--shell-side", "up"}, "--shell-side");
  refused({"--features", "keen"}, "--features");
}

TEST(SurfaceCommand, WritesDistancesFromTheInput)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("sphere.off", asOff(sphere(1))), out = folder.path("o.vtp");
  const Outcome run =
    runProgram({"surface", in, "-o", out, "--resolution", "12", "--distance", "--json"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_FALSE(run.json().contains("distance_band")) << run; // a field's
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(out.c_str());
  reader->Update();
  vtkDataArray* distances = reader->GetOutput()->GetPointData()->GetArray("DistanceToInput");
  ASSERT_NE(distances, nullptr);
  EXPECT_LT(distances->GetRange()[1], 1e-5);
  const Outcome other = runProgram({"surface", in, "-o", folder.path("o.stl"), "--distance"});
  EXPECT_EQ(other.status, 1) << other;
  EXPECT_NE(other.err.find("--distance is for outputs .vtp"), std::string::npos) << other;
}

} // namespace
