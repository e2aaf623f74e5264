#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <cstdint>
#include <cstring>

namespace
{

constexpr std::size_t headerBytes = 84;
constexpr std::size_t triangleBytes = 50;

void guardBinary(const std::string& fileName, const std::string& data)
{
  if (data.size() < headerBytes)
  {
    throw Failure(REFUSED, fileName,
      "is not STL: it has " + std::to_string(data.size()) + " bytes, less than a header");
  }
  std::uint32_t triangles;
  std::memcpy(&triangles, data.data() + headerBytes - sizeof triangles, sizeof triangles);
  const std::size_t held = (data.size() - headerBytes) / triangleBytes;
  if (held < triangles)
  {
    throw Failure(REFUSED, fileName,
      "promises " + std::to_string(triangles) + " triangles but holds " + std::to_string(held) +
        "; it is truncated, or not STL");
  }
  if (data.size() != headerBytes + triangleBytes * std::size_t(triangles))
  {
    throw Failure(REFUSED, fileName,
      "is " + std::to_string(data.size()) + " bytes long, but its " + std::to_string(triangles) +
        " triangles take " + std::to_string(headerBytes + triangleBytes * std::size_t(triangles)) +
        "; it is damaged, or not STL");
  }
}

bool isBinary(const std::string& data)
{
  // Words may be in small letters or capital ones, for VTK's reader, too.
  if (inSmallLetters(std::string_view(data).substr(0, 5)) != "solid")
  {
    return true;
  }
  // Some programs begin binary files with "solid", too, as text files begin.
  std::uint32_t triangles = 0;
  if (data.size() >= headerBytes)
  {
    std::memcpy(&triangles, data.data() + headerBytes - sizeof triangles, sizeof triangles);
  }
  return data.size() == headerBytes + triangleBytes * std::size_t(triangles);
}

void guardText(const std::string& fileName, const std::string& data)
{
  std::size_t line = 0, vertices = 0, facets = 0;
  std::string lastWord;
  for (std::size_t start = 0; start < data.size();)
  {
    std::string_view rest = takeLine(data, start);
    ++line;
    const std::string word = inSmallLetters(takeWord(rest));
    if (word.empty())
    {
      continue;
    }
    lastWord = word;
    facets += word == "endfacet";
    if (word == "vertex")
    {
      ++vertices;
      double value;
      for (int axis = 0; axis < 3; ++axis)
      {
        if (!parseNumber(takeWord(rest), value))
        {
          throw Failure(REFUSED, fileName,
            "line " + std::to_string(line) +
              ": a vertex needs three numbers; it is truncated or damaged");
        }
      }
    }
  }
  if (vertices != 3 * facets || lastWord != "endsolid")
  {
    throw Failure(REFUSED, fileName,
      "ends at line " + std::to_string(line) + " with " + std::to_string(facets) +
        " facets and without endsolid; it is truncated, or not STL");
  }
}

} // namespace

void guardStl(const std::string& fileName)
{
  const std::string data = contentsOf(fileName);
  if (isBinary(data))
  {
    guardBinary(fileName, data);
  }
  else
  {
    guardText(fileName, data);
  }
}
