// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Legacy .vtk files that are whole, in the many ways in which they can be written.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

std::string head(const std::string& version, const std::string& dataset)
{
  return "# vtk DataFile Version " + version + "\ntitle\nASCII\nDATASET " + dataset + "\n";
}

const std::string points = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n";

struct WholeFile
{
  std::string name, contents;
  int triangles;
};

const WholeFile wholeFiles[] = {
  {"SmallLetters",
    head("3.0", "polydata") + "points 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n" +
      "polygons 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    4},
  {"FieldsBeforeCells",
    head("4.2", "POLYDATA") +
      "FIELD FieldData 2\nwords 1 2 string\na%20b\nPOLYGONS\nnumbers 2 1 int\n1 2\n" + points +
      "METADATA\nCOMPONENT_NAMES\nx\ny\nz\n\nVERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n" +
      "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    4},
  {"Strips", head("4.2", "POLYDATA") + points + "TRIANGLE_STRIPS 1 7\n6 0 1 2 3 0 1\n", 4},
  {"NewCells",
    head("5.1", "POLYDATA") + points +
      "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n"
      "0 2 1 0 1 3 0 3 2 1 2 3\n",
    4},
  {"Grid", head("4.2", "UNSTRUCTURED_GRID") + points + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
    4},
  {"TypesFirst",
    head("4.2", "UNSTRUCTURED_GRID") + points + "CELL_TYPES 1\n10\nCELLS 1 5\n4 0 1 2 3\n", 4},
  {"NewGrid",
    head("5.1", "UNSTRUCTURED_GRID") + points +
      "CELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_TYPES "
      "1\n10\n",
    4},
  {"Polyhedron",
    head("4.2", "UNSTRUCTURED_GRID") + points +
      "CELLS 1 18\n17 4 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3\nCELL_TYPES 1\n42\n",
    4},
  {"UnknownKey",
    head("4.2", "POLYDATA") + points +
      "METADATA\nINFORMATION 1\nNAME UNKNOWN LOCATION vtkNobody\nDATA 2 0 1\n\n" +
      "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    4},
  {"StructuredGrid",
    head("3.0", "STRUCTURED_GRID") + "DIMENSIONS 2 2 1\n" +
      "POINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n",
    2},
};

class LegacyVtk : public testing::TestWithParam<WholeFile>
{
};

TEST_P(LegacyVtk, IsRead)
{
  const TemporaryFolder folder;
  const Outcome run =
    runProgram({"check", folder.write("a.vtk", this->GetParam().contents), "--json"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["triangles"], this->GetParam().triangles) << run;
}

TEST(LegacyVtkNumbers, MayBeNotFinite)
{
  // VTK writes these numbers, and refuses them itself.
  const TemporaryFolder folder;
  const std::string faces = "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  for (const std::string type : {"float", "double"})
  {
    const std::string in = folder.write("in.vtk",
      head("3.0", "POLYDATA") + "POINTS 6 " + type + "\n0 0 0 1 0 0 0 1 0\n0 0 1 nan -nan inf\n" +
        "-inf NaN 0\n" + faces + "POINT_DATA 6\nSCALARS nan " + type +
        " 1\nLOOKUP_TABLE default\nnan 1 -inf inf 5 2.5\n" + "CELL_DATA 4\nSCALARS heat " + type +
        " 1\nLOOKUP_TABLE default\n7 nan -inf inf\n");
    const Outcome run = runProgram({"check", in, "--json"});
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.json()["triangles"], 4) << run;
    EXPECT_EQ(run.json()["closed"], true) << run;
    const Outcome probe =
      runProgram({"probe", folder.write("a.vtk", head("3.0", "POLYDATA") + points + faces), in,
        "-o", folder.path("out.csv")});
    ASSERT_EQ(probe.status, 0) << probe;
    const std::string table = contentsOf(folder.path("out.csv"));
    EXPECT_NE(table.find("nan,nan,inf"), std::string::npos) << table;
    EXPECT_NE(table.find("-inf,nan,0"), std::string::npos) << table;
    EXPECT_EQ(table.find("e+38"), std::string::npos) << table;
    const Outcome cells =
      runProgram({"probe", folder.path("a.vtk"), in, "-o", folder.path("out.vtp")});
    ASSERT_EQ(cells.status, 0) << cells;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(folder.path("out.vtp").c_str());
    reader->Update();
    vtkDataArray* const heat = reader->GetOutput()->GetCellData()->GetArray("heat");
    ASSERT_TRUE(heat && heat->GetNumberOfTuples() == 4);
    EXPECT_EQ(heat->GetTuple1(0), 7);
    EXPECT_TRUE(std::isnan(heat->GetTuple1(1)));
    EXPECT_EQ(heat->GetTuple1(2), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(heat->GetTuple1(3), std::numeric_limits<double>::infinity());
  }
  const std::string words = folder.write("words.vtk",
    head("4.2", "POLYDATA") + "FIELD FieldData 1\nwords 1 1 string\nnan\n" + points + faces);
  EXPECT_EQ(runProgram({"check", words}).status, 0);
}

INSTANTIATE_TEST_SUITE_P(Whole, LegacyVtk, testing::ValuesIn(wholeFiles),
  [](const testing::TestParamInfo<WholeFile>& file) { return file.param.name; });

/// Binary files may have a keyword right behind their numbers.
TEST(LegacyVtkBytes, NeedNoEndOfTheLine)
{
  const auto bigEndian = [](std::initializer_list<std::int32_t> numbers)
  {
    std::string bytes;
    for (const std::int32_t number : numbers)
    {
      for (int shift = 24; shift >= 0; shift -= 8)
      {
        bytes += static_cast<char>(number >> shift);
      }
    }
    return bytes;
  };
  const std::int32_t one = 0x3f800000; // the bits of 1 in single precision
  const TemporaryFolder folder;
  const std::string file = folder.write("a.vtk",
    "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n" +
      bigEndian({0, 0, 0, one, 0, 0, 0, one, 0}) + "POLYGONS 1 4\n" + bigEndian({3, 0, 1, 2}));
  const Outcome run = runProgram({"check", file, "--json"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["triangles"], 1) << run;
}

} // namespace
