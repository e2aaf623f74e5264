// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ContentCheck.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "program/Failure.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace
{

bool isOff(std::string_view text)
{
  while (!text.empty() && text[0] == '#')
  {
    std::size_t start = 0;
    takeLine(text, start);
    text.remove_prefix(std::min(start, text.size()));
  }
  const std::string_view word = takeWord(text);
  return word.size() >= 3 && word.size() <= 9 && word.substr(word.size() - 3) == "OFF" &&
         std::all_of(word.begin(), word.end(),
           [](char c) { return (c >= 'A' && c <= 'Z') || c == '4' || c == 'n'; });
}

bool isPly(std::string_view text)
{
  return startsWith(text, "ply\n") || startsWith(text, "ply\r");
}

bool isLegacyVtk(std::string_view text)
{
  return startsWith(text, "# vtk DataFile");
}

bool isXml(std::string_view text)
{
  return startsWith(text, "<?xml") || startsWith(text, "<VTKFile");
}

bool isBinaryGltf(std::string_view text)
{
  return startsWith(text, "glTF");
}

bool isZip(std::string_view text)
{
  return startsWith(text, "PK\x03\x04");
}

bool isHdf5(std::string_view text)
{
  return startsWith(text, "\x89HDF\r\n\x1a\n");
}

bool isJson(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

/// A kind of file that announces itself in its first bytes.
struct Kind
{
  const char* name;
  const char* suffixes; ///< that promise this kind
  bool (*isAnnounced)(std::string_view head);
};

constexpr Kind kinds[] = {{"PLY", ".ply", isPly}, {"legacy VTK", ".vtk", isLegacyVtk},
  {"VTK XML", ".vtp .vtu .vtm .pvtp .pvtu .vti .vtr or .vts", isXml}, {"OFF", ".off", isOff},
  {"binary glTF", ".glb", isBinaryGltf}, {"JSON", ".gltf", isJson}, {"ZIP", ".3mf", isZip},
  {"HDF5", ".vtkhdf", isHdf5}};

/// Returns the kind for which `fits` holds; null if there is none.
template <class Fits> const Kind* kindWhere(const Fits& fits)
{
  const Kind* const kind = std::find_if(std::begin(kinds), std::end(kinds), fits);
  return kind == std::end(kinds) ? nullptr : kind;
}

/// The name of the packer whose mark the first bytes have; null if there is none.
const char* compressedKind(std::string_view head)
{
  if (startsWith(head, "\x1f\x8b"))
  {
    return "gzip";
  }
  if (isZip(head))
  {
    return "zip";
  }
  if (startsWith(head, "BZh") && head.substr(std::min<std::size_t>(4, head.size()), 6) == "1AY&SY")
  {
    return "bzip2";
  }
  return startsWith(head, std::string("\xFD") + "7zXZ") ? "xz" : nullptr;
}

} // namespace

void checkContentFits(const std::string& fileName)
{
  if (unpackedName(fileName) != fileName)
  {
    return; // the reader unpacks it, and knows what is in it
  }
  const std::string suffix = suffixOf(fileName);
  const std::string name = suffix.size() > 1 ? suffix.substr(1) : suffix;
  std::string head = beginningOf(fileName, 1024);
  if (startsWith(head, "\xEF\xBB\xBF"))
  {
    head.erase(0, 3); // a byte order mark
  }
  const Kind* const promised = kindWhere([&suffix](const Kind& kind)
    { return std::string_view(kind.suffixes).find(suffix) != std::string_view::npos; });
  if (const char* compressed = compressedKind(head);
      compressed && !(promised && promised->isAnnounced(head)))
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + " but compressed with " + compressed + "; unpack it first" +
        (std::string(compressed) == "gzip" && !vtkFormatOf(suffix)
            ? ", or give it the suffix " + suffix + ".gz"
            : ""));
  }
  const Kind* announced = kindWhere([&head](const Kind& kind) { return kind.isAnnounced(head); });
  if (isTable(fileName) && isOff(head))
  {
    announced = nullptr; // a column may have this name
  }
  if (announced && announced != promised)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + ": it begins like " + announced->name + "; give it the suffix " +
        announced->suffixes);
  }
  if (promised && announced != promised)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + ": it does not begin like " + promised->name +
        "; give the file a suffix that fits, or another file");
  }
  if (!promised && suffix != ".stl" && head.find('\0') != std::string::npos)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + ": it is not text; give the file a suffix that fits, or another file");
  }
}
