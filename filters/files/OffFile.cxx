// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/OffFile.h"

#include "base/Progress.h"
#include "files/ContentLines.h"

#include <algorithm>
#include <array>
#include <vector>

namespace winding
{

namespace
{

/// The shortest vertex is "0 0 0\n", the shortest face "1 0\n".
constexpr std::size_t bytesPerVertex = 6;
constexpr std::size_t bytesPerFace = 4;

struct Header
{
  bool hasNormals = false;
  std::size_t lines = 0; ///< in the header
  std::size_t vertices = 0;
  std::size_t faces = 0;

  std::size_t firstFace() const { return lines + vertices; }
  std::size_t end() const { return lines + vertices + faces; }
};

bool takePrefix(std::string_view& word, std::string_view prefix)
{
  const bool there = word.substr(0, prefix.size()) == prefix;
  word.remove_prefix(there ? prefix.size() : 0);
  return there;
}

/// Reads the keyword of the format. True where normals are promised.
bool readKeyword(LineScanner& words)
{
  std::string_view keyword = words.word();
  bool hasNormals = false, isSpatial = true;
  for (bool isPrefix = true; isPrefix;)
  {
    const bool isNormals = takePrefix(keyword, "N");
    const bool isDimension = takePrefix(keyword, "4") || takePrefix(keyword, "n");
    hasNormals = hasNormals || isNormals;
    isSpatial = isSpatial && !isDimension;
    isPrefix = isNormals || isDimension || takePrefix(keyword, "C") || takePrefix(keyword, "ST");
  }
  if (keyword != "OFF")
  {
    words.refuse("is not an OFF file: the keyword OFF is missing; write it before the numbers");
  }
  if (!isSpatial)
  {
    words.refuse("vertices have not three dimensions; give a file without 4 and n before OFF");
  }
  return hasNormals;
}

Header readHeader(const InputFile& file, const ContentLines& lines)
{
  FirstLines first(lines);
  if (!first.nextLine())
  {
    file.refuse("is not an OFF file: the keyword OFF is missing");
  }
  Header header;
  header.hasNormals = readKeyword(first.words());
  header.lines = 1;
  if (first.words().wordsLeft() == 0)
  {
    ++header.lines;
    if (!first.nextLine())
    {
      file.refuseEnd("the numbers of vertices and faces are missing");
    }
  }
  LineScanner& words = first.words();
  if (words.wordsLeft() == 1)
  {
    words.refuse("binary OFF cannot be read; convert it to text");
  }
  header.vertices = static_cast<std::size_t>(words.count("the number of vertices", bytesPerVertex));
  header.faces = static_cast<std::size_t>(words.count("the number of faces", bytesPerFace));
  return header;
}

void requireLines(const InputFile& file, const ContentLines& lines, const Header& header)
{
  const auto require = [&file](const char* kind, std::size_t there, std::size_t promised)
  {
    if (there < promised)
    {
      file.refuseEnd("it promises " + std::to_string(promised) + " " + kind + " but has " +
                     std::to_string(there) + "; it is truncated");
    }
  };
  const std::size_t there = lines.count() - header.lines;
  require("vertices", there, header.vertices);
  require("faces", there - header.vertices, header.faces);
}

void readVertices(
  const ContentLines& lines, const Header& header, MeshArrays& mesh, Executor& executor)
{
  mesh.points.doubles = PlainArray<double>(3 * header.vertices);
  mesh.normals.doubles = PlainArray<double>(header.hasNormals ? 3 * header.vertices : 0);
  lines.visit(
    header.lines, header.firstFace(),
    [&](std::size_t, ContentLines::Part& part)
    {
      while (part.nextLine())
      {
        const std::size_t first = 3 * (part.number() - header.lines);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          mesh.points.doubles[first + axis] = part.words().number("a coordinate");
        }
        for (std::size_t axis = 0; header.hasNormals && axis < 3; ++axis)
        {
          mesh.normals.doubles[first + axis] = part.words().number("a component of the normal");
        }
      }
    },
    executor);
}

/// The numbers of cells with one, two and more corners, and of their corners, in some part of a
/// file.
struct FaceCounts
{
  std::array<std::size_t, 3> cells = {};
  std::array<std::size_t, 3> corners = {};

  void add(const FaceCounts& other)
  {
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      cells[kind] += other.cells[kind];
      corners[kind] += other.corners[kind];
    }
  }
};

std::size_t kindOf(std::size_t corners)
{
  return std::min<std::size_t>(corners, 3) - 1;
}

/// Reads the number of corners, each of them a word on the line.
std::size_t readSize(LineScanner& words)
{
  const std::int64_t size = words.integer("the number of corners");
  if (size < 1 || static_cast<std::uint64_t>(size) > words.wordsLeft())
  {
    words.refuse("the face has " + std::to_string(size) + " corners, but " +
                 std::to_string(words.wordsLeft()) + " numbers follow");
  }
  return static_cast<std::size_t>(size);
}

/// The counts of faces before each block of lines, and, as the last one, of all.
std::vector<FaceCounts> countFaces(
  const ContentLines& lines, const Header& header, Executor& executor)
{
  std::vector<FaceCounts> starts(lines.blocks() + 1);
  lines.visit(
    header.firstFace(), header.end(),
    [&](std::size_t block, ContentLines::Part& part)
    {
      while (part.nextLine())
      {
        const std::size_t size = readSize(part.words());
        ++starts[block + 1].cells[kindOf(size)];
        starts[block + 1].corners[kindOf(size)] += size;
      }
    },
    executor);
  for (std::size_t block = 0; block < lines.blocks(); ++block)
  {
    starts[block + 1].add(starts[block]);
  }
  return starts;
}

std::int64_t readCorner(LineScanner& words, std::size_t vertices)
{
  const std::int64_t corner = words.integer("the index of a vertex");
  if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertices)
  {
    words.refuse("vertex " + std::to_string(corner) + " does not exist; there are " +
                 std::to_string(vertices) + ", counted from 0");
  }
  return corner;
}

void readFaces(const InputFile& file, const ContentLines& lines, const Header& header,
  const std::vector<FaceCounts>& starts, const std::array<CellArrays*, 3>& cells,
  Executor& executor)
{
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    if (starts.back().cells[kind] > 0)
    {
      cells[kind]->offsets = PlainArray<std::int64_t>(starts.back().cells[kind] + 1);
      cells[kind]->offsets[0] = 0;
      cells[kind]->connectivity = PlainArray<std::int64_t>(starts.back().corners[kind]);
    }
  }
  lines.visit(
    header.firstFace(), header.end(),
    [&](std::size_t block, ContentLines::Part& part)
    {
      FaceCounts at = starts[block];
      const FaceCounts& limit = starts[block + 1];
      while (part.nextLine())
      {
        const std::size_t size = readSize(part.words()), kind = kindOf(size);
        // The file may have changed since its faces were counted.
        if (at.cells[kind] == limit.cells[kind] || limit.corners[kind] - at.corners[kind] < size)
        {
          file.refuseChanged();
        }
        for (std::size_t i = 0; i < size; ++i)
        {
          cells[kind]->connectivity[at.corners[kind]++] = readCorner(part.words(), header.vertices);
        }
        cells[kind]->offsets[++at.cells[kind]] = static_cast<std::int64_t>(at.corners[kind]);
      }
      if (at.corners != limit.corners)
      {
        file.refuseChanged();
      }
    },
    executor);
}

} // namespace

MeshArrays readOff(const InputFile& file, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.15); // the parts of the time that the steps take, for a mesh of triangles
  const ContentLines lines(file, executor);
  const Header header = readHeader(file, lines);
  requireLines(file, lines, header);
  MeshArrays mesh;
  progress.set(0.15, 0.5);
  readVertices(lines, header, mesh, executor);
  progress.set(0.5, 0.7);
  const std::vector<FaceCounts> starts = countFaces(lines, header, executor);
  progress.set(0.7, 1);
  readFaces(file, lines, header, starts, {&mesh.vertices, &mesh.lines, &mesh.polygons}, executor);
  if (header.faces == 0)
  {
    mesh.vertices = oneCellOf(header.vertices);
  }
  if (lines.count() > header.end())
  {
    mesh.notes.push_back({"lines behind the last face are not read",
      {{"correct the counts in the first lines, if these are faces", {}}},
      "there are " + std::to_string(lines.count() - header.end())});
  }
  return mesh;
}

} // namespace winding
