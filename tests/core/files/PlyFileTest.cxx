/// The parser of PLY: text and both orders of bytes, numbers of all types, lists of any lengths,
/// what it refuses, and that threads and blocks change nothing.

#include "core/files/Parsing.h"
#include "core/support/Interruption.h"
#include "core/support/ShuffledThreads.h"

#include "files/PlyFile.h"

#include <cmath>
#include <cstdio>
#include <cstring>

using namespace winding;

namespace
{

const char* const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Writes numbers as a format has them.
class Body
{
public:
  explicit Body(std::string format)
    : format_(std::move(format))
  {
  }

  bool isText() const { return format_ == "ascii"; }

  template <class Number> Body& add(double value)
  {
    if (this->isText())
    {
      char text[40];
      bytes_.append(
        text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.17g ", value)));
      return *this;
    }
    const auto number = static_cast<Number>(value);
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    if (format_ == "binary_big_endian")
    {
      std::reverse(bytes, bytes + sizeof bytes);
    }
    bytes_.append(bytes, sizeof bytes);
    return *this;
  }

  /// By the name of the type in PLY.
  Body& add(const std::string& type, double value)
  {
    return type == "char" || type == "int8"       ? this->add<std::int8_t>(value)
           : type == "uchar" || type == "uint8"   ? this->add<std::uint8_t>(value)
           : type == "short" || type == "int16"   ? this->add<std::int16_t>(value)
           : type == "ushort" || type == "uint16" ? this->add<std::uint16_t>(value)
           : type == "int" || type == "int32"     ? this->add<std::int32_t>(value)
           : type == "uint" || type == "uint32"   ? this->add<std::uint32_t>(value)
           : type == "float" || type == "float32" ? this->add<float>(value)
                                                  : this->add<double>(value);
  }

  /// A list behind its length.
  Body& addList(const std::string& lengthType, const std::string& type, const Ids& values)
  {
    this->add(lengthType, static_cast<double>(values.size()));
    for (const std::int64_t value : values)
    {
      this->add(type, static_cast<double>(value));
    }
    return *this;
  }

  Body& endItem()
  {
    bytes_ += this->isText() ? "\n" : "";
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string format_, bytes_;
};

std::string head(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::string vertexHead(std::size_t count, const std::string& type = "float")
{
  const std::string property = "property " + type + " ";
  return "element vertex " + std::to_string(count) + "\n" + property + "x\n" + property + "y\n" +
         property + "z\n";
}

std::string faceHead(
  std::size_t count, const std::string& lengthType = "uchar", const std::string& type = "int")
{
  return "element face " + std::to_string(count) + "\nproperty list " + lengthType + " " + type +
         " vertex_indices\n";
}

/// A file of so many vertices (i, 2 i, 3 i) and of some faces.
std::string meshFile(const std::string& format, std::size_t vertices, const std::vector<Ids>& faces)
{
  Body body(format);
  for (std::size_t i = 0; i < vertices; ++i)
  {
    for (const double factor : {1.0, 2.0, 3.0})
    {
      body.add<float>(factor * static_cast<double>(i));
    }
    body.endItem();
  }
  for (const Ids& face : faces)
  {
    body.addList("uchar", "int", face).endItem();
  }
  return head(format, vertexHead(vertices) + faceHead(faces.size())) + body.bytes();
}

std::vector<double> pointsOf(const MeshArrays& mesh)
{
  return mesh.points.doubles.empty()
           ? std::vector<double>(mesh.points.floats.begin(), mesh.points.floats.end())
           : vectorOf(mesh.points.doubles);
}

TEST(PlyFile, PolygonsOfAnySizeInAllFormats)
{
  const std::vector<std::vector<Ids>> meshes = {{{0, 1, 2}, {2, 1, 3}}, {{0, 1, 2, 3}},
    {{0, 1, 2}, {0, 1, 2, 3}, {}, {1}, {3, 2}, {0, 1, 2}}, {{}}, {}};
  for (const std::string format : formats)
  {
    for (const std::vector<Ids>& faces : meshes)
    {
      SCOPED_TRACE(format + ", " + std::to_string(faces.size()) + " faces");
      const MeshArrays mesh = parsed(readPly, meshFile(format, 4, faces));
      EXPECT_EQ(pointsOf(mesh), (std::vector<double>{0, 0, 0, 1, 2, 3, 2, 4, 6, 3, 6, 9}));
      EXPECT_EQ(mesh.points.floats.empty(), format == "ascii");
      Ids offsets, ids;
      for (const Ids& face : faces)
      {
        offsets.push_back(static_cast<std::int64_t>(ids.size()));
        ids.insert(ids.end(), face.begin(), face.end());
      }
      if (!faces.empty())
      {
        offsets.push_back(static_cast<std::int64_t>(ids.size()));
      }
      expectCells(mesh.polygons, offsets, ids);
      EXPECT_EQ(mesh.vertices.count(), 0u);
      EXPECT_EQ(mesh.lines.count(), 0u);
    }
  }
}

TEST(PlyFile, NumbersOfAllTypes)
{
  struct Type
  {
    const char* name;
    double value;
    bool isFloat; ///< whether single precision holds all numbers of the type
  };
  const Type types[] = {{"char", -100, true}, {"int8", 100, true}, {"uchar", 200, true},
    {"uint8", 255, true}, {"short", -30000, true}, {"int16", 30000, true}, {"ushort", 60000, true},
    {"uint16", 65535, true}, {"int", -2000000001, false}, {"int32", 2000000001, false},
    {"uint", 4000000001.0, false}, {"uint32", 4294967295.0, false}, {"float", 0.375, true},
    {"float32", -1e30f, true}, {"double", 0.1, false}, {"float64", -1e300, false}};
  for (const std::string format : formats)
  {
    for (const Type& type : types)
    {
      SCOPED_TRACE(format + " " + type.name);
      Body body(format);
      for (int i = 0; i < 9; ++i)
      {
        body.add(type.name, i % 3 == 0 ? type.value : i);
      }
      std::string bytes = body.bytes();
      if (body.isText())
      {
        bytes.clear();
        for (int i = 0; i < 3; ++i)
        {
          bytes +=
            Body(format).add<double>(type.value).add<int>(3 * i + 1).add<int>(3 * i + 2).bytes() +
            "\n";
        }
      }
      const MeshArrays mesh = parsed(readPly, head(format, vertexHead(3, type.name)) + bytes);
      EXPECT_EQ(pointsOf(mesh),
        (std::vector<double>{type.value, 1, 2, type.value, 4, 5, type.value, 7, 8}));
      EXPECT_EQ(mesh.points.doubles.empty(), type.isFloat && format != "ascii");
    }
  }
}

TEST(PlyFile, ListsOfAllTypes)
{
  const char* const types[] = {
    "char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  for (const std::string format : formats)
  {
    for (const std::string lengthType : types)
    {
      for (const std::string type : types)
      {
        SCOPED_TRACE(format + " " + lengthType + " " + type);
        Body body(format);
        for (int i = 0; i < 12; ++i)
        {
          body.add<float>(i);
          if (i % 3 == 2)
          {
            body.endItem();
          }
        }
        for (const Ids& face : {Ids{0, 1, 2}, Ids{3, 2, 1}})
        {
          body.addList(lengthType, type, face).endItem();
        }
        const MeshArrays mesh = parsed(
          readPly, head(format, vertexHead(4) + faceHead(2, lengthType, type)) + body.bytes());
        expectCells(mesh.polygons, {0, 3, 6}, {0, 1, 2, 3, 2, 1});
      }
    }
  }
}

/// Elements before, between and behind vertices and faces, and properties beside those that are
/// read, with and without lists, in any order; normals.
TEST(PlyFile, WhatElseThereIsIsPassedOver)
{
  const std::string elements =
    "comment made by hand\nobj_info nothing\nelement other 2\nproperty list short double more\n"
    "element vertex 3\nproperty uchar red\nproperty double nz\nproperty double z\n"
    "property list uchar int tags\nproperty double y\nproperty double x\nproperty double ny\n"
    "property double nx\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
    "element face 2\nproperty float quality\nproperty list uint ushort vertex_index\n"
    "property list uchar float texcoord\nelement last 1\nproperty list uchar char list\n";
  for (const std::string format : formats)
  {
    for (const bool areUniform : {true, false})
    {
      SCOPED_TRACE(format + (areUniform ? ", lists of equal lengths" : ""));
      Body body(format);
      body.addList("short", "double", {1, 2}).endItem();
      body.addList("short", "double", areUniform ? Ids{3, 4} : Ids{3}).endItem();
      for (int i = 0; i < 3; ++i)
      {
        body.add<std::uint8_t>(7).add<double>(i + 0.5).add<double>(i + 0.1);
        body.addList("uchar", "int", areUniform ? Ids{9} : Ids(static_cast<std::size_t>(i), 9));
        body.add<double>(i + 0.2).add<double>(i + 0.3).add<double>(-i).add<double>(1).endItem();
      }
      body.add<int>(0).add<int>(1).endItem();
      for (const Ids& corners : {Ids{0, 1, 2}, areUniform ? Ids{2, 1, 0} : Ids{2, 1}})
      {
        body.add<float>(5).addList("uint", "ushort", corners).addList("uchar", "float", {1, 2});
        body.endItem();
      }
      body.addList("uchar", "char", {1, 2, 3}).endItem();
      const MeshArrays mesh = parsed(readPly, head(format, elements) + body.bytes());
      EXPECT_EQ(vectorOf(mesh.points.doubles),
        (std::vector<double>{0.3, 0.2, 0.1, 1.3, 1.2, 1.1, 2.3, 2.2, 2.1}));
      EXPECT_EQ(
        vectorOf(mesh.normals.doubles), (std::vector<double>{1, 0, 0.5, 1, -1, 1.5, 1, -2, 2.5}));
      expectCells(mesh.polygons, areUniform ? Ids{0, 3, 6} : Ids{0, 3, 5},
        areUniform ? Ids{0, 1, 2, 2, 1, 0} : Ids{0, 1, 2, 2, 1});
    }
  }
}

TEST(PlyFile, FacesOfManyCorners)
{
  for (const std::string format : formats)
  {
    for (const std::size_t second : {std::size_t(1000), std::size_t(3)})
    {
      Body body(format);
      for (int i = 0; i < 3; ++i)
      {
        body.add<float>(i).add<float>(i).add<float>(i).endItem();
      }
      body.addList("int", "int", Ids(1000, 2)).endItem();
      body.addList("int", "int", Ids(second, 1)).endItem();
      Ids ids(1000, 2);
      ids.insert(ids.end(), second, 1);
      const MeshArrays mesh =
        parsed(readPly, head(format, vertexHead(3) + faceHead(2, "int")) + body.bytes());
      expectCells(mesh.polygons, {0, 1000, static_cast<std::int64_t>(ids.size())}, ids);
    }
  }
}

/// Colours and texture coordinates have arrays of their own, by any of their usual names.
TEST(PlyFile, ColoursAndTextureCoordinates)
{
  for (const std::string format : formats)
  {
    for (const bool hasAlpha : {false, true})
    {
      for (const std::array<const char*, 2>& names : {std::array<const char*, 2>{"u", "v"},
             {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}})
      {
        SCOPED_TRACE(format + " " + names[0]);
        const std::string header = std::string("element vertex 2\nproperty double ") + names[1] +
                                   "\nproperty uchar red\nproperty float x\nproperty float y\n" +
                                   (hasAlpha ? "property uchar alpha\n" : "") +
                                   "property float z\nproperty uchar blue\n" +
                                   "property uchar green\nproperty float " + names[0] + "\n";
        Body body(format);
        for (int i = 0; i < 2; ++i)
        {
          body.add<double>(0.25 + i).add<std::uint8_t>(255 - i).add<float>(1).add<float>(2);
          if (hasAlpha)
          {
            body.add<std::uint8_t>(128);
          }
          body.add<float>(3).add<std::uint8_t>(7).add<std::uint8_t>(i).add<float>(0.5).endItem();
        }
        const MeshArrays mesh = parsed(readPly, head(format, header) + body.bytes());
        EXPECT_EQ(mesh.colorComponents, hasAlpha ? 4 : 3);
        EXPECT_EQ(std::vector<int>(mesh.colors.begin(), mesh.colors.end()),
          hasAlpha ? (std::vector<int>{255, 0, 7, 128, 254, 1, 7, 128})
                   : (std::vector<int>{255, 0, 7, 254, 1, 7}));
        EXPECT_EQ(vectorOf(mesh.textureCoordinates), (std::vector<float>{0.5, 0.25, 0.5, 1.25}));
        EXPECT_EQ(pointsOf(mesh), (std::vector<double>{1, 2, 3, 1, 2, 3}));
      }
    }
  }
  const MeshArrays none = parsed(readPly,
    head("ascii", "element vertex 1\nproperty float x\n"
                  "property float y\nproperty float z\nproperty float red\nproperty float green\n"
                  "property float blue\nproperty list uchar float u\nproperty float v\n") +
      "1 2 3 0.5 0.5 0.5 1 0.1 0.2\n");
  EXPECT_TRUE(none.colors.empty());
  EXPECT_TRUE(none.textureCoordinates.empty());
}

TEST(PlyFile, FacesBeforeVertices)
{
  for (const std::string format : formats)
  {
    Body body(format);
    body.addList("uchar", "int", {2, 1, 0}).endItem();
    for (int i = 0; i < 3; ++i)
    {
      body.add<float>(i).add<float>(0).add<float>(0).endItem();
    }
    const MeshArrays mesh =
      parsed(readPly, head(format, faceHead(1) + vertexHead(3)) + body.bytes());
    expectCells(mesh.polygons, {0, 3}, {2, 1, 0});
    EXPECT_EQ(mesh.points.count(), 3u);
  }
}

TEST(PlyFile, TextIsFree)
{
  const std::string end = vertexHead(3) + faceHead(1) + "end_header\n";
  const std::string first = "ply\r\nformat  ascii\t1.0\r\n";
  const MeshArrays mesh =
    parsed(readPly, first + end + "\n0 0 +0 extra\r\n\t1e0 0 0\n\n# a comment\n0 .5 0\n3 0 1 2 7");
  EXPECT_EQ(pointsOf(mesh), (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 0.5, 0}));
  expectCells(mesh.polygons, {0, 3}, {0, 1, 2});
  EXPECT_EQ(parsed(readPly, first + vertexHead(0) + "end_header\n").points.count(), 0u);
  EXPECT_EQ(parsed(readPly, first + vertexHead(0) + "end_header").points.count(), 0u);
}

TEST(PlyFile, LongHeaders)
{
  const std::string mesh = meshFile("binary_little_endian", 3, {{0, 1, 2}});
  std::string comments = "comment " + std::string(20000, 'x') + "\n";
  for (int i = 0; i < 3000; ++i)
  {
    comments += "comment " + std::to_string(i) + "\n";
  }
  const std::size_t place = mesh.find("element");
  expectSame(
    parsed(readPly, mesh.substr(0, place) + comments + mesh.substr(place)), parsed(readPly, mesh));
}

TEST(PlyFile, RefusalsOfHeaders)
{
  const auto expect = [](const std::string& text, const std::string& words)
  {
    EXPECT_EQ(refusalOf(readPly, text), words + "; give another file") << text;
  };
  const std::string first = "ply\nformat ascii 1.0\n", vertex = vertexHead(1);
  EXPECT_EQ(refusalOf(readPly, "solid\n"),
    "is not ply: it does not begin like PLY; give the file a suffix that fits, or another file");
  expect(first + vertex, "the header has no end; it is truncated");
  expect("ply\nformat binary 1.0\n", "line 2: the header names no format that PLY has");
  expect("ply\n" + vertex + "end_header\n0 0 0\n", "the header has no format line of version 1.0");
  expect("ply\nformat ascii 2.0\n" + vertex + "end_header\n0 0 0\n",
    "the header has no format line of version 1.0");
  expect(first + "\n", "line 3: the header has a line that PLY does not know");
  expect(first + "property float x\n", "line 3: the header has a line that PLY does not know");
  expect(first + "element vertex x\n", "line 3: the count of vertex is no number of items");
  expect(first + "element vertex -1\n", "line 3: the count of vertex is no number of items");
  expect(first + "element vertex 99999999999999999999\n",
    "line 3: the count of vertex is no number of items");
  expect(first + "element vertex 1\nproperty real x\n",
    "line 4: a property has the unknown type \"real\"");
  expect(first + "element vertex 1\nproperty list uchar\n",
    "line 4: a property has the unknown type \"\"");
  expect(first + "element vertex 1\nproperty float\n", "line 4: a property has no name");
  expect(first + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
    "the header has no vertices with x, y and z");
  expect(first + "element vertex 1\nproperty float x\nproperty float y\n"
                 "property list uchar float z\nend_header\n0 0 1 0\n",
    "the header has no vertices with x, y and z");
  expect(first + vertex + "element nothing 2\nend_header\n0 0 0\n",
    "the header has an element nothing without properties");
  expect(first + vertex + "element face 1\nproperty int vertex_indices\nend_header\n0 0 0\n0\n",
    "the header has faces without vertex_indices");
  for (const std::string format : formats)
  {
    expect(head(format, vertexHead(99999999)) + "0 0 0\n",
      "promises 99999999 items of vertex, more than it can hold; it is truncated or damaged");
  }
}

TEST(PlyFile, RefusalsOfText)
{
  const auto expect = [](const std::string& body, const std::string& words)
  {
    EXPECT_EQ(refusalOf(readPly, head("ascii", vertexHead(3) + faceHead(2)) + body),
      words + "; give another file")
      << body;
  };
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  expect("0 0 0\n1 0\n0 1 0\n3 0 1 2\n3 0 1 2\n",
    "line 11: a number is missing; it is truncated or damaged");
  expect("0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n3 0 1 2\n",
    "line 11: holds something that is no number; it is damaged");
  expect(vertices + "3 0 1 2\n", "line 13: a number is missing; it is truncated or damaged");
  expect(vertices + "3 0 1 9\n", "line 13: vertex 9 does not exist; there are 3, counted from 0");
  expect(vertices + "\n3 0 1 2\n3 0 -1 2\n",
    "line 15: vertex -1 does not exist; there are 3, counted from 0");
  expect(vertices + "3 0 1 1e300\n3 0 1 2\n",
    "line 13: vertex 1e+300 does not exist; there are 3, counted from 0");
  expect(vertices + "3 0 1 nan\n3 0 1 2\n",
    "line 13: vertex nan does not exist; there are 3, counted from 0");
  expect(
    vertices + "4 0 1 2\n3 0 1 2\n", "line 13: a number is missing; it is truncated or damaged");
  expect(
    vertices + "3 0 1 2\n2 0 x\n", "line 14: holds something that is no number; it is damaged");
  expect(vertices + "-1\n3 0 1 2\n", "line 13: a list of -1 numbers; it is damaged");
  expect(vertices + "1.5 0 1\n3 0 1 2\n", "line 13: a list of 1.5 numbers; it is damaged");
  expect(
    vertices + "3 0 1 2\n256 0 1 2\n", "line 14: a number is missing; it is truncated or damaged");
  expect(vertices + "3 0 1 2\n1e300 0 1 2\n",
    "line 14: a number is missing; it is truncated or damaged");
}

TEST(PlyFile, RefusalsOfBinaries)
{
  for (const std::string format : {formats[1], formats[2]})
  {
    const auto expect = [&](const std::vector<Ids>& faces, const std::string& words)
    {
      EXPECT_EQ(refusalOf(readPly, meshFile(format, 3, faces)), words + "; give another file");
    };
    const Ids good = {0, 1, 2};
    const std::string three = " does not exist; there are 3, counted from 0";
    expect({good, {0, 3, 1}, {0, 4, 1}}, "vertex 3" + three);
    expect({good, {0, -7, 3}}, "vertex -7" + three);
    expect({good, {0, 1}, {0, 1, 5}}, "vertex 5" + three);
    const std::string mesh = meshFile(format, 3, {good, good});
    EXPECT_EQ(refusalOf(readPly, mesh), "");
    EXPECT_EQ(refusalOf(readPly, mesh.substr(0, mesh.size() - 1)),
      "ends before its last item; it is truncated; give another file");
    EXPECT_EQ(refusalOf(readPly, mesh.substr(0, mesh.size() - 30)),
      "ends before the last of the 3 items of vertex that it promises; it is truncated; give "
      "another file");
    const auto faceOfLength = [&](double length)
    {
      Body body(format);
      for (int i = 0; i < 9; ++i)
      {
        body.add<float>(i);
      }
      body.add<double>(3).add<int>(0).add<int>(1).add<int>(2);
      body.add<double>(length).add<int>(0).add<int>(1);
      return head(format, vertexHead(3) + faceHead(2, "double")) + body.bytes();
    };
    EXPECT_EQ(refusalOf(readPly, faceOfLength(2)), "");
    EXPECT_EQ(refusalOf(readPly, faceOfLength(-1)),
      "a list of -1 numbers; it is damaged; give another file");
    EXPECT_EQ(refusalOf(readPly, faceOfLength(1.5)),
      "a list of 1.5 numbers; it is damaged; give another file");
    EXPECT_EQ(refusalOf(readPly, faceOfLength(1e300)),
      "a list of 1e+300 numbers; it is damaged; give another file");
    EXPECT_NE(refusalOf(readPly, faceOfLength(std::nan(""))), "");
    EXPECT_EQ(refusalOf(readPly, faceOfLength(256)),
      "ends before its last item; it is truncated; give another file");
  }
}

TEST(PlyFile, EveryTruncationIsRefused)
{
  for (const std::string format : formats)
  {
    for (const std::vector<Ids>& faces :
      {std::vector<Ids>{{0, 1, 2}, {2, 1, 3}}, std::vector<Ids>{{0, 1, 2}, {3, 2, 1, 0}}})
    {
      const std::string mesh = meshFile(format, 4, faces);
      // The end of the last line and the blank before it say nothing.
      const std::size_t needed = mesh.size() - (format == "ascii" ? 2 : 0);
      for (std::size_t size = 1; size < needed; ++size)
      {
        EXPECT_NE(refusalOf(readPly, mesh.substr(0, size)), "") << format << " " << size;
      }
      EXPECT_EQ(refusalOf(readPly, mesh.substr(0, needed)), "") << format;
    }
  }
}

/// Meshes of many blocks: of triangles; with one other face at the end; of faces of all sizes.
std::vector<std::vector<Ids>> largeMeshes()
{
  constexpr std::int64_t count = 60000;
  std::vector<Ids> triangles, any;
  for (std::int64_t i = 0; i < count; ++i)
  {
    triangles.push_back({i, (i + 1) % count, (i * i) % count});
    any.emplace_back(static_cast<std::size_t>(i % 6), i);
  }
  std::vector<Ids> almost = triangles;
  almost.push_back({0, 1, 2, 3});
  return {triangles, almost, any};
}

TEST(LargePlyFiles, AreTheSameForAllExecutorsAndFormats)
{
  for (const std::vector<Ids>& faces : largeMeshes())
  {
    const MeshArrays serial = parsed(readPly, meshFile(formats[1], 60000, faces));
    ASSERT_EQ(serial.polygons.count(), faces.size());
    for (const std::size_t i : {std::size_t(0), std::size_t(4), faces.size() / 2, faces.size() - 1})
    {
      const auto first = static_cast<std::size_t>(serial.polygons.offsets[i]);
      const auto last = static_cast<std::size_t>(serial.polygons.offsets[i + 1]);
      const std::int64_t* const ids = serial.polygons.connectivity.data();
      EXPECT_EQ(Ids(ids + first, ids + last), faces[i]);
    }
    for (const std::string format : formats)
    {
      const std::string file = meshFile(format, 60000, faces);
      for (const unsigned seed : {1U, 2U})
      {
        shapes::ShuffledThreads threads(seed);
        const MeshArrays mesh = parsed(readPly, file, threads);
        EXPECT_EQ(pointsOf(mesh), pointsOf(serial));
        expectCells(
          mesh.polygons, vectorOf(serial.polygons.offsets), vectorOf(serial.polygons.connectivity));
      }
    }
  }
}

TEST(LargePlyFiles, AreRefusedForTheFirstFault)
{
  for (std::vector<Ids> faces : largeMeshes())
  {
    faces[20003][1] = 99990;
    faces[50003][1] = 99991;
    for (const std::string format : formats)
    {
      const std::string file = meshFile(format, 60000, faces);
      for (const unsigned seed : {1U, 2U})
      {
        shapes::ShuffledThreads threads(seed);
        const std::string refusal = refusalOf(readPly, file, threads);
        EXPECT_NE(refusal.find("vertex 99990 does not exist; there are 60000"), std::string::npos)
          << refusal;
      }
    }
  }
}

/// An item whose list is longer than a block.
TEST(LargePlyFiles, ListsOfAnyLength)
{
  for (const std::string format : formats)
  {
    for (const std::size_t second : {std::size_t(700000), std::size_t(3)})
    {
      Body body(format);
      body.addList("int", "short", Ids(700000, 5)).endItem();
      body.addList("int", "short", Ids(second, 6)).endItem();
      body.add<float>(1).add<float>(2).add<float>(3).endItem();
      const std::string other = "element other 2\nproperty list int short values\n";
      const MeshArrays mesh = parsed(readPly, head(format, other + vertexHead(1)) + body.bytes());
      EXPECT_EQ(pointsOf(mesh), (std::vector<double>{1, 2, 3}));
    }
  }
}

TEST(InterruptedPlyFiles, GiveNothing)
{
  for (const std::string format : formats)
  {
    for (const int runs : {0, 1})
    {
      shapes::Interruption executor(runs);
      EXPECT_THROW(parsed(readPly, meshFile(format, 3, {{0, 1, 2}}), executor), Interrupted);
    }
  }
}

} // namespace
