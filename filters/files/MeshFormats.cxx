// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/MeshFormats.h"

#include "files/ObjFile.h"
#include "files/OffFile.h"
#include "files/PlyFile.h"
#include "files/PointsFile.h"
#include "files/StlFile.h"

#include <algorithm>
#include <iterator>

namespace winding
{

namespace
{

/// Reads a format that has no numbers of points without a meaning.
template <MeshArrays (*read)(const InputFile&, Executor&)>
MeshArrays plain(const InputFile& file, const ColumnWishes&, Executor& executor)
{
  return read(file, executor);
}

/// All formats, in the order in which users are given their suffixes.
constexpr MeshFormat formats[] = {
  {".ply", readPlyColumns, 0, false},
  {".stl", plain<readStl>, 0, false},
  {".obj", readObjColumns, 0, false},
  {".off", plain<readOff>, 0, false},
  {".xyz", readPointColumns, 0, true},
  {".pwn", readPointColumns, 0, true},
  {".csv", nullptr, ',', true},
  {".tsv", nullptr, '\t', true},
};

/// Returns the suffix of a file's name in small letters.
std::string suffixOf(const std::string& name)
{
  const std::size_t folder = name.find_last_of("/\\"), dot = name.rfind('.');
  const bool isOfFolder = folder != std::string::npos && dot != std::string::npos && dot < folder;
  std::string suffix = dot == std::string::npos || isOfFolder ? "" : name.substr(dot);
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](char letter)
    {
      const bool isCapital = letter >= 'A' && letter <= 'Z';
      return static_cast<char>(isCapital ? letter - 'A' + 'a' : letter);
    });
  return suffix;
}

} // namespace

const MeshFormat& formatOf(const InputFile& file)
{
  const std::string suffix = suffixOf(file.unpackedName());
  const auto* format = std::find_if(std::begin(formats), std::end(formats),
    [&suffix](const MeshFormat& candidate) { return candidate.suffix == suffix; });
  if (format == std::end(formats))
  {
    file.refuse("has a suffix that is not known; give one of " + suffixesOfMeshes());
  }
  return *format;
}

const std::string& suffixesOfMeshes()
{
  static const std::string all = []
  {
    std::string suffixes;
    for (const MeshFormat& format : formats)
    {
      suffixes += (suffixes.empty() ? "" : " ") + std::string(format.suffix);
    }
    return suffixes;
  }();
  return all;
}

} // namespace winding
