// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

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

std::string binaryGltf()
{
  std::string words = gltfOf(""), buffer = cubeBuffer();
  words.resize((words.size() + 3) / 4 * 4, ' ');
  const auto size = [](std::size_t bytes)
  {
    return bytesOf<std::uint32_t>({static_cast<std::uint32_t>(bytes)});
  };
  return "glTF" + size(2) + size(28 + words.size() + buffer.size()) + size(words.size()) + "JSON" +
         words + size(buffer.size()) + std::string("BIN\0", 4) + buffer;
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
  this->expectRefused("cut.vtm", "Error parsing XML");
  this->expectRefused("cut.pvtp", "Error parsing XML");
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

} // namespace
