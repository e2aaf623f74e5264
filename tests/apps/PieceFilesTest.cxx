#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
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

TEST_F(PieceFiles, ThatAreNotThereAreNamed)
{
  this->writeHalves(".vtp");
  folder.write("a.vtm", blocks("a.vtp", "gone.vtp"));
  folder.write("a.pvtp", pieces("PPolyData", "gone.vtp", "a.vtp"));
  folder.write("a.gltf", gltfOf(R"(,"uri":"gone.bin")"));
  this->expectRefused("a.vtm", "its part gone.vtp is not there");
  this->expectRefused("a.pvtp", "its part gone.vtp is not there");
  this->expectRefused("a.gltf", "buffer");
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
