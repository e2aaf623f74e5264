// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// The parser of PLY: text and both orders of bytes, numbers of all types, lists of any lengths.

#include "files/PlyFiles.h"

#include "files/PlyFile.h"

using namespace plyfiles;
using namespace winding;

namespace
{

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

/// Elements before, between and behind vertices and faces, and properties besides the ones that are
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

/// A file of five vertices and of items of one list each, in elements one behind the other.
struct ListElement
{
  std::string name, list, type;
  std::vector<Ids> items;
};

std::string fileOfLists(const std::string& format, const std::vector<ListElement>& elements)
{
  Body body(format);
  std::string header = vertexHead(5);
  for (int i = 0; i < 15; ++i)
  {
    body.add<float>(i);
    if (i % 3 == 2)
    {
      body.endItem();
    }
  }
  for (const ListElement& element : elements)
  {
    header += "element " + element.name + " " + std::to_string(element.items.size()) +
              "\nproperty list int " + element.type + " " + element.list + "\n";
    for (const Ids& item : element.items)
    {
      body.addList("int", element.type, item).endItem();
    }
  }
  return head(format, header) + body.bytes();
}

TEST(PlyFile, StripsBecomeTriangles)
{
  for (const std::string format : formats)
  {
    for (const std::string name : {"tristrips", "tristrip", "triangle_strips", "Strips"})
    {
      for (const std::string type : {"int", "uint", "short", "char", "double"})
      {
        const std::int64_t end = type == "uint" ? 4294967295 : -1;
        SCOPED_TRACE(format + " " + name + " " + type);
        const MeshArrays one =
          parsed(readPly, fileOfLists(format,
                            {{name, "vertex_indices", type,
                              {{0, 1, 2, 3, 4, end, end, 0, 1, end, 2, 3, 4, end, 4, 4, 3, 2}}}}));
        expectCells(
          one.polygons, {0, 3, 6, 9, 12, 15}, {0, 1, 2, 2, 1, 3, 2, 3, 4, 2, 3, 4, 3, 4, 2});
        EXPECT_EQ(one.notes.size(), 0u);
        const MeshArrays fromAnOddPlace = parsed(readPly,
          fileOfLists(format, {{name, "vertex_index", type, {{0, 1, 2, 3, end, 1, 2, 3, 4}}}}));
        expectCells(
          fromAnOddPlace.polygons, {0, 3, 6, 9, 12}, {0, 1, 2, 2, 1, 3, 1, 2, 3, 3, 2, 4});
        const MeshArrays several =
          parsed(readPly, fileOfLists(format,
                            {{name, "vertex_index", type, {{0, 1, 2}, {}, {1, 2, 3, 4}, {end}}}}));
        expectCells(several.polygons, {0, 3, 6, 9}, {0, 1, 2, 1, 2, 3, 3, 2, 4});
      }
    }
    EXPECT_EQ(
      refusalOf(
        readPly, fileOfLists(format, {{"tristrips", "vertex_indices", "int", {{0, 1, 2, -1, -2}}}}))
          .find("vertex -2 does not exist; there are 5, counted from 0") == std::string::npos,
      false)
      << format;
    EXPECT_NE(
      refusalOf(readPly, fileOfLists(format, {{"face", "vertex_indices", "int", {{0, 1, 2, -1}}}})),
      "")
      << "only strips go on behind -1";
  }
}

TEST(PlyFile, FacesOfSeveralElementsComeInTheirOrder)
{
  for (const std::string format : formats)
  {
    const MeshArrays mesh = parsed(readPly,
      fileOfLists(format,
        {{"tristrips", "vertex_indices", "int", {{0, 1, 2, 3}}},
          {"Face", "vertex_index", "uint", {{4, 3, 2}, {0, 1, 2, 3}}},
          {"face", "vertex_indices", "int", {}}, {"polygon", "corner_ids", "uchar", {{2, 3, 4}}}}));
    expectCells(
      mesh.polygons, {0, 3, 6, 9, 13, 16}, {0, 1, 2, 2, 1, 3, 4, 3, 2, 0, 1, 2, 3, 2, 3, 4});
    EXPECT_EQ(mesh.notes.size(), 0u) << format;
  }
}

TEST(PlyFile, GeometryThatIsNotReadIsNoted)
{
  for (const std::string format : formats)
  {
    const MeshArrays mesh = parsed(
      readPly, fileOfLists(format,
                 {{"trifans", "vertex_indices", "int", {{0, 1, 2, 3}}},
                   {"cell", "vertex_indices", "int", {{0, 1, 2, 3}, {1, 2, 3, 4}}},
                   {"weights", "values", "float", {{1}}}, {"edge", "vertex_indices", "int", {}}}));
    EXPECT_EQ(mesh.polygons.count(), 0u);
    ASSERT_EQ(mesh.notes.size(), 2u) << format;
    EXPECT_EQ(sentenceOf(mesh.notes[1]), "the element \"cell\" is not read: save faces, if it has "
                                         "the surface; 2 items are passed over");
  }
  const std::string header = vertexHead(1) + "element edge 1\nproperty int vertex1\nproperty int "
                                             "vertex2\nelement camera 1\nproperty float view_px\n";
  EXPECT_EQ(parsed(readPly, head("ascii", header) + "0 0 0\n0 0\n1\n").notes.size(), 1u);
}

TEST(PlyFile, NormalsMayHaveTheNamesOfPcl)
{
  const std::string normals =
    "property float normal_x\nproperty float normal_y\nproperty float normal_z\n";
  EXPECT_EQ(
    vectorOf(
      parsed(readPly, head("ascii", vertexHead(1) + normals) + "0 0 0 1 2 3\n").normals.doubles),
    (std::vector<double>{1, 2, 3}));
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
                  "property float y\nproperty float z\nproperty float red\nproperty uchar green\n"
                  "property float blue\nproperty list uchar float u\nproperty float v\n") +
      "1 2 3 0.5 128 0.5 1 0.1 0.2\n");
  EXPECT_TRUE(none.colors.empty());
  EXPECT_TRUE(none.textureCoordinates.empty());
  const std::string unlike = head("ascii", "element vertex 1\nproperty float x\n"
                                           "property float y\nproperty float z\n"
                                           "property short s\nproperty double t\n");
  EXPECT_TRUE(parsed(readPly, unlike + "1 2 3 4 1000000000.5\n").textureCoordinates.empty());
}

TEST(PlyFile, ColorsOfRealNumbersBecomeBytes)
{
  for (const std::string format : formats)
  {
    for (const bool areBytes : {false, true})
    {
      SCOPED_TRACE(format + (areBytes ? " 0 to 255" : " 0 to 1"));
      const std::string header = vertexHead(2, "float") +
                                 "property double red\nproperty float blue\n"
                                 "property double green\n";
      const double unit = areBytes ? 255 : 1;
      Body body(format);
      body.add<float>(1).add<float>(2).add<float>(3);
      body.add<double>(unit).add<float>(-1).add<double>(0.5 * unit).endItem();
      body.add<float>(1).add<float>(2).add<float>(3);
      body.add<double>(0.25 * unit).add<float>(0).add<double>(0.1 * unit).endItem();
      const MeshArrays mesh = parsed(readPly, head(format, header) + body.bytes());
      EXPECT_EQ(mesh.colorComponents, 3);
      EXPECT_EQ(std::vector<int>(mesh.colors.begin(), mesh.colors.end()),
        (std::vector<int>{255, 128, 0, 64, 26, 0}));
    }
  }
}

/// Colours of any integers are 0 to 255 or, where one is larger, to 65535.
TEST(PlyFile, ColorsOfAnyIntegersAndNamesBecomeBytes)
{
  for (const std::string format : formats)
  {
    for (const std::string prefix : {"red", "diffuse_red", "r"})
    {
      for (const int most : {255, 65535})
      {
        for (const std::string type : {"ushort", "int", "uint", most > 255 ? "double" : "char"})
        {
          SCOPED_TRACE(format + " " + prefix + " " + type + " to " + std::to_string(most));
          const auto property = [&](const std::string& color)
          {
            const std::string own = prefix == "r" ? color.substr(0, 1) : color;
            const bool isDiffuse = prefix == "diffuse_red";
            return "property " + type + (isDiffuse ? " diffuse_" : " ") + own + "\n";
          };
          const std::string header = vertexHead(2, "float") + property("red") + property("green") +
                                     property("blue") + property("alpha");
          Body body(format);
          for (const std::array<int, 4>& color :
            {std::array<int, 4>{most, 0, most / 5, most}, {0, most / 255, 2 * most / 5, most / 3}})
          {
            body.add<float>(1).add<float>(2).add<float>(3);
            for (const int number : color)
            {
              body.add(type, type == "char" && number > 127 ? number - 256 : number);
            }
            body.endItem();
          }
          const MeshArrays mesh = parsed(readPly, head(format, header) + body.bytes());
          EXPECT_EQ(mesh.colorComponents, 4);
          EXPECT_EQ(std::vector<int>(mesh.colors.begin(), mesh.colors.end()),
            (std::vector<int>{255, 0, 51, 255, 0, 1, 102, 85}));
        }
      }
    }
  }
}

/// The end of the header is the CR alone: LF may be the first byte of a number.
TEST(PlyFile, BinaryDataMayBeginWithLfBehindLinesThatEndWithCr)
{
  Body body("binary_little_endian");
  const float first = 3.0000024F; // its first byte is 10
  body.add<float>(first).add<float>(2).add<float>(3).endItem();
  ASSERT_EQ(body.bytes()[0], '\n');
  std::string header = head("binary_little_endian", vertexHead(1, "float"));
  const MeshArrays usual = parsed(readPly, header + body.bytes());
  std::replace(header.begin(), header.end(), '\n', '\r');
  const MeshArrays mesh = parsed(readPly, header + body.bytes());
  EXPECT_EQ(pointsOf(mesh), pointsOf(usual));
  EXPECT_EQ(pointsOf(mesh), (std::vector<double>{first, 2, 3}));
}

TEST(PlyFile, NumbersOfFacesAreReadWhereTheyAreWanted)
{
  const auto wanted = [](const InputFile& file, Executor& executor)
  {
    return readPlyColumns(file, {{}, true}, executor);
  };
  for (const std::string format : formats)
  {
    for (const bool areUniform : {false, true})
    {
      SCOPED_TRACE(format + (areUniform ? " triangles" : " polygons"));
      Body body(format);
      for (int i = 0; i < 4; ++i)
      {
        body.add<float>(1).add<float>(2).add<float>(3).endItem();
      }
      for (int i = 0; i < 3; ++i)
      {
        body.add<std::int32_t>(7 * i).add<std::uint8_t>(i).add<std::uint8_t>(2);
        body.addList("uchar", "int", areUniform || i != 1 ? Ids{0, 1, 2} : Ids{0, 1, 2, 3});
        body.add<std::uint8_t>(250).add<float>(0.5f + i).endItem();
      }
      const std::string file =
        head(format, vertexHead(4, "float") +
                       "element face 3\nproperty int label\nproperty uchar red\n"
                       "property uchar green\nproperty list uchar int vertex_indices\n"
                       "property uchar blue\nproperty float quality\n") +
        body.bytes();
      const MeshArrays mesh = parsed(wanted, file);
      EXPECT_EQ(mesh.polygons.count(), 3u);
      EXPECT_EQ(mesh.faceColorComponents, 3);
      EXPECT_EQ(std::vector<int>(mesh.faceColors.begin(), mesh.faceColors.end()),
        (std::vector<int>{0, 2, 250, 1, 2, 250, 2, 2, 250}));
      ASSERT_EQ(mesh.faceNumbers.size(), 2u);
      EXPECT_EQ(mesh.faceNumbers[0].name, "label");
      EXPECT_TRUE(mesh.faceNumbers[0].areIntegers);
      EXPECT_EQ(vectorOf(mesh.faceNumbers[0].numbers), (std::vector<double>{0, 7, 14}));
      EXPECT_FALSE(mesh.faceNumbers[1].areIntegers);
      EXPECT_EQ(vectorOf(mesh.faceNumbers[1].numbers), (std::vector<double>{0.5, 1.5, 2.5}));
      EXPECT_TRUE(parsed(readPly, file).faceNumbers.empty());
      EXPECT_TRUE(parsed(readPly, file).faceColors.empty());
    }
  }
}

TEST(PlyFile, ColorsOfFacesOfRealNumbersBecomeBytes)
{
  const auto wanted = [](const InputFile& file, Executor& executor)
  {
    return readPlyColumns(file, {{}, true}, executor);
  };
  for (const std::string format : formats)
  {
    for (const bool areUniform : {false, true})
    {
      SCOPED_TRACE(format + (areUniform ? " triangles" : " polygons"));
      Body body(format);
      for (int i = 0; i < 4; ++i)
      {
        body.add<float>(1).add<float>(2).add<float>(3).endItem();
      }
      for (int i = 0; i < 2; ++i)
      {
        body.add<float>(1).add<double>(0.5 * i);
        body.addList("uchar", "int", areUniform || i != 1 ? Ids{0, 1, 2} : Ids{0, 1, 2, 3});
        body.add<float>(0.1).add<float>(-i).endItem();
      }
      const MeshArrays mesh =
        parsed(wanted, head(format, vertexHead(4, "float") +
                                      "element face 2\nproperty float red\nproperty double green\n"
                                      "property list uchar int vertex_indices\n"
                                      "property float blue\nproperty float alpha\n") +
                         body.bytes());
      EXPECT_EQ(mesh.faceColorComponents, 4);
      EXPECT_EQ(std::vector<int>(mesh.faceColors.begin(), mesh.faceColors.end()),
        (std::vector<int>{255, 0, 26, 0, 255, 128, 26, 0}));
    }
  }
}

TEST(PlyFile, OtherNumbersOfVerticesAreReadWhereTheyAreWanted)
{
  const auto wanted = [](const InputFile& file, Executor& executor)
  {
    return readPlyColumns(file, {{}, true}, executor);
  };
  for (const std::string format : formats)
  {
    Body body(format);
    for (int i = 0; i < 3; ++i)
    {
      body.add<float>(0.5f + i).add<float>(1).add<float>(2).add<float>(3);
      body.add<std::int16_t>(-7 - i).add<float>(0).add<std::uint8_t>(1).endItem();
    }
    const std::string header =
      "element vertex 3\nproperty float scalar_Intensity\nproperty float x\nproperty float y\n"
      "property float z\nproperty short label\nproperty float nx\nproperty uchar label\n";
    const std::string file = head(format, header) + body.bytes();
    const MeshArrays mesh = parsed(wanted, file);
    EXPECT_EQ(pointsOf(mesh), (std::vector<double>{1, 2, 3, 1, 2, 3, 1, 2, 3})) << format;
    std::vector<std::string> names;
    for (const OtherNumbers& other : mesh.others)
    {
      names.push_back(other.name);
    }
    // A component of a normal that is not whole is a number, too.
    ASSERT_EQ(names, (std::vector<std::string>{"scalar_Intensity", "label", "nx", "label 4"}));
    EXPECT_EQ(vectorOf(mesh.others[0].numbers), (std::vector<double>{0.5, 1.5, 2.5})) << format;
    EXPECT_EQ(vectorOf(mesh.others[1].numbers), (std::vector<double>{-7, -8, -9})) << format;
    EXPECT_EQ(vectorOf(mesh.others[3].numbers), (std::vector<double>{1, 1, 1})) << format;
    EXPECT_FALSE(mesh.others[0].areIntegers);
    EXPECT_TRUE(mesh.others[1].areIntegers);
    EXPECT_TRUE(parsed(readPly, file).others.empty());
  }
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

} // namespace
