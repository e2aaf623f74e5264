// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Surfaces as people have them, whose winding numbers mean something else than their owners expect:
// the program says so in a line, and what to do.

namespace
{

using Polygons = std::vector<std::vector<int>>;
using Points = std::vector<std::array<double, 3>>;

/// An OBJ file of polygons.
std::string asObj(const Points& points, const Polygons& polygons)
{
  std::ostringstream text;
  text.precision(17);
  for (const auto& p : points)
  {
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  for (const std::vector<int>& polygon : polygons)
  {
    text << "f";
    for (const int point : polygon)
    {
      text << " " << point + 1;
    }
    text << "\n";
  }
  return text.str();
}

/// The quadrilaterals of a box, outward.
Polygons facesOfBox(int first = 0)
{
  Polygons faces = {
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (std::vector<int>& face : faces)
  {
    for (int& point : face)
    {
      point += first;
    }
  }
  return faces;
}

Points cornersOfBox(double x0, double x1, double side)
{
  return {{x0, 0, 0}, {x1, 0, 0}, {x1, side, 0}, {x0, side, 0}, {x0, 0, side}, {x1, 0, side},
    {x1, side, side}, {x0, side, side}};
}

Polygons reversed(Polygons polygons)
{
  for (std::vector<int>& polygon : polygons)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  return polygons;
}

template <class T> std::vector<T> joined(std::vector<T> first, const std::vector<T>& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// A height field over a square, which looks up.
std::string terrain(int cells)
{
  Points points;
  Polygons faces;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = static_cast<double>(i) / cells, y = static_cast<double>(j) / cells;
      points.push_back({x, y, 0.2 + 0.1 * std::sin(9 * x) * std::cos(7 * y)});
      const int p = j * (cells + 1) + i;
      if (i < cells && j < cells)
      {
        faces.push_back({p, p + 1, p + cells + 2, p + cells + 1});
      }
    }
  }
  return asObj(points, faces);
}

class SurfaceInputs : public testing::Test
{
protected:
  /// The part of a grid's samples that are inside, and what the program warns of.
  Outcome fieldOf(const std::string& file, const std::vector<std::string>& options = {})
  {
    std::vector<std::string> arguments = {
      "field", file, "-o", folder.path("out.vti"), "--resolution", "24", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    return run;
  }

  /// The winding number at a place, by the program.
  double windingAt(const std::string& file, const std::array<double, 3>& place,
    const std::vector<std::string>& options = {})
  {
    std::ostringstream row;
    row << "x,y,z\n" << place[0] << "," << place[1] << "," << place[2] << "\n";
    const std::string out = folder.path("w.csv");
    std::vector<std::string> arguments = {
      "probe", file, folder.write("place.csv", row.str()), "-o", out, "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    std::istringstream table(contentsOf(out));
    std::string field;
    std::getline(table, field);
    for (int column = 0; column < 4; ++column)
    {
      std::getline(table, field, ',');
    }
    return std::stod(field);
  }

  TemporaryFolder folder;
};

int count(const std::string& text, const std::string& part)
{
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++found;
  }
  return found;
}

TEST_F(SurfaceInputs, FacesDrawnFromBothSidesAreToldAndTakenOnce)
{
  const Points corners = cornersOfBox(0, 1, 1);
  // A reversed polygon begins at another corner, and so is cut along its other diagonal.
  const std::string twoSided =
    folder.write("both.obj", asObj(corners, joined(facesOfBox(), reversed(facesOfBox()))));
  EXPECT_EQ(windingAt(twoSided, {0.5, 0.5, 0.4}), 0);
  const Outcome bare = fieldOf(twoSided);
  EXPECT_EQ(count(bare.err, "every face is there with both senses"), 1) << bare;
  EXPECT_EQ(count(bare.err, "--orient"), 1) << bare;
  EXPECT_EQ(windingAt(twoSided, {0.5, 0.5, 0.4}, {"--orient"}), 1);
  EXPECT_EQ(fieldOf(twoSided, {"--orient"}).err, "");
  const Outcome check = runProgram({"check", twoSided});
  EXPECT_NE(check.out.find("every face is there with both senses"), std::string::npos) << check;

  const std::string fixed = folder.path("fixed.obj");
  const Outcome fix = runProgram({"check", twoSided, "--fix-orientation", "-o", fixed, "--json"});
  EXPECT_EQ(fix.json()["left_out_faces"], 6);
  EXPECT_EQ(fix.json()["volume"], 1);
  EXPECT_EQ(windingAt(fixed, {0.5, 0.5, 0.4}), 1);

  // Some of them only, and faces that are there twice in the same sense.
  Polygons some = facesOfBox();
  const Polygons back = reversed(facesOfBox());
  some.insert(some.begin() + 1, back.begin(), back.begin() + 4);
  const std::string partly = folder.write("some.obj", asObj(corners, some));
  EXPECT_EQ(count(fieldOf(partly).err, "faces are there more than once"), 1);
  EXPECT_EQ(windingAt(partly, {0.5, 0.5, 0.4}, {"--orient"}), 1);
  const std::string ofCheck = runProgram({"check", partly}).out;
  EXPECT_NE(ofCheck.find("take each once (--fix-orientation, --orient)"), std::string::npos)
    << ofCheck;
  const std::string twice =
    folder.write("twice.obj", asObj(corners, joined(facesOfBox(), facesOfBox())));
  EXPECT_EQ(windingAt(twice, {0.5, 0.5, 0.4}), 2);
  EXPECT_EQ(count(fieldOf(twice).err, "faces are there more than once: they add up, or cancel"), 1);
  EXPECT_EQ(windingAt(twice, {0.5, 0.5, 0.4}, {"--orient"}), 1);
  const nlohmann::json report = runProgram({"check", twice, "--json"}).json();
  EXPECT_DOUBLE_EQ(report["volume"].get<double>(), 2) << "the integral of w";
  EXPECT_EQ(report["duplicate_faces"], 12);
}

TEST_F(SurfaceInputs, StackedBoxesKeepTheirWalls)
{
  const std::string stack =
    folder.write("stack.obj", asObj(joined(cornersOfBox(0, 1, 1), cornersOfBox(1, 2, 1)),
                                joined(facesOfBox(), facesOfBox(8))));
  for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--orient"}})
  {
    EXPECT_EQ(windingAt(stack, {0.5, 0.5, 0.4}, options), 1);
    EXPECT_EQ(windingAt(stack, {1.5, 0.5, 0.4}, options), 1);
    EXPECT_EQ(fieldOf(stack, options).err, "");
  }
}

TEST_F(SurfaceInputs, BafflesAreCountedAndMayBeLeftOut)
{
  Points points = cornersOfBox(0, 6, 2);
  Polygons faces = facesOfBox();
  for (int baffle = 1; baffle <= 5; ++baffle)
  {
    const auto first = static_cast<int>(points.size());
    const double x = baffle;
    points = joined(points, {{x, 0.2, 0.2}, {x, 1.8, 0.2}, {x, 1.8, 1.8}, {x, 0.2, 1.8}});
    faces.push_back({first, first + 1, first + 2, first + 3});
  }
  const std::string tank = folder.write("tank.obj", asObj(points, faces));
  const nlohmann::json report = runProgram({"check", tank, "--json"}).json();
  EXPECT_EQ(report["open_parts_inside"], 5);
  EXPECT_NE(report["advice"].get<std::string>().find("--ignore-open-parts"), std::string::npos);
  EXPECT_NE(windingAt(tank, {1.01, 1, 1}), 1);
  const Outcome bare = fieldOf(tank);
  EXPECT_EQ(count(bare.err, "open parts lie inside of closed ones"), 1) << bare;
  EXPECT_EQ(count(bare.err, "--ignore-open-parts"), 1) << bare;
  EXPECT_EQ(fieldOf(tank, {"--ignore-open-parts"}).err, "");
  EXPECT_EQ(windingAt(tank, {1.01, 1, 1}, {"--ignore-open-parts"}), 1);
  EXPECT_EQ(windingAt(tank, {0.99, 1, 1}, {"--ignore-open-parts"}), 1);
  const Outcome labels = runProgram({"labels", tank, "-o", folder.path("labels.vti"),
    "--resolution", "24", "--ignore-open-parts", "--json"});
  EXPECT_EQ(labels.json()["labels"].size(), 1u) << labels;
  EXPECT_EQ(labels.err, "");
  const Outcome bareLabels =
    runProgram({"labels", tank, "-o", folder.path("labels.vti"), "--resolution", "24"});
  EXPECT_EQ(count(bareLabels.err, "warning"), 1) << bareLabels;
  EXPECT_EQ(count(bareLabels.err, "open parts lie inside of closed ones"), 1) << bareLabels;
}

TEST_F(SurfaceInputs, TerrainIsNoInwardSolid)
{
  const std::string file = folder.write("terrain.obj", terrain(24));
  const Outcome bare = fieldOf(file);
  EXPECT_EQ(count(bare.err, "the surface is open on a whole side"), 1) << bare;
  EXPECT_EQ(count(bare.err, "(--sheet-side)"), 1) << bare;
  EXPECT_EQ(count(bare.err, "look inward"), 0) << bare;
  EXPECT_EQ(count(bare.err, "--close-border"), 0) << bare;
  // A surface ends at the border of the grid.
  const Outcome slab = runProgram({"surface", file, "-o", folder.path("slab.vtp"), "--as-is"});
  EXPECT_EQ(count(slab.err, "(--sheet-side, --close-border)"), 1) << slab;
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--threshold", "0"},
         {"--sheet-side", "down"}, {"--flat-base", "z=-0.1"}})
  {
    std::vector<std::string> arguments = {
      "surface", file, "-o", folder.path("slab.vtp"), "--close-border"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome closed = runProgram(arguments);
    EXPECT_EQ(closed.err, "");
    const Outcome checked = runProgram({"check", folder.path("slab.vtp"), "--json"});
    EXPECT_EQ(checked.json()["boundary_edges"].get<int>(), 0) << checked;
  }
  EXPECT_NE(runProgram({"check", file}).out.find("open on a whole side"), std::string::npos);
  // Then all that lies below is inside.
  EXPECT_GT(windingAt(file, {0.5, 0.5, 0.02}), 0);
  EXPECT_LT(windingAt(file, {0.5, 0.5, 0.4}), 0);
  EXPECT_GT(windingAt(file, {0.5, 0.5, 0.02}, {"--sheet-side", "down"}), 0.5);
  EXPECT_LT(windingAt(file, {0.5, 0.5, 0.02}, {"--sheet-side", "up"}), 0.5);
  EXPECT_EQ(windingAt(file, {0.5, 0.5, 0.02}, {"--flat-base", "z=-1"}), 1);
  EXPECT_EQ(windingAt(file, {0.5, 0.5, 0.4}, {"--flat-base", "z=-1"}), 0);
}

TEST_F(SurfaceInputs, WrongPlanesAndSidesAreRefused)
{
  const std::string file = folder.write("terrain.obj", terrain(4));
  for (const auto& [option, value, says] :
    {std::tuple<const char*, const char*, const char*>{"--mirror", "up", "--mirror is no plane"},
      {"--flat-base", "z", "--flat-base is no side"},
      {"--sheet-side", "z=0", "--sheet-side is no direction"},
      {"--weld-tolerance", "-1", "--weld-tolerance is -1"}})
  {
    const Outcome run =
      runProgram({"field", file, "-o", folder.path("refused.vti"), option, value});
    EXPECT_NE(run.status, 0) << run;
    EXPECT_EQ(count(run.err, says), 1) << run;
  }
  // A base that closes nothing says so.
  const Outcome idle = fieldOf(file, {"--flat-base", "+x"});
  EXPECT_EQ(count(idle.err, "--flat-base closes nothing"), 1) << idle;
}

TEST_F(SurfaceInputs, AHalfHullNamesThePlanesWhereItIsOpen)
{
  // A quarter of a sphere, open at y = 0 and at z = 0.
  Mesh quarter = sphere(4);
  const auto isElsewhere = [&quarter](const std::array<int, 3>& t)
  {
    const auto middle = [&](int axis)
    {
      return quarter.points[t[0]][axis] + quarter.points[t[1]][axis] + quarter.points[t[2]][axis];
    };
    return middle(1) < 0 || middle(2) > 0;
  };
  quarter.triangles.erase(
    std::remove_if(quarter.triangles.begin(), quarter.triangles.end(), isElsewhere),
    quarter.triangles.end());
  const std::string hull = folder.write("hull.obj", ::asObj(quarter));
  const Outcome check = runProgram({"check", hull});
  EXPECT_NE(check.out.find("at y = 0 and z = 0"), std::string::npos) << check;
  EXPECT_NE(check.out.find("(--flat-base, --mirror)"), std::string::npos) << check;
  // Two images make the whole ball.
  const nlohmann::json whole =
    runProgram({"check", hull, "--mirror", "y=0", "--mirror", "z=0", "--json"}).json();
  EXPECT_EQ(whole["closed"], true);
  EXPECT_EQ(whole["euler"], 2);
  const nlohmann::json based =
    runProgram({"check", hull, "--mirror", "y=0", "--flat-base", "z=0", "--json"}).json();
  EXPECT_EQ(based["closed"], true);
  EXPECT_NEAR(based["volume"].get<double>(), whole["volume"].get<double>() / 2, 1e-9);
  EXPECT_EQ(count(fieldOf(hull).err, "at y = 0 and z = 0"), 1);
}

TEST_F(SurfaceInputs, ThinWallsAreToldWithTheResolutionThatKeepsThem)
{
  // A hollow box whose walls have a hundredth of its side.
  Points points = cornersOfBox(0, 1, 1);
  for (const auto& p : cornersOfBox(0, 1, 1))
  {
    points.push_back({0.01 + 0.98 * p[0], 0.01 + 0.98 * p[1], 0.01 + 0.98 * p[2]});
  }
  const std::string hollow =
    folder.write("hollow.obj", asObj(points, joined(facesOfBox(), reversed(facesOfBox(8)))));
  for (const std::string command : {"field", "surface", "voxels"})
  {
    const std::string out = command == "field" ? "a.vti" : "a.vtp";
    const Outcome run = runProgram({command, hollow, "-o", folder.path(out), "--resolution", "40"});
    EXPECT_EQ(count(run.err, "parts are thinner than a voxel"), 1) << command << run;
    EXPECT_EQ(count(run.err, "a resolution of 120 would keep it"), 1) << command << run;
    EXPECT_EQ(count(run.err, "--coverage any"), command == "surface" ? 0 : 1) << command << run;
    const Outcome fine =
      runProgram({command, hollow, "-o", folder.path(out), "--resolution", "110"});
    EXPECT_EQ(fine.err, "") << command;
  }
  std::vector<std::string> arguments = {
    "field", hollow, "--resolution", "40", "-o", folder.path("a.vti"), "--pieces", "4"};
  const Outcome inPieces = runProgram(arguments);
  EXPECT_EQ(count(inPieces.err, "parts are thinner than a voxel"), 1) << inPieces;
  EXPECT_EQ(count(inPieces.err, "--coverage any"), 1) << inPieces;
  arguments.insert(arguments.end(), {"--coverage", "any"});
  EXPECT_EQ(count(runProgram(arguments).err, "thinner"), 0);
  // Labels without any voxel say that; here walls across x are lost alone.
  const Outcome inPart = runProgram({"labels", hollow, "-o", folder.path("a.vti"), "--dims", "40",
    "30", "30", "--coverage", "center"});
  EXPECT_EQ(count(inPart.err, "parts are thinner than a voxel"), 1) << inPart;
  EXPECT_EQ(count(inPart.err, "1 of 1 solid ('Part 1')"), 1) << inPart;
  const Outcome covered = runProgram(
    {"voxels", hollow, "-o", folder.path("a.vtp"), "--resolution", "40", "--coverage", "any"});
  EXPECT_EQ(covered.err, "");
}

TEST_F(SurfaceInputs, FacesThatContradictEachOtherAreTold)
{
  Polygons faces = facesOfBox();
  std::reverse(faces[1].begin(), faces[1].end());
  const std::string box = folder.write("box.obj", asObj(cornersOfBox(0, 1, 1), faces));
  const Outcome bare = fieldOf(box);
  EXPECT_EQ(count(bare.err, "faces contradict each other"), 1) << bare;
  EXPECT_EQ(count(bare.err, "at 4 edges"), 1) << bare;
  EXPECT_EQ(fieldOf(box, {"--orient"}).err, "");
  EXPECT_EQ(windingAt(box, {0.5, 0.5, 0.4}, {"--orient"}), 1);

  // A band with a half twist.
  Points points;
  Polygons band;
  const int quads = 20;
  for (int i = 0; i < quads; ++i)
  {
    const double angle = 2 * 3.141592653589793 * i / quads;
    for (const double side : {-0.3, 0.3})
    {
      const double r = 1 + side * std::cos(angle / 2);
      points.push_back({r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2)});
    }
    const int a = 2 * i, next = i + 1 < quads ? a + 2 : 1, other = i + 1 < quads ? a + 3 : 0;
    band.push_back({a, next, other, a + 1});
  }
  const Outcome twisted = fieldOf(folder.write("band.obj", asObj(points, band)));
  EXPECT_EQ(count(twisted.err, "1 part has one side only"), 1) << twisted;
  EXPECT_EQ(count(twisted.err, "contradict"), 0) << twisted;
}

TEST_F(SurfaceInputs, SeveralFilesAreOneSource)
{
  // A channel without its ends, and the ends in files of other formats.
  const Points corners = cornersOfBox(0, 6, 1);
  const Polygons faces = facesOfBox();
  const std::string walls =
    folder.write("walls.obj", asObj(corners, {faces[0], faces[1], faces[2], faces[4]}));
  const std::string inlet = folder.write("inlet.stl", asStl({corners, {{3, 0, 4}, {3, 4, 7}}}));
  const std::string outlet = folder.write("outlet.off", asOff({corners, {{1, 2, 6}, {1, 6, 5}}}));
  const std::string box = folder.write("box.obj", asObj(corners, faces));

  const nlohmann::json report = runProgram({"check", walls, inlet, outlet, "--json"}).json();
  EXPECT_EQ(report["closed"], true) << report;
  EXPECT_NEAR(report["volume"], 6, 1e-9);
  EXPECT_EQ(runProgram({"check", walls, inlet, "--json"}).json()["closed"], false);
  for (const std::string command : {"field", "surface", "voxels"})
  {
    const std::string suffix = command == "field" ? ".vti" : ".ply";
    const std::string parts = folder.path("parts" + suffix), whole = folder.path("whole" + suffix);
    const Outcome run = runProgram({command, walls, inlet, outlet, "-o", parts});
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find(walls + " and 2 more: "), std::string::npos) << run;
    EXPECT_EQ(runProgram({command, box, "-o", whole}).status, 0);
    EXPECT_EQ(contentsOf(parts), contentsOf(whole)) << command;
  }
  const std::string queries = folder.write("queries.csv", "x,y,z\n3,0.5,0.5\n3,0.5,1.5\n");
  const std::string answers = folder.path("answers.csv");
  EXPECT_EQ(runProgram({"probe", walls, inlet, outlet, queries, "-o", answers}).err, "");
  EXPECT_EQ(contentsOf(answers), "x,y,z,WindingNumber,Inside\n3,0.5,0.5,1,1\n3,0.5,1.5,0,0\n");

  // Refusals name the files, and no file that is read is replaced.
  const std::string cloud = folder.write("ball.xyz", asXyz(sphere(2)));
  EXPECT_TRUE(runProgram({"field", box, cloud, "-o", folder.path("no.vti")})
                .saysInOneLine({box + " and 1 more: ", "mixes surfaces and point clouds"}));
  EXPECT_TRUE(runProgram({"field", box, folder.path("none.stl"), "-o", folder.path("no.vti")})
                .saysInOneLine({"none.stl: "}));
  EXPECT_TRUE(runProgram({"surface", walls, inlet, "-o", inlet}).saysInOneLine({"inlet.stl"}));
  EXPECT_TRUE(runProgram({"probe", box, "-o", answers}).saysInOneLine({"QUERIES is required"}));
}

TEST_F(SurfaceInputs, FilesInAnotherUnitAreTold)
{
  const Points corners = cornersOfBox(0, 6000, 1000);
  const Polygons faces = facesOfBox();
  const std::string walls =
    folder.write("walls.obj", asObj(corners, {faces[0], faces[1], faces[2], faces[4]}));
  const Points last = {corners[1], corners[2], corners[6], corners[5]};
  const std::string outlet = folder.write("outlet.off", asOff({last, {{0, 1, 2}, {0, 2, 3}}}));
  const auto inletTimes = [&](double scale)
  {
    Points ends = {corners[3], corners[0], corners[4], corners[7]};
    for (auto& end : ends)
    {
      end = {scale * end[0], scale * end[1], scale * end[2]};
    }
    return folder.write("inlet.obj", asObj(ends, {{0, 1, 2, 3}}));
  };
  const auto warningsOf = [&](const std::string& inlet)
  {
    return runProgram({"surface", walls, inlet, outlet, "-o", folder.path("out.ply")}).err;
  };
  EXPECT_EQ(warningsOf(inletTimes(1)), "");
  for (const auto& [unit, factor] : {std::make_pair(1000.0, "1000"), {25.4, "25.4"}})
  {
    const std::string warnings = warningsOf(inletTimes(1 / unit));
    const std::string expected =
      std::string("'inlet' seems to be in another unit: scale it by ") + factor + ";";
    EXPECT_NE(warnings.find(expected), std::string::npos) << warnings;
    EXPECT_EQ(warnings.find(expected, warnings.find(expected) + 1), std::string::npos) << "once";
  }
  // Solids of labels are compared, too. A bolt next to a ship is none in another unit.
  const std::string box = folder.write("box.obj", asObj(corners, faces));
  const std::string small = folder.write("small.obj", asObj(cornersOfBox(6, 12, 1), faces));
  const std::string bolt = folder.write("bolt.obj", asObj(cornersOfBox(2, 2.5, 0.1), faces));
  const auto labelled = [&](const std::string& other)
  {
    return runProgram({"labels", box, other, "-o", folder.path("labels.vti"), "--resolution", "8"})
      .err;
  };
  EXPECT_NE(labelled(small).find("'small' seems to be in another unit"), std::string::npos)
    << labelled(small);
  EXPECT_EQ(labelled(bolt).find("another unit"), std::string::npos) << labelled(bolt);
}

TEST_F(SurfaceInputs, PointsHaveNoFacesToTurn)
{
  const Outcome run = fieldOf(folder.write("ball.xyz", asXyz(sphere(3))), {"--orient"});
  EXPECT_EQ(count(run.err, "points have no faces to turn"), 1) << run;
}

} // namespace
