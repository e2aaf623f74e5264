// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

vtkSmartPointer<vtkImageData> readImage(const std::string& fileName)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

class FieldCommand : public testing::Test
{
protected:
  Outcome run(
    const std::string& name, const std::vector<std::string>& more, const std::string& before = "")
  {
    std::vector<std::string> arguments = {"field", in, "-o", folder.path(name), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Outcome result = runProgram(arguments, before);
    EXPECT_EQ(result.status, 0) << result;
    EXPECT_EQ(result.err, "") << "nothing but errors when piped";
    return result;
  }

  vtkSmartPointer<vtkImageData> image(const std::string& name)
  {
    return readImage(folder.path(name));
  }

  TemporaryFolder folder;
  std::string in = folder.write("sphere.off", asOff(sphere(3)));
};

std::vector<std::string> namesOf(const nlohmann::json& object)
{
  std::vector<std::string> names;
  for (const auto& item : object.items())
  {
    names.push_back(item.key());
  }
  return names;
}

TEST_F(FieldCommand, CoverageAddsItsArrays)
{
  run("any.vti", {"--resolution", "9", "--coverage", "any"});
  run("whole.vti", {"--resolution", "9", "--coverage", "fraction"});
  run("pieces.vti", {"--resolution", "9", "--coverage", "fraction", "--pieces", "4"});
  run("only.vti", {"--resolution", "9", "--coverage", "fraction", "--inside-only"});
  const auto arrayOf = [this](const char* file, const char* array)
  {
    return vtkSmartPointer<vtkDataArray>(image(file)->GetPointData()->GetArray(array));
  };
  const auto any = arrayOf("any.vti", "Inside");
  const auto onlyInside = arrayOf("only.vti", "Inside");
  const auto whole = arrayOf("whole.vti", "Coverage");
  const auto pieces = arrayOf("pieces.vti", "Coverage");
  const auto only = arrayOf("only.vti", "Coverage");
  EXPECT_EQ(image("any.vti")->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(image("whole.vti")->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(image("only.vti")->GetPointData()->GetNumberOfArrays(), 2);
  for (vtkIdType i = 0; i < 9 * 9 * 9; ++i)
  {
    const double share = whole->GetTuple1(i);
    ASSERT_EQ(pieces->GetTuple1(i), share);
    ASSERT_EQ(only->GetTuple1(i), share);
    ASSERT_EQ(onlyInside->GetTuple1(i), share >= 0.5);
    ASSERT_GE(any->GetTuple1(i), share > 0);
  }
  run("eighths.vti", {"--resolution", "9", "--coverage", "fraction", "--coverage-samples", "2"});
  const auto eighths = arrayOf("eighths.vti", "Coverage");
  int between = 0;
  for (vtkIdType i = 0; i < 9 * 9 * 9; ++i)
  {
    const double share = 8 * eighths->GetTuple1(i);
    ASSERT_EQ(share, std::round(share));
    between += share > 0 && share < 8;
  }
  EXPECT_GT(between, 0);
}

TEST_F(FieldCommand, PeakMemoryIsNotThatOfTheProcessThatStartedTheRun)
{
  const std::vector<char> held(400'000'000, 1);
  EXPECT_EQ(held.back(), 1);
  // A process keeps the peaks of its children when it becomes another program.
  const std::string large = "head -c 400000000 /dev/zero | tail -c 400000000 >/dev/null; exec ";
  for (const std::string& before : {std::string(), large})
  {
    const double peak = run("a.vti", {"--resolution", "16"}, before).json()["peak_memory"];
    EXPECT_LT(peak, 0.75 * static_cast<double>(held.size())) << before; // 32 MB, sanitized 203
  }
}

TEST_F(FieldCommand, JsonHasTheNamesOfTheInterface)
{
  const nlohmann::json report =
    run("a.vti", {"--resolution", "16", "--verify", "100", "--threads", "1"}).json();
  for (const char* name : {"input", "method", "why", "tolerance", "grid", "expected", "seconds",
         "peak_memory", "threads", "max_error", "rms_error", "near_max_error", "on_surface"})
  {
    EXPECT_TRUE(report.contains(name)) << name;
  }
  EXPECT_EQ(report["input"]["file"], in);
  EXPECT_EQ(report["input"]["kind"], "surface");
  EXPECT_EQ(report["input"]["primitives"], 512);
  EXPECT_EQ(report["input"]["welded_vertices"], 258);
  EXPECT_EQ(report["input"]["boundary_edges"], 0);
  EXPECT_EQ(report["input"]["net_boundary_edges"], 0);
  EXPECT_EQ(report["input"]["dropped"], 0);
  EXPECT_EQ(namesOf(report["grid"]),
    (std::vector<std::string>{"association", "bounds", "dimensions", "origin", "spacing", "why"}));
  EXPECT_EQ(namesOf(report["seconds"]),
    (std::vector<std::string>{"evaluate", "prepare", "read", "total", "verify", "write"}));
  EXPECT_EQ(report["threads"], 1);
  EXPECT_GT(report["peak_memory"], 1000000);
  EXPECT_LT(report["max_error"], 1e-5);
  EXPECT_LT(report["near_max_error"], 1e-5);
  EXPECT_EQ(report["cap_triangles"], 0);
  const nlohmann::json plain = run("a.vti", {"--method", "direct"}).json();
  EXPECT_FALSE(plain.contains("max_error"));
  EXPECT_FALSE(plain.contains("on_surface"));
  EXPECT_FALSE(plain["seconds"].contains("verify"));
  EXPECT_FALSE(plain.contains("cap_triangles"));
}

TEST_F(FieldCommand, JsonSaysWhatTheImageIs)
{
  for (const bool cells : {false, true})
  {
    std::vector<std::string> arguments = {
      "--dims", "4", "5", "6", "--bounds", "-1", "1", "-1.25", "1.25", "-1.5", "1.5"};
    if (cells)
    {
      arguments.emplace_back("--cells");
    }
    const nlohmann::json grid = run("a.vti", arguments).json()["grid"];
    const auto field = image("a.vti");
    EXPECT_EQ(grid["association"], cells ? "cells" : "points");
    EXPECT_EQ(grid["bounds"], nlohmann::json({-1.0, 1.0, -1.25, 1.25, -1.5, 1.5}));
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      EXPECT_EQ(grid["dimensions"][a], field->GetDimensions()[axis] - (cells ? 1 : 0));
      EXPECT_EQ(grid["origin"][a], field->GetOrigin()[axis]);
      EXPECT_EQ(grid["spacing"][a], field->GetSpacing()[axis]);
    }
    vtkDataArray* values = cells ? field->GetCellData()->GetArray("WindingNumber")
                                 : field->GetPointData()->GetArray("WindingNumber");
    ASSERT_NE(values, nullptr);
    EXPECT_EQ(values->GetNumberOfTuples(), 4 * 5 * 6);
  }
}

TEST_F(FieldCommand, OutputOptions)
{
  run("a.vti", {"--resolution", "9", "--inside", "--double", "--array", "w", "--padding", "0"});
  const auto field = image("a.vti");
  vtkDataArray* w = field->GetPointData()->GetArray("w");
  vtkDataArray* inside = field->GetPointData()->GetArray("Inside");
  ASSERT_NE(w, nullptr);
  ASSERT_NE(inside, nullptr);
  EXPECT_EQ(w->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(inside->GetDataType(), VTK_UNSIGNED_CHAR);
  const vtkIdType middle = w->GetNumberOfTuples() / 2;
  EXPECT_NEAR(w->GetTuple1(middle), 1, 1e-12);
  EXPECT_EQ(inside->GetTuple1(middle), 1);
  EXPECT_NEAR(w->GetTuple1(0), 0, 1e-12);
  EXPECT_EQ(inside->GetTuple1(0), 0);
  EXPECT_LT(field->GetBounds()[1], 1) << "no padding: the outer samples are in the sphere's box";
}

TEST_F(FieldCommand, CountsWhatIsInside)
{
  const std::vector<std::string> small = {"--resolution", "9", "--quiet"};
  for (const std::vector<std::string>& options :
    std::vector<std::vector<std::string>>{{}, {"--inside"}, {"--inside-only"}, {"--method", "rows"},
      {"--coverage", "any"}, {"--rule", "absolute"}, {"--rule", "odd"}, {"--threshold", "-1"},
      {"--cells", "--pieces", "3"}, {"--cells", "--inside", "--pieces", "2", "--rule", "odd"}})
  {
    std::vector<std::string> arguments = small;
    arguments.insert(arguments.end(), options.begin(), options.end());
    const nlohmann::json report = run("a.vti", arguments).json();
    arguments.emplace_back("--inside");
    run("b.vti", arguments);
    const auto read = image("b.vti");
    vtkDataArray* inside = read->GetPointData()->GetArray("Inside")
                             ? read->GetPointData()->GetArray("Inside")
                             : read->GetCellData()->GetArray("Inside");
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
    {
      count += inside->GetTuple1(i) != 0;
    }
    EXPECT_EQ(report["inside"], count) << ::testing::PrintToString(options);
    EXPECT_GT(count, 0);
  }
  EXPECT_TRUE(run("c.vti", {"--pieces", "2"}).json()["inside"].is_null()) << "they share samples";
  const Outcome people = runProgram({"field", in, "-o", folder.path("d.vti"), "--resolution", "9"});
  EXPECT_NE(people.out.find("9 x 9 x 9 voxels, "), std::string::npos) << people;
  EXPECT_NE(people.out.find(" inside, "), std::string::npos) << people;

  const Outcome nothing = runProgram({"field", in, "-o", folder.path("e.vti"), "--resolution", "9",
    "--pieces", "3", "--threshold", "5"});
  EXPECT_EQ(nothing.status, 0);
  EXPECT_NE(nothing.err.find("no sample is inside"), std::string::npos) << nothing;
}

TEST_F(FieldCommand, PiecesSayOfTheSourceWhatTheWholeSays)
{
  Mesh inward = sphere(2);
  for (std::array<int, 3>& t : inward.triangles)
  {
    std::swap(t[1], t[2]);
  }
  Mesh two = inward;
  const int count = static_cast<int>(two.points.size());
  for (const std::array<double, 3>& p : inward.points)
  {
    two.points.push_back({p[0] + 3, p[1], p[2]});
  }
  for (const std::array<int, 3>& t : inward.triangles)
  {
    two.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  }
  for (const Mesh& mesh : {two, inward})
  {
    const std::string input = folder.write("in.off", asOff(mesh));
    std::string whole;
    for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
           {}, {"--pieces", "4"}, {"--pieces", "4", "--inside-only"}, {"--pieces", "7"}})
    {
      for (const std::string suffix : {".vti", ".pvti"})
      {
        std::vector<std::string> arguments = {
          "field", input, "-o", folder.path("f" + suffix), "--resolution", "20", "--cells"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = runProgram(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        whole = whole.empty() ? outcome.err : whole;
        EXPECT_EQ(outcome.err, whole);
      }
    }
    EXPECT_NE(whole.find("faces look inward: use --rule absolute, or turn the faces (--orient)"),
      std::string::npos)
      << whole;
    EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 1) << whole;
  }
}

TEST_F(FieldCommand, InsideOnlyIsInsideWithoutTheRest)
{
  for (const bool cells : {false, true})
  {
    std::vector<std::string> arguments = {"--resolution", "13"};
    if (cells)
    {
      arguments.emplace_back("--cells");
    }
    arguments.emplace_back("--inside");
    run("both.vti", arguments);
    arguments.back() = "--inside-only";
    run("only.vti", arguments);
    const auto both = image("both.vti"), only = image("only.vti");
    const auto inside = [cells](vtkImageData* field)
    {
      return cells ? field->GetCellData()->GetArray("Inside")
                   : field->GetPointData()->GetArray("Inside");
    };
    ASSERT_NE(inside(only), nullptr);
    EXPECT_EQ(only->GetPointData()->GetNumberOfArrays(), cells ? 0 : 1);
    EXPECT_EQ(only->GetCellData()->GetNumberOfArrays(), cells ? 1 : 0);
    ASSERT_EQ(inside(only)->GetNumberOfTuples(), inside(both)->GetNumberOfTuples());
    for (vtkIdType i = 0; i < inside(both)->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(inside(only)->GetTuple1(i), inside(both)->GetTuple1(i));
    }
  }
}

TEST_F(FieldCommand, DistancesAreSignedAndMayHaveABand)
{
  const nlohmann::json report = run("a.vti", {"--resolution", "21", "--distance"}).json();
  EXPECT_TRUE(report["distance_band"].is_null());
  const auto full = image("a.vti");
  vtkDataArray* distances = full->GetPointData()->GetArray("SignedDistance");
  ASSERT_NE(distances, nullptr);
  ASSERT_NE(full->GetPointData()->GetArray("WindingNumber"), nullptr);
  EXPECT_EQ(distances->GetDataType(), VTK_FLOAT);
  const vtkIdType middle = distances->GetNumberOfTuples() / 2;
  EXPECT_NEAR(distances->GetTuple1(middle), -1, 0.02) << "the faces are inside of the sphere";
  const double corner = std::sqrt(3.0) * (1 + full->GetSpacing()[0] / 2);
  EXPECT_NEAR(distances->GetTuple1(0), corner - 1, 0.02);

  const nlohmann::json banded =
    run("b.vti", {"--resolution", "21", "--distance", "--distance-band", "2", "--inside-only"})
      .json();
  const double band = 2 * full->GetSpacing()[0];
  EXPECT_EQ(banded["distance_band"], band);
  const auto near = image("b.vti");
  EXPECT_EQ(near->GetPointData()->GetArray("WindingNumber"), nullptr);
  distances = near->GetPointData()->GetArray("SignedDistance");
  ASSERT_NE(distances, nullptr);
  EXPECT_EQ(distances->GetTuple1(middle), -static_cast<float>(band));
  EXPECT_EQ(distances->GetTuple1(0), static_cast<float>(band));
  EXPECT_FALSE(run("a.vti", {"--resolution", "5"}).json().contains("distance_band"));
}

TEST_F(FieldCommand, TellsInWordsWhereNothingCouldBeCompared)
{
  const auto summaryOf = [&](const std::vector<std::string>& bounds)
  {
    std::vector<std::string> arguments = {
      "field", in, "-o", folder.path("a.vti"), "--dims", "1", "1", "1", "--verify", "5"};
    arguments.insert(arguments.end(), bounds.begin(), bounds.end());
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.out.find("null"), std::string::npos) << run;
    return run.out;
  };
  const std::string beside = summaryOf({"--bounds", "2", "3", "2", "3", "2", "3"});
  EXPECT_NE(beside.find(", no sample near the surface could be compared\n"), std::string::npos)
    << beside;
  const std::string atAVertex = summaryOf({"--bounds", "0.5", "1.5", "-0.5", "0.5", "-0.5", "0.5"});
  EXPECT_NE(atAVertex.find("\nno sample could be compared\n"), std::string::npos) << atAVertex;
}

TEST_F(FieldCommand, CapTrianglesOfOpenSurfaces)
{
  Mesh mesh = sphere(3);
  mesh.triangles.pop_back();
  in = folder.write("open.off", asOff(mesh));
  const nlohmann::json report = run("a.vti", {"--resolution", "8", "--verify", "50"}).json();
  EXPECT_EQ(report["method"], "rows");
  EXPECT_EQ(report["cap_triangles"], 1);
  EXPECT_LT(report["near_max_error"], 2e-6);
}

/// Voxels of an eighth whose centres lie on all faces of the unit cube.
const std::vector<std::string> throughTheCube = {"--dims", "13", "13", "13", "--bounds", "-0.3125",
  "1.3125", "-0.3125", "1.3125", "-0.3125", "1.3125", "--verify", "500"};

TEST_F(FieldCommand, SamplesOnTheSurfaceAreNoErrors)
{
  in =
    folder.write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                             "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  for (const char* method : {"rows", "hierarchical", "direct"})
  {
    std::vector<std::string> arguments = throughTheCube;
    arguments.insert(arguments.end(), {"--method", method});
    const nlohmann::json report = run("a.vti", arguments).json();
    EXPECT_GT(report["on_surface"], 100) << method;
    EXPECT_LT(report["max_error"], 1e-3) << method;
    EXPECT_LT(report["near_max_error"], 1e-3) << method;
    std::vector<std::string> inPieces = arguments;
    inPieces.insert(inPieces.end(), {"--cells", "--pieces", "3"});
    EXPECT_EQ(run("a.vti", inPieces).json()["on_surface"], report["on_surface"]) << method;
    std::vector<std::string> words = {"field", in, "-o", folder.path("a.vti")};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Outcome said = runProgram(words);
    EXPECT_NE(said.out.find(report["on_surface"].dump() + " of 1000 samples lie on the surface"),
      std::string::npos)
      << said;
  }
  EXPECT_EQ(run("a.vti", {"--resolution", "16", "--verify", "100"}).json()["on_surface"], 0);
}

TEST_F(FieldCommand, PiecesAndThreadsDoNotChangeABit)
{
  for (const bool cells : {false, true})
  {
    const std::string flag = cells ? "--cells" : "--inside";
    run("whole.vti", {"--resolution", "21", "--threads", "1", flag});
    const auto whole = image("whole.vti");
    const std::vector<std::vector<std::string>> variants = {{"--pieces", "1"}, {"--pieces", "4"},
      {"--pieces", "7", "--threads", "2"}, {"--threads", "2"}};
    for (const auto& variant : variants)
    {
      std::vector<std::string> arguments = variant;
      arguments.insert(arguments.end(), {"--resolution", "21", flag});
      run("part.vti", arguments);
      const auto part = image("part.vti");
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_EQ(part->GetDimensions()[axis], whole->GetDimensions()[axis]);
        EXPECT_EQ(part->GetOrigin()[axis], whole->GetOrigin()[axis]);
      }
      const auto valuesOf = [cells](vtkImageData* field)
      {
        return cells ? field->GetCellData()->GetArray("WindingNumber")
                     : field->GetPointData()->GetArray("WindingNumber");
      };
      vtkDataArray *a = valuesOf(whole), *b = valuesOf(part);
      ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
      for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
      {
        ASSERT_EQ(a->GetTuple1(i), b->GetTuple1(i)) << variant[1] << " at " << i;
      }
    }
  }
}

/// Errors and counts of samples are the whole grid's, whichever piece has the worst sample.
TEST_F(FieldCommand, PiecesReportTheFiguresOfAll)
{
  Mesh moved = sphere(3);
  for (auto& point : moved.points)
  {
    point[2] = 0.7 * point[2] + 0.3 * point[0];
  }
  const std::string cloud = folder.write("cloud.xyz", asXyz(sphere(2)));
  const std::string oblique = folder.write("moved.off", asOff(moved));
  for (const auto& [source, names] :
    {std::pair(in, std::vector<std::string>{}), std::pair(oblique, std::vector<std::string>{}),
      std::pair(cloud, std::vector<std::string>{"beside_points_max_error"})})
  {
    for (const char* dimensions : {"31", "12"})
    {
      SCOPED_TRACE(source + " " + dimensions);
      // Errors of this size distinguish one piece from another.
      std::vector<std::string> words = {"field", source, "-o", folder.path("a.vti"), "--json",
        "--cells", "--dims", dimensions, "17", "9", "--verify", "200", "--inside", "--distance",
        "--distance-band", "1.5", "--method", "hierarchical", "--tolerance", "0.01"};
      const nlohmann::json whole = runProgram(words).json();
      EXPECT_GT(whole["max_error"], 1e-6);
      for (const char* count : {"2", "5"})
      {
        std::vector<std::string> more = words;
        more.insert(more.end(), {"--pieces", count});
        const nlohmann::json pieces = runProgram(more).json();
        for (const char* name : {"max_error", "rms_error", "near_max_error", "distance_band"})
        {
          EXPECT_NEAR(whole[name].get<double>(), pieces[name].get<double>(), 1e-12) << name;
        }
        for (const std::string& name : names)
        {
          EXPECT_GT(whole[name], 0) << name;
          EXPECT_EQ(whole[name], pieces[name]) << name;
        }
        for (const char* name : {"on_surface", "beside_points", "inside", "grid", "input"})
        {
          EXPECT_EQ(whole[name], pieces[name]) << name;
        }
        EXPECT_GT(pieces["seconds"]["evaluate"], 0);
      }
      const nlohmann::json sides = whole["grid"]["spacing"];
      const double longest = std::max({sides[0], sides[1], sides[2]});
      EXPECT_NEAR(whole["distance_band"].get<double>(), 1.5 * longest, 1e-12);
    }
  }
}

TEST_F(FieldCommand, PiecesWarnOnce)
{
  Mesh mesh = sphere(2);
  mesh.points[0][0] = std::nan("");
  const Outcome warned = runProgram({"field", folder.write("nan.off", asOff(mesh)), "-o",
    folder.path("a.vti"), "--resolution", "8", "--pieces", "4"});
  EXPECT_EQ(warned.status, 0) << warned;
  const std::size_t first = warned.err.find("unusable");
  EXPECT_NE(first, std::string::npos) << warned;
  EXPECT_EQ(warned.err.find("unusable", first + 1), std::string::npos) << warned;
}

TEST_F(FieldCommand, Methods)
{
  EXPECT_EQ(run("a.vti", {"--resolution", "8", "--method", "direct"}).json()["method"], "direct");
  EXPECT_EQ(run("a.vti", {"--resolution", "8", "--method", "parity"}).json()["method"], "parity");
  EXPECT_EQ(run("a.vti", {"--resolution", "8", "--method", "rows"}).json()["method"], "rows");
  EXPECT_NE(run("a.vti", {"--resolution", "8"}).json()["why"], "");
}

TEST_F(FieldCommand, Clouds)
{
  const Mesh mesh = sphere(3);
  const std::string csv = folder.write("cloud.csv", asCsv(mesh));
  for (const std::vector<std::string>& arguments : {
         std::vector<std::string>{"field", csv, "--areas", "array"},
         {"field", csv, "--areas", "constant", "--area", "0.0487"},
         {"field", csv, "--areas", "constant"},
         {"field", csv, "--neighbors", "12"},
         {"field", in, "--points"},
         {"field", in, "--points", "--areas", "mesh"},
       })
  {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"-o", folder.path("c.vti"), "--resolution", "5", "--json"});
    const Outcome result = runProgram(all);
    ASSERT_EQ(result.status, 0) << result;
    EXPECT_EQ(result.json()["input"]["kind"], "points");
    EXPECT_EQ(result.json()["input"]["primitives"], mesh.points.size());
    const auto field = image("c.vti");
    vtkDataArray* w = field->GetPointData()->GetArray("WindingNumber");
    EXPECT_NEAR(w->GetTuple1(w->GetNumberOfTuples() / 2), 1, 0.03) << result;
  }
}

TEST_F(FieldCommand, WithoutJsonItIsForPeople)
{
  const Outcome result = runProgram({"field", in, "-o", folder.path("a.vti"), "--resolution", "8"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("wrote " + folder.path("a.vti")), std::string::npos) << result;
  EXPECT_EQ(result.err, "");
}

} // namespace
