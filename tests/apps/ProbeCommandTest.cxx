// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace
{

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> fields;
  std::istringstream stream(text);
  for (std::string field; std::getline(stream, field, separator);)
  {
    fields.push_back(field);
  }
  return fields;
}

class ProbeCommand : public testing::Test
{
protected:
  Outcome probe(
    const std::string& queries, const std::string& out, const std::vector<std::string>& more = {})
  {
    std::vector<std::string> arguments = {"probe", in, queries, "-o", folder.path(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  }

  TemporaryFolder folder;
  std::string in = folder.write("sphere.off", asOff(sphere(3)));
};

/// Rows, their order and their text stay, with quotes, spaces, trailing zeros and line ends.
TEST_F(ProbeCommand, TableIsKeptAsItIs)
{
  const std::vector<std::string> rows = {
    "\"a, b\", 0.10,0 ,+0.0,1e-1", "far,5.000,0,0,", "edge,.5,.5,-.5,\"x\""};
  const std::string header = "\"the name\",x,y,z,note";
  const std::string queries =
    folder.write("q.csv", header + "\r\n" + rows[0] + "\r\n" + rows[1] + "\r\n" + rows[2] + "\r\n");
  const Outcome run = probe(queries, "out.csv", {"--json"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["queries"]["count"], 3);
  const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], header + ",WindingNumber,Inside\r");
  const double expected[] = {1, 0, 1};
  for (std::size_t i = 0; i < 3; ++i)
  {
    ASSERT_EQ(lines[i + 1].rfind(rows[i] + ",", 0), 0u) << lines[i + 1];
    const auto added = split(lines[i + 1].substr(rows[i].size() + 1), ',');
    ASSERT_EQ(added.size(), 2u);
    EXPECT_NEAR(std::stod(added[0]), expected[i], 1e-12);
    EXPECT_EQ(added[1], expected[i] == 1 ? "1\r" : "0\r");
  }
}

TEST_F(ProbeCommand, FacesThatLookInwardAreToldWhereNothingIsInside)
{
  Mesh mesh = sphere(3);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  in = folder.write("inverted.off", asOff(mesh));
  const std::string inside = folder.write("q.csv", "x,y,z\n0,0,0\n2,0,0\n");
  const std::string outside = folder.write("o.csv", "x,y,z\n0,3,0\n2,0,0\n");
  for (const char* out : {"out.csv", "out.vtp"})
  {
    const Outcome run = probe(inside, out, {"--extract"});
    EXPECT_NE(run.err.find("faces look inward: use --rule absolute, or turn the faces (--orient)"),
      std::string::npos)
      << run;
    EXPECT_EQ(probe(inside, out, {"--extract", "--rule", "absolute"}).err, "");
    const Outcome empty = probe(outside, out, {"--extract"});
    EXPECT_TRUE(empty.err.find("no point is inside, so the result is empty") != std::string::npos)
      << empty;
    EXPECT_EQ(probe(outside, out).err, "");
  }
}

/// VTK's writers crash where a cell has too few points for its kind.
TEST_F(ProbeCommand, CellsWithTooFewPointsAreLeftOut)
{
  const std::string lines = folder.write("lines.vtk",
    "# vtk DataFile Version 3.0\nlines\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
    "0 0 0 5 0 0 0 1 0\nLINES 4 9\n1 0\n2 0 1\n1 1\n1 2\n"
    "CELL_DATA 4\nSCALARS number int 1\nLOOKUP_TABLE default\n10 11 12 13\n");
  for (const char* out : {"out.vtp", "out.vtu"})
  {
    const Outcome run = this->probe(lines, out);
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_NE(
      run.err.find("is written without 3 cells that have too few points"), std::string::npos)
      << run;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 3);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfLines(), 1);
  vtkDataArray* numbers = reader->GetOutput()->GetCellData()->GetArray("number");
  ASSERT_NE(numbers, nullptr);
  ASSERT_EQ(numbers->GetNumberOfTuples(), 1);
  EXPECT_EQ(numbers->GetTuple1(0), 11) << "the data of the cell that stays";

  const std::string polygons = folder.write("polygons.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n1 0\n3 0 1 2\n");
  const Outcome run = this->probe(polygons, "polygons.vtp");
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_NE(run.err.find("without 1 cell that has"), std::string::npos) << run;
}

TEST_F(ProbeCommand, TabsStayTabs)
{
  const std::string queries = folder.write("q.tsv", "x\ty\tz\n0\t0\t0");
  ASSERT_EQ(probe(queries, "out.tsv", {"--array", "w"}).status, 0);
  const auto lines = split(contentsOf(folder.path("out.tsv")), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "x\ty\tz\tw\tInside");
  EXPECT_EQ(lines[1].rfind("0\t0\t0\t", 0), 0u);
  const Outcome mixed = probe(queries, "out.csv");
  EXPECT_EQ(mixed.status, 2);
  EXPECT_TRUE(mixed.saysInOneLine({"out.csv", ".tsv"})) << mixed;
}

TEST_F(ProbeCommand, NamesOfColumnsAreQuotedWhereTablesNeedIt)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0,0,0\n");
  const std::pair<const char*, const char*> names[] = {{"w", "w"}, {"two words", "two words"},
    {"a,b", "\"a,b\""}, {",", "\",\""}, {" w", "\" w\""}, {"w ", "\"w \""}};
  for (const auto& [name, column] : names)
  {
    ASSERT_EQ(probe(queries, "out.csv", {"--array", name}).status, 0);
    const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
    EXPECT_EQ(lines[0], std::string("x,y,z,") + column + ",Inside");
    // The table can be read again, with its three numbers for each row.
    const Outcome again = probe(folder.path("out.csv"), "again.csv", {"--array", "v"});
    EXPECT_EQ(again.status, 2) << again;
    EXPECT_TRUE(again.saysInOneLine({"already has a column Inside"})) << again;
  }
  const std::string tabs = folder.write("q.tsv", "x\ty\tz\n0\t0\t0\n");
  ASSERT_EQ(probe(tabs, "out.tsv", {"--array", "a,b"}).status, 0);
  EXPECT_EQ(split(contentsOf(folder.path("out.tsv")), '\n')[0], "x\ty\tz\ta,b\tInside");
}

TEST_F(ProbeCommand, NoTableGetsTwoColumnsOfOneName)
{
  for (const char* name : {"x", "y", "z"})
  {
    const Outcome run = probe(in, "out.csv", {"--array", name});
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"already has a column", name, "--array"})) << run;
    EXPECT_EQ(probe(in, "out.vtp", {"--array", name}).status, 0);
  }
}

/// Numbers in tables have all the bits of those in binary files, and no digit more than that needs.
TEST_F(ProbeCommand, DigitsBringBackEveryBit)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0.9999,0.01,0.02\n0.1,0.2,3\n");
  in = folder.write("half.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(probe(queries, "out.csv").status, 0);
  ASSERT_EQ(probe(queries, "out.vtp").status, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  vtkDataArray* const values = reader->GetOutput()->GetPointData()->GetArray("WindingNumber");
  for (int row = 0; row < 2; ++row)
  {
    const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
    const std::string field = split(lines[static_cast<std::size_t>(row + 1)], ',')[3];
    EXPECT_EQ(std::stod(field), values->GetTuple1(row)) << field;
  }
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", values->GetTuple1(1));
  EXPECT_NE(std::stod(text), values->GetTuple1(1)) << "the second number needs more digits";
  ASSERT_EQ(probe(folder.write("p.xyz", "0.1 0.2 3\n"), "p.csv").status, 0);
  EXPECT_NE(contentsOf(folder.path("p.csv")).find("\n0.1,0.2,3,"), std::string::npos);
}

TEST_F(ProbeCommand, PointsThatAreNotFinite)
{
  const std::string queries = folder.write("q.csv", "x,y,z\nnan,0,0\n0,inf,0\n0,0,0\n");
  const Outcome run = probe(queries, "out.csv");
  ASSERT_EQ(run.status, 0);
  EXPECT_EQ(run.err,
    "winding: warning: " + in + ": 2 of 3 queries are not finite; they have no winding number\n");
  const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
  EXPECT_EQ(lines[1].rfind("nan,0,0,nan,0", 0), 0u) << lines[1];
  EXPECT_EQ(lines[3].back(), '1');
}

TEST_F(ProbeCommand, ColumnsOfTheSameNameAreRefused)
{
  const std::string queries = folder.write("q.csv", "x,y,z,WindingNumber\n0,0,0,1\n");
  const Outcome run = probe(queries, "out.csv");
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"q.csv", "WindingNumber", "--array"})) << run;
  EXPECT_EQ(probe(queries, "out.csv", {"--array", "w"}).status, 0);
}

TEST_F(ProbeCommand, BadQueriesAreNamed)
{
  const Outcome run = probe(folder.write("q.csv", "x,y,z\n0,0,0\n0,zero,0\n"), "out.csv");
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"q.csv: line 3", "column y"})) << run;
  const Outcome missing = probe(folder.path("missing.csv"), "out.csv");
  EXPECT_TRUE(missing.saysInOneLine({"missing.csv", "no such file"})) << missing;
}

TEST_F(ProbeCommand, TableToVtp)
{
  const std::string queries =
    folder.write("q.csv", "x,y,z,t,name,RowPlace,area\n0,0,0,7,a,5,north\n3,0,0,8,b,6,south\n");
  ASSERT_EQ(probe(queries, "out.vtp").status, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  vtkPointData* data = reader->GetOutput()->GetPointData();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetArray("WindingNumber")->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(data->GetArray("WindingNumber")->GetTuple1(0), 1, 1e-12);
  EXPECT_EQ(data->GetArray("Inside")->GetTuple1(1), 0);
  EXPECT_EQ(data->GetArray("t")->GetTuple1(1), 8);
  EXPECT_EQ(data->GetArray("RowPlace")->GetTuple1(1), 6);
  EXPECT_NE(data->GetAbstractArray("name"), nullptr);
  EXPECT_NE(data->GetAbstractArray("area"), nullptr) << "areas of queries mean nothing";
}

TEST_F(ProbeCommand, ResultsReplaceNoColumn)
{
  const std::string queries = folder.write("q.csv", ",x,y,z,w\n7,0,0,0,8\n");
  for (const std::string out : {"out.csv", "out.vtp"})
  {
    const Outcome run = probe(queries, out, {"--array", "w"});
    EXPECT_EQ(run.status, 2) << out;
    EXPECT_TRUE(run.saysInOneLine({"q.csv", "already has a column w", "--array"})) << run;
  }
  // Arrays have names, where columns need not.
  EXPECT_EQ(probe(queries, "out.csv", {"--array", "Column 1"}).status, 0);
  EXPECT_EQ(probe(queries, "out.vtp", {"--array", "Column 1"}).status, 2);
}

TEST_F(ProbeCommand, ColumnsMayHaveNamesThatBeginOtherFiles)
{
  const std::string queries = folder.write("q.tsv", "CUTOFF\tx\ty\tz\n1\t0\t0\t0\n");
  ASSERT_EQ(probe(queries, "out.tsv").status, 0);
  EXPECT_NE(contentsOf(folder.path("out.tsv")).find("\n1\t0\t0\t0\t1"), std::string::npos);
}

TEST_F(ProbeCommand, DataSetsKeepTheirCells)
{
  const Mesh small = sphere(1);
  const std::string grid = folder.write("grid.vtu", asVtu(small));
  ASSERT_EQ(probe(grid, "out.vtu").status, 0);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(folder.path("out.vtu").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 18);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 32);
  EXPECT_NE(reader->GetOutput()->GetPointData()->GetArray("Inside"), nullptr);
  const Outcome wrong = probe(grid, "out.vtp");
  EXPECT_EQ(wrong.status, 2) << wrong;
  EXPECT_TRUE(wrong.saysInOneLine({"out.vtp", ".vtu"})) << wrong;

  ASSERT_EQ(probe(folder.write("mesh.obj", asObj(small)), "out.csv").status, 0);
  const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
  EXPECT_EQ(lines[0], "x,y,z,WindingNumber,Inside");
  EXPECT_EQ(lines.size(), 19u);
}

/// VTK's writers follow a null pointer where a cell has too few points for its kind.
TEST_F(ProbeCommand, CellsOfEachKindWithTooFewPointsAreLeftOut)
{
  const std::string points = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                             "POINTS 4 float\n0 0 0 .1 0 0 0 .1 0 .1 .1 0\n";
  for (const auto& [kind, fewest] : {std::pair("VERTICES", 1), std::pair("LINES", 2),
         std::pair("POLYGONS", 3), std::pair("TRIANGLE_STRIPS", 3)})
  {
    // One cell has one point fewer, the next as many as there must be, the last one more.
    std::string cells;
    int numbers = 0;
    for (int size = std::max(fewest - 1, 1); size <= fewest + 1; ++size)
    {
      cells += std::to_string(size);
      for (int n = 0; n < size; ++n)
      {
        cells += " " + std::to_string(n);
      }
      cells += "\n";
      numbers += size + 1;
    }
    const int count = fewest == 1 ? 2 : 3;
    const Outcome run =
      probe(folder.write("cells.vtk", points + kind + " " + std::to_string(count) + " " +
                                        std::to_string(numbers) + "\n" + cells),
        "out.vtp");
    ASSERT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(folder.path("out.vtp").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 2) << kind;
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4) << kind;
  }
}

TEST_F(ProbeCommand, FractionsAreThoseOfCells)
{
  vtkNew<vtkRectilinearGrid> cells;
  cells->SetDimensions(4, 3, 3);
  vtkNew<vtkDoubleArray> x, yz;
  for (const double coordinate : {-2, -1, 0, 2})
  {
    x->InsertNextValue(coordinate);
  }
  for (const double coordinate : {-2, 0, 2})
  {
    yz->InsertNextValue(coordinate);
  }
  cells->SetXCoordinates(x);
  cells->SetYCoordinates(yz);
  cells->SetZCoordinates(yz);
  const std::string grid = folder.path("grid.vtr");
  vtkNew<vtkXMLRectilinearGridWriter> writer;
  writer->SetFileName(grid.c_str());
  writer->SetInputData(cells);
  writer->Write();
  const Outcome run = probe(grid, "out.vtu", {"--fraction"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err, "");
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(folder.path("out.vtu").c_str());
  reader->Update();
  vtkDataArray* fractions = reader->GetOutput()->GetCellData()->GetArray("Fraction");
  ASSERT_NE(fractions, nullptr);
  ASSERT_EQ(fractions->GetNumberOfTuples(), 12);
  const double volumes[] = {4, 4, 8};
  double inside = 0;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    inside += volumes[i % 3] * fractions->GetTuple1(i);
  }
  EXPECT_NEAR(inside, 4 * 3.14159 / 3, 0.11) << "the sphere has few triangles";
  EXPECT_EQ(fractions->GetTuple1(0), 0);
  EXPECT_NEAR(fractions->GetTuple1(2), inside / 8 / 8, 1e-6);

  const Outcome table = probe(grid, "out.csv", {"--fraction"});
  EXPECT_EQ(table.status, 1) << table;
  EXPECT_TRUE(table.saysInOneLine({"--fraction", "suffix .vtu"})) << table;
  const Outcome points = probe(folder.write("q.csv", "x,y,z\n0,0,0\n"), "o.vtp", {"--fraction"});
  EXPECT_EQ(points.status, 1) << points;
  EXPECT_TRUE(points.saysInOneLine({"--fraction", "give a mesh"})) << points;
}

TEST_F(ProbeCommand, DistancesAreOneColumnMore)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0,0,-5\n0,0,0\nnan,0,0\n");
  ASSERT_EQ(probe(queries, "out.csv", {"--distance"}).status, 0);
  const auto lines = split(contentsOf(folder.path("out.csv")), '\n');
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "x,y,z,WindingNumber,Inside,SignedDistance");
  const auto outside = split(lines[1], ','), inside = split(lines[2], ',');
  ASSERT_EQ(outside.size(), 6u);
  EXPECT_NEAR(std::stod(outside[5]), 4, 1e-12) << "a vertex is nearest";
  EXPECT_LT(std::stod(inside[5]), -0.9);
  EXPECT_EQ(lines[3], "nan,0,0,nan,0,nan");

  const Outcome taken =
    probe(folder.write("taken.csv", "x,y,z,SignedDistance\n0,0,0,1\n"), "out.csv", {"--distance"});
  EXPECT_EQ(taken.status, 2);
  EXPECT_TRUE(taken.saysInOneLine({"already has a column SignedDistance"})) << taken;
}

TEST_F(ProbeCommand, ExtractsTheRowsThatAreInside)
{
  const std::string queries =
    folder.write("q.csv", "name,x,y,z\na,0,0,0\nb,5,0,0\nc,nan,0,0\nd,0.1,0,0.1\n");
  const Outcome run = probe(queries, "in.csv", {"--extract", "--json"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["queries"]["count"], 4);
  EXPECT_EQ(run.json()["queries"]["inside"], 2);
  auto lines = split(contentsOf(folder.path("in.csv")), '\n');
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "name,x,y,z,WindingNumber,Inside");
  EXPECT_EQ(lines[1], "a,0,0,0,1,1");
  EXPECT_EQ(lines[2], "d,0.1,0,0.1,1,1");
  ASSERT_EQ(probe(queries, "out.csv", {"--extract", "--inside-out"}).status, 0);
  lines = split(contentsOf(folder.path("out.csv")), '\n');
  ASSERT_EQ(lines.size(), 2u) << "what is nowhere is on neither side";
  EXPECT_EQ(lines[1], "b,5,0,0,0,1");
  ASSERT_EQ(probe(queries, "all.csv", {"--inside-out"}).status, 0);
  lines = split(contentsOf(folder.path("all.csv")), '\n');
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[1], "a,0,0,0,1,0");
}

TEST_F(ProbeCommand, NothingIsAnAnswer)
{
  const std::string far = folder.write("far.csv", "x,y,z,name\n5,5,5,a\n");
  const std::string none = folder.write("none.csv", "x,y,z\n");
  const std::string mesh = folder.write("small.vtu", asVtu(sphere(2)));
  for (const char* out : {"out.vtp", "out.vtu", "out.csv"})
  {
    for (const std::string& queries : {far, none})
    {
      const Outcome run = probe(queries, out, {"--extract", "--json"});
      EXPECT_EQ(run.status, 0) << out << run;
      EXPECT_EQ(run.json()["queries"]["inside"], 0);
    }
  }
  EXPECT_EQ(probe(mesh, "out.vtu", {"--extract", "--threshold", "5"}).status, 0);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(folder.path("out.vtu").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_NE(reader->GetOutput()->GetPointData()->GetArray("WindingNumber"), nullptr);
}

TEST_F(ProbeCommand, ReportSaysWhichSideItCounts)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0,0,0\n5,0,0\n6,0,0\nnan,0,0\n");
  const auto counts = [&](const std::vector<std::string>& more)
  {
    return probe(queries, "out.csv", more).json()["queries"];
  };
  EXPECT_EQ(counts({"--json"})["inside"], 1);
  EXPECT_EQ(counts({"--json", "--inside-out"})["outside"], 2);
  EXPECT_FALSE(counts({"--json", "--inside-out"}).contains("inside"));
}

TEST_F(ProbeCommand, ExtractsRowsToPointsWithTheirColumns)
{
  const std::string queries =
    folder.write("q.csv", "x,y,z,t,name\n0,0,0,7,a\n3,0,0,8,b\n0,0.1,0,9,c\n");
  ASSERT_EQ(probe(queries, "out.vtp", {"--extract"}).status, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  vtkPolyData* points = reader->GetOutput();
  ASSERT_EQ(points->GetNumberOfPoints(), 2);
  EXPECT_EQ(points->GetNumberOfVerts(), 2);
  EXPECT_EQ(points->GetPointData()->GetArray("t")->GetTuple1(1), 9);
  EXPECT_EQ(points->GetPointData()->GetAbstractArray("name")->GetNumberOfValues(), 2);
  EXPECT_EQ(points->GetPointData()->GetArray("Inside")->GetTuple1(0), 1);
}

TEST_F(ProbeCommand, ExtractsCells)
{
  // There are two spheres of 32 triangles, one of them far from the source.
  Mesh both = sphere(1);
  const std::size_t corners = both.points.size();
  for (std::size_t i = 0; i < corners; ++i)
  {
    both.points[i] = {0.5 * both.points[i][0], 0.5 * both.points[i][1], 0.5 * both.points[i][2]};
    both.points.push_back({both.points[i][0] + 9, both.points[i][1], both.points[i][2]});
  }
  const std::size_t triangles = both.triangles.size();
  for (std::size_t i = 0; i < triangles; ++i)
  {
    auto triangle = both.triangles[i];
    for (auto& corner : triangle)
    {
      corner += static_cast<int>(corners);
    }
    both.triangles.push_back(triangle);
  }
  const std::string mesh = folder.write("both.off", asOff(both));
  ASSERT_EQ(probe(mesh, "out.vtp", {"--extract"}).status, 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("out.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), static_cast<vtkIdType>(triangles));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(corners));
  // A table has no cells: its rows are points.
  ASSERT_EQ(probe(mesh, "out.csv", {"--extract"}).status, 0);
  EXPECT_EQ(split(contentsOf(folder.path("out.csv")), '\n').size(), 1 + corners);
  const std::string grid = folder.write("both.vtu", asVtu(both));
  ASSERT_EQ(probe(grid, "out.vtu", {"--extract", "--inside-out"}).status, 0);
  vtkNew<vtkXMLUnstructuredGridReader> gridReader;
  gridReader->SetFileName(folder.path("out.vtu").c_str());
  gridReader->Update();
  EXPECT_EQ(gridReader->GetOutput()->GetNumberOfCells(), static_cast<vtkIdType>(triangles));
  EXPECT_GT(gridReader->GetOutput()->GetBounds()[0], 8);
}

/// Compares with independent values: sums in long double, by another program, over the same float
/// coordinates.
TEST(ProbeReference, EveryMesh)
{
  const std::string shared = WINDING_SHARED_DATA;
  const auto lines = split(contentsOf(shared + "/REFERENCE_W.tsv"), '\n');
  ASSERT_EQ(
    split(lines[0], '\t'), (std::vector<std::string>{"set", "name", "kind", "x", "y", "z", "w"}));
  std::map<std::string, std::string> tables;
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    const std::string name = split(lines[i], '\t')[1];
    auto place = tables.try_emplace(name, lines[0] + "\n").first;
    place->second += lines[i] + "\n";
  }
  EXPECT_GE(tables.size(), 3u);
  for (const auto& [name, table] : tables)
  {
    const TemporaryFolder folder;
    const std::string queries = folder.write("q.tsv", table);
    const Outcome run =
      runProgram({"probe", shared + "/" + name, queries, "-o", folder.path("a.tsv"), "--quiet"});
    ASSERT_EQ(run.status, 0) << run;
    const auto answers = split(contentsOf(folder.path("a.tsv")), '\n');
    double largest = 0;
    for (std::size_t i = 1; i < answers.size(); ++i)
    {
      const auto fields = split(answers[i], '\t');
      largest = std::max(largest, std::abs(std::stod(fields[6]) - std::stod(fields[7])));
    }
    EXPECT_LT(largest, 2e-5) << name; // at most 1.2e-7 was measured
  }
}

} // namespace
