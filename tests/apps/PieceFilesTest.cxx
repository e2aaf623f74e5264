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

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <sys/stat.h>

// Files with parts: indices of VTK's XML files, and glTF, whose nodes place meshes.

namespace
{

class PieceFiles : public ::testing::Test
{
protected:
  nlohmann::json check(const std::string& fileName) const
  {
    const Outcome run = runProgram({"check", folder.path(fileName), "--json"});
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    return run.status == 0 ? run.json() : nlohmann::json();
  }

  void expectRefused(const std::string& fileName, const std::string& words) const
  {
    const Outcome run =
      runProgram({"field", folder.path(fileName), "-o", folder.path("out.vti"), "--quiet"});
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({fileName + ": ", words})) << run;
  }

  /// Writes both halves of a sphere as `suffix`.
  void writeHalves(const std::string& suffix) const
  {
    Mesh halves[] = {sphere(3), sphere(3)};
    const auto middle = halves[0].triangles.begin() + 100;
    halves[1].triangles.assign(middle, halves[0].triangles.end());
    halves[0].triangles.erase(middle, halves[0].triangles.end());
    folder.write("a" + suffix, asFile(halves[0], suffix.substr(1)));
    folder.write("b & c" + suffix, asFile(halves[1], suffix.substr(1)));
  }

  TemporaryFolder folder;
};

std::string xmlFile(const std::string& type, const std::string& content)
{
  return "<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"LittleEndian\"><" + type +
         ">" + content + "</" + type + "></VTKFile>";
}

std::string pieces(const std::string& type, const std::string& first, const std::string& second)
{
  return xmlFile(type, R"(<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>)"
                       R"(<Piece Source=")" +
                         first + R"("/><Piece Source=")" + second + R"("/>)");
}

std::string blocks(const std::string& first, const std::string& second)
{
  return xmlFile("vtkMultiBlockDataSet", R"(<DataSet index="0" name="left" file=")" + first +
                                           R"("/><Block index="1" name="group"><DataSet index="0")"
                                           R"( name="right" file=")" +
                                           second + R"("/><DataSet index="1"/></Block>)");
}

template <class Number> std::string bytesOf(const std::vector<Number>& numbers)
{
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// The buffer of a glTF file: the unit cube's corners, and its triangles.
std::string cubeBuffer()
{
  std::vector<float> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners.insert(
      corners.end(), {static_cast<float>(corner & 1), static_cast<float>(corner >> 1 & 1),
                       static_cast<float>(corner >> 2)});
  }
  const std::vector<std::uint16_t> ids = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 1,
    3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};
  return bytesOf(corners) + bytesOf(ids);
}

/// A glTF file of two nodes that place the cube of a buffer; `uri` says where that is.
std::string gltfOf(const std::string& uri)
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],"nodes":[
    {"translation":[10,0,0],"children":[1]},{"mesh":0,"scale":[2,3,1]},
    {"mesh":0,"translation":[0,0,5]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[
    {"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
    {"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],"bufferViews":[
    {"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],
    "buffers":[{"byteLength":168)" +
         uri + "}]}";
}

/// The same in binary, with the buffer behind it unless `uri` says where that is.
std::string binaryGltf(const std::string& uri = "")
{
  std::string words = gltfOf(uri), buffer = uri.empty() ? cubeBuffer() : "";
  words.resize((words.size() + 3) / 4 * 4, ' ');
  const auto size = [](std::size_t bytes)
  {
    return bytesOf<std::uint32_t>({static_cast<std::uint32_t>(bytes)});
  };
  if (!buffer.empty())
  {
    buffer = size(buffer.size()) + std::string("BIN\0", 4) + buffer;
  }
  return "glTF" + size(2) + size(20 + words.size() + buffer.size()) + size(words.size()) + "JSON" +
         words + buffer;
}

TEST_F(PieceFiles, AreOneSurface)
{
  this->writeHalves(".vtp");
  this->writeHalves(".vtu");
  folder.write("a.pvtp", pieces("PPolyData", "a.vtp", "b &amp; c.vtp"));
  folder.write("a.pvtu", pieces("PUnstructuredGrid", "a.vtu", "b &amp; c.vtu"));
  folder.write("a.vtm", blocks("a.vtp", "b &amp; c.vtu"));
  for (const char* const name : {"a.pvtp", "a.pvtu", "a.vtm"})
  {
    const nlohmann::json report = this->check(name);
    EXPECT_EQ(report["closed"], true) << name << report;
    EXPECT_EQ(report["triangles"], sphere(3).triangles.size()) << name;
  }
}

TEST_F(PieceFiles, OfBlocksHaveASolidEach)
{
  folder.write("a.vtp", asVtp(sphere(2)));
  Mesh far = sphere(2);
  for (auto& point : far.points)
  {
    point[0] += 3;
  }
  folder.write("far.vtp", asVtp(far));
  const std::string in = folder.write("a.vtm", blocks("a.vtp", "far.vtp"));
  const Outcome run = runProgram({"labels", in, "-o", folder.path("out.vti"), "--json"});
  ASSERT_EQ(run.status, 0) << run;
  const nlohmann::json labels = run.json()["labels"];
  ASSERT_GE(labels.size(), 2U) << labels;
  EXPECT_EQ(labels[0]["name"], "left");
  EXPECT_EQ(labels[1]["name"], "right");
  // Queries are written as one data set.
  const Outcome probe = runProgram({"probe", in, in, "-o", folder.path("out.vtu")});
  EXPECT_TRUE(probe.saysInOneLine({"a.vtm: has several blocks"})) << probe;
}

TEST_F(PieceFiles, OfGltfAreWhereTheirNodesPlaceThem)
{
  folder.write("cube.bin", cubeBuffer());
  folder.write("a.gltf", gltfOf(R"(,"uri":"cube.bin")"));
  folder.write("a.glb", binaryGltf());
  for (const char* const name : {"a.gltf", "a.glb"})
  {
    const nlohmann::json report = this->check(name);
    EXPECT_NEAR(report["volume"], 7, 1e-12) << name; // 2 x 3 x 1 and 1
    EXPECT_EQ(report["bbox"], (std::vector<double>{0, 0, 0, 12, 3, 6})) << name;
  }
}

TEST_F(PieceFiles, OfGltfHaveTheShapeThatNodesGiveThem)
{
  // A target moves the far face, z = 1, by 1: by the mesh it is left out, by one node taken.
  std::vector<float> moves(24, 0);
  for (std::size_t corner = 4; corner < 8; ++corner)
  {
    moves[3 * corner + 2] = 1;
  }
  folder.write("cube.bin", cubeBuffer() + bytesOf(moves));
  nlohmann::json file = nlohmann::json::parse(gltfOf(R"(,"uri":"cube.bin")"));
  file["buffers"][0]["byteLength"] = 264;
  file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 168}, {"byteLength", 96}});
  file["accessors"].push_back(
    {{"bufferView", 2}, {"componentType", 5126}, {"count", 8}, {"type", "VEC3"}});
  file["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 2}}};
  file["meshes"][0]["weights"] = {0};
  folder.write("a.gltf", file.dump());
  EXPECT_NEAR(this->check("a.gltf")["volume"], 7, 1e-12);
  file["nodes"][1]["weights"] = {1};
  folder.write("a.gltf", file.dump());
  EXPECT_NEAR(this->check("a.gltf")["volume"], 13, 1e-12) << "2 x 3 x 2 and 1";
}

TEST_F(PieceFiles, OfGltfMayMirrorAndMoveInAllWays)
{
  folder.write("cube.bin", cubeBuffer());
  const nlohmann::json whole = nlohmann::json::parse(gltfOf(R"(,"uri":"cube.bin")"));
  const auto reportOn = [&](const std::function<void(nlohmann::json&)>& change)
  {
    nlohmann::json file = whole;
    change(file);
    folder.write("a.gltf", file.dump());
    return this->check("a.gltf");
  };
  // The volume is 7 in each case: a mirrored node looks outward, too.
  const std::vector<std::function<void(nlohmann::json&)>> changes = {
    [](nlohmann::json& file) {
      file["nodes"][1]["scale"] = {-2, 3, 1};
    },
    [](nlohmann::json& file) {
      file["nodes"][0]["scale"] = {1, -1, 1};
    },
    [](nlohmann::json& file)
    {
      file["nodes"][1].erase("scale");
      file["nodes"][1]["matrix"] = {0, 2, 0, 0, 3, 0, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1};
    },
    [](nlohmann::json& file) { file.erase("scenes"), file.erase("scene"); },
    [](nlohmann::json& file)
    {
      file["extensionsUsed"] = {"KHR_materials_clearcoat", "SOME_extension"};
      file["images"] = {{{"uri", "gone.png"}}};
      file["textures"] = {{{"source", 0}}};
    },
    [](nlohmann::json& file) {
      file["nodes"][0]["rotation"] = {0, 0, 0.6, 0.8};
    },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const nlohmann::json report = reportOn(changes[i]);
    EXPECT_NEAR(report["volume"], 7, 1e-6) << i;
    EXPECT_EQ(report["inverted_components"], 0) << i;
  }
  // Data of any type in the text, lines next to faces, and what no reader can do.
  const nlohmann::json embedded = reportOn(
    [](nlohmann::json& file)
    {
      file["buffers"] = {
        {{"byteLength", 12}, {"uri", "data:;base64,AAAAAAAAgD8AAABA"}}, file["buffers"][0]};
      file["bufferViews"][0]["buffer"] = 1;
      file["bufferViews"][1]["buffer"] = 1;
      file["meshes"][0]["primitives"].push_back({{"mode", 1}, {"attributes", {{"POSITION", 0}}}});
    });
  EXPECT_NEAR(embedded["volume"], 7, 1e-12);
  EXPECT_NE(embedded["advice"].get<std::string>().find("8 are left out"), std::string::npos)
    << embedded["advice"];
  nlohmann::json packed = whole;
  packed["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  folder.write("packed.gltf", packed.dump());
  this->expectRefused("packed.gltf", "needs the extension KHR_draco_mesh_compression");
  // Blocks have the names of nodes.
  nlohmann::json named = whole;
  named["nodes"][1]["name"] = "wall";
  named["meshes"][0]["name"] = "cube";
  const std::string in = folder.write("named.gltf", named.dump());
  const nlohmann::json labels =
    runProgram({"labels", in, "-o", folder.path("out.vti"), "--json"}).json()["labels"];
  EXPECT_EQ(labels[0]["name"], "wall");
  EXPECT_EQ(labels[1]["name"], "cube");
}

/// The extension that a packed mesh needs is named, even where accessors have no data.
TEST_F(PieceFiles, OfGltfThatArePackedNameTheExtension)
{
  for (const std::string extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
  {
    for (const char* const list : {"extensionsRequired", "extensionsUsed"})
    {
      nlohmann::json file = nlohmann::json::parse(gltfOf(R"(,"uri":"cube.bin")"));
      folder.write("cube.bin", cubeBuffer());
      file[list] = {extension};
      file["meshes"][0]["primitives"][0]["extensions"] = {{extension, {{"bufferView", 0}}}};
      for (nlohmann::json& accessor : file["accessors"])
      {
        accessor.erase("bufferView");
      }
      folder.write("a.gltf", file.dump());
      this->expectRefused("a.gltf", "needs the extension " + extension);
      file["meshes"][0]["primitives"][0].erase("indices");
      folder.write("a.gltf", file.dump());
      if (extension == "KHR_draco_mesh_compression")
      {
        this->expectRefused("a.gltf", "needs the extension " + extension);
      }
    }
  }
}

/// Weights of joints may have any sum, and there may be more than four for a vertex.
TEST_F(PieceFiles, OfGltfFollowTheJointsOfASkin)
{
  // Two joints, 4 and 6 further along x. Half of the corners follow the first, the other half both.
  std::vector<std::uint8_t> joints;
  std::vector<float> weights, more;
  for (int corner = 0; corner < 8; ++corner)
  {
    joints.insert(joints.end(), {0, 1, 0, 0});
    const bool isFirst = corner < 4;
    weights.insert(weights.end(), {isFirst ? 0.25F : 0.5F, 0, 0, 0});
    more.insert(more.end(), {0, isFirst ? 0.F : 0.5F, 0, 0});
  }
  const std::string buffer = cubeBuffer() + bytesOf(joints) + bytesOf(weights) + bytesOf(more);
  folder.write("cube.bin", buffer);
  nlohmann::json file = nlohmann::json::parse(gltfOf(R"(,"uri":"cube.bin")"));
  file["buffers"][0]["byteLength"] = buffer.size();
  std::size_t at = 168;
  for (const std::size_t bytes : {joints.size(), 4 * weights.size(), 4 * more.size()})
  {
    const std::size_t view = file["bufferViews"].size();
    file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes}});
    file["accessors"].push_back({{"bufferView", view}, {"count", 8}, {"type", "VEC4"},
      {"componentType", bytes == joints.size() ? 5121 : 5126}});
    at += bytes;
  }
  nlohmann::json& attributes = file["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = attributes["JOINTS_1"] = 2;
  attributes["WEIGHTS_0"] = 3;
  attributes["WEIGHTS_1"] = 4;
  file["nodes"] = {
    {{"mesh", 0}, {"skin", 0}}, {{"translation", {4, 0, 0}}}, {{"translation", {6, 0, 0}}}};
  file["skins"] = {{{"joints", {1, 2}}}};
  file["scenes"][0]["nodes"] = {0, 1, 2};
  folder.write("a.gltf", file.dump());
  const nlohmann::json report = this->check("a.gltf");
  EXPECT_EQ(report["bbox"], (std::vector<double>{4, 0, 0, 6, 1, 1})) << "4 and 5, and 1 wide";
  EXPECT_NEAR(report["volume"], 1, 1e-12);
  file["scenes"][0]["nodes"] = {0}; // joints need not be seen
  folder.write("a.gltf", file.dump());
  EXPECT_EQ(this->check("a.gltf")["bbox"], report["bbox"]);
}

/// Colours of vertices are bytes, whatever numbers they are. Other blocks are white, as glTF says.
TEST_F(PieceFiles, OfGltfKeepTheColorsOfVertices)
{
  for (const int type : {5121, 5123, 5126})
  {
    for (const bool hasAlpha : {false, true})
    {
      std::string colors;
      for (int corner = 0; corner < 8; ++corner)
      {
        const std::vector<double> shares = {1, 0, 0.2, 0.4};
        for (std::size_t i = 0; i < (hasAlpha ? 4 : 3); ++i)
        {
          const auto whole = static_cast<std::uint16_t>(std::lround(65535 * shares[i]));
          colors += type == 5121   ? std::string(1, static_cast<char>(std::lround(255 * shares[i])))
                    : type == 5123 ? bytesOf<std::uint16_t>({whole})
                                   : bytesOf<float>({static_cast<float>(shares[i])});
        }
      }
      const std::string buffer = cubeBuffer() + colors;
      folder.write("cube.bin", buffer);
      nlohmann::json file = nlohmann::json::parse(gltfOf(R"(,"uri":"cube.bin")"));
      file["buffers"][0]["byteLength"] = buffer.size();
      file["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 168}, {"byteLength", colors.size()}});
      file["accessors"].push_back({{"bufferView", 2}, {"count", 8}, {"componentType", type},
        {"type", hasAlpha ? "VEC4" : "VEC3"}, {"normalized", type != 5126}});
      file["meshes"].push_back(file["meshes"][0]);
      file["meshes"][1]["primitives"][0]["attributes"]["COLOR_0"] = 2;
      file["nodes"][2]["mesh"] = 1;
      const std::string in = folder.write("a.gltf", file.dump()), out = folder.path("out.vtp");
      const Outcome run = runProgram({"surface", in, "-o", out, "--resolution", "20",
        "--transfer-attributes", "--overwrite", "--nearest-cells"});
      ASSERT_EQ(run.status, 0) << run;
      const std::string name = hasAlpha ? "RGBA" : "RGB";
      EXPECT_NE(run.err.find(name + " is white there"), std::string::npos) << run;
      vtkNew<vtkXMLPolyDataReader> reader;
      reader->SetFileName(out.c_str());
      reader->Update();
      vtkPointData* const points = reader->GetOutput()->GetPointData();
      ASSERT_TRUE(points->GetScalars());
      EXPECT_EQ(points->GetScalars()->GetName(), name);
      const std::vector<double> expected = {255, 0, 51, 102};
      for (vtkIdType n = 0; n < points->GetNumberOfTuples(); ++n)
      {
        const bool isColored = points->GetArray("NearestBlock")->GetTuple1(n) == 2;
        for (int i = 0; i < (hasAlpha ? 4 : 3); ++i)
        {
          ASSERT_EQ(points->GetScalars()->GetComponent(n, i),
            isColored ? expected[static_cast<std::size_t>(i)] : 255);
        }
      }
    }
  }
}

TEST_F(PieceFiles, HaveNoWallsAtTheirSeams)
{
  // Two boxes of cells that touch, each with points of its own.
  const auto box = [](double x)
  {
    std::string points;
    for (int corner = 0; corner < 8; ++corner)
    {
      points += std::to_string(x + (corner & 1)) + " " + std::to_string(corner >> 1 & 1) + " " +
                std::to_string(corner >> 2) + " ";
    }
    return xmlFile("UnstructuredGrid",
      R"(<Piece NumberOfPoints="8" NumberOfCells="1"><Points><DataArray type="Float64")"
      R"( NumberOfComponents="3">)" +
        points +
        R"(</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity">)"
        R"(0 1 3 2 4 5 7 6</DataArray><DataArray type="Int64" Name="offsets">8</DataArray>)"
        R"(<DataArray type="UInt8" Name="types">12</DataArray></Cells></Piece>)");
  };
  folder.write("a.vtu", box(0));
  folder.write("b.vtu", box(1));
  folder.write("both.pvtu", pieces("PUnstructuredGrid", "a.vtu", "b.vtu"));
  const nlohmann::json report = this->check("both.pvtu");
  EXPECT_EQ(report["triangles"], 20) << report;
  EXPECT_EQ(report["nonmanifold_edges"], 0);
  EXPECT_EQ(report["components_edge"], 1);
  const std::string queries = folder.write("q.csv", "x,y,z\n1,0.5,0.5\n");
  const Outcome probe = runProgram(
    {"probe", folder.path("both.pvtu"), queries, "-o", folder.path("answers.csv"), "--distance"});
  EXPECT_NE(contentsOf(folder.path("answers.csv")).find("-0.5"), std::string::npos) << probe;
}

TEST_F(PieceFiles, ThatAreNotThereAreNamed)
{
  this->writeHalves(".vtp");
  folder.write("a.vtm", blocks("a.vtp", "gone.vtp"));
  folder.write("a.pvtp", pieces("PPolyData", "gone.vtp", "a.vtp"));
  folder.write("a.gltf", gltfOf(R"(,"uri":"gone.bin")"));
  this->expectRefused("a.vtm", "its part gone.vtp is not there");
  this->expectRefused("a.pvtp", "its part gone.vtp is not there");
  this->expectRefused("a.gltf", "gone.bin");
}

TEST_F(PieceFiles, AreFoundByTheSyntaxOfTheirIndex)
{
  folder.write("a.vtp", asVtp(sphere(2)));
  for (const char* const part : {R"(<DataSet file='a.vtp'/>)",
         "<DataSet\tindex='0'\n file = \"a.vtp\"/>", R"(<DataSet file="&#97;.vtp"/>)",
         R"(<!-- <DataSet file="gone.vtp"/> --><DataSet file="a.vtp"/>)",
         R"(<DataSet name=' file="gone.vtp"' file="&#x61;&#46;vtp"/>)"})
  {
    folder.write("a.vtm", xmlFile("vtkMultiBlockDataSet", part));
    EXPECT_EQ(this->check("a.vtm")["closed"], true) << part;
    std::string piece = part;
    for (const auto& [block, name] : {std::pair("DataSet", "Piece"), {"file", "Source"}})
    {
      for (std::size_t at = 0; (at = piece.find(block, at)) != std::string::npos;)
      {
        piece.replace(at, std::strlen(block), name);
      }
    }
    folder.write("a.pvtp",
      xmlFile("PPolyData",
        R"(<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>)" + piece));
    EXPECT_EQ(this->check("a.pvtp")["closed"], true) << piece;
  }
  folder.write("gone.vtm", xmlFile("vtkMultiBlockDataSet", "<DataSet file='g&#111;ne.vtp'/>"));
  this->expectRefused("gone.vtm", "its part gone.vtp is not there");
  folder.write("cube.bin", cubeBuffer());
  folder.write("a b.bin", cubeBuffer());
  for (const char* const uri :
    {R"("cube.bin")", R"("\u0063ube.bin")", R"("c%75be.bin")", R"("a%20b.bin")"})
  {
    folder.write("a.gltf", gltfOf(std::string(R"(, "uri" : )") + uri));
    folder.write("a.glb", binaryGltf(std::string(R"(,"uri":)") + uri));
    EXPECT_NEAR(this->check("a.gltf")["volume"], 7, 1e-12) << uri;
    EXPECT_NEAR(this->check("a.glb")["volume"], 7, 1e-12) << uri;
  }
}

TEST_F(PieceFiles, ThatArePipesAreNotWaitedFor)
{
  ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(folder.path("fifo.vtp").c_str(), 0600), 0);
  for (const char* const name :
    {R"(file="fifo.vtp")", "file='fifo.vtp'", "\tfile = \"fifo&#46;vtp\""})
  {
    folder.write("a.vtm", xmlFile("vtkMultiBlockDataSet", "<DataSet " + std::string(name) + "/>"));
    folder.write("a.pvtp",
      xmlFile("PPolyData",
        "<Piece Source" + std::string(name).substr(std::string(name).find_first_of(" =")) + "/>"));
    folder.write("a.gltf", gltfOf(R"(,"uri":"f\u0069fo")"));
    folder.write("a.glb", binaryGltf(R"(,"uri":"f%69fo")"));
    for (const char* const file : {"a.vtm", "a.pvtp", "a.gltf", "a.glb"})
    {
      const Outcome run = runProgram({"check", folder.path(file)}, "timeout 30 ");
      EXPECT_EQ(run.status, 2) << file << run;
      EXPECT_TRUE(run.saysInOneLine({"its part fifo", "is a pipe, a device or a socket"})) << run;
    }
  }
  // One in the working directory is no part of a file elsewhere.
  std::filesystem::create_directory(folder.path("other"));
  folder.write("other/a.gltf", gltfOf(R"(,"uri":"fifo")"));
  const Outcome elsewhere = runProgram(
    {"check", folder.path("other/a.gltf")}, "cd '" + folder.path("") + "' && timeout 30 ");
  EXPECT_EQ(elsewhere.status, 2) << elsewhere;
}

TEST_F(PieceFiles, AreKeptUnlessTheUserOverwrites)
{
  this->writeHalves(".vtp");
  folder.write("cube.stl", cubeBuffer());
  folder.write("a.vtm", blocks("a.vtp", "b &amp; c.vtp"));
  folder.write("a.pvtp", pieces("PPolyData", "a.vtp", "b &amp; c.vtp"));
  folder.write("outer.vtm", xmlFile("vtkMultiBlockDataSet", "<DataSet file='a.pvtp'/>"));
  folder.write("a.gltf", gltfOf(R"(,"uri":"cube.stl")"));
  folder.write("a.glb", binaryGltf(R"(,"uri":"cube.stl")"));
  const std::string header =
    "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = ";
  folder.write("one.mhd", header + "voxels.nrrd\n");
  folder.write("list.mhd", header + "LIST\ncube.stl\nvoxels.nrrd\n");
  folder.write("a.nhdr", "NRRD0004\ndimension: 3\nsizes: 4 4 4\ntype: uchar\nencoding: raw\n"
                         "data file: voxels.nrrd\n");
  folder.write("voxels.nrrd", std::string(64, '\1'));
  std::filesystem::create_symlink(folder.path("a.vtp"), folder.path("link.vtp"));
  const std::string mesh = folder.write("mesh.off", asFile(sphere(2), "off"));
  using Words = std::vector<std::string>;
  for (const auto& [arguments, part] :
    {std::pair<Words, std::string>{{"surface", "a.vtm"}, "a.vtp"},
      {{"surface", "a.vtm"}, "link.vtp"}, {{"surface", "a.pvtp"}, "b & c.vtp"},
      {{"surface", "a.gltf"}, "cube.stl"}, {{"surface", "a.glb"}, "cube.stl"},
      {{"normals", "outer.vtm"}, "a.vtp"}, {{"probe", "mesh.off", "a.pvtp"}, "a.vtp"},
      {{"field", "mesh.off", "--like", "one.mhd"}, "voxels.nrrd"},
      {{"field", "mesh.off", "--like", "list.mhd"}, "voxels.nrrd"},
      {{"voxels", "mesh.off", "--like", "a.nhdr"}, "voxels.nrrd"}})
  {
    const std::string before = contentsOf(folder.path(part));
    Words words = arguments;
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      words[i] = words[i][0] == '-' ? words[i] : folder.path(words[i]);
    }
    words.insert(words.end(), {"-o", folder.path(part)});
    const Outcome run = runProgram(words);
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"is the input", "or say --overwrite"})) << run;
    EXPECT_EQ(contentsOf(folder.path(part)), before) << part;
  }
  const std::string part = contentsOf(folder.path("a.vtp"));
  const Outcome run = runProgram({"surface", folder.path("a.vtm"), "--resolution", "8", "-o",
    folder.path("a.vtp"), "--overwrite", "--quiet"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_NE(contentsOf(folder.path("a.vtp")), part);
}

TEST_F(PieceFiles, ThatAreDamagedOrOfNewerFormatsAreRefused)
{
  this->writeHalves(".vtp");
  const std::string whole = contentsOf(folder.path("a.vtp"));
  folder.write("cut.vtp", whole.substr(0, whole.size() / 2));
  folder.write("newer.vtp", std::string(whole).replace(whole.find("1.0"), 3, "9.7"));
  folder.write("cut.vtm", blocks("cut.vtp", "b &amp; c.vtp"));
  folder.write("cut.pvtp", pieces("PPolyData", "a.vtp", "cut.vtp"));
  folder.write("newer.vtm", blocks("newer.vtp", "cut.vtp"));
  folder.write("itself.vtm", blocks("itself.vtm", "a.vtp"));
  folder.write("image.vtm", blocks("image.vti", "a.vtp"));
  std::string image = xmlFile("ImageData", R"(<Piece Extent="0 0 0 0 0 0"/>)");
  image.insert(
    image.find("<ImageData") + 10, R"( WholeExtent="0 0 0 0 0 0" Origin="0 0 0" Spacing="1 1 1")");
  folder.write("image.vti", image);
  this->expectRefused("cut.vtm", "is no whole XML at line ");
  this->expectRefused("cut.pvtp", "is no whole XML at line ");
  this->expectRefused("newer.vtm", "was written by a newer VTK, format 9.7");
  this->expectRefused("itself.vtm", "itself.vtm");
  this->expectRefused("image.vtm", "holds vtkImageData");
  for (const char* const name : {"a.gltf", "a.glb"})
  {
    folder.write("cube.bin", cubeBuffer());
    const std::string content =
      std::string(name) == "a.glb" ? binaryGltf() : gltfOf(R"(,"uri":"cube.bin")");
    for (const std::size_t size : {content.size() / 4, content.size() / 2, content.size() - 4})
    {
      folder.write(name, content.substr(0, size));
      this->expectRefused(name, "");
    }
  }
  folder.write("b.glb", gltfOf(""));
  this->expectRefused("b.glb", "give it the suffix .gltf");
}

TEST_F(PieceFiles, ThatNameThemselvesByOtherSpellingsAreReadOnce)
{
  std::filesystem::create_directories(folder.path("f"));
  std::filesystem::create_directory_symlink(".", folder.path("f/here"));
  for (const char* const other : {"../f/self.vtm", "here/self.vtm", ".//self.vtm"})
  {
    folder.write("f/self.vtm", blocks("./self.vtm", other));
    const Outcome run = runProgram({"check", folder.path("f/self.vtm")}, "timeout 30 ");
    EXPECT_EQ(run.status, 2) << other << run;
  }
  // Links to one index in several folders name the parts in each.
  folder.write("index.vtm", xmlFile("vtkMultiBlockDataSet", "<DataSet file='a.vtp'/>"));
  for (const std::string name : {"0", "1"})
  {
    std::filesystem::create_directory(folder.path(name));
    std::filesystem::create_symlink("../index.vtm", folder.path(name + "/index.vtm"));
  }
  folder.write("0/a.vtp", asVtp(sphere(2)));
  folder.write("all.vtm", blocks("0/index.vtm", "1/index.vtm"));
  this->expectRefused("all.vtm", "its part 1/a.vtp is not there");
}

TEST_F(PieceFiles, HaveLimits)
{
  for (int i = 0; i <= 100; ++i)
  {
    folder.write(std::to_string(i) + ".vtm",
      xmlFile("vtkMultiBlockDataSet", "<DataSet file='" + std::to_string(i + 1) + ".vtm'/>"));
  }
  this->expectRefused("0.vtm", "has parts of parts, 101 deep");
  this->expectRefused("1.vtm", "its part 101.vtm is not there");
  std::string parts;
  for (int i = 0; i <= 1000000; ++i)
  {
    parts += "<DataSet file='" + std::to_string(i) + "'/>";
  }
  folder.write("wide.vtm", xmlFile("vtkMultiBlockDataSet", parts));
  this->expectRefused("wide.vtm", "has more than 1000000 parts");
}

TEST_F(PieceFiles, AreFoundInGltfBehindLongData)
{
  folder.write("a.bin", cubeBuffer());
  // Data in the text is no name, and neither it nor nested brackets hide the names behind.
  nlohmann::json file = nlohmann::json::parse(gltfOf(R"(,"uri":"a.bin")"));
  std::filesystem::rename(folder.path("a.bin"), folder.path("a.stl"));
  file["buffers"][0]["uri"] = "a.stl";
  file["asset"]["extras"] = nlohmann::json::parse(std::string(500, '[') + std::string(500, ']'));
  file["buffers"].push_back({{"byteLength", 3000000},
    {"uri", "data:application/octet-stream;base64," + std::string(4000000, 'A')}});
  std::swap(file["buffers"][0], file["buffers"][1]);
  for (const int view : {0, 1})
  {
    file["bufferViews"][view]["buffer"] = 1;
  }
  for (const std::string start : {"", " \n", "\xEF\xBB\xBF"})
  {
    const std::string in = folder.write("a.gltf", start + file.dump());
    const Outcome run = runProgram({"surface", in, "-o", folder.path("a.stl")});
    EXPECT_TRUE(run.saysInOneLine({"is the input", "or say --overwrite"})) << run;
  }
  // Codes have two hexadecimal digits.
  folder.write("a%-1.stl", cubeBuffer());
  const std::string coded = folder.write("coded.gltf", gltfOf(R"(,"uri":"a%-1.stl")"));
  const Outcome run = runProgram({"surface", coded, "-o", folder.path("a%-1.stl")});
  EXPECT_TRUE(run.saysInOneLine({"is the input", "or say --overwrite"})) << run;
  // Files that do not begin like glTF are not parsed, which takes 0.1 s and not 5 s.
  folder.write("a.gltf", std::string(30000000, '['));
  const auto begin = std::chrono::steady_clock::now();
  this->expectRefused("a.gltf", "does not begin like JSON");
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(time.count(), 3);
}

} // namespace
