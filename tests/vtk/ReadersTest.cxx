// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/Gzip.h"
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/FileReading.h"
#include "vtk/ReadMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "vtkWindingNumberReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace reading;

namespace
{

TEST(ReaderOfOff, PolygonsOfAnySize)
{
  const auto mesh = read("OFF\n# a comment\n5 4 0\n0 0 0\n1 0 0 # one\n\n1 1 0\n0 1 0\n"
                         "0.1 -2e-3 +3\n3 0 1 2\n4 0 1 2 3 255 0 0\n2 3 4\n1 4\n",
    ".off");
  EXPECT_EQ(mesh->GetNumberOfPoints(), 5);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectRow(mesh->GetPoints()->GetData(), 4, 0.1, -2e-3, 3);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(mesh->GetNumberOfLines(), 1);
  EXPECT_EQ(mesh->GetNumberOfVerts(), 1);
  vtkIdType size;
  const vtkIdType* ids;
  mesh->GetPolys()->GetCellAtId(1, size, ids);
  EXPECT_EQ(std::vector<vtkIdType>(ids, ids + size), (std::vector<vtkIdType>{0, 1, 2, 3}));
}

TEST(ReaderOfOff, CountsOnTheLineOfTheKeyword)
{
  EXPECT_EQ(read("OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2", ".off")->GetNumberOfPolys(), 1);
  EXPECT_EQ(read("OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", ".off")->GetNumberOfPolys(), 1);
}

TEST(ReaderOfOff, NormalsAreKeptAndColoursPassedOver)
{
  const auto normals = read("NOFF\n1 0 0\n0 0 0 0 0.6 0.8\n", ".off");
  expectRow(normals->GetPointData()->GetNormals(), 0, 0, 0.6, 0.8);
  EXPECT_EQ(normals->GetNumberOfVerts(), 1) << "points alone are to be seen";
  const auto colours = read("COFF\n1 0 0\n1 2 3 255 0 0 255\n", ".off");
  expectRow(colours->GetPoints()->GetData(), 0, 1, 2, 3);
  EXPECT_EQ(colours->GetPointData()->GetNormals(), nullptr);
  const auto all = read("STCNOFF\n1 0 0\n1 2 3 0 0 1 1 0 0 1 0.5 0.5\n", ".off");
  expectRow(all->GetPointData()->GetNormals(), 0, 0, 0, 1);
}

TEST(ReaderOfOff, SpecialNumbers)
{
  const auto mesh = read("OFF\n2 0 0\nnan inf -inf\n1e-400 +1e300 -0\n", ".off");
  const double* first = mesh->GetPoints()->GetData()->GetTuple3(0);
  EXPECT_TRUE(std::isnan(first[0]));
  EXPECT_TRUE(std::isinf(first[1]) && std::isinf(first[2]));
  expectRow(mesh->GetPoints()->GetData(), 1, 0, 1e300, 0);
}

TEST(ReaderOfOff, Refusals)
{
  expectRefusal("", "is empty", end, ".off");
  expectRefusal("# only a comment\n", "keyword OFF", format, ".off");
  expectRefusal("solid\n", "keyword OFF", format, ".off");
  expectRefusal("OFF BINARY\n", "binary", format, ".off");
  expectRefusal("4OFF\n1 0 0\n1 1 1 1\n", "three dimensions", format, ".off");
  expectRefusal("OFF\n", "numbers of vertices", end, ".off");
  expectRefusal("OFF\nx 1 0\n", "line 2: \"x\"", format, ".off");
  expectRefusal("OFF\n-3 1 0\n", "negative: -3", format, ".off");
  expectRefusal("OFF\n99999999999999 1 0\n0 0 0\n", "99999999999999", format, ".off");
  expectRefusal("OFF\n99999999999999999999999 1 0\n0 0 0\n", "line 2", format, ".off");
  expectRefusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", "promises 1 faces but has 0", end, ".off");
  expectRefusal(
    "OFF\n3 1 0\n0 0 0.000000\n1 0 0.000000\n", "promises 3 vertices but has 2", end, ".off");
  expectRefusal(
    "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 zero\n3 0 1 2\n", "line 5: \"zero\"", format, ".off");
  expectRefusal("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4: a coordinate", format, ".off");
  expectRefusal("OFF\n1 0 0\n0 +-1 0\n", "line 3: \"+-1\"", format, ".off");
  expectRefusal(
    "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "vertex 3 does not exist", format, ".off");
  expectRefusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "vertex -1", format, ".off");
  expectRefusal(
    "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "line 6: the face has 3", format, ".off");
  expectRefusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1\n", "the face has -3", format, ".off");
  expectRefusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999 0 1\n", "999999999", format, ".off");
}

TEST(ReaderOfOff, MissingFilesAndNames)
{
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  reader->SetFileName("/nowhere/at/all.off");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  reader->SetFileName("/");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  EXPECT_NE(log.errors().find("/nowhere/at/all.off: no such file"), std::string::npos);
}

TEST(ReaderOfPoints, PositionsOnly)
{
  const auto cloud = read("# x y z\n0 0 0\n1.5 2 -3 # last\n", ".xyz");
  EXPECT_EQ(cloud->GetNumberOfPoints(), 2);
  EXPECT_EQ(cloud->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectRow(cloud->GetPoints()->GetData(), 1, 1.5, 2, -3);
  EXPECT_EQ(cloud->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(cloud->GetNumberOfVerts(), 1);
}

TEST(ReaderOfPoints, NormalsOnTheSameLine)
{
  for (const std::string count : {"", "2\n"})
  {
    const auto cloud = read(count + "0 0 0 0 0 1\n1\t2\t3\t0\t2\t0\r\n", ".xyz");
    EXPECT_EQ(cloud->GetNumberOfPoints(), 2);
    expectRow(cloud->GetPoints()->GetData(), 1, 1, 2, 3);
    expectRow(cloud->GetPointData()->GetNormals(), 1, 0, 2, 0);
    EXPECT_STREQ(cloud->GetPointData()->GetNormals()->GetName(), "Normals");
  }
}

TEST(ReaderOfPoints, NormalsAfterAllPositions)
{
  const auto cloud = read("2\n0 0 0\n1 2 3\n0 0 1\n0 1 0\n", ".xyz");
  EXPECT_EQ(cloud->GetNumberOfPoints(), 2);
  expectRow(cloud->GetPoints()->GetData(), 1, 1, 2, 3);
  expectRow(cloud->GetPointData()->GetNormals(), 0, 0, 0, 1);
  const auto positions = read("2\n0 0 0\n1 2 3\n", ".xyz");
  EXPECT_EQ(positions->GetNumberOfPoints(), 2);
  EXPECT_EQ(positions->GetPointData()->GetNormals(), nullptr);
}

TEST(ReaderOfPoints, Refusals)
{
  expectRefusal("1\n0 0 0\n0 0 1\n5 5 5\n", "promises 1 points, but 3 lines", format, ".xyz");
  expectRefusal("", "is empty", end, ".xyz");
  expectRefusal("# nothing\n\n", "holds no points", end, ".xyz");
  expectRefusal("5\n", "5", format, ".xyz");
  expectRefusal("-2\n0 0 0\n1 1 1\n", "negative: -2", format, ".xyz");
  expectRefusal("99999999999\n0 0 0\n", "99999999999", format, ".xyz");
  expectRefusal(
    "3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "promises 3 points, but 4 lines", format, ".xyz");
  expectRefusal("0 0\n", "line 1: holds 2 words", format, ".xyz");
  expectRefusal("0 0 0 1\n", "line 1: holds 4 words", format, ".xyz");
  expectRefusal("0 0 0\n0 0 1 0 0 1\n", "line 2: holds more", format, ".xyz");
  expectRefusal("0 0 0 0 0 1\n0 0 1\n", "line 2: a number is missing", format, ".xyz");
  expectRefusal("0 0 0\n0 C 0\n", "line 2: \"C\"", format, ".xyz");
  expectRefusal(std::string("0 0 0\n\0\x01 2 3\n", 13), "line 2", format, ".xyz");
}

TEST(ReaderOfPoints, ReadsAgainWhenTheNameChanges)
{
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->SetFileName("/nowhere.xyz");
  reader->Update();
  EXPECT_NE(log.errors(), "");
  const TextFile file("1 2 3\n", ".xyz");
  reader->SetFileName(file.path());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

const std::string objTriangle = "v 0 0 0\nv 0.1 0 0\nv 0 123456789.123 0\n";

TEST(ReaderOfMeshes, ObjInDoublePrecision)
{
  const auto mesh = read(objTriangle + "f 1 2 3\nl 1 2\np 3\n", ".OBJ");
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectRow(mesh->GetPoints()->GetData(), 1, 0.1, 0, 0);
  expectRow(mesh->GetPoints()->GetData(), 2, 0, 123456789.123, 0);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
  EXPECT_EQ(mesh->GetNumberOfLines(), 1);
  EXPECT_EQ(mesh->GetNumberOfVerts(), 1);
  EXPECT_EQ(mesh->GetPointData()->GetNormals(), nullptr);
  vtkIdType size;
  const vtkIdType* ids;
  mesh->GetPolys()->GetCellAtId(0, size, ids);
  EXPECT_EQ(std::vector<vtkIdType>(ids, ids + size), (std::vector<vtkIdType>{0, 1, 2}));
}

TEST(ReaderOfMeshes, ObjOfPointsWithNormals)
{
  const auto cloud = read("v 1 2 3\nvn 0 0 0.1\n", ".obj");
  EXPECT_EQ(cloud->GetNumberOfCells(), 0);
  expectRow(cloud->GetPointData()->GetNormals(), 0, 0, 0, 0.1);
  EXPECT_STREQ(cloud->GetPointData()->GetNormals()->GetName(), "Normals");
}

/// Cells that are no polygons come first, and belong to no region.
TEST(ReaderOfMeshes, RegionsArePolygons)
{
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
                    faces = "g left\nf 1 2 3\ng right\nf 3 2 1\nf 1 2 3\n";
  for (const std::string others : {"", "l 1 2 3\nl 2 3\n", "p 1\n", "l 1 2\np 1\np 2\n"})
  {
    const auto mesh = read(corners + others + faces, ".obj");
    vtkDataArray* const ids = mesh->GetCellData()->GetArray("GroupIds");
    ASSERT_TRUE(ids && ids->GetNumberOfTuples() == mesh->GetNumberOfCells()) << others;
    std::vector<int> expected(static_cast<std::size_t>(mesh->GetNumberOfCells()) - 3, -1);
    expected.insert(expected.end(), {0, 1, 1});
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(ids->GetComponent(static_cast<vtkIdType>(i), 0), expected[i]) << others << i;
    }
  }
}

TEST(ReaderOfMeshes, Refusals)
{
  expectRefusal("", "is empty", end, ".obj");
  expectRefusal("hello\n", "is not OBJ", format, ".obj");
  expectRefusal(objTriangle + "f 1 2 4\n", "line 4: vertex 4 does not", format, ".obj");
  expectRefusal("v 0 0 0\n", "has a suffix that is not known; give", format, ".step");
}

/// The output is VTK's, which may take hold of memory that others have allocated.
TEST(ReaderOfMeshes, OutputsGrowAsAllOthers)
{
  const auto mesh = read(objTriangle + "f 1 2 3\n", ".obj");
  mesh->GetPoints()->InsertNextPoint(4, 5, 6);
  const vtkIdType ids[] = {1, 2, 3};
  mesh->GetPolys()->InsertNextCell(3, ids);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
  expectRow(mesh->GetPoints()->GetData(), 3, 4, 5, 6);
}

const std::string plyHead = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                            "property double y\nproperty double z\n";
const std::string plyFace = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(ReaderOfMeshes, PlyWithNormals)
{
  const auto mesh = read(plyHead + "property float nx\nproperty float ny\nproperty float nz\n" +
                           plyFace + "0 0 0 0 0 1\n0.1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n",
    ".ply");
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectRow(mesh->GetPoints()->GetData(), 1, 0.1, 0, 0);
  expectRow(mesh->GetPointData()->GetNormals(), 1, 0, 1, 0);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
}

TEST(ReaderOfMeshes, PlyWithColoursAndTextureCoordinates)
{
  const auto mesh =
    read(plyHead +
           "property uchar red\nproperty uchar green\nproperty uchar blue\n"
           "property float u\nproperty float v\n" +
           plyFace + "0 0 0 1 2 3 0.5 0.25\n1 0 0 4 5 6 0 0\n0 1 0 7 8 255 1 1\n3 0 1 2\n",
      ".ply");
  vtkDataArray* const colors = mesh->GetPointData()->GetScalars();
  ASSERT_TRUE(colors);
  EXPECT_STREQ(colors->GetName(), "RGB");
  EXPECT_EQ(colors->GetDataType(), VTK_UNSIGNED_CHAR);
  expectRow(colors, 2, 7, 8, 255);
  vtkDataArray* const coordinates = mesh->GetPointData()->GetTCoords();
  ASSERT_TRUE(coordinates);
  EXPECT_STREQ(coordinates->GetName(), "TCoords");
  EXPECT_EQ(coordinates->GetComponent(0, 1), 0.25);
}

/// Vertices and faces may have colours of different numbers of components.
TEST(ReaderOfMeshes, PlyWithColoursOfVerticesAndFaces)
{
  const auto colors = [](bool hasAlpha)
  {
    return std::string("property uchar red\nproperty uchar green\nproperty uchar blue\n") +
           (hasAlpha ? "property uchar alpha\n" : "");
  };
  for (const bool haveFacesAlpha : {false, true})
  {
    const std::string ofVertices = haveFacesAlpha ? " 4 5 6\n" : " 4 5 6 7\n";
    const TextFile file(plyHead + colors(!haveFacesAlpha) +
                          "element face 1\nproperty list uchar int vertex_indices\n" +
                          colors(haveFacesAlpha) + "end_header\n0 0 0" + ofVertices + "1 0 0" +
                          ofVertices + "0 1 0" + ofVertices + "3 0 1 2 1 2 3" +
                          (haveFacesAlpha ? " 9\n" : "\n"),
      ".ply");
    vtkNew<vtkWindingNumberReader> reader;
    reader->SetFileName(file.path());
    reader->ReadAllColumnsOn();
    reader->Update();
    vtkDataArray* const vertices = reader->GetOutput()->GetPointData()->GetScalars();
    vtkDataArray* const faces = reader->GetOutput()->GetCellData()->GetScalars();
    ASSERT_TRUE(vertices && faces);
    EXPECT_STREQ(vertices->GetName(), haveFacesAlpha ? "RGB" : "RGBA");
    EXPECT_STREQ(faces->GetName(), haveFacesAlpha ? "RGBA" : "RGB");
    EXPECT_EQ(vertices->GetNumberOfComponents(), haveFacesAlpha ? 3 : 4);
    ASSERT_EQ(faces->GetNumberOfComponents(), haveFacesAlpha ? 4 : 3);
    ASSERT_EQ(faces->GetNumberOfTuples(), 1);
    EXPECT_EQ(faces->GetComponent(0, haveFacesAlpha ? 3 : 2), haveFacesAlpha ? 9 : 3);
  }
}

TEST(ReaderOfMeshes, RefusalsOfPlyAndStl)
{
  expectRefusal("solid\n", "is not ply: it does not begin like PLY", format, ".ply");
  expectRefusal(
    plyHead + plyFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13: vertex 3", format, ".ply");
  expectRefusal(
    plyHead + plyFace + "0 0 0\n1 0 0\n", "line 11: a number is missing", format, ".ply");
  expectRefusal("hello\n", "is not STL: it is text without solid", format, ".stl");
  expectRefusal("solid\nfacet\n", "ends at line 2 with 0 facets", end, ".stl");
}

vtkSmartPointer<vtkPolyData> readWithVtk(const std::string& path)
{
  if (path.substr(path.rfind('.')) != ".stl")
  {
    return readMesh(path);
  }
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff();
  reader->Update();
  return reader->GetOutput();
}

/// VTK's readers keep single precision, and that of OBJ makes several points of a vertex whose
/// corners have different normals.
TEST(ReaderOfMeshes, SharedFilesAsVtkReadsThem)
{
  for (const std::string name :
    shapes::present({"armadillo_86k.obj", "bunny_10k.obj", "bunny_1k.obj", "bunny_70k.obj",
      "maxplanck_open_90k.obj", "self_intersectA.obj", "sphere_quads.obj", "teapot.obj",
      "truck_soup.obj", "armadillo_346k_sub4.ply", "bunny_res2_nonmanifold.ply",
      "aneurysm_open.stl", "conrod_flipped.stl", "icosahedron.stl", "tray_thin_cad.stl"}))
  {
    const std::string path = shapes::realMesh(name);
    const auto expected = readWithVtk(path), found = readWith<vtkWindingNumberReader>(path);
    ASSERT_EQ(found->GetNumberOfPolys(), expected->GetNumberOfPolys()) << name;
    EXPECT_LE(found->GetNumberOfPoints(), expected->GetNumberOfPoints()) << name;
    vtkNew<vtkIdList> expectedIds, foundIds;
    for (vtkIdType cell = 0; cell < found->GetNumberOfPolys(); ++cell)
    {
      expected->GetPolys()->GetCellAtId(cell, expectedIds);
      found->GetPolys()->GetCellAtId(cell, foundIds);
      ASSERT_EQ(foundIds->GetNumberOfIds(), expectedIds->GetNumberOfIds()) << name << cell;
      for (vtkIdType corner = 0; corner < foundIds->GetNumberOfIds(); ++corner)
      {
        const double* const point = found->GetPoint(foundIds->GetId(corner));
        const float rounded[] = {
          static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
        const double* const vtk = expected->GetPoint(expectedIds->GetId(corner));
        for (int axis = 0; axis < 3; ++axis)
        {
          ASSERT_EQ(rounded[axis], static_cast<float>(vtk[axis])) << name << " cell " << cell;
        }
      }
    }
  }
}

TEST(ReaderOfMeshes, SharedCloudAsVtkReadsIt)
{
  const std::string path = std::string(WINDING_SHARED_DATA) + "/kitten_points_normals.ply";
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is not there";
  }
  const auto expected = readMesh(path), found = readWith<vtkWindingNumberReader>(path);
  ASSERT_EQ(found->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(found->GetPoints()->GetDataType(), VTK_FLOAT);
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    const double* const point = expected->GetPoint(i);
    expectRow(found->GetPoints()->GetData(), i, point[0], point[1], point[2]);
    const double* const normal = expected->GetPointData()->GetNormals()->GetTuple3(i);
    expectRow(found->GetPointData()->GetNormals(), i, normal[0], normal[1], normal[2]);
  }
}

/// Points in text, which is longer than what is read and unpacked at once.
std::string manyPoints()
{
  std::string text;
  for (int i = 0; text.size() < 3000000; ++i)
  {
    text += std::to_string(i) + " " + std::to_string(i % 89) + " 0.25\n";
  }
  return text;
}

TEST(ReaderOfPackedFiles, GivesWhatIsPacked)
{
  const std::string points = manyPoints();
  const auto plain = read(points, ".xyz");
  const std::size_t half = points.find('\n', points.size() / 2) + 1;
  const std::string parts = gzip(points.substr(0, half)) + gzip("") + gzip(points.substr(half));
  for (const std::string& packed : {gzip(points), parts, parts + std::string(512, '\0')})
  {
    const auto mesh = read(packed, ".xyz.GZ");
    ASSERT_EQ(mesh->GetNumberOfPoints(), plain->GetNumberOfPoints());
    const auto values = 3 * static_cast<std::size_t>(mesh->GetNumberOfPoints());
    const auto* const expected = static_cast<double*>(plain->GetPoints()->GetVoidPointer(0));
    const auto* const got = static_cast<double*>(mesh->GetPoints()->GetVoidPointer(0));
    EXPECT_TRUE(std::equal(got, got + values, expected));
  }
  EXPECT_EQ(read(gzip("x,y,z\n1,2,3\n"), ".csv.gz")->GetNumberOfPoints(), 1);
}

TEST(ReaderOfPackedFiles, RefusesDamagedOnes)
{
  const std::string whole = gzip("1 2 3\n4 5 6\n");
  for (std::size_t bytes = 1; bytes < whole.size(); ++bytes)
  {
    expectRefusal(whole.substr(0, bytes), "it is damaged", end, ".xyz.gz");
  }
  std::string other = whole;
  other[other.size() - 6] ^= 1; // of the checksum
  expectRefusal(other, "it is damaged", format, ".xyz.gz");
  expectRefusal("1 2 3\n", "is not packed by gzip", format, ".xyz.gz");
  expectRefusal(whole + "more", "is damaged", format, ".xyz.gz");
  expectRefusal(gzip(""), "is empty when it is unpacked", end, ".xyz.gz");
  expectRefusal(whole, "suffix that is not known", format, ".gz");
  expectRefusal(gzip("1 2 3\n4 five 6\n"), "line 2", format, ".xyz.gz");
}

} // namespace
