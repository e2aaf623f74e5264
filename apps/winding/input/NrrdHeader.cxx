// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/NrrdHeader.h"

#include "files/Text.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace
{

/// Returns the name of a field of NRRD in small letters and without blanks. Teem ignores case, and
/// has names of several words in both ways.
std::string nrrdName(std::string_view name)
{
  std::string plain = inSmallLetters(name);
  plain.erase(std::remove(plain.begin(), plain.end(), ' '), plain.end());
  return plain;
}

/// The fields that the format has, by nrrdName(). The ones in the second row say where voxels are.
constexpr std::string_view nrrdNames[] = {"content", "number", "type", "blocksize", "thicknesses",
  "labels", "units", "min", "max", "oldmin", "oldmax", "endian", "encoding", "lineskip", "byteskip",
  "sampleunits", "datafile", "spaceunits", "measurementframe", //
  "dimension", "sizes", "spacings", "axismins", "axismaxs", "centers", "centerings", "kinds",
  "space", "spacedimension", "spacedirections", "spaceorigin"};

/// Adds the field in a line. A line that is none is refused, as Teem does, for it may be a place
/// with a typing error.
void addNrrdField(std::string_view line, HeaderFields& fields)
{
  const std::size_t at = std::min(line.find(':'), line.size());
  if (line.front() == '#' || line.substr(at, 2) == ":=")
  {
    return; // a comment, or the key of a user
  }
  const std::string name(trimmed(line.substr(0, at))), plain = nrrdName(name);
  if (at == line.size() ||
      std::find(std::begin(nrrdNames), std::end(nrrdNames), plain) == std::end(nrrdNames))
  {
    throw HeaderFault(
      "its header has '" + name.substr(0, 30) + "', which is no field of the format");
  }
  if (!fields.emplace(plain, trimmed(line.substr(at + 1))).second)
  {
    throw HeaderFault("its header has '" + name + "' twice");
  }
}

/// Returns how many numbers the vectors of a NRRD have; 0 where it does not say.
std::size_t lengthOfVectors(const HeaderFields& fields)
{
  if (const auto* text = findAny(fields, {"spacedimension"}))
  {
    return static_cast<std::size_t>(sizeOf(numberOf(*text, "space dimension"), "space dimension"));
  }
  const auto* const space = findAny(fields, {"space"});
  const std::string name = space ? inSmallLetters(*space) : "";
  const bool hasTime =
    name.size() >= 4 && (name.size() == 4 || name.substr(name.size() - 4) == "time");
  return !space ? 0 : hasTime ? 4 : 3;
}

/// Reads a vector as "(1,0,0)", of `length` numbers, or two to four if that is 0; nothing where
/// there is "none".
std::optional<std::vector<double>> vectorOf(
  std::string_view& text, const std::string& key, std::size_t length)
{
  text = trimmed(text);
  if (text.substr(0, 4) == "none")
  {
    text.remove_prefix(4);
    return {};
  }
  const std::size_t end = text.find(')');
  if (text.empty() || text.front() != '(' || end == std::string_view::npos)
  {
    throw HeaderFault("its header has no vectors in '" + key + "'");
  }
  std::string words(text.substr(1, end - 1));
  const auto count = static_cast<std::size_t>(1 + std::count(words.begin(), words.end(), ','));
  std::replace(words.begin(), words.end(), ',', ' ');
  std::vector<double> numbers = numbersOf(words, key, length > 0 ? length : count);
  if (count < 2 || count > 4)
  {
    throw HeaderFault(
      "its header has vectors of " + std::to_string(count) + " numbers in '" + key + "'");
  }
  text.remove_prefix(end + 1);
  return numbers;
}

/// Reads a number for each of `axes` axes; nothing where there is NaN or no field.
std::vector<std::optional<double>> numbersOfAxes(
  const HeaderFields& fields, const std::string& key, std::size_t axes)
{
  std::vector<std::optional<double>> numbers;
  const std::string* const text = findAny(fields, {nrrdName(key).c_str()});
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const bool isKnown = inSmallLetters(word) != "nan";
    numbers.push_back(isKnown ? std::optional(numberOf(word, key)) : std::nullopt);
  }
  checkCount(numbers.size(), key, text ? axes : 0);
  numbers.resize(axes);
  return numbers;
}

/// Reads for each of `axes` axes whether its ends are samples. They are the ends of cells
/// otherwise, half a step farther out, and where nothing is said, as in ITK.
std::vector<bool> endsAreSamples(const HeaderFields& fields, std::size_t axes)
{
  std::vector<bool> areSamples;
  const std::string* const text = findAny(fields, {"centers", "centerings"});
  std::string_view rest = text ? std::string_view(*text) : std::string_view();
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const std::string center = inSmallLetters(word);
    if (center != "node" && center != "cell" && center != "???" && center != "none")
    {
      throw HeaderFault("its header has '" + std::string(word.substr(0, 20)) + "' in 'centers'");
    }
    areSamples.push_back(center == "node");
  }
  checkCount(areSamples.size(), "centers", text ? axes : 0);
  areSamples.resize(axes);
  return areSamples;
}

/// Reads for each of `axes` axes whether it is one of space by its kind. Others are of channels or
/// times.
std::vector<bool> axesOfSpace(const HeaderFields& fields, std::size_t axes)
{
  std::vector<bool> areOfSpace;
  const std::string* const text = findAny(fields, {"kinds"});
  if (!text)
  {
    return std::vector<bool>(axes, true);
  }
  std::string_view rest = *text;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
  {
    const std::string kind = inSmallLetters(word);
    areOfSpace.push_back(kind == "domain" || kind == "space" || kind == "???" || kind == "none");
  }
  checkCount(areOfSpace.size(), "kinds", axes);
  return areOfSpace;
}

/// Returns the units of three axes of space, in quotation marks as in the header; nothing where
/// they are not said.
std::string unitsOfSpace(const HeaderFields& fields)
{
  const std::string* const text = findAny(fields, {"spaceunits"});
  std::string units;
  std::size_t end = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t start = text ? text->find('"', end) : std::string::npos;
    end = start == std::string::npos ? start : text->find('"', start + 1);
    if (end == std::string::npos)
    {
      return "";
    }
    units += (axis > 0 ? " " : "") + text->substr(start, ++end - start);
  }
  return units;
}

/// Adds an axis of space with its number of voxels.
void addAxis(const std::array<double, 3>& step, double size, std::size_t& axis, ImagePlace& place)
{
  if (axis == 3)
  {
    throw HeaderFault("its header has more than 3 axes of space");
  }
  place.steps[axis] = step;
  place.dimensions[axis++] = sizeOf(size, "sizes");
}

/// The numbers that say where axes lie without directions, for each of all axes.
struct Ends
{
  std::vector<std::optional<double>> spacings, mins, maxs;
  std::vector<bool> areSamples;
};

/// Reads the directions of the axes of space. Others have none, or go along time alone. Returns the
/// number of axes.
std::size_t addDirections(
  const HeaderFields& fields, const std::vector<double>& sizes, const Ends& ends, ImagePlace& place)
{
  std::size_t axis = 0;
  std::string_view rest = fields.at("spacedirections");
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    const auto vector = vectorOf(rest, "space directions", lengthOfVectors(fields));
    if (!vector)
    {
      continue;
    }
    if (ends.spacings[n] || ends.mins[n] || ends.maxs[n])
    {
      throw HeaderFault(
        "its header has 'space directions' and 'spacings', 'axis mins' or 'axis maxs'");
    }
    std::array<double, 3> step = {};
    std::copy_n(vector->begin(), std::min<std::size_t>(vector->size(), 3), step.begin());
    if (vector->size() == 4 && vector->back() != 0 && step == std::array<double, 3>())
    {
      continue;
    }
    checkStep(*vector);
    addAxis(step, sizes[n], axis, place);
  }
  if (!trimmed(rest).empty())
  {
    throw HeaderFault("its header has more vectors in 'space directions' than axes");
  }
  return axis;
}

/// Lays axes without directions along the ones of space, as ITK does: steps are 1 where there are
/// no spacings, whatever the ends of the axes say. Of more than three axes, `kinds` has to say
/// which are of space; the first three of these count, as in NIfTI. Returns the number of axes.
std::size_t addStraightAxes(
  const HeaderFields& fields, const std::vector<double>& sizes, const Ends& ends, ImagePlace& place)
{
  std::size_t axis = 0;
  const bool haveKinds = findAny(fields, {"kinds"});
  const std::vector<bool> areOfSpace = axesOfSpace(fields, sizes.size());
  const bool haveMins = std::any_of(ends.mins.begin(), ends.mins.end(),
    [](const std::optional<double>& min) { return min.has_value(); });
  for (std::size_t n = 0; n < sizes.size(); ++n)
  {
    if (!areOfSpace[n] || (haveKinds && axis == 3))
    {
      continue;
    }
    const auto& spacing = ends.spacings[n];
    const auto& min = ends.mins[n];
    const auto& max = ends.maxs[n];
    std::array<double, 3> step = {};
    step[std::min<std::size_t>(axis, 2)] = spacing.value_or(1);
    addAxis(step, sizes[n], axis, place);
    if (min ? !spacing && !max : haveMins || max)
    {
      throw HeaderFault(min ? "its header has 'axis mins' and no 'spacings'"
                            : "its header has an axis without a number in 'axis mins'");
    }
    if (min)
    {
      const double width = spacing ? *spacing : (*max - *min) / sizes[n];
      place.origin[axis - 1] = *min + (ends.areSamples[n] ? 0 : width / 2);
    }
  }
  return axis;
}

/// Reads the axes of space, and where they begin.
void addAxes(const HeaderFields& fields, const std::vector<double>& sizes, ImagePlace& place)
{
  const Ends ends = {numbersOfAxes(fields, "spacings", sizes.size()),
    numbersOfAxes(fields, "axis mins", sizes.size()),
    numbersOfAxes(fields, "axis maxs", sizes.size()), endsAreSamples(fields, sizes.size())};
  const std::string* const origin = findAny(fields, {"spaceorigin"});
  const std::size_t axes = findAny(fields, {"spacedirections"})
                             ? addDirections(fields, sizes, ends, place)
                             : addStraightAxes(fields, sizes, ends, place);
  if (axes < 2)
  {
    throw HeaderFault("its header has fewer than 2 axes of space");
  }
  if (origin)
  {
    if (findAny(fields, {"axismins"}))
    {
      throw HeaderFault("its header has 'space origin' and 'axis mins'");
    }
    std::string_view rest = *origin;
    if (const auto vector = vectorOf(rest, "space origin", lengthOfVectors(fields)))
    {
      std::copy_n(vector->begin(), std::min<std::size_t>(vector->size(), 3), place.origin.begin());
    }
  }
}

} // namespace

HeaderFields nrrdFields(const std::string& head, std::size_t& start)
{
  HeaderFields fields;
  takeHeaderLine(head, start); // the format's name
  const auto hasEnded = [&]
  {
    const std::string* const data = findAny(fields, {"datafile"});
    return data && (start >= head.size() || data->rfind("LIST", 0) == 0);
  };
  while (!hasEnded())
  {
    const std::string_view line = takeHeaderLine(head, start);
    if (line.empty())
    {
      break;
    }
    addNrrdField(line, fields);
  }
  return fields;
}

ImagePlace nrrdImage(const std::string& head)
{
  if (head.rfind("NRRD000", 0) != 0)
  {
    throw HeaderFault("it does not begin like NRRD");
  }
  std::size_t start = 0;
  const HeaderFields fields = nrrdFields(head, start);
  const std::string* const sizes = findAny(fields, {"sizes"});
  if (!sizes)
  {
    throw HeaderFault("its header has no 'sizes'");
  }
  ImagePlace place;
  place.space = ImageSpace::lps; // as in ITK where none is named
  place.unit = LengthUnit::millimetre;
  if (const auto* name = findAny(fields, {"space"}))
  {
    const std::optional<ImageSpace> space = spaceOf(*name);
    if (!space)
    {
      throw HeaderFault(
        "its header has a space '" + name->substr(0, 40) + "', which the format does not have");
    }
    place.space = *space;
  }
  place.spaceUnits = unitsOfSpace(fields);
  addAxes(fields, numbersOf(*sizes, "sizes", axesOf(fields, "dimension")), place);
  return place;
}
