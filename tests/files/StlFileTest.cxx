// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// The parser of STL: text and binary files, what it refuses, and that threads and blocks change
/// nothing.

#include "files/Parsing.h"
#include "support/Interruption.h"
#include "support/ShuffledThreads.h"

#include "files/LineBlocks.h"
#include "files/StlFile.h"

#include <cctype>
#include <cstdio>
#include <cstring>

using namespace winding;

namespace
{

/// The nine numbers of a triangle.
std::vector<float> triangle(std::size_t i)
{
  std::vector<float> numbers;
  for (std::size_t k = 0; k < 9; ++k)
  {
    numbers.push_back(static_cast<float>(9 * i + k) / 7);
  }
  return numbers;
}

std::string facet(std::size_t i)
{
  std::string text = "facet normal 0 0 1\n outer loop\n";
  const std::vector<float> numbers = triangle(i);
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    char line[100];
    const float* const at = numbers.data() + 3 * corner;
    text.append(
      line, static_cast<std::size_t>(std::snprintf(line, sizeof line, "  vertex %.9g %.9g %.9g\n",
              static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]))));
  }
  return text + " endloop\nendfacet\n";
}

std::string textFile(std::size_t triangles)
{
  std::string text = "solid part\n";
  for (std::size_t i = 0; i < triangles; ++i)
  {
    text += facet(i);
  }
  return text + "endsolid part\n";
}

std::string binaryFile(std::size_t triangles, std::string head = "made by hand")
{
  head.resize(80, ' ');
  for (std::size_t i = 0; i < 4; ++i)
  {
    head += static_cast<char>((triangles >> (8 * i)) & 255);
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const float normal[3] = {0, 0, 1};
    const std::vector<float> numbers = triangle(i);
    head.append(reinterpret_cast<const char*>(normal), sizeof normal);
    head.append(reinterpret_cast<const char*>(numbers.data()), 36);
    head.append("\1\2", 2);
  }
  return head;
}

/// The mesh has these triangles, each with points of its own.
void expectTriangles(const MeshArrays& mesh, std::size_t count, bool areFloats)
{
  ASSERT_EQ(mesh.points.count(), 3 * count);
  ASSERT_EQ(mesh.polygons.count(), count);
  EXPECT_EQ(mesh.points.doubles.empty(), areFloats || count == 0);
  EXPECT_EQ(mesh.normals.count(), 0u);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto first = static_cast<std::int64_t>(3 * i);
    ASSERT_EQ(mesh.polygons.offsets[i], first);
    ASSERT_EQ(mesh.polygons.offsets[i + 1], first + 3);
    const std::vector<float> numbers = triangle(i);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      ASSERT_EQ(
        mesh.polygons.connectivity[3 * i + corner], first + static_cast<std::int64_t>(corner));
    }
    for (std::size_t k = 0; k < 9; ++k)
    {
      const float read = areFloats ? mesh.points.floats[9 * i + k]
                                   : static_cast<float>(mesh.points.doubles[9 * i + k]);
      ASSERT_EQ(read, numbers[k]) << i;
    }
  }
}

TEST(StlFile, SolidsAreNamed)
{
  const MeshArrays mesh = parsed(readStl,
    "solid left half\n" + facet(0) + facet(1) + "endsolid left half\nsolid\nendsolid\nSOLID\n" +
      facet(2) + "endsolid\nsolid left half\n" + facet(3) + "endsolid\n");
  ASSERT_EQ(mesh.regions.size(), 1u);
  EXPECT_STREQ(mesh.regions[0].kind, "Solid");
  EXPECT_EQ(mesh.regions[0].names, (std::vector<std::string>{"left half", "", "left half"}));
  EXPECT_EQ(vectorOf(mesh.regions[0].ofPolygon), (std::vector<std::int32_t>{0, 0, 1, 2}));
  EXPECT_TRUE(parsed(readStl, textFile(3)).regions.empty());
}

TEST(StlFile, BinaryFiles)
{
  for (const std::size_t count : {0, 1, 2, 20000})
  {
    expectTriangles(parsed(readStl, binaryFile(count)), count, true);
    expectTriangles(parsed(readStl, binaryFile(count, "solid part")), count, true);
    shapes::ShuffledThreads threads(1);
    expectTriangles(parsed(readStl, binaryFile(count), threads), count, true);
  }
}

TEST(StlFile, TextFiles)
{
  expectTriangles(parsed(readStl, textFile(0)), 0, false);
  expectTriangles(parsed(readStl, textFile(2)), 2, false);
  const MeshArrays mesh = parsed(readStl,
    "SOLID of 0.1 # mm\r\ncolor 1 0 0\nFacet NORMAL 0 0 1\nOuter Loop\n\nVERTEX 0.1 +2 -3e-1 "
    "4\nvertex 0 0 0\nvertex nan inf 1e-400\nEndLoop\nEndFacet\nEndSolid\nsolid\nendsolid");
  EXPECT_EQ(mesh.points.doubles[0], 0.1) << "text has double precision";
  EXPECT_EQ(mesh.points.doubles[2], -0.3);
  EXPECT_EQ(mesh.points.doubles[8], 0);
  expectCells(mesh.polygons, {0, 3}, {0, 1, 2});
}

TEST(StlFile, SolidsBehindEachOther)
{
  const std::string text =
    "solid a\n" + facet(0) + "endsolid a\nsolid b\n" + facet(1) + facet(2) + "endsolid b\n\n";
  expectTriangles(parsed(readStl, text), 3, false);
  const std::string loose = "solid a\n" + facet(0) + "# the next one\nsolid Geh\xE4use\n" +
                            facet(1) + facet(2) + "endsolid b\n# the end\n";
  const MeshArrays mesh = parsed(readStl, loose);
  expectTriangles(mesh, 3, false);
  ASSERT_EQ(mesh.regions.size(), 1u);
  EXPECT_EQ(mesh.regions[0].names, (std::vector<std::string>{"a", "Geh\xC3\xA4use"}));
}

/// Solids of large files begin in blocks of their own.
TEST(StlFile, SolidsMayBeginInAnyBlock)
{
  const std::string part = textFile(5000);
  ASSERT_GT(part.size(), LineBlocks::usualBytes);
  std::string text;
  for (const char* name : {"a", "b", "c"})
  {
    text += std::string("solid ") + name + part.substr(part.find('\n'));
  }
  shapes::ShuffledThreads threads(1);
  const MeshArrays mesh = parsed(readStl, text, threads);
  ASSERT_EQ(mesh.regions.size(), 1u);
  EXPECT_EQ(mesh.regions[0].names, (std::vector<std::string>{"a", "b", "c"}));
  const std::vector<std::int32_t> solids = vectorOf(mesh.regions[0].ofPolygon);
  ASSERT_EQ(solids.size(), 15000u);
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    ASSERT_EQ(solids[i], static_cast<std::int32_t>(i / 5000)) << i;
  }
}

TEST(StlFile, BinariesMayBeginLikeText)
{
  std::string binary = binaryFile(3);
  binary.replace(0, 6, "solid ");
  expectTriangles(parsed(readStl, binary), 3, true);
  EXPECT_EQ(refusalOf(readStl, binary + "x"),
    "is 235 bytes long, but its 3 triangles take 234; it is damaged, or not STL");
}

TEST(StlFile, LargeTextIsTheSameForAllExecutors)
{
  const std::string text = textFile(20000);
  ASSERT_GT(text.size(), 4 * LineBlocks::usualBytes);
  expectTriangles(parsed(readStl, text), 20000, false);
  for (const unsigned seed : {1U, 2U})
  {
    shapes::ShuffledThreads threads(seed);
    expectTriangles(parsed(readStl, text, threads), 20000, false);
  }
}

TEST(StlFile, RefusalsOfBinaries)
{
  EXPECT_EQ(
    refusalOf(readStl, std::string(1, '\0')), "is not STL: it has 1 bytes, less than a header");
  const std::string good = binaryFile(3);
  EXPECT_EQ(refusalOf(readStl, good.substr(0, good.size() - 1)),
    "promises 3 triangles but holds 2; it is truncated, or not STL");
  EXPECT_EQ(refusalOf(readStl, good + "x"),
    "is 235 bytes long, but its 3 triangles take 234; it is damaged, or not STL");
  std::string many = good;
  many[83] = '\x7f';
  EXPECT_EQ(refusalOf(readStl, many),
    "promises 2130706435 triangles but holds 3; it is truncated, or not STL");
}

TEST(StlFile, TextMayBeginBehindBlanksAndComments)
{
  for (const std::string before : {"\n\n", "\r\n \t", "\xEF\xBB\xBF", "# solid\n# ball\n", "\n#\n"})
  {
    expectTriangles(parsed(readStl, before + textFile(2)), 2, false);
  }
}

TEST(StlFile, OtherTextIsSaidToBeThat)
{
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const std::string text : {"x", "ply\nformat ascii 1.0\n", "# a\n# b", "\n \n"})
  {
    for (const std::string behind : {"", obj.c_str()})
    {
      EXPECT_EQ(refusalOf(readStl, text + behind + std::string(200, ' ')),
        "is not STL: it is text without solid at its beginning; give it the suffix of its format");
    }
  }
}

TEST(StlFile, RefusalsOfText)
{
  const auto expect = [](const std::string& text, const std::string& words)
  {
    EXPECT_EQ(refusalOf(readStl, text), words) << text;
  };
  const std::string loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
  expect("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0\n",
    "line 5: a vertex needs three numbers; it is truncated or damaged");
  expect("solid\nfacet\nouter loop\nvertex 0 0 x\n",
    "line 4: a vertex needs three numbers; it is truncated or damaged");
  expect("solid nothing\n",
    "ends at line 1 with 0 facets and without endsolid; it is truncated, or not STL");
  expect("solid\nfacet\n" + loop + "endfacet\n",
    "ends at line 8 with 1 facets and without endsolid; it is truncated, or not STL");
  expect("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
    "ends at line 8 with 1 facets and without endsolid; it is truncated, or not STL");
  // There are three vertices for each facet, but not in their places.
  expect("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nfacet\n"
         "outer loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nendloop\n"
         "endfacet\nendsolid\n",
    "line 6: \"endloop\" stands where vertex should; correct it");
  expect("solid\n" + loop + "facet\nendfacet\nendsolid\n",
    "line 2: \"outer\" stands where facet should; correct it");
  expect("solid\nfacet\n" + loop + "endfacet\nouter loop\nendsolid\n",
    "line 9: \"outer\" stands where facet should; correct it");
  expect("solid\nfoo\nfacet\n" + loop + "endfacet\nendsolid\n",
    "line 2: \"foo\" stands where facet should; correct it");
  expect("solid\nendsolid\nfacet\n" + loop + "endfacet\nendsolid\n",
    "line 3: \"facet\" stands where solid should; correct it");
}

TEST(StlFile, EveryTruncationIsRefused)
{
  for (const std::string& file : {textFile(2), binaryFile(2), binaryFile(2, "solid")})
  {
    const std::size_t end = file.find("endsolid");
    const std::size_t needed = end == std::string::npos ? file.size() : end + 8;
    for (std::size_t size = 1; size < needed; ++size)
    {
      EXPECT_NE(refusalOf(readStl, file.substr(0, size)), "") << size;
    }
    EXPECT_EQ(refusalOf(readStl, file.substr(0, needed)), "");
  }
}

TEST(StlFile, LargeTextIsRefusedForTheFirstFault)
{
  for (const bool isOrder : {true, false})
  {
    std::string text = textFile(20000);
    std::string expected;
    for (const double part : {0.8, 0.4})
    {
      const std::size_t place =
        text.find(isOrder ? "outer" : "vertex", static_cast<std::size_t>(part * 2e6));
      text[place + (isOrder ? 0 : 7)] = 'x';
      const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
      expected = "line " + std::to_string(line) + ": ";
    }
    for (const unsigned seed : {1U, 2U, 3U})
    {
      shapes::ShuffledThreads threads(seed);
      const std::string refusal = refusalOf(readStl, text, threads);
      EXPECT_EQ(refusal.substr(0, expected.size()), expected) << refusal;
    }
  }
}

TEST(StlFile, InterruptedGivesNothing)
{
  for (const std::string& file : {textFile(2), binaryFile(2)})
  {
    for (const int runs : {0, 1})
    {
      shapes::Interruption executor(runs);
      EXPECT_THROW(parsed(readStl, file, executor), Interrupted);
    }
  }
}

} // namespace
