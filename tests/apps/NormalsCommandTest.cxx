// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <iomanip>
#include <limits>
#include <sstream>
#include <thread>

#include <sys/wait.h>

namespace
{

using Places = std::vector<std::array<double, 3>>;

/// The points of two nested spheres, on which the spanning tree fails.
Places shell(int levels = 4)
{
  Places places;
  for (const double radius : {1.0, 0.6})
  {
    for (const auto& at : sphere(levels).points)
    {
      places.push_back({radius * at[0] + 0.1, radius * at[1] + 0.2, radius * at[2] + 0.3});
    }
  }
  return places;
}

std::string asBareXyz(const Places& places)
{
  std::ostringstream text;
  text << std::setprecision(17);
  for (const auto& at : places)
  {
    text << at[0] << " " << at[1] << " " << at[2] << "\n";
  }
  return text.str();
}

class NormalsCommand : public testing::Test
{
protected:
  Outcome run(const std::string& in, const std::string& out, std::vector<std::string> options = {})
  {
    options.insert(options.begin(), {"normals", in, "-o", folder.path(out)});
    return runProgram(options);
  }

  /// The field of a file, in double precision.
  std::vector<double> fieldOf(const std::string& in, std::vector<std::string> options = {})
  {
    const std::string out = folder.path("field.vti");
    options.insert(
      options.begin(), {"field", in, "-o", out, "--resolution", "8", "--double", "--quiet"});
    const Outcome run = runProgram(options);
    EXPECT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(out.c_str());
    reader->Update();
    std::vector<double> values;
    vtkDataArray* const array = reader->GetOutput()->GetPointData()->GetArray("WindingNumber");
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetTuple1(i));
    }
    EXPECT_EQ(values.size(), 512u);
    return values;
  }

  TemporaryFolder folder;
};

TEST_F(NormalsCommand, ComeBackWithTheFieldOfEstimatedOnesFromEveryFormat)
{
  const std::string in = folder.write("in.xyz", asBareXyz(shell()));
  for (const std::string estimation : {"auto", "tree", "consistent"})
  {
    const std::vector<double> expected =
      this->fieldOf(in, {"--estimate-normals", "--normal-estimation", estimation});
    for (const std::string out : {"a.ply", "a.xyz", "a.pwn", "a.csv", "a.vtp", "a.vtu"})
    {
      const Outcome outcome =
        this->run(in, out, {"--normal-estimation", estimation, "--json", "--quiet"});
      ASSERT_EQ(outcome.status, 0) << outcome;
      const nlohmann::json input = outcome.json()["input"];
      EXPECT_EQ(input["normals_estimated"], true);
      EXPECT_EQ(
        input["normal_estimation"], estimation == "tree" ? "spanning tree" : "winding consistent");
      EXPECT_EQ(input["clear_share"] > 0.98, estimation != "tree") << outcome; // 1 and 0.66
      EXPECT_EQ(outcome.json()["output"]["points"], input["primitives"]);
      EXPECT_EQ(this->fieldOf(folder.path(out)), expected) << out << " " << estimation;
    }
    for (const std::string out : {"a.csv", "a.vtp"})
    {
      EXPECT_EQ(this->fieldOf(folder.path(out), {"--areas", "array"}), expected) << out;
    }
  }
  ASSERT_EQ(this->run(in, "a.tsv").status, 0);
  const std::string header = "x\ty\tz\tnx\tny\tnz\tarea\n";
  EXPECT_EQ(contentsOf(folder.path("a.tsv")).substr(0, header.size()), header);
}

TEST_F(NormalsCommand, AreDescribedForPeopleWhoAreWarnedWhereTheyAreUnsure)
{
  const std::string in = folder.write("in.xyz", asBareXyz(shell()));
  const Outcome clear = this->run(in, "a.ply");
  EXPECT_EQ(clear.status, 0) << clear;
  EXPECT_EQ(clear.err, "");
  EXPECT_NE(clear.out.find("normals by winding consistent, clear at 100 %"), std::string::npos)
    << clear;
  EXPECT_NE(clear.out.find("wrote " + folder.path("a.ply")), std::string::npos) << clear;
  const Outcome unsure = this->run(in, "a.ply", {"--normal-estimation", "tree"});
  EXPECT_EQ(unsure.status, 0) << unsure;
  EXPECT_NE(unsure.err.find("estimated normals are not right everywhere"), std::string::npos)
    << unsure;
}

TEST_F(NormalsCommand, ThatAreThereAreKeptUnlessOthersAreAskedFor)
{
  const std::string in = folder.write("in.xyz", asXyz(sphere(3)));
  const Outcome kept = this->run(in, "kept.vtp");
  EXPECT_EQ(kept.status, 0) << kept;
  EXPECT_NE(kept.err.find("to estimate others, give the points alone"), std::string::npos) << kept;
  EXPECT_NE(kept.out.find("normals as given"), std::string::npos) << kept;
  EXPECT_EQ(this->fieldOf(folder.path("kept.vtp")), this->fieldOf(in));
  const Outcome others = this->run(in, "others.vtp", {"--replace", "--json"});
  EXPECT_EQ(others.status, 0) << others;
  EXPECT_EQ(others.err, "");
  EXPECT_EQ(others.json()["input"]["normal_estimation"], "spanning tree");
}

TEST_F(NormalsCommand, OfPointsOfMeshesAreThoseOfTheirFacesUnlessOthersAreAskedFor)
{
  const std::string in = folder.write("in.off", asOff(sphere(3)));
  const Outcome ofFaces = this->run(in, "a.ply");
  EXPECT_EQ(ofFaces.status, 0) << ofFaces;
  EXPECT_NE(ofFaces.err.find("normals are taken as given or from faces"), std::string::npos)
    << ofFaces;
  EXPECT_NE(ofFaces.out.find("normals of the faces"), std::string::npos) << ofFaces;
  const std::vector<double> points = this->fieldOf(in, {"--points"});
  const std::vector<double> written = this->fieldOf(folder.path("a.ply"));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_NEAR(written[i], points[i], 1e-5); // normals are in single precision: 1e-7
  }
  const Outcome others = this->run(in, "b.ply", {"--replace", "--json"});
  EXPECT_EQ(others.json()["input"]["normals_estimated"], true) << others;
  EXPECT_EQ(this->run(in, "c.csv", {"--areas", "mesh"}).status, 0);
  const std::string bare = folder.write("bare.xyz", asBareXyz(shell(2)));
  const Outcome noMesh = this->run(bare, "c.csv", {"--areas", "mesh"});
  EXPECT_EQ(noMesh.status, 2) << noMesh;
  EXPECT_TRUE(
    noMesh.saysInOneLine({"bare.xyz", "areas from the mesh need triangles", "--areas voronoi"}))
    << noMesh;
}

TEST_F(NormalsCommand, HaveTheAreasThatAreAskedForBesideThem)
{
  const std::string in = folder.write("in.csv", asCsv(sphere(3)));
  ASSERT_EQ(this->run(in, "a.vtp", {"--replace", "--areas", "constant", "--area", "2"}).status, 0);
  const Outcome field = runProgram({"field", folder.path("a.vtp"), "-o", folder.path("f.vti"),
    "--resolution", "4", "--areas", "array", "--json"});
  EXPECT_NEAR(field.json()["input"]["mean_area"], 2, 1e-12) << field;
  EXPECT_EQ(field.json()["input"]["kind"], "points") << field;
}

TEST_F(NormalsCommand, LeaveOutPointsThatHaveNone)
{
  Places places = shell(3);
  places[3][1] = std::nan("");
  places[7][0] = std::numeric_limits<double>::infinity();
  const std::string in = folder.write("in.xyz", asBareXyz(places));
  const Outcome outcome = this->run(in, "a.xyz", {"--json"});
  EXPECT_EQ(outcome.status, 0) << outcome;
  const std::size_t first = outcome.err.find("2 of " + std::to_string(places.size()));
  EXPECT_NE(first, std::string::npos) << outcome;
  EXPECT_EQ(outcome.err.find("2 of ", first + 1), std::string::npos) << outcome;
  EXPECT_EQ(outcome.json()["input"]["dropped"], 2) << outcome;
  EXPECT_EQ(outcome.json()["output"]["points"], places.size() - 2);
  EXPECT_EQ(runProgram({"check", folder.path("a.xyz")}).err, "");
}

/// The share of points whose written normals look up.
double shareUp(const std::string& xyz)
{
  std::istringstream lines(xyz);
  double x, y, z, nx, ny, nz, up = 0, all = 0;
  while (lines >> x >> y >> z >> nx >> ny >> nz)
  {
    up += nz > 0 ? 1 : 0;
    ++all;
  }
  return up / all;
}

TEST_F(NormalsCommand, LookTowardWhereThePointsWereSeenFrom)
{
  // Hills from the air.
  Places places;
  for (int i = 0; i < 50; ++i)
  {
    for (int k = 0; k < 50; ++k)
    {
      const double x = 0.1 * i + 0.01 * (k % 3), y = 0.1 * k;
      places.push_back({x, y, 0.4 * std::sin(2 * x) * std::cos(3 * y)});
    }
  }
  const std::string in = folder.write("in.xyz", asBareXyz(places));
  const std::string path = folder.write("path.csv", "t,x,y,z\n0,0,2.5,30\n1,5,2.5,30\n");
  for (const std::vector<std::string>& toward : std::vector<std::vector<std::string>>{
         {"--toward", "up"}, {"--toward", "direction", "0.1", "-0.1", "1"},
         {"--toward", "2", "2", "30"}, {"--toward", path}})
  {
    const Outcome run = this->run(in, "out.xyz", toward);
    EXPECT_EQ(run.err, "") << toward[1];
    EXPECT_NE(run.out.find("normals by viewpoint"), std::string::npos) << run;
    EXPECT_EQ(shareUp(contentsOf(folder.path("out.xyz"))), 1) << toward[1];
  }
  ASSERT_EQ(this->run(in, "out.xyz", {"--toward", "2", "2", "-30"}).status, 0);
  EXPECT_EQ(shareUp(contentsOf(folder.path("out.xyz"))), 0);
  // A field takes it as well, and bad ones are refused.
  std::vector<std::string> field = {
    "field", in, "-o", folder.path("out.vti"), "--resolution", "8", "--estimate-normals", "--json"};
  field.insert(field.end(), {"--toward", "up"});
  EXPECT_EQ(runProgram(field).json()["input"]["normal_estimation"], "viewpoint");
  EXPECT_TRUE(runProgram({"field", in, "-o", folder.path("out.vti"), "--toward", "up"})
                .saysInOneLine({"--toward is for --estimate-normals"}));
  EXPECT_TRUE(
    this->run(in, "a.xyz", {"--toward", "upward"}).saysInOneLine({"--toward is no position"}));
  EXPECT_TRUE(this->run(in, "a.xyz", {"--toward", folder.path("none.csv")})
                .saysInOneLine({"none.csv: no such file"}));
}

TEST_F(NormalsCommand, KeepWhatPointsCameWith)
{
  // A table with other names, colours, an intensity and words; without normals.
  std::string table = "East;North;Up;r;g;b;Intensity (dB);class\n";
  for (const auto& at : sphere(3).points)
  {
    table += std::to_string(at[0]) + ";" + std::to_string(at[1]) + ";" + std::to_string(at[2]) +
             ";255;128;0;0.5;\"a, b\"\n";
  }
  const std::string in = folder.write("in.csv", table);
  const std::vector<std::string> columns = {"--columns", "x=East", "y=North", "z=Up"};
  ASSERT_EQ(this->run(in, "out.csv", columns).err, "");
  const std::string csv = contentsOf(folder.path("out.csv"));
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "x,y,z,nx,ny,nz,area,r,g,b,Intensity (dB),class");
  EXPECT_NE(csv.find(",255,128,0,0.5,\"a, b\"\n"), std::string::npos);
  ASSERT_EQ(this->run(in, "out.ply", columns).err, "");
  const std::string ply = contentsOf(folder.path("out.ply"));
  EXPECT_NE(ply.find("property uchar red\nproperty uchar green\nproperty uchar blue\n"
                     "property double Intensity_(dB)\nend_header\n"),
    std::string::npos)
    << ply.substr(0, 400);
  EXPECT_EQ(static_cast<unsigned char>(ply[ply.size() - 11]), 255); // red before 2 and 8 bytes
  // Colours and other numbers come back from PLY, and columns by numbers from a file without names.
  ASSERT_EQ(this->run(folder.path("out.ply"), "again.csv", {"--replace"}).err, "");
  const std::string again = contentsOf(folder.path("again.csv"));
  EXPECT_EQ(again.substr(0, again.find('\n')), "x,y,z,nx,ny,nz,area,red,green,blue,Intensity_(dB)");
  const std::string bare = folder.write("bare.csv", table.substr(table.find('\n') + 1));
  ASSERT_EQ(this->run(bare, "bare.ply", {"--columns", "x=1", "y=2", "z=3"}).err, "");
  EXPECT_TRUE(this->run(in, "out.csv").saysInOneLine({"in.csv: has no columns x, y and z"}));
  EXPECT_TRUE(
    this->run(in, "out.csv", {"--columns", "x=Easting"}).saysInOneLine({"no column Easting"}));
  EXPECT_TRUE(this->run(folder.path("out.ply"), "a.csv", {"--columns", "x=1"})
                .saysInOneLine({"--columns is for .csv .tsv .xyz .pwn"}));
  EXPECT_TRUE(this->run(in, "a.csv", {"--columns", "East"}).saysInOneLine({"x=Easting"}));
}

TEST_F(NormalsCommand, GiveColumnsNamesThatDiffer)
{
  // Colours of two bytes become one, and texture coordinates come back as such.
  std::string ply = "ply\nformat ascii 1.0\nelement vertex 66\n";
  for (const char* const property : {"float x", "float y", "float z", "ushort red", "ushort green",
         "ushort blue", "float u", "float v", "float \xC3\xA4", "float \xC3\xB6"})
  {
    ply += std::string("property ") + property + "\n";
  }
  ply += "end_header\n";
  for (const auto& at : sphere(2).points)
  {
    ply += std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]) +
           " 1000 2000 3 0.25 0.5 7 8\n";
  }
  const std::string in = folder.write("in.ply", ply);
  ASSERT_EQ(this->run(in, "out.ply").err, "");
  const std::string out = contentsOf(folder.path("out.ply"));
  EXPECT_NE(out.find("property uchar red\nproperty uchar green\nproperty uchar blue\n"),
    std::string::npos)
    << out.substr(0, 600);
  EXPECT_NE(out.find("property double s\nproperty double t\n"), std::string::npos);
  EXPECT_NE(out.find("property double __\nproperty double ___input\n"), std::string::npos);
}

TEST_F(NormalsCommand, OfNothingOrOfPointsThatAreFewAreRefusedOrWarnedOf)
{
  const Outcome nothing = this->run(folder.write("no.pwn", "0\n"), "a.ply");
  EXPECT_EQ(nothing.status, 2) << nothing;
  EXPECT_TRUE(nothing.saysInOneLine({"no.pwn", "has no points"})) << nothing;
  const Outcome bad = this->run(folder.write("bad.xyz", "nan 0 0\nnan 1 1\n"), "a.ply");
  EXPECT_EQ(bad.status, 2) << bad;
  EXPECT_TRUE(bad.saysInOneLine({"bad.xyz"})) << bad;
  const Outcome huge = this->run(folder.write("huge.xyz", "0 0 0\n1e200 1 1\n"), "a.ply");
  EXPECT_EQ(huge.status, 2) << huge;
  EXPECT_TRUE(huge.saysInOneLine({"huge.xyz", "1e+200"})) << huge;
  const Outcome one = this->run(folder.write("one.xyz", "1 2 3\n"), "a.ply");
  EXPECT_EQ(one.status, 0) << one;
  EXPECT_NE(one.err.find("points at one place have no areas: use --area"), std::string::npos)
    << one;
  EXPECT_FALSE(folder.names().empty());
}

TEST_F(NormalsCommand, OfPlatesInPlanesOfTheAxesAreTakenAlongEachAxis)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Places places;
    for (int n = 0; n < 100; ++n)
    {
      std::array<double, 3> place = {};
      place[static_cast<std::size_t>(axis + 1) % 3] = n % 10;
      place[static_cast<std::size_t>(axis + 2) % 3] = std::floor(n / 10);
      places.push_back(place);
    }
    const Outcome run = this->run(folder.write("plate.xyz", asBareXyz(places)), "plate.csv");
    EXPECT_EQ(run.status, 0) << run;
    const std::string table = contentsOf(folder.path("plate.csv"));
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 101) << "all points have normals";
  }
}

TEST_F(NormalsCommand, EndAtASignal)
{
  const std::string in = folder.write("in.xyz", asBareXyz(shell(7))); // 6 s or more
  const int process = startProgram({"normals", in, "-o", folder.path("a.ply")});
  for (int i = 0; i < 2000 && folder.names().size() < 2; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(folder.names().size(), 2u) << "the temporary file is there";
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  const auto start = std::chrono::steady_clock::now();
  kill(process, SIGTERM);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)); // 0.2
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.xyz"});
}

} // namespace
