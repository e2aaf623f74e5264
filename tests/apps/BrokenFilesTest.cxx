// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Small broken files, each of which made the program crash, hang or give a wrong answer once.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace
{

struct BrokenFile
{
  std::string name; ///< with its suffix
  std::string contents;
};

/// For the names of tests.
std::ostream& operator<<(std::ostream& stream, const BrokenFile& file)
{
  return stream << file.name;
}

const std::string vtkHead = "# vtk DataFile Version 4.2\nt\nASCII\n";
const std::string vtkPolyData = vtkHead + "DATASET POLYDATA\n";
const std::string vtkGrid = vtkHead + "DATASET UNSTRUCTURED_GRID\n";
const std::string threePoints = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
const std::string fourPoints = "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n";
const std::string metadata = "METADATA\nINFORMATION ";

std::string array(const std::string& type, const std::string& name, const std::string& values)
{
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values +
         "</DataArray>";
}

/// A grid of one cell of all four points.
std::string vtu(const std::string& type, const std::string& faces, const std::string& offset)
{
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"><UnstructuredGrid><Piece "
         "NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
         "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>"
         "<Cells>" +
         array("Int64", "connectivity", "0 1 2 3") + array("Int64", "offsets", offset) +
         array("UInt8", "types", type) +
         (faces.empty() ? ""
                        : array("Int64", "faces", faces) + array("Int64", "faceoffsets", "17")) +
         "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

const std::string plyVertices =
  "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

const BrokenFile brokenFiles[] = {
  // An id that is no number, behind a field that the guard of old did not know.
  {"id_behind_field.vtk", vtkPolyData + "FIELD FieldData 1\na 1 1 int\n5\n" + threePoints +
                            "POLYGONS 2 8\n3 0 1 2\nx 0 1 2\n"},
  // Eight coordinates of nine, which gave a field of nobody knows what.
  {"eight_of_nine.vtk", vtkPolyData + "POINTS 3 float\n0 0 0 1 0 0 0 1\nPOLYGONS 1 4\n3 0 1 2\n"},
  // A polygon that reaches over the end of the list.
  {"long_polygon.vtk", vtkPolyData + threePoints + "POLYGONS 1 4\n2000 0 1 2\n"},
  {"long_cell.vtk", vtkGrid + fourPoints + "CELLS 1 5\n6000 0 1 2 3\nCELL_TYPES 1\n10\n"},
  // Fewer types than cells, and more cells than there are.
  {"few_types.vtk", vtkGrid + fourPoints + "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 1\n10\n"},
  {"few_cells.vtk", vtkGrid + fourPoints + "CELLS 2 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n"},
  // Metadata without an end, over which VTK's reader brooded.
  {"metadata.vtk", vtkPolyData + threePoints + metadata + "2147483647\n\n"},
  {"array_length.vtk", vtkPolyData + "FIELD FieldData 1\na 1 99999999 string\nb\n" + threePoints},
  // Polyhedra of absurd counts, and of points that do not exist.
  {"polyhedron.vtk",
    vtkGrid + fourPoints +
      "CELLS 1 18\n17 4000000 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3\nCELL_TYPES 1\n42\n"},
  {"faces.vtu", vtu("42", "4000000000 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3", "4")},
  {"face_id.vtu", vtu("42", "4 3 0 2 99999999 3 0 1 3 3 0 3 2 3 1 2 3", "4")},
  {"other_point.vtu", vtu("42", "4 3 0 2 -1 3 0 1 3 3 0 3 2 3 1 2 3", "4")},
  {"no_faces.vtu", vtu("42", "", "4")},
  // Cells of too few points for their type, and of a type that there is not.
  {"hexahedron.vtu", vtu("12", "", "4")},
  {"bezier.vtu", vtu("80", "", "4")},
  {"type.vtu", vtu("200", "", "4")},
  {"offset.vtu", vtu("10", "", "400")},
  // Bytes that are no zlib data.
  {"base64.vtp",
    "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"><PolyData><Piece "
    "NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" "
    "NumberOfComponents=\"3\" format=\"binary\">"
    "AQAAAACAAAAkAAAA////fwECAwQFBgcI</DataArray></Points></Piece></PolyData></VTKFile>\n"},
  // Elements without properties.
  {"nothing.ply", "ply\nformat ascii 1.0\n" + plyVertices +
                    "element nothing 2\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n"},
  // Quotation marks that are not closed, and one behind which the field goes on.
  {"open_mark.csv", "x,y,z,note\n0,0,0,\"a\n1,0,0,b\n"},
  {"early_mark.csv", "x,y,z,note\n0,0,0,\"a\nb\"c\n1,0,0,d\n"},
};

class BrokenFiles : public testing::TestWithParam<BrokenFile>
{
protected:
  /// The program refuses the file in one line that names it, and soon.
  void expectRefused(const std::vector<std::string>& arguments) const
  {
    const auto start = std::chrono::steady_clock::now();
    const Outcome run = runProgram(arguments);
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({this->GetParam().name + ": "})) << run;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  }

  const TemporaryFolder folder;
};

TEST_P(BrokenFiles, AreRefusedInOneLine)
{
  const std::string file = folder.write(this->GetParam().name, this->GetParam().contents);
  const std::string good = folder.write("good.off", asOff(sphere(1)));
  this->expectRefused({"check", file});
  this->expectRefused({"field", file, "-o", folder.path("a.vti"), "--resolution", "4"});
  this->expectRefused(
    {"field", file, "-o", folder.path("a.vti"), "--points", "--estimate-normals"});
  this->expectRefused({"probe", good, file, "-o", folder.path("a.vtu"), "--extract"});
  this->expectRefused({"probe", file, good, "-o", folder.path("a.csv")});
  EXPECT_EQ(folder.names().size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Small, BrokenFiles, testing::ValuesIn(brokenFiles),
  [](const testing::TestParamInfo<BrokenFile>& file)
  {
    std::string name = file.param.name;
    name[name.find('.')] = '_';
    return name;
  });

/// Ids of points that do not exist: of a surface they are counted, but a data set to be probed is
/// refused by its name, whether its cells are written or not.
TEST(BadIds, OfQueriesAreRefused)
{
  const TemporaryFolder folder;
  const std::string good = folder.write("good.off", asOff(sphere(1)));
  for (const std::string id : {"99999999", "-5", "9223372036854775807"})
  {
    std::string queries = asVtp(sphere(0));
    const std::size_t triangle = queries.find("0 2 4");
    ASSERT_NE(triangle, std::string::npos);
    queries.replace(triangle, 5, "0 2 " + id);
    const std::string file = folder.write("queries.vtp", queries);
    for (const std::string out : {"a.vtu", "a.vtp", "a.csv"})
    {
      for (const std::string more : {"--distance", "--extract"})
      {
        const Outcome run = runProgram({"probe", good, file, "-o", folder.path(out), more});
        EXPECT_EQ(run.status, 2) << run;
        EXPECT_TRUE(
          run.saysInOneLine({"queries.vtp: mend the data set: cell 0", "refers to point " + id}))
          << run;
      }
    }
    const Outcome source = runProgram({"check", file, "--json"});
    EXPECT_EQ(source.status, 0) << source;
    EXPECT_EQ(source.json()["invalid_ids"], 1) << source;
  }
}

/// VTK's reader of PLY crashes on text whose last line has no end, however "format ascii" is
/// written.
TEST(PlyText, NeedsNoEndOfTheLastLine)
{
  const TemporaryFolder folder;
  const std::string rest = plyVertices +
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  for (const std::string format : {"format ascii 1.0\n", "format  ascii 1.0\n",
         "format\tascii 1.0\n", "comment end_header\nformat ascii 1.0\n"})
  {
    const Outcome run =
      runProgram({"check", folder.write("a.ply", "ply\n" + format + rest), "--json"});
    ASSERT_EQ(run.status, 0) << format << run;
    EXPECT_EQ(run.json()["triangles"], 1) << run;
  }
}

/// A pipe, a device or a socket is refused, and nobody waits for a writer.
TEST(NoRegularFile, IsRefusedAtOnce)
{
  const TemporaryFolder folder;
  for (const std::string suffix : {"off", "vtp", "vtk", "ply", "csv", "xyz"})
  {
    const std::string pipe = folder.path("pipe." + suffix);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string device = folder.path("device." + suffix);
    ASSERT_EQ(symlink("/dev/zero", device.c_str()), 0);
    for (const std::string& file : {pipe, device})
    {
      const Outcome run = runProgram({"check", file}, "timeout 20 ");
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_TRUE(run.saysInOneLine({file + ": ", "regular file"})) << run;
    }
  }
  struct sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const std::string name = folder.path("s.off");
  ASSERT_LT(name.size(), sizeof address.sun_path);
  name.copy(address.sun_path, name.size());
  const int socketFile = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socketFile, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  const Outcome run = runProgram({"check", name});
  close(socketFile);
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({name + ": ", "regular file"})) << run;
}

} // namespace
