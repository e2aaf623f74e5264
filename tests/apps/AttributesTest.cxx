// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

/**
 * Colours, texture coordinates and regions of files stay with surfaces, and with their files.
 */
namespace
{

/// The colour of a place on the unit sphere, 0 to 255.
double colorOf(const double position[3], int component)
{
  return 128 + 100 * position[component];
}

class Attributes : public testing::Test
{
protected:
  /// A sphere with colours, texture coordinates that are x and y, and two objects, below and above.
  std::string colored()
  {
    const Mesh mesh = sphere(5);
    std::ostringstream text;
    text.precision(9);
    for (const auto& point : mesh.points)
    {
      text << "v";
      for (const double x : point)
      {
        text << ' ' << x;
      }
      for (int component = 0; component < 3; ++component)
      {
        text << ' ' << colorOf(point.data(), component) / 255;
      }
      text << "\nvt " << point[0] << ' ' << point[1] << '\n';
    }
    for (const bool isAbove : {false, true})
    {
      text << (isAbove ? "o upper part\n" : "o lower\n");
      for (const auto& t : mesh.triangles)
      {
        double height = 0;
        for (const auto corner : t)
        {
          height += mesh.points[static_cast<std::size_t>(corner)][2];
        }
        if ((height > 0) == isAbove)
        {
          text << 'f';
          for (const auto corner : t)
          {
            text << ' ' << corner + 1 << '/' << corner + 1;
          }
          text << '\n';
        }
      }
    }
    return folder.write("scan.obj", text.str());
  }

  std::string surfaceOf(const std::string& in, const std::string& name)
  {
    const std::string out = folder.path(name);
    const Outcome run =
      runProgram({"surface", in, "-o", out, "--resolution", "40", "--transfer-attributes"});
    EXPECT_EQ(run.status, 0) << run;
    const bool losesNames = name.find(".ply") != std::string::npos;
    const std::string names = "the format does not hold ObjectNames; .vtp holds all arrays";
    EXPECT_EQ(run.err.find(names) != std::string::npos, losesNames) << run;
    EXPECT_EQ(run.err.find("warning") != std::string::npos, losesNames) << run;
    return out;
  }

  TemporaryFolder folder;
};

vtkSmartPointer<vtkPolyData> read(const std::string& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

} // namespace

TEST_F(Attributes, StayThroughAllFormatsThatHoldThem)
{
  const std::string scan = colored();
  for (const std::string suffix : {"ply", "obj", "vtp"})
  {
    SCOPED_TRACE(suffix);
    const std::string again = surfaceOf(surfaceOf(scan, "solid." + suffix), "again.vtp");
    const auto surface = read(again);
    vtkDataArray* const colors = surface->GetPointData()->GetScalars();
    vtkDataArray* const texture = surface->GetPointData()->GetTCoords();
    vtkDataArray* const objects = surface->GetCellData()->GetArray("ObjectIds");
    ASSERT_TRUE(colors && texture && objects);
    ASSERT_STREQ(colors->GetName(), "RGB");
    double worst = 0, worstTexture = 0;
    for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
    {
      double position[3];
      surface->GetPoint(n, position);
      for (int component = 0; component < 3; ++component)
      {
        worst = std::max(
          worst, std::abs(colors->GetComponent(n, component) - colorOf(position, component)));
      }
      for (int axis = 0; axis < 2; ++axis)
      {
        worstTexture =
          std::max(worstTexture, std::abs(texture->GetComponent(n, axis) - position[axis]));
      }
    }
    EXPECT_LT(worst, 1.6);          // measured
    EXPECT_LT(worstTexture, 0.001); // measured
    for (vtkIdType n = 0; n < surface->GetNumberOfCells(); ++n)
    {
      double bounds[6];
      surface->GetCellBounds(n, bounds);
      if (bounds[4] > 0.1 || bounds[5] < -0.1)
      {
        ASSERT_EQ(objects->GetTuple1(n), bounds[4] > 0 ? 1 : 0);
      }
    }
  }
  EXPECT_NE(contentsOf(folder.path("solid.obj")).find("\no upper part\n"), std::string::npos);
}

TEST_F(Attributes, ThatAFormatDoesNotHoldAreNamed)
{
  const std::string scan = colored();
  const auto warningOf = [&](const std::string& name)
  {
    const Outcome run = runProgram({"surface", scan, "-o", folder.path(name), "--resolution", "20",
      "--transfer-attributes", "--nearest-cells"});
    EXPECT_EQ(run.status, 0) << run;
    return run.err;
  };
  EXPECT_NE(warningOf("out.stl").find("does not hold RGB, TCoords, NearestCell, ObjectIds;"),
    std::string::npos);
  EXPECT_NE(warningOf("out.obj").find("does not hold NearestCell;"), std::string::npos);
  EXPECT_NE(warningOf("out.ply").find("does not hold ObjectNames;"), std::string::npos);
  EXPECT_EQ(warningOf("out.vtp").find("does not hold"), std::string::npos);
}

TEST_F(Attributes, TransparencyIsNamedWhereObjDropsIt)
{
  for (const int alpha : {128, 255})
  {
    const Mesh mesh = sphere(3);
    std::ostringstream text;
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size();
    for (const char* name :
      {"float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "uchar alpha"})
    {
      text << "\nproperty " << name;
    }
    text << "\nelement face " << mesh.triangles.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& point : mesh.points)
    {
      text << point[0] << ' ' << point[1] << ' ' << point[2] << " 10 20 30 " << alpha << '\n';
    }
    for (const auto& t : mesh.triangles)
    {
      text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
    const std::string in = folder.write("glass.ply", text.str());
    const Outcome run = runProgram({"surface", in, "-o", folder.path("glass.obj"), "--resolution",
      "20", "--transfer-attributes"});
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err.find("does not hold alpha of RGBA;") != std::string::npos, alpha == 128)
      << run;
  }
}

/// Groups of two files, whose names differ, keep them.
TEST_F(Attributes, OfBooleansKeepTheNamesOfRegions)
{
  const auto grouped = [this](const std::string& name, double x)
  {
    Mesh mesh = sphere(3);
    for (auto& point : mesh.points)
    {
      point[0] += x;
    }
    std::string text = asObj(mesh);
    text.insert(text.rfind("\nf ") + 1, "g lid\n");
    text.insert(text.find("\nf ") + 1, "g " + name + '\n');
    return folder.write(name + ".obj", text);
  };
  const std::string out = folder.path("both.obj");
  const Outcome run = runProgram({"boolean", grouped("wall", 0), grouped("inlet", 0.8), "-o", out,
    "--resolution", "20", "--transfer-attributes"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err.find("not taken over"), std::string::npos) << run;
  const std::string text = contentsOf(out);
  EXPECT_NE(text.find("\ng wall\n"), std::string::npos);
  EXPECT_NE(text.find("\ng inlet\n"), std::string::npos);
}

TEST_F(Attributes, OfBooleansNameTheInputOfEachFace)
{
  const std::string scan = colored();
  Mesh tool = sphere(4);
  for (auto& point : tool.points)
  {
    point[0] += 0.8;
  }
  const std::string other = folder.write("tool.off", asOff(tool));
  const std::string out = folder.path("cut.vtp");
  const Outcome run = runProgram({"boolean", scan, other, "-o", out, "--operation", "difference",
    "--resolution", "30", "--nearest-cells", "--transfer-attributes"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_NE(run.err.find("TCoords, ObjectIds are not taken over"), std::string::npos) << run;
  EXPECT_NE(run.err.find("some inputs have no colors: give all colors; RGB is white there"),
    std::string::npos)
    << run;
  const auto surface = read(out);
  vtkDataArray* const blocks = surface->GetCellData()->GetArray("NearestBlock");
  ASSERT_TRUE(blocks && surface->GetCellData()->GetArray("NearestCell"));
  vtkDataArray* const colors = surface->GetPointData()->GetScalars();
  vtkDataArray* const ofPoints = surface->GetPointData()->GetArray("NearestBlock");
  ASSERT_TRUE(colors && ofPoints);
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
  {
    double position[3];
    surface->GetPoint(n, position);
    const bool isOfScan = ofPoints->GetTuple1(n) == 1;
    ASSERT_NEAR(colors->GetComponent(n, 2), isOfScan ? colorOf(position, 2) : 255, 3);
  }
  EXPECT_EQ(blocks->GetRange()[0], 1);
  EXPECT_EQ(blocks->GetRange()[1], 2);
}

TEST_F(Attributes, OfMeshesAndCloudsAtOnceAreRefusedAtOnce)
{
  const std::string mesh = folder.write("mesh.off", asOff(sphere(3)));
  const std::string cloud = folder.write("cloud.xyz", asXyz(sphere(3)));
  const auto run = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = {
      "boolean", mesh, cloud, "-o", folder.path("out.vtp"), "--resolution", "20"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  };
  EXPECT_EQ(run({}).status, 0);
  EXPECT_EQ(run({"--nearest-cells", "--points"}).status, 0);
  for (const std::string option : {"--nearest-cells", "--transfer-attributes"})
  {
    const Outcome refused = run({option});
    EXPECT_EQ(refused.status, 2) << refused;
    EXPECT_TRUE(refused.saysInOneLine({option, "not for both at once; take inputs of one kind"}))
      << refused;
  }
}

TEST_F(Attributes, OfFieldsVoxelsAndProbesAreIdsOfCells)
{
  const std::string scan = colored();
  const auto run = [&](const std::vector<std::string>& arguments)
  {
    const Outcome outcome = runProgram(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome;
    return outcome.err;
  };
  const std::string blocks = folder.path("blocks.vtp");
  run({"voxels", scan, "-o", blocks, "--resolution", "20", "--transfer-attributes",
    "--nearest-cells"});
  EXPECT_TRUE(read(blocks)->GetPointData()->HasArray("RGB"));
  EXPECT_TRUE(read(blocks)->GetCellData()->HasArray("NearestCell"));
  const std::string queries = folder.write("queries.csv", "x,y,z\n0,0,2\n0,0,-2\n");
  const std::string answers = folder.path("answers.csv");
  run({"probe", scan, scan, queries, "-o", answers, "--nearest-cells"});
  const std::string table = contentsOf(answers);
  EXPECT_EQ(
    table.substr(0, table.find('\n')), "x,y,z,WindingNumber,Inside,NearestCell,NearestBlock");
  run({"field", scan, "-o", folder.path("field.vti"), "--resolution", "10", "--nearest-cells"});
  run({"field", scan, "-o", folder.path("field.pvti"), "--resolution", "10", "--nearest-cells",
    "--pieces", "2"});
  EXPECT_NE(contentsOf(folder.path("field.pvti")).find("type=\"Int64\" Name=\"NearestCell\""),
    std::string::npos);
  const Outcome refused =
    runProgram({"field", scan, "-o", folder.path("field.nrrd"), "--nearest-cells"});
  EXPECT_EQ(refused.status, 1) << refused;
  EXPECT_TRUE(refused.saysInOneLine({"--nearest-cells", ".nrrd"})) << refused;
}
