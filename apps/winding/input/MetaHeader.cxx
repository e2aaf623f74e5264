// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/MetaHeader.h"

#include "files/Text.h"

#include <algorithm>

HeaderFields metaFields(const std::string& head, std::size_t& start)
{
  HeaderFields fields;
  while (fields.count("ElementDataFile") == 0)
  {
    const std::string_view line = takeHeaderLine(head, start);
    if (const std::size_t at = line.find_first_of("=:"); at != std::string_view::npos)
    {
      fields[std::string(trimmed(line.substr(0, at)))] = trimmed(line.substr(at + 1));
    }
  }
  return fields;
}

ImagePlace metaImage(const std::string& head)
{
  std::size_t start = 0;
  const HeaderFields fields = metaFields(head, start);
  const std::size_t axes = axesOf(fields, "NDims"), ofSpace = std::min<std::size_t>(axes, 3);
  const auto read = [&](const std::vector<const char*>& keys, std::size_t count)
  {
    const std::string* const text = findAny(fields, keys);
    return text ? numbersOf(*text, keys.front(), count) : std::vector<double>();
  };
  const std::vector<double> sizes = read({"DimSize"}, axes);
  // The directions of the axes follow each other.
  const std::vector<double> directions =
    read({"TransformMatrix", "Rotation", "Orientation"}, axes * axes);
  const std::vector<double> spacings = read({"ElementSpacing", "ElementSize"}, axes);
  const std::vector<double> origin = read({"Offset", "Position", "Origin"}, axes);
  if (sizes.empty())
  {
    throw HeaderFault("its header has no 'DimSize'");
  }
  ImagePlace place;
  place.space = ImageSpace::lps;
  place.unit = LengthUnit::millimetre; // as in ITK
  for (std::size_t axis = 0; axis < ofSpace; ++axis)
  {
    std::vector<double> step(axes);
    step[axis] = 1;
    if (!directions.empty())
    {
      const auto first = directions.begin() + static_cast<std::ptrdiff_t>(axis * axes);
      std::copy_n(first, axes, step.begin());
      checkStep(step);
    }
    place.dimensions[axis] = sizeOf(sizes[axis], "DimSize");
    place.origin[axis] = origin.empty() ? 0 : origin[axis];
    for (std::size_t row = 0; row < ofSpace; ++row)
    {
      place.steps[axis][row] = step[row] * (spacings.empty() ? 1 : spacings[axis]);
    }
  }
  return place;
}
