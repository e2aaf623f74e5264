// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <tuple>
#include <vector>

namespace
{

class CheckCommand : public testing::Test
{
protected:
  nlohmann::json check(const std::string& name, const std::string& contents)
  {
    const Outcome run = runProgram({"check", folder.write(name, contents), "--json"});
    EXPECT_EQ(run.status, 0) << run;
    return run.json();
  }

  TemporaryFolder folder;
};

TEST_F(CheckCommand, ClosedSurface)
{
  const nlohmann::json report = check("a.off", asOff(sphere(3)));
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["euler"], 2);
  EXPECT_NEAR(report["area"], 12.566, 0.3);
  EXPECT_EQ(report["bbox"], nlohmann::json({-1.0, -1.0, -1.0, 1.0, 1.0, 1.0}));
  EXPECT_EQ(report["advice"], "nothing to mend; closed: every winding number is an integer");
}

TEST_F(CheckCommand, OpenSurface)
{
  Mesh mesh = sphere(2);
  mesh.triangles.pop_back();
  mesh.triangles.erase(mesh.triangles.begin());
  const nlohmann::json report = check("a.off", asOff(mesh));
  EXPECT_EQ(report["closed"], false);
  EXPECT_EQ(report["boundary_edges"], 6);
  EXPECT_EQ(report["boundary_loops"], 2);
  EXPECT_EQ(report["advice"].get<std::string>().rfind("open: 6 boundary edges in 2 loops", 0), 0u);
}

TEST_F(CheckCommand, Slits)
{
  EXPECT_TRUE(check("a.off", asOff(sphere(2)))["widest_slit"].is_null());
  // One triangle has points of its own, moved by a rounding error.
  Mesh mesh = sphere(2);
  for (int& corner : mesh.triangles[7])
  {
    std::array<double, 3> moved = mesh.points[static_cast<std::size_t>(corner)];
    moved[0] += 1e-15;
    corner = static_cast<int>(mesh.points.size());
    mesh.points.push_back(moved);
  }
  const std::string file = folder.write("slit.off", asOff(mesh));
  const nlohmann::json report = runProgram({"check", file, "--json"}).json();
  EXPECT_NEAR(report["widest_slit"].get<double>(), 1e-15, 3e-16);
  const auto advice = report["advice"].get<std::string>();
  EXPECT_EQ(advice.rfind("closed, except for slits of 1e-15: weld points up to ", 0), 0u) << advice;
  const Outcome shown = runProgram({"check", file});
  EXPECT_NE(shown.out.find("widest slit"), std::string::npos) << shown;
}

TEST_F(CheckCommand, FlippedAndDuplicateAndUnusedAndBadTriangles)
{
  Mesh mesh = sphere(2);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  mesh.triangles.push_back(mesh.triangles[40]);
  mesh.triangles.push_back({7, 7, 8});
  mesh.points.push_back({3, 3, 3});
  mesh.points.push_back({std::nan(""), 0, 0});
  mesh.triangles.push_back({0, 1, static_cast<int>(mesh.points.size()) - 1});
  const nlohmann::json report = check("a.off", asOff(mesh));
  EXPECT_EQ(report["inconsistent_edges"], 3);
  EXPECT_EQ(report["duplicate_faces"], 1);
  EXPECT_EQ(report["nonmanifold_edges"], 3);
  EXPECT_EQ(report["degenerate"], 1);
  EXPECT_EQ(report["unreferenced_vertices"], 1);
  EXPECT_EQ(report["non_finite"], 1);
  const auto advice = report["advice"].get<std::string>();
  EXPECT_EQ(advice.rfind("3 edges are inconsistently oriented", 0), 0u);
  EXPECT_NE(advice.find("3 edges are non-manifold"), std::string::npos) << advice;
}

TEST_F(CheckCommand, Clouds)
{
  const nlohmann::json report =
    check("a.xyz", "0 0 0 0 0 1\n1 0 0 0 0 2\n0 1 0 0 0 0\nnan 0 0 0 0 1\n");
  EXPECT_EQ(report["kind"], "points");
  EXPECT_EQ(report["points"], 4);
  EXPECT_EQ(report["normals"], true);
  EXPECT_EQ(report["non_unit_normals"], 1);
  EXPECT_EQ(report["zero_normals"], 1);
  EXPECT_EQ(report["non_finite"], 1);
  EXPECT_EQ(report["bbox"], nlohmann::json({0.0, 0.0, 0.0, 1.0, 1.0, 0.0}));
  const nlohmann::json bare = check("b.xyz", "0 0 0\n1 0 0\n");
  EXPECT_EQ(bare["normals"], false);
  EXPECT_NE(bare["advice"].get<std::string>().find("winding normals"), std::string::npos);
}

TEST_F(CheckCommand, CloudsInAllTheirFormats)
{
  const Mesh mesh = sphere(3);
  const auto points = mesh.points.size();
  // Without its triangles, a .ply is a cloud, here without normals.
  Mesh bare = mesh;
  bare.triangles.clear();
  for (const auto& [name, contents, withNormals] :
    {std::make_tuple("a.xyz", asXyz(mesh), true), std::make_tuple("a.pwn", asPwn(mesh), true),
      std::make_tuple("a.csv", asCsv(mesh), true), std::make_tuple("a.ply", asPly(bare), false)})
  {
    SCOPED_TRACE(name);
    const nlohmann::json report = check(name, contents);
    EXPECT_EQ(report["kind"], "points");
    EXPECT_EQ(report["points"], points);
    EXPECT_EQ(report["duplicates"], 0);
    EXPECT_EQ(report["normals"], withNormals);
    EXPECT_EQ(report["non_unit_normals"], 0);
    EXPECT_EQ(report["opposite_neighbors"], 0);
    // The octahedron's edges are divided in eight; the parts are longer in the middle of a face.
    EXPECT_NEAR(report["spacing_median"].get<double>(), 0.17, 0.04);
    EXPECT_LE(report["spacing_min"], report["spacing_median"]);
    EXPECT_LE(report["spacing_mean"], report["spacing_max"]);
    const auto advice = report["advice"].get<std::string>();
    EXPECT_EQ(advice.find("--estimate-normals") == std::string::npos, withNormals) << advice;
  }
}

TEST_F(CheckCommand, DuplicateAndContradictingPoints)
{
  const std::string cloud = asXyz(sphere(3));
  const nlohmann::json twice = check("a.xyz", cloud + cloud);
  EXPECT_EQ(twice["points"], 2 * twice["duplicates"].get<int>());
  EXPECT_NE(
    twice["advice"].get<std::string>().find("points lie where others do"), std::string::npos);

  std::istringstream lines(cloud);
  std::string contradicting;
  double x, y, z, nx, ny, nz;
  for (int i = 0; lines >> x >> y >> z >> nx >> ny >> nz; ++i)
  {
    const double sign = i * i % 7 < 3 ? 1 : -1; // as irregular as random numbers
    std::ostringstream line;
    line << x << " " << y << " " << z << " " << sign * nx << " " << sign * ny << " " << sign * nz;
    contradicting += line.str() + "\n";
  }
  const nlohmann::json report = check("b.xyz", contradicting);
  EXPECT_NEAR(report["opposite_neighbors"].get<double>(), 0.5, 0.1);
  EXPECT_NE(report["advice"].get<std::string>().find("% of neighbours have opposite normals"),
    std::string::npos);
}

TEST_F(CheckCommand, CloudsWithNothingUsable)
{
  const nlohmann::json zero = check("a.xyz", "0 0 0 0 0 0\n1 0 0 0 0 0\n");
  EXPECT_EQ(zero["zero_normals"], 2);
  EXPECT_EQ(zero["advice"].get<std::string>().rfind("all normals have length 0", 0), 0u);
  const nlohmann::json bad = check("b.csv", "x,y,z\nnan,0,0\n0,inf,0\n");
  EXPECT_EQ(bad["non_finite"], 2);
  EXPECT_TRUE(bad["bbox"].is_null());
  EXPECT_EQ(bad["advice"], "nothing to evaluate: all points are NaN or infinite");
}

TEST_F(CheckCommand, FieldDataOfTheFileIsNoPartOfTheReport)
{
  const std::string mesh = asVtk(sphere(2));
  const std::size_t data = mesh.find("DATASET");
  ASSERT_NE(data, std::string::npos);
  const std::string named = "FIELD FieldData 2\nclosed 1 1 int\n0\nother 1 1 int\n3\n";
  const std::size_t lineEnd = mesh.find('\n', data) + 1;
  const nlohmann::json report =
    check("a.vtk", mesh.substr(0, lineEnd) + named + mesh.substr(lineEnd));
  EXPECT_EQ(report["closed"], true);
  EXPECT_FALSE(report.contains("other"));
}

TEST_F(CheckCommand, SurfacesWithBadTrianglesOnlyAreRefused)
{
  const Outcome run =
    runProgram({"check", folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\nnan 0 1\n3 0 1 2\n")});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"a.off", "all 1 triangles are unusable"})) << run;
}

/// The names in a folder, in alphabetical order.
std::vector<std::string> namesIn(const std::string& path)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Mesh shuffledSphere()
{
  Mesh mesh = sphere(3);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (i * i % 7 < 4)
    {
      std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
  }
  return mesh;
}

TEST_F(CheckCommand, InvertedSurfaces)
{
  Mesh mesh = sphere(2);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const nlohmann::json report = check("a.off", asOff(mesh));
  EXPECT_EQ(report["closed_components"], 1);
  EXPECT_EQ(report["inverted_components"], 1);
  EXPECT_EQ(report["nested_solids"], 0);
  EXPECT_EQ(report["one_sided_components"], 0);
  EXPECT_EQ(report["fractional_share"], 0);
  EXPECT_FALSE(report.contains("flipped_triangles"));
  EXPECT_NE(report["advice"].get<std::string>().find("--orient"), std::string::npos);
}

TEST_F(CheckCommand, FixesTheOrientationAndWritesTheResult)
{
  const std::string in = folder.write("in.off", asOff(shuffledSphere()));
  for (const std::string name : {"out.vtp", "out.ply", "out.stl", "out.obj"})
  {
    const std::string out = folder.path(name);
    const Outcome run = runProgram({"check", in, "--fix-orientation", "-o", out, "--json"});
    ASSERT_EQ(run.status, 0) << run;
    const nlohmann::json fixed = run.json();
    EXPECT_EQ(fixed["closed"], true);
    EXPECT_GT(fixed["flipped_triangles"], 100);
    EXPECT_EQ(fixed["flipped_components"], 1);
    EXPECT_EQ(fixed["output"]["file"], out);
    EXPECT_EQ(fixed["output"]["cells"], sphere(3).triangles.size());
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run;

    const nlohmann::json again = runProgram({"check", out, "--json"}).json();
    EXPECT_EQ(again["closed"], true);
    EXPECT_EQ(again["inverted_components"], 0);
    EXPECT_NEAR(again["volume"].get<double>(), fixed["volume"].get<double>(), 1e-4);
  }
  const Outcome dry = runProgram({"check", in, "--fix-orientation"});
  EXPECT_EQ(dry.status, 0) << dry;
  EXPECT_NE(dry.out.find("\nflipped components     1\n"), std::string::npos) << dry;
}

TEST_F(CheckCommand, WritesFaultsAsBlocks)
{
  Mesh mesh = sphere(3);
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const std::string in = folder.write("in.off", asOff(mesh));
  const std::string out = folder.path("what is <wrong>.vtm");
  const std::string blocks = folder.path("what is <wrong>");
  const Outcome run = runProgram({"check", in, "--blocks", out, "--json"});
  ASSERT_EQ(run.status, 0) << run;
  const nlohmann::json cells = run.json()["blocks"]["cells"];
  EXPECT_EQ(run.json()["blocks"]["file"], out);
  EXPECT_EQ(cells["InconsistentEdges"], 3);
  EXPECT_EQ(cells["NonManifoldEdges"], 0);
  EXPECT_GE(cells["Boundary"], 2);
  EXPECT_EQ(namesIn(blocks),
    (std::vector<std::string>{"Boundary.vtp", "Caps.vtp", "InconsistentEdges.vtp"}));
  const std::string index = contentsOf(out);
  EXPECT_NE(index.find("name=\"Caps\" file=\"what is &lt;wrong&gt;/Caps.vtp\""), std::string::npos)
    << index;
  // The caps close the surface.
  const nlohmann::json caps = runProgram({"check", blocks + "/Caps.vtp", "--json"}).json();
  EXPECT_EQ(caps["triangles"], cells["Caps"]);

  // A second run writes over the blocks of the first, and its text says so.
  const Outcome again = runProgram({"check", in, "--blocks", out});
  EXPECT_EQ(again.status, 0) << again;
  EXPECT_NE(again.out.find("\nwrote " + out + "\n"), std::string::npos) << again;
  EXPECT_EQ(contentsOf(out), index);
  EXPECT_EQ(namesIn(blocks).size(), 3u);
}

TEST_F(CheckCommand, BlocksOfAnEarlierRunThatAreNoMoreAreRemoved)
{
  Mesh mesh = sphere(3);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const std::string turned = folder.write("turned.off", asOff(mesh));
  mesh = sphere(3);
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  const std::string open = folder.write("open.off", asOff(mesh));
  const std::string closed = folder.write("closed.off", asOff(sphere(3)));
  const std::string out = folder.path("faults & more.vtm"), blocks = folder.path("faults & more");
  using Names = std::vector<std::string>;
  ASSERT_EQ(runProgram({"check", turned, "--blocks", out}).status, 0);
  EXPECT_EQ(namesIn(blocks), (Names{"Boundary.vtp", "Caps.vtp", "InconsistentEdges.vtp"}));
  folder.write("faults & more/mine.vtp", "no block");
  for (const bool overwrites : {false, true})
  {
    Names command = {"check", open, "--blocks", out};
    if (overwrites)
    {
      command.emplace_back("--overwrite");
    }
    const Outcome run = runProgram(command);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run;
    EXPECT_EQ(namesIn(blocks), (Names{"Boundary.vtp", "Caps.vtp", "mine.vtp"}));
  }
  ASSERT_EQ(runProgram({"check", closed, "--blocks", out}).status, 0);
  EXPECT_EQ(namesIn(blocks), Names{"mine.vtp"});
  EXPECT_EQ(contentsOf(blocks + "/mine.vtp"), "no block");
}

TEST_F(CheckCommand, BlocksThatCannotBeWrittenLeaveNothingHalf)
{
  const std::string in = folder.write("in.off", asOff(sphere(2)));
  folder.write("taken", "a file");
  ASSERT_EQ(std::system(("mkdir " + folder.path("mine")).c_str()), 0);
  folder.write("mine/Caps.vtp", "what was there before");
  const Outcome mine = runProgram({"check", in, "--blocks", folder.path("mine.vtm")});
  EXPECT_EQ(mine.status, 2) << mine;
  EXPECT_TRUE(mine.saysInOneLine({"mine.vtm", "holds other files"})) << mine;
  folder.write("mine.vtm", "notes");
  EXPECT_EQ(runProgram({"check", in, "--blocks", folder.path("mine.vtm")}).status, 2);
  std::filesystem::remove(folder.path("mine.vtm"));
  EXPECT_EQ(contentsOf(folder.path("mine/Caps.vtp")), "what was there before");
  const Outcome taken = runProgram({"check", in, "--blocks", folder.path("taken.vtm")});
  EXPECT_EQ(taken.status, 2) << taken;
  EXPECT_TRUE(taken.saysInOneLine({"taken.vtm", "cannot be made"})) << taken;
  const Outcome nowhere = runProgram({"check", in, "--blocks", "/proc/out.vtm"});
  EXPECT_EQ(nowhere.status, 2) << nowhere;
  EXPECT_TRUE(nowhere.saysInOneLine({"/proc/out.vtm", "cannot be made"})) << nowhere;

  Mesh open = sphere(5);
  for (std::size_t i = 0; i + 3 < open.triangles.size(); i += 3)
  {
    std::swap(open.triangles[i][0], open.triangles[i][1]);
  }
  const std::string large = folder.write("large.off", asOff(open));
  const Outcome full =
    runProgram({"check", large, "--blocks", folder.path("out.vtm")}, "ulimit -f 8; ");
  EXPECT_EQ(full.status, 2) << full;
  EXPECT_TRUE(full.saysInOneLine({"Caps.vtp", "cannot be written"})) << full;
  EXPECT_EQ(
    namesIn(folder.path("")), (std::vector<std::string>{"in.off", "large.off", "mine", "taken"}));
}

TEST_F(CheckCommand, TurnsNormalsOfACloud)
{
  Mesh ball = sphere(3);
  std::string text = asXyz(ball);
  std::istringstream lines(text);
  std::string turned;
  int number = 0;
  for (std::string line; std::getline(lines, line); ++number)
  {
    std::istringstream words(line);
    double x, y, z, nx, ny, nz;
    words >> x >> y >> z >> nx >> ny >> nz;
    const int sign = x > 0.3 ? -1 : 1;
    std::ostringstream out;
    out << x << " " << y << " " << z << " " << sign * nx << " " << sign * ny << " " << sign * nz;
    turned += out.str() + "\n";
  }
  const std::string vtp = folder.path("out.vtp");
  const Outcome run = runProgram(
    {"check", folder.write("turned.xyz", turned), "--fix-orientation", "-o", vtp, "--json"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_GT(run.json()["flipped_normals"], 0.2 * number);
  EXPECT_LT(run.json()["flipped_normals"], 0.5 * number);
  EXPECT_EQ(run.json()["outward_share"], 1) << run;
  const Outcome again = runProgram({"check", vtp, "--json"});
  EXPECT_EQ(again.json()["outward_share"], 1) << again;
}

TEST_F(CheckCommand, RefusesOptionsThatMakeNoSense)
{
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  const std::string cloud = folder.write("in.xyz", asXyz(sphere(1)));
  const std::string points = folder.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::string vtp = folder.path("out.vtp"), vtm = folder.path("out.vtm");
  for (const auto& [arguments, status, part] :
    {std::make_tuple(std::vector<std::string>{in, "-o", vtp}, 1, "--fix-orientation"),
      std::make_tuple(
        std::vector<std::string>{in, "--fix-orientation", "-o", "out.vti"}, 1, ".vtp .ply"),
      std::make_tuple(std::vector<std::string>{in, "--blocks", vtp}, 1, ".vtm"),
      std::make_tuple(std::vector<std::string>{cloud, "--blocks", vtm}, 2, "has no faces"),
      std::make_tuple(
        std::vector<std::string>{points, "--fix-orientation", "-o", vtp}, 2, "or give normals")})
  {
    std::vector<std::string> command = {"check"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome run = runProgram(command);
    EXPECT_EQ(run.status, status) << run;
    EXPECT_TRUE(run.saysInOneLine({part})) << run;
  }
  EXPECT_EQ(namesIn(folder.path("")), (std::vector<std::string>{"in.off", "in.xyz", "points.xyz"}));
}

TEST_F(CheckCommand, TextBeginsWithAdviceByPoint)
{
  const Outcome run = runProgram({"check", folder.write("a.off", asOff(sphere(1)))});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("\nboundary edges         0\n"), std::string::npos) << run;
  EXPECT_EQ(run.out.rfind("nothing to mend; closed: every winding number is an integer\n\n", 0), 0u)
    << run;
  Mesh mesh = sphere(1);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  const Outcome inward = runProgram({"check", folder.write("b.off", asOff(mesh))});
  EXPECT_EQ(inward.out.rfind("inside out: use --rule absolute, or turn the faces "
                             "(--fix-orientation, --orient)\nclosed:",
              0),
    0u)
    << inward;
}

/// Compares with the values that another program found in the real meshes.
TEST(CheckReference, Manifest)
{
  const std::string shared = WINDING_SHARED_DATA;
  std::istringstream stream(contentsOf(shared + "/MANIFEST.tsv"));
  const auto row = [&stream]
  {
    std::string line, field;
    std::getline(stream, line);
    std::istringstream fields(line);
    std::vector<std::string> result;
    while (std::getline(fields, field, '\t'))
    {
      result.push_back(field);
    }
    return result;
  };
  const std::vector<std::string> names = row();
  int meshes = 0;
  for (std::vector<std::string> values = row(); !values.empty(); values = row())
  {
    const Outcome run = runProgram({"check", shared + "/" + values[1], "--json"});
    ASSERT_EQ(run.status, 0) << run;
    const nlohmann::json report = run.json();
    ++meshes;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      // VTK's OBJ reader makes several vertices of a corner with different normals, so "vertices"
      // differs. The volume of an open surface depends on the origin.
      const bool comparable = report.contains(names[i]) && names[i] != "bbox" &&
                              names[i] != "vertices" &&
                              (names[i] != "volume" || report["closed"] == true);
      if (!comparable)
      {
        continue;
      }
      const nlohmann::json& found = report[names[i]];
      if (names[i] == "volume")
      {
        EXPECT_NEAR(
          found.get<double>(), std::stod(values[i]), 1e-5 * std::abs(std::stod(values[i])));
      }
      else
      {
        EXPECT_EQ(found.is_boolean() ? (found == true ? "yes" : "no") : found.dump(), values[i])
          << names[i] << " of " << values[1];
      }
    }
  }
  EXPECT_GE(meshes, 3);
}

} // namespace
