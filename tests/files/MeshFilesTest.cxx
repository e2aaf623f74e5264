// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// The parsers of text: what they give, what they refuse, and that threads and blocks change
/// nothing.

#include "files/Parsing.h"
#include "support/Interruption.h"
#include "support/ShuffledThreads.h"

#include "files/LineBlocks.h"
#include "files/ObjFile.h"
#include "files/OffFile.h"
#include "files/PlyFile.h"
#include "files/PointsFile.h"
#include "files/StlFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace winding;

namespace
{

const std::string threeVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjFile, PolygonsLinesAndPoints)
{
  const MeshArrays mesh = parsed(readObj,
    "# a comment \\\nmtllib a.mtl\n  v 0 0 0 # first\nv 1 0 0 1 0 0\r\nv\t0 +1e-3 -.5\n"
    "vt 0\nvt 0 1\ng f 1\ns off\n\nf 1 2 3\nf -3/1 -2/2 -1/-1 1//\nl 1 2/1 3\np 3 # 1\n"
    "vp 1 2\nf 1 2 \\\n 3 \\\r\n 1");
  EXPECT_EQ(vectorOf(mesh.points.doubles), (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1e-3, -0.5}));
  EXPECT_TRUE(mesh.points.floats.empty());
  EXPECT_EQ(mesh.normals.count(), 0u);
  expectCells(mesh.polygons, {0, 3, 7, 11}, {0, 1, 2, 0, 1, 2, 0, 0, 1, 2, 0});
  expectCells(mesh.lines, {0, 3}, {0, 1, 2});
  expectCells(mesh.vertices, {0, 1}, {2});
}

TEST(ObjFile, BackslashesJoinLinesOfAllStatements)
{
  const std::string text = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nvn 0 1 0\n"
                           "vn 1 0 0\ng left 1\nf 1 2 3\nl 1 2\np 3\n";
  const MeshArrays plain = parsed(readObj, text);
  for (const std::string end : {"\\\n", " \\\r\n", "\\\n\\\n \t", "\\\r"})
  {
    std::string broken;
    for (const char letter : text)
    {
      broken += letter == ' ' ? (end.back() == ' ' ? end : end + ' ') : std::string(1, letter);
    }
    const MeshArrays mesh = parsed(readObj, "# a comment \\\n" + broken + "# \\\np 1 2 # \\\np 2");
    ASSERT_EQ(mesh.vertices.count(), 3u) << broken;
    expectSame(mesh, parsed(readObj, text + "p 1 2\np 2\n"));
    EXPECT_EQ(vectorOf(mesh.colors), vectorOf(plain.colors));
    ASSERT_EQ(mesh.regions.size(), plain.regions.size());
  }
}

TEST(ObjFile, NormalsAreThoseOfVertices)
{
  const std::string normals = "vn 0 0 1\nvn 0 0 2\nvn nan 0 3\n";
  const MeshArrays alone = parsed(readObj, threeVertices + normals);
  ASSERT_EQ(alone.normals.count(), 3u);
  EXPECT_EQ(alone.normals.doubles[5], 2);
  EXPECT_EQ(parsed(readObj, threeVertices + normals + "f 1//1 2//2 3//-1\n").normals.count(), 3u);
  EXPECT_EQ(parsed(readObj, threeVertices + normals + "f 1 2 3\n").normals.count(), 3u);
  EXPECT_EQ(parsed(readObj, threeVertices + normals + "f 1//1 2//2 3//2\n").normals.count(), 0u)
    << "a corner has the normal of another vertex";
  EXPECT_EQ(parsed(readObj, threeVertices + "vn 0 0 1\nf 1//1 2//1 3//1\n").normals.count(), 0u)
    << "there are fewer normals than vertices";
}

TEST(ObjFile, WhatIsNotUsedMayNotExist)
{
  const MeshArrays mesh =
    parsed(readObj, threeVertices + "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/7/1 2/x/2 3//9\nf 1/ 2 3\n");
  expectCells(mesh.polygons, {0, 3, 6}, {0, 1, 2, 0, 1, 2});
  EXPECT_EQ(mesh.normals.count(), 0u);
}

TEST(ObjFile, ColorsStandBehindPositions)
{
  const MeshArrays mesh = parsed(
    readObj, "vn 0 0 1\nv 0 0 0 1 0.5 0\nv 1 0 0 0 0 0.1 1 # white\nv 0 1 0 0 0 -2\nf 1 2 3\n");
  EXPECT_EQ(mesh.colorComponents, 3);
  EXPECT_EQ(std::vector<int>(mesh.colors.begin(), mesh.colors.end()),
    (std::vector<int>{255, 128, 0, 0, 0, 26, 0, 0, 0}));
  EXPECT_TRUE(mesh.notes.empty());
  const MeshArrays bytes = parsed(readObj, "v 0 0 0 255 7 0\nv 1 0 0 1 2 3\nv 0 1 0\n");
  EXPECT_EQ(std::vector<int>(bytes.colors.begin(), bytes.colors.end()),
    (std::vector<int>{255, 7, 0, 1, 2, 3, 255, 255, 255}));
  EXPECT_EQ(bytes.notes.size(), 1u) << "a vertex has no colour";
  const MeshArrays late = parsed(readObj, "v 0 0 0\nv 1 0 0 1\nv 0 1 0 0 0.5 1\nf 1 2 3\n");
  EXPECT_EQ(std::vector<int>(late.colors.begin(), late.colors.end()),
    (std::vector<int>{255, 255, 255, 255, 255, 255, 0, 128, 255}));
  EXPECT_EQ(late.notes.size(), 1u) << "two vertices have no colour";
  // Four numbers are a position with a weight.
  EXPECT_TRUE(parsed(readObj, "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\n").colors.empty());
}

TEST(ObjFile, VerticesAreThereOnceForEachTextureThatCornersName)
{
  const auto wanted = [](const InputFile& file, Executor& executor)
  {
    return readObjColumns(file, {{}, true}, executor);
  };
  const std::string text =
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\n"
    "vt 0.5\nvt 1 0.25\nvt 2 3 4\nf 1/1 2/2 3/3\nf 2/3 4 3/-1\nf 2/1 4/9 3/2\n"
    "f 2/3 4/2 1/1\nl 1 2\n";
  const MeshArrays mesh = parsed(wanted, text);
  EXPECT_EQ(vectorOf(mesh.points.doubles),
    (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(vectorOf(mesh.textureCoordinates),
    (std::vector<float>{0.5, 0, 1, 0.25, 2, 3, 1, 0.25, 2, 3, 0.5, 0, 1, 0.25}));
  EXPECT_EQ(mesh.colors.size(), mesh.points.doubles.size());
  EXPECT_EQ(mesh.colors[3 * 5 + 1], 255) << "the copy of the second vertex is green, too";
  expectCells(mesh.polygons, {0, 3, 6, 9, 12}, {0, 1, 2, 4, 3, 2, 5, 3, 6, 4, 3, 0});
  expectCells(mesh.lines, {0, 2}, {0, 1});
  EXPECT_EQ(parsed(readObj, text).points.count(), 4u);
  EXPECT_TRUE(parsed(readObj, text).textureCoordinates.empty());
  const std::string normals = "vn 0 0 1\nvn 0 2 0\nvn 3 0 0\nvn 4 0 0\n";
  EXPECT_EQ(vectorOf(parsed(wanted, normals + text).normals.doubles),
    (std::vector<double>{0, 0, 1, 0, 2, 0, 3, 0, 0, 4, 0, 0, 0, 2, 0, 0, 2, 0, 3, 0, 0}))
    << "copies have normals, too";
}

TEST(ObjFile, RegionsAreNamed)
{
  const MeshArrays mesh = parsed(readObj,
    "o house \n" + threeVertices +
      "g\nf 1 2 3\nl 1 2\nusemtl red brick\nf 1 3 2\no a tree\ng leaf 1\r\n"
      "f 1 2 3\no house\nusemtl glass\nusemtl red brick\nf 2 1 3\ng leaf 1\nusemtl unused\n");
  ASSERT_EQ(mesh.regions.size(), 3u);
  EXPECT_STREQ(mesh.regions[0].kind, "Object");
  EXPECT_EQ(mesh.regions[0].names, (std::vector<std::string>{"house", "a tree"}));
  EXPECT_EQ(vectorOf(mesh.regions[0].ofPolygon), (std::vector<std::int32_t>{0, 0, 1, 0}));
  EXPECT_STREQ(mesh.regions[1].kind, "Group");
  EXPECT_EQ(mesh.regions[1].names, (std::vector<std::string>{"", "leaf 1"}));
  EXPECT_EQ(vectorOf(mesh.regions[1].ofPolygon), (std::vector<std::int32_t>{0, 0, 1, 1}));
  EXPECT_STREQ(mesh.regions[2].kind, "Material");
  EXPECT_EQ(mesh.regions[2].names, (std::vector<std::string>{"", "red brick"}));
  EXPECT_EQ(vectorOf(mesh.regions[2].ofPolygon), (std::vector<std::int32_t>{0, 1, 1, 1}));
  EXPECT_TRUE(parsed(readObj, threeVertices + "o all\nusemtl a\nf 1 2 3\n").regions.empty());
  EXPECT_TRUE(parsed(readObj, threeVertices + "o a\no b\n").regions.empty());
}

TEST(ObjFile, RegionsMayBeginInAnyBlock)
{
  std::string text = threeVertices;
  std::vector<std::int32_t> regions;
  for (std::int32_t i = 0; text.size() < 4 * LineBlocks::usualBytes; ++i)
  {
    const std::int32_t region = i / 10000;
    text += (i % 10000 == 0 ? "g part " + std::to_string(region) + "\n" : "") + "f 1 2 3\n";
    regions.push_back(region);
  }
  shapes::ShuffledThreads threads(321);
  const MeshArrays mesh = parsed(readObj, text, threads);
  ASSERT_EQ(mesh.regions.size(), 1u);
  EXPECT_EQ(vectorOf(mesh.regions[0].ofPolygon), regions);
  EXPECT_EQ(mesh.regions[0].names.back(), "part " + std::to_string(regions.back()));
}

TEST(ObjFile, Refusals)
{
  const auto expect = [](const std::string& text, const std::string& words)
  {
    const std::string refusal = refusalOf(readObj, text);
    EXPECT_EQ(refusal.substr(0, words.size()), words) << text;
  };
  expect("# nothing\n", "is not OBJ: it has no line with a vertex; give another file");
  expect("f 1 2 3\n", "is not OBJ");
  expect("v 0 0 0\nv 0 0\n", "line 2: a vertex without its numbers; it is truncated or damaged");
  expect("v 0 0 zero\n", "line 1: a vertex without its numbers");
  expect("v 0 0 0\nvn 1 0\n", "line 2: a normal without its numbers");
  expect("v 0 0 0\nvt\n", "line 2: a texture coordinate without its numbers");
  expect(threeVertices + "f 1 2\n",
    "line 4: a face with 2 corners, which needs three; it is truncated or damaged");
  expect(threeVertices + "f\n", "line 4: a face with 0 corners");
  expect(threeVertices + "f 1 2 # 3\n", "line 4: a face with 2 corners");
  expect(threeVertices + "f 1 2 \\", "line 4: a face with 2 corners, ");
  expect(threeVertices + "l 1\n", "line 4: a line with 1 corners, which needs two");
  expect(threeVertices + "p\n", "line 4: a point with 0 corners, which needs one");
  expect(
    threeVertices + "f 1 2 4\n", "line 4: vertex 4 does not exist; there are 3, counted from 1");
  expect(threeVertices + "f 1 2 0\n", "line 4: vertex 0 does not exist");
  expect(threeVertices + "f 1 2 -4\n", "line 4: vertex -4 does not exist");
  expect("v 0 0 0\nv 1 0 0\nf 1 2 -3\nv 0 1 0\n", "line 3: vertex -3 does not exist");
  expect(threeVertices + "f 1 2 99999999999999999999\n", "line 4: vertex 99999999999999999999");
  expect(threeVertices + "f 1 2 -9223372036854775808\n", "line 4: vertex -9223372036854775808");
  expect(threeVertices + "f 1 2 x\n", "line 4: vertex x does not exist");
  expect(threeVertices + "f 1 2 /3\n", "line 4: vertex  does not exist");
}

/// Vertices that are no numbers are read: what is left out of a source, and counted, is its own
/// matter. Older C libraries write 1.#QNAN and 1.#INF.
TEST(MeshFiles, MayHaveVerticesThatAreNoNumbers)
{
  for (const std::string vertex : {"nan -inf 0", "-1.#IND 1.#INF 0", "NaN(ind) infinity 0"})
  {
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n" + vertex + "\n";
    const MeshArrays meshes[] = {parsed(readObj, threeVertices + "v " + vertex + "\nf 1 2 3\n"),
      parsed(readOff, "OFF\n4 1 0\n" + triangle + "3 0 1 2\n"), parsed(readPoints, triangle)};
    for (const MeshArrays& mesh : meshes)
    {
      ASSERT_EQ(mesh.points.count(), 4u) << vertex;
      EXPECT_TRUE(std::isnan(mesh.points.doubles[9])) << vertex;
      EXPECT_TRUE(std::isinf(mesh.points.doubles[10])) << vertex;
      EXPECT_EQ(mesh.points.doubles[11], 0) << vertex;
    }
  }
}

TEST(MeshFiles, MayBeginWithAByteOrderMark)
{
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(parsed(readObj, mark + threeVertices + "f 1 2 3\n").points.count(), 3u);
  EXPECT_EQ(parsed(readOff, mark + "OFF\n1 0 0\n0 0 0\n").points.count(), 1u);
  EXPECT_EQ(parsed(readPoints, mark + "0 0 0\n1;1;1\n").points.count(), 2u);
}

TEST(ObjFile, GeometryThatIsNotReadIsNoted)
{
  const MeshArrays mesh = parsed(readObj,
    threeVertices + "cstype bspline\nsurf 0 1 0 1 1 2 3\ncurv 0 1 1 2\ncurv2 1 2\nfo 1 2 3\n");
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_EQ(sentenceOf(mesh.notes[0]),
    "free-form curves and surfaces are not read: export them as polygons; there are 3");
  expectCells(mesh.polygons, {0, 3}, {0, 1, 2});
  const MeshArrays points = parsed(readObj, threeVertices + "vn 0 0 1\n");
  ASSERT_EQ(points.notes.size(), 1u);
  EXPECT_EQ(sentenceOf(points.notes[0]), "normals that fit no vertices are not read: export one "
                                         "for each vertex; 1 normals for 3 vertices");
  EXPECT_EQ(parsed(readObj, threeVertices + "vn 0 0 1\nf 1//1 2//1 3//1\n").notes.size(), 0u);
}

TEST(OffFile, PrefixesInAnyOrder)
{
  const std::string ofNormals = "3 1 0\n0 0 0 0 0 1 9 9 9 1\n1 0 0 0 0 1 9 9 9 1\n0 1 0 0 0 1 9 9 "
                                "9 1\n3 0 1 2\n";
  for (const std::string prefix : {"N", "CN", "NC", "STCN", "NCST", "CSTN", "NST"})
  {
    const MeshArrays mesh = parsed(readOff, prefix + "OFF\n" + ofNormals);
    EXPECT_EQ(vectorOf(mesh.normals.doubles), (std::vector<double>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(mesh.points.doubles[3], 1) << prefix;
    EXPECT_EQ(mesh.notes.size(), 0u) << prefix;
  }
  for (const std::string prefix : {"", "C", "ST", "CST", "STC"})
  {
    EXPECT_EQ(parsed(readOff, prefix + "OFF\n" + ofNormals).normals.count(), 0u) << prefix;
  }
  for (const std::string prefix : {"4", "n", "4n", "C4", "NCn", "N4", "STCN4n"})
  {
    EXPECT_EQ(refusalOf(readOff, prefix + "OFF\n" + ofNormals),
      "line 1: vertices have not three dimensions; give a file without 4 and n before OFF");
  }
  for (const std::string keyword : {"3 1 0", "XOFF", "OFFX", "NOF"})
  {
    EXPECT_EQ(refusalOf(readOff, keyword + "\n" + ofNormals),
      "line 1: is not an OFF file: the keyword OFF is missing; write it before the numbers");
  }
}

TEST(OffFile, LinesBehindTheLastFaceAreNoted)
{
  const MeshArrays mesh = parsed(readOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n");
  EXPECT_EQ(mesh.polygons.count(), 1u);
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_EQ(sentenceOf(mesh.notes[0]),
    "lines behind the last face are not read: correct the "
    "counts in the first lines, if these are faces; there are 1");
}

TEST(OffFile, CellsBySize)
{
  const MeshArrays mesh =
    parsed(readOff, "OFF\n3 5 0\n0 0 0\n1 0 0\n0 1 0\n1 2\n3 0 1 2\n2 0 1\n1 1\n4 2 1 0 1 255\n");
  expectCells(mesh.polygons, {0, 3, 7}, {0, 1, 2, 2, 1, 0, 1});
  expectCells(mesh.lines, {0, 2}, {0, 1});
  expectCells(mesh.vertices, {0, 1, 2}, {2, 1});
}

TEST(PointsFile, AllAreInOneCell)
{
  const MeshArrays cloud = parsed(readPoints, "0 0 0 0 0 1\n1 2 3 0 1 0\n");
  expectCells(cloud.vertices, {0, 2}, {0, 1});
  EXPECT_EQ(vectorOf(cloud.normals.doubles), (std::vector<double>{0, 0, 1, 0, 1, 0}));
  EXPECT_EQ(parsed(readPoints, "0\n").vertices.count(), 0u);
}

TEST(PointsFile, ACommentBeforeThePointsMayNameTheColumns)
{
  const MeshArrays cloud =
    parsed(readPoints, "# a scan\n# x y z r g b nx ny nz\n1 2 3 9 8 7 0 0 1\n4 5 6 9 8 7 0 1 0\n");
  EXPECT_EQ(vectorOf(cloud.points.doubles), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(vectorOf(cloud.normals.doubles), (std::vector<double>{0, 0, 1, 0, 1, 0}));
  EXPECT_EQ(vectorOf(parsed(readPoints, "# x y z of a wall\n1 2 3\n").points.doubles),
    (std::vector<double>{1, 2, 3}));
}

TEST(PointsFile, ColumnsMayBeChosen)
{
  const auto read = [](const std::string& text, const std::string& columns)
  {
    const TemporaryFile file(text);
    SerialExecutor serial;
    MeshArrays cloud =
      readPointColumns(InputFile(file.name()), {ColumnChoice(columns), true}, serial);
    std::string names;
    for (const OtherNumbers& other : cloud.others)
    {
      names += other.name + "=" + std::to_string(std::lround(other.numbers[0])) + " ";
    }
    return std::make_pair(std::move(cloud), names);
  };
  const auto [plain, rest] = read("9 1 2 3 4 0 0 1\n", "x=2 y=3 z=4 area=5 nx=6 ny=7 nz=8");
  EXPECT_EQ(vectorOf(plain.points.doubles), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(vectorOf(plain.normals.doubles), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(vectorOf(plain.areas), (std::vector<double>{4}));
  EXPECT_EQ(rest, "Column 1=9 ");
  const auto [seen, none] = read("x y z vp_x vp_y vp_z\n1 2 3 7 8 9\n", "");
  EXPECT_EQ(vectorOf(seen.viewpoints), (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(none, "");
  const auto [named, others] = read("//East North Height R area\n1\n1;2;3;7;5\n", "x=East y=North");
  EXPECT_EQ(vectorOf(named.points.doubles), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(vectorOf(named.areas), (std::vector<double>{5}));
  EXPECT_EQ(others, "R=7 ");
  const auto weighted =
    read("x y z Weight Area nx ny nz Normals\n1 2 3 4 5 0 0 1 6\n", "area=Weight");
  EXPECT_EQ(vectorOf(weighted.first.areas), (std::vector<double>{4}));
  EXPECT_EQ(weighted.second, "Area 5=5 Normals 9=6 ") << "other names than the arrays'";
  EXPECT_THROW(read("1 2 3\n", "z=4"), FileRefusal);
  EXPECT_THROW(read("E N H\n1 2 3\n", "x=E y=N z=Z"), FileRefusal);
}

TEST(PointsFile, ColoursMayBeMeansOfOthers)
{
  std::string text;
  for (int i = 0; i < 20; ++i)
  {
    text += std::to_string(i) + " 0 0 " + std::to_string(100 + i) + ".5 127.25 30\n";
  }
  const MeshArrays cloud = parsed(readPoints, text);
  EXPECT_EQ(cloud.normals.count(), 0u);
  EXPECT_EQ(cloud.notes.size(), 1u);
}

/// Expects that three columns behind the position are colours, with these bytes, or normals.
void expectColors(const std::string& text, const std::vector<std::uint8_t>& colors)
{
  const MeshArrays cloud = parsed(readPoints, text);
  EXPECT_EQ(vectorOf(cloud.colors), colors) << text;
  EXPECT_EQ(cloud.normals.count() == 0, !colors.empty()) << text;
  ASSERT_EQ(cloud.notes.size(), colors.empty() ? 0u : 1u) << text;
  if (!colors.empty())
  {
    EXPECT_EQ(cloud.notes[0].fault, "columns 4 to 6 are taken for colours");
    EXPECT_EQ(cloud.notes[0].remedies.at(0).settings.at(0).parameter, Parameter::estimateNormals);
  }
}

TEST(PointsFile, ColoursAreNoNormals)
{
  expectColors("0 0 0 255 0 0\n1 0 0 0 7 255\n", {255, 0, 0, 0, 7, 255});
  expectColors("0 0 0 2 0 0\n1 0 0 0 3 1\n", {2, 0, 0, 0, 3, 1});
  expectColors("0 0 0 2 0 0\n1 0 0 0 0 1\n", {});
  expectColors("0 0 0 65535 0 0\n1 0 0 0 257 0\n", {255, 0, 0, 0, 1, 0});
  expectColors("0 0 0 40000 10000 300\n1 0 0 0 60000 5\n", {156, 39, 1, 0, 233, 0});
  expectColors("0 0 0 1 1 1\n1 0 0 0 0 0\n1 0 1 nan 0 0\n", {255, 255, 255, 0, 0, 0, 0, 0, 0});
  expectColors("0 0 0 0.2 0.4 0.6\n1 0 0 1 1 0.6\n", {51, 102, 153, 255, 255, 153});
  expectColors("2\n0,0,0,10,20,30\n1,0,0,10,20,30\n", {10, 20, 30, 10, 20, 30});
  expectColors("0 0 0 0 0 1\n1 0 0 0 0.6 0.8\n", {}); // unit vectors
  expectColors("0 0 0 0 0 200\n1 0 0 0 0 -200\n", {});
  expectColors("0 0 0 0 0 20.5\n1 0 0 3 4 5\n", {});
  expectColors("0 0 0 0 0 0\n1 0 0 0 0 0\n", {}); // the core takes these for none
  std::string few, many; // points with fractions beyond 1: normals, and from 16 points on colours
  std::vector<std::uint8_t> ofMany;
  for (int i = 0; i < 16; ++i)
  {
    many += "0 0 " + std::to_string(i) + " 10.5 200.25 30.5\n";
    few = i == 14 ? many : few;
    ofMany.insert(ofMany.end(), {11, 200, 31});
  }
  expectColors(few, {});
  expectColors(many, ofMany);
  expectColors("x y z nx ny nz\n0 0 0 9 9 9\n1 0 0 9 9 9\n", {});
  expectColors("1\n0 0 0\n9 9 9\n", {}); // in lines behind all positions
}

TEST(PointsFile, AnythingSeparatesNumbers)
{
  const std::vector<double> points = {0.5, 1, 2, -3.25, 1e-3, 4}, normals = {0, 0, 1, 1, 0, 0};
  for (const std::string text : {"0.5 1 2 0 0 1\n-3.25 1e-3 4 1 0 0\n",
         "0.5,1,2,0,0,1\n-3.25,1e-3,4,1,0,0\n", "0.5, 1, 2, 0, 0, 1\n-3.25 ,1e-3 ,4 ,1 ,0 ,0\n",
         "0.5;1;2;0;0;1\n-3.25;1e-3;4;1;0;0\n", "0,5;1;2;0;0;1\n-3,25;1e-3;4;1;0;0\n",
         "0,5 1 2 0 0 1\n-3,25 1e-3 4 1 0 0\n", "# a, b\n0.5,1,2 0,0,1\n-3.25,1e-3,4 1,0,0\n",
         "0.5\t1\t2\t0\t0\t1\r\n-3.25\t1e-3\t4\t1\t0\t0\r\n",
         "2\n0.5,1,2\n-3.25,1e-3,4\n0,0,1\n1,0,0\n"})
  {
    const MeshArrays cloud = parsed(readPoints, text);
    EXPECT_EQ(vectorOf(cloud.points.doubles), points) << text;
    EXPECT_EQ(vectorOf(cloud.normals.doubles), normals) << text;
  }
  EXPECT_EQ(parsed(readPoints, "1 2 3\n1,5 2 3\n").points.doubles[3], 1.5)
    << "the first line with a comma says what it is";
}

TEST(PointsFile, NamesSayWhatColumnsAre)
{
  for (const std::string names : {"x y z r g b nx ny nz", "//X Y Z R G B Nx Ny Nz",
         "X;Y;Z;R;G;B;normal_x;normal_y;normal_z", "easting,northing,height,r,g,b,nx,ny,nz"})
  {
    for (const std::string count : {"", "1\n"})
    {
      const MeshArrays cloud = parsed(readPoints, names + "\n" + count + "1 2 3 9 9 9 0 1 0\n");
      EXPECT_EQ(vectorOf(cloud.points.doubles), (std::vector<double>{1, 2, 3})) << names;
      EXPECT_EQ(vectorOf(cloud.normals.doubles), (std::vector<double>{0, 1, 0})) << names;
      EXPECT_EQ(cloud.notes.size(), 0u) << names;
    }
  }
  const MeshArrays others = parsed(readPoints, "intensity z y x\n9 3 2 1\n");
  EXPECT_EQ(vectorOf(others.points.doubles), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(others.normals.count(), 0u);
  EXPECT_EQ(parsed(readPoints, "// a comment\n1 2 3\n").points.count(), 1u);
  EXPECT_EQ(refusalOf(readPoints, "1 2 3 4 5 6 7 8 9\n"),
    "line 1: holds 9 words; a point is x y z or x y z nx ny nz; where there are others, name all "
    "in a line before, as in x y z r g b nx ny nz");
  EXPECT_EQ(refusalOf(readPoints, "x y z\n1 2 3 4\n"),
    "line 2: holds 4 words, but the first line has 3 names; write one for each column");
}

/// Files of several blocks.
struct LargeFile
{
  const char* name;
  Parser parser;
  std::string text;
};

constexpr std::int64_t largeCount = 60000;

std::string lines(const std::string& head, const char* point, const char* face)
{
  std::string text = head;
  char line[200];
  for (std::int64_t i = 0; i < largeCount; ++i)
  {
    const double value = static_cast<double>(i);
    text.append(line, static_cast<std::size_t>(std::snprintf(
                        line, sizeof line, point, value / 3, value / 7, -value / 11)));
  }
  for (std::int64_t i = 0; face && i < largeCount; ++i)
  {
    const long long first = 1 + i % (largeCount - 2);
    text.append(line, static_cast<std::size_t>(
                        std::snprintf(line, sizeof line, face, first, first + 1, first + (i % 2))));
  }
  return text;
}

std::vector<LargeFile> largeFiles()
{
  const std::string count = std::to_string(largeCount);
  return {{"obj", readObj, lines("", "v %.17g %.17g %.17g\n", "f %lld \\\n%lld/ %lld//\n")},
    {"off", readOff,
      lines("OFF\n" + count + " " + count + "\n\n", "%.17g %.17g %.17g # point\n",
        "3 %lld %lld %lld\n")},
    {"xyz", readPoints, lines("", "%.17g %.17g %.17g 0 0 1\n", nullptr)},
    {"pwn", readPoints, lines(count + "\n", "%.17g %.17g %.17g\n", "%lld %lld %lld\n")}};
}

/// Text in UTF-16, in either order of bytes and with a mark or without, is named as such.
TEST(MeshFiles, InUtf16AreNamed)
{
  const std::pair<Parser, std::string> files[] = {{readObj, threeVertices + "f 1 2 3\n"},
    {readOff, "OFF\n1 0 0\n0 0 0\n"}, {readPoints, "0 0 0 0 0 1\n"}, {readStl, "solid \n"},
    {readPly, "ply\nformat ascii 1.0\n"}};
  for (const auto& [parser, text] : files)
  {
    for (const bool isBig : {false, true})
    {
      for (const bool isMarked : {false, true})
      {
        std::string wide = !isMarked ? "" : isBig ? "\xFE\xFF" : "\xFF\xFE";
        for (const char letter : text)
        {
          const char pair[] = {isBig ? '\0' : letter, isBig ? letter : '\0'};
          wide.append(pair, 2);
        }
        wide += isMarked ? "\x30\x42\x30\x44" : ""; // letters that are not Latin
        EXPECT_EQ(refusalOf(parser, wide), "is text in UTF-16; save it as UTF-8") << text;
      }
    }
  }
}

TEST(MeshFiles, OfZerosAreNotTakenForUtf16)
{
  std::string bytes(84 + 50 * 5, '\0');
  bytes[80] = 5; // triangles
  EXPECT_EQ(parsed(readStl, bytes).polygons.count(), 5u);
}

TEST(LargeFiles, AreTheSameForAllExecutors)
{
  for (const LargeFile& file : largeFiles())
  {
    SCOPED_TRACE(file.name);
    ASSERT_GT(file.text.size(), 4 * LineBlocks::usualBytes);
    const MeshArrays serial = parsed(file.parser, file.text);
    ASSERT_EQ(serial.points.count(), static_cast<std::size_t>(largeCount));
    EXPECT_EQ(serial.points.doubles[3 * 50000], 50000.0 / 3);
    for (const unsigned seed : {1U, 2U})
    {
      shapes::ShuffledThreads threads(seed);
      expectSame(parsed(file.parser, file.text, threads), serial);
    }
  }
}

TEST(LargeFiles, AreRefusedForTheFirstFault)
{
  for (LargeFile file : largeFiles())
  {
    SCOPED_TRACE(file.name);
    for (const double part : {0.2, 0.4})
    {
      // A letter takes the place of a space within a line of vertices.
      const auto from = static_cast<std::size_t>(part * static_cast<double>(file.text.size()));
      file.text[file.text.find(' ', file.text.find('\n', from) + 3)] = 'x';
    }
    const std::string refusal = refusalOf(file.parser, file.text);
    const std::size_t firstFault = file.text.find('x');
    const std::size_t line =
      1 + static_cast<std::size_t>(std::count(
            file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(firstFault), '\n'));
    EXPECT_EQ(refusal.rfind("line " + std::to_string(line) + ": ", 0), 0u) << refusal;
    for (const unsigned seed : {1U, 2U})
    {
      shapes::ShuffledThreads threads(seed);
      EXPECT_EQ(refusalOf(file.parser, file.text, threads), refusal);
    }
  }
}

/// Does something before the second time that it runs blocks.
class DisturbedExecutor final : public winding::Executor
{
public:
  explicit DisturbedExecutor(std::function<void()> disturb)
    : disturb_(std::move(disturb))
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    if (++runs_ == 2)
    {
      disturb_();
    }
    winding::SerialExecutor().run(count, work);
  }

private:
  std::function<void()> disturb_;
  int runs_ = 0;
};

TEST(ChangedFiles, AreRefused)
{
  const std::string obj = threeVertices + "f 1 2 3\nf 1 2 3\n";
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string xyz = "0 0 0\n1 0 0\n0 1 0\n";
  struct Change
  {
    Parser parser;
    std::string before, after;
  };
  // The contents after have the same size.
  const Change changes[] = {{readObj, obj, threeVertices + "f 1 2 3 1 2 3 1\n"},
    {readObj, obj, threeVertices + "v 1 2 3\nf 1 2 3\n"},
    {readObj, obj, threeVertices + "g 1 2 3\nf 1 2 3\n"},
    {readObj, obj, threeVertices + "f 1 2 3 1\nf 1 2\n"},
    {readOff, off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 3 0 1 2\n"},
    {readPoints, xyz, "0 0 0\n1 0 0\n# 1 0\n"}};
  for (const Change& change : changes)
  {
    ASSERT_EQ(change.before.size(), change.after.size());
    const TemporaryFile file(change.before);
    const InputFile input(file.name());
    DisturbedExecutor executor([&]() { file.write(change.after); });
    EXPECT_THROW(change.parser(input, executor), FileRefusal) << change.after;
  }
}

TEST(InterruptedFiles, GiveNothing)
{
  for (const auto& [parser, text] : {std::pair<Parser, std::string>(readObj, threeVertices),
         {readOff, "OFF\n1 0 0\n0 0 0\n"}, {readPoints, "0 0 0\n"}})
  {
    shapes::Interruption executor(0);
    EXPECT_THROW(parsed(parser, text, executor), Interrupted);
  }
}

/// Returns `text` with `end` for the ends of its lines, of which every `every`-th only.
std::string withEnds(const std::string& text, const std::string& end, int every = 1)
{
  std::string other;
  int line = 0;
  for (const char letter : text)
  {
    other += letter == '\n' && ++line % every == 0 ? end : std::string(1, letter);
  }
  return other;
}

TEST(TextFiles, MayHaveLinesThatEndWithCarriageReturns)
{
  const std::pair<Parser, std::string> files[] = {
    {readObj, "# made by hand\nv 0 0 0\nv 1 0 0 # a\nv 0 1 0\n\nf 1 2 \\\n3\nl 1 2\n"},
    {readOff, "OFF\n# a comment\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {readStl, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
              "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
    {readPly, "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
              "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
              "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {readPoints, "# x y z\n0 0 0 0 0 1\n1,0,0,0,0,1\n0 1 0 0 0 1\n"}};
  for (const auto& [parser, text] : files)
  {
    const MeshArrays plain = parsed(parser, text);
    EXPECT_EQ(plain.points.count(), 3u) << text;
    for (const std::string end : {"\r", "\r\n"})
    {
      for (const int every : {1, 2, 3})
      {
        const std::string mark = parser == readPly ? "" : "\xEF\xBB\xBF";
        expectSame(parsed(parser, withEnds(text, end, every)), plain);
        expectSame(parsed(parser, mark + withEnds(text, end, every)), plain);
      }
    }
  }
  EXPECT_EQ(
    refusalOf(readOff, withEnds("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "\r")).substr(0, 7),
    "line 4:");
}

} // namespace
