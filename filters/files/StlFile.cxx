// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/StlFile.h"

#include "files/BinaryNumbers.h"
#include "files/OrderedBlocks.h"
#include "files/StlText.h"
#include "files/Words.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace winding
{

namespace
{

constexpr std::size_t headerBytes = 84;   ///< any 80 bytes, and the number of triangles
constexpr std::size_t triangleBytes = 50; ///< the normal, the vertices, and two bytes more
constexpr std::size_t normalBytes = 12;
constexpr std::size_t verticesBytes = 36;
constexpr std::size_t trianglesPerBlock = 4096;

/// The number of triangles that the header of a binary file promises; 0 where there is no header.
std::size_t promisedTriangles(const InputFile& file)
{
  if (file.size() < headerBytes)
  {
    return 0;
  }
  char bytes[4];
  file.read(headerBytes - sizeof bytes, bytes, sizeof bytes);
  return numberAt<std::uint32_t, isBigEndianMachine>(bytes);
}

/// Whether a file is binary. Throws FileRefusal for text of another format.
bool isBinary(const InputFile& file)
{
  // Some programs begin binary files with "solid", too, as text files begin.
  if (file.size() == headerBytes + triangleBytes * promisedTriangles(file))
  {
    return true;
  }
  constexpr std::size_t looked = 1024;
  const std::size_t start = file.textStart();
  std::string head(std::min(looked, file.size() - start), ' ');
  file.readText(start, head.data(), head.size());
  std::size_t word = head.find_first_not_of(" \t\r\n");
  while (word < head.size() && head[word] == '#')
  {
    word = head.find_first_not_of(" \t\r\n", head.find('\n', word));
  }
  const bool isText =
    head.find('\0') == std::string::npos || inSmallLetters(head).find("facet") != std::string::npos;
  if (isText && word < head.size() && inSmallLetters(head.substr(word, 5)) == "solid")
  {
    return false;
  }
  if (head.find('\0') == std::string::npos)
  {
    file.refuse("is not STL: it is text without solid at its beginning; give it the suffix of its "
                "format");
  }
  return true;
}

void checkSize(const InputFile& file)
{
  if (file.size() < headerBytes)
  {
    file.refuse("is not STL: it has " + std::to_string(file.size()) + " bytes, less than a header",
      FileFault::ends);
  }
  const std::size_t triangles = promisedTriangles(file);
  const std::size_t held = (file.size() - headerBytes) / triangleBytes;
  if (held < triangles)
  {
    file.refuse("promises " + std::to_string(triangles) + " triangles but holds " +
                  std::to_string(held) + "; it is truncated, or not STL",
      FileFault::ends);
  }
  const std::size_t bytes = headerBytes + triangleBytes * triangles;
  if (file.size() != bytes)
  {
    file.refuse("is " + std::to_string(file.size()) + " bytes long, but its " +
                std::to_string(triangles) + " triangles take " + std::to_string(bytes) +
                "; it is damaged, or not STL");
  }
}

/// The vertices of all triangles, nine numbers for each.
PlainArray<float> readBinary(const InputFile& file, Executor& executor)
{
  checkSize(file);
  const std::size_t triangles = (file.size() - headerBytes) / triangleBytes;
  PlainArray<float> numbers(9 * triangles);
  runOrderedBlocks((triangles + trianglesPerBlock - 1) / trianglesPerBlock,
    [&](std::size_t block)
    {
      const std::size_t first = block * trianglesPerBlock;
      const std::size_t count = std::min(trianglesPerBlock, triangles - first);
      PlainArray<char> bytes(count * triangleBytes);
      file.read(headerBytes + first * triangleBytes, bytes.data(), bytes.size());
      const char* from = bytes.data() + normalBytes;
      float* into = numbers.data() + 9 * first;
      for (std::size_t i = 0; i < count; ++i, from += triangleBytes)
      {
        for (std::size_t offset = 0; offset < verticesBytes; offset += sizeof(float))
        {
          *into++ = numberAt<float, isBigEndianMachine>(from + offset);
        }
      }
    },
    executor);
  return numbers;
}

/// Triangles of three points of their own.
CellArrays separateTriangles(std::size_t count, Executor& executor)
{
  CellArrays cells;
  if (count == 0)
  {
    return cells;
  }
  cells.offsets = PlainArray<std::int64_t>(count + 1);
  cells.connectivity = PlainArray<std::int64_t>(3 * count);
  cells.offsets[0] = 0;
  runBlocks(
    count, trianglesPerBlock,
    [&cells](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int64_t>(3 * i);
        cells.connectivity[3 * i] = point;
        cells.connectivity[3 * i + 1] = point + 1;
        cells.connectivity[3 * i + 2] = point + 2;
        cells.offsets[i + 1] = point + 3;
      }
    },
    executor);
  return cells;
}

} // namespace

MeshArrays readStl(const InputFile& file, Executor& executor)
{
  MeshArrays mesh;
  if (isBinary(file))
  {
    mesh.points.floats = readBinary(file, executor);
  }
  else
  {
    readStlText(file, mesh, executor);
  }
  mesh.polygons = separateTriangles(mesh.points.count() / 3, executor);
  return mesh;
}

} // namespace winding
