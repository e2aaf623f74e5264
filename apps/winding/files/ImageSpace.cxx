// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ImageSpace.h"

#include "files/Text.h"

#include <algorithm>
#include <iterator>

namespace
{

/// A space by its names, and whether its first two axes look the way of LPS.
struct Space
{
  ImageSpace space;
  const char* name;
  const char* letters;
  double x, y;
};

constexpr Space spaces[] = {{ImageSpace::lps, "left-posterior-superior", "lps", 1, 1},
  {ImageSpace::ras, "right-anterior-superior", "ras", -1, -1},
  {ImageSpace::las, "left-anterior-superior", "las", 1, -1}};

const Space* find(ImageSpace space)
{
  const Space* const found = std::find_if(std::begin(spaces), std::end(spaces),
    [space](const Space& candidate) { return candidate.space == space; });
  return found == std::end(spaces) ? nullptr : found;
}

/// Returns a name in small letters, without the signs between its words.
std::string plainName(const std::string& name)
{
  std::string plain = inSmallLetters(name);
  plain.erase(
    std::remove_if(plain.begin(), plain.end(), [](char c) { return c == '-' || c == ' '; }),
    plain.end());
  return plain;
}

} // namespace

std::string nameOf(ImageSpace space)
{
  const Space* const found = find(space);
  return found ? found->name : "";
}

std::optional<ImageSpace> spaceOf(const std::string& name)
{
  const std::string small = plainName(name);
  for (const Space& space : spaces)
  {
    const std::string plain = plainName(space.name), letters = space.letters;
    if (small == plain || small == plain + "time" || small == letters || small == letters + "t")
    {
      return space.space;
    }
  }
  for (const std::string plain : {"scannerxyz", "3drighthanded", "3dlefthanded"})
  {
    if (small == plain || small == plain + "time")
    {
      return ImageSpace::lps;
    }
  }
  return {};
}

std::array<double, 3> signsBetween(ImageSpace from, ImageSpace to)
{
  const Space* const a = find(from);
  const Space* const b = find(to);
  return a && b ? std::array<double, 3>{a->x * b->x, a->y * b->y, 1}
                : std::array<double, 3>{1, 1, 1};
}

double inMillimetres(LengthUnit unit)
{
  return unit == LengthUnit::metre ? 1e3 : unit == LengthUnit::micrometre ? 1e-3 : 1;
}

bool isMedical(const std::string& suffix)
{
  const char* const suffixes[] = {".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"};
  return std::find(std::begin(suffixes), std::end(suffixes), suffix) != std::end(suffixes);
}

bool isImage(const std::string& suffix)
{
  return suffix == ".vti" || isMedical(suffix);
}
