// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Files that the parser of PLY refuses, and its words.

#include "files/PlyFiles.h"

#include "files/PlyFile.h"

#include <cmath>

using namespace plyfiles;
using namespace winding;

namespace
{

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
  for (const std::string corners : {"property int vertex_indices\n",
         "property list uchar int a\nproperty list uchar int b\n", "property list int float a\n"})
  {
    EXPECT_EQ(
      refusalOf(readPly, first + vertex + "element face 1\n" + corners + "end_header\n0 0 0\n0\n"),
      "has faces without vertex_indices; give the list of their vertices this name");
  }
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
    Body small(format);
    for (int i = 0; i < 9; ++i)
    {
      small.add<float>(i);
    }
    small.add<std::int8_t>(-1).add<int>(0);
    EXPECT_EQ(refusalOf(readPly, head(format, vertexHead(3) + faceHead(1, "char")) + small.bytes()),
      "a list of -1 numbers; it is damaged; give another file");
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

} // namespace
