// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/OptionChecks.h"

#include "files/Formats.h"
#include "files/ImageSpace.h"
#include "options/Options.h"
#include "program/Failure.h"
#include "program/Print.h"

#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Filter = vtkWindingNumberField;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The range of the numbers of an option.
struct Range
{
  const char* option;
  double lowest, highest;
};

// The names of the list's kinds, as what they mean here: whether an option has numbers.
constexpr bool flag = false, choice = false, text = false;
constexpr bool integer = true, number = true, integers = true, numbers = true;

std::vector<Range> rangesOfList()
{
  std::vector<Range> ranges;
#define OPTION(                                                                                    \
  parameter, property, kind, standard, lowest, highest, unit, label, option, keyword, help)        \
  if (kind && *option)                                                                             \
  {                                                                                                \
    ranges.push_back({option, lowest, highest});                                                   \
  }
#define CHOICE(...)
#define OTHER(...)
#include "Options.def"
#undef OPTION
#undef CHOICE
#undef OTHER
  return ranges;
}

std::string inWords(const Range& range)
{
  return range.lowest == -infinity   ? "a finite number"
         : range.highest == infinity ? shown(range.lowest) + " or more"
                                     : shown(range.lowest) + " to " + shown(range.highest);
}

const std::vector<std::string> surfaceSuffixes = {".vtp", ".ply", ".stl", ".obj"};
const std::vector<std::string> medicalSuffixes = {".mha", ".nrrd", ".nii", ".nii.gz"};

/// The suffixes of two lists.
std::vector<std::string> both(
  std::vector<std::string> suffixes, const std::vector<std::string>& others)
{
  suffixes.insert(suffixes.end(), others.begin(), others.end());
  return suffixes;
}

/// Refuses what medical images have no place for.
void checkMedical(const Options& options)
{
  const std::string suffix = suffixOf(options.output);
  if (!isMedical(suffix))
  {
    return;
  }
  requireUsage(!options.cells,
    "--cells is for images with cells, which " + suffix + " has none of; leave it out");
  requireUsage(options.pieces == 1,
    "--pieces is for .vti and .pvti, and " + suffix + " is written as a whole; leave it out");
  const std::pair<const char*, bool> arrays[] = {{"--inside", options.inside},
    {"--distance", options.distance}, {"--nearest-cells", options.nearestCells},
    {"--transfer-attributes", options.transferAttributes}, {"--count", options.count},
    {"--shares", options.shares != 0}};
  for (const auto& [option, isGiven] : arrays)
  {
    requireUsage(!isGiven, std::string(option) + " adds an array, and " + suffix +
                             " holds one; give the output the suffix .vti or leave it out");
  }
}

void checkGrid(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(!wasGiven("--voxel-size") || options.voxelSize > 0,
    "--voxel-size is " + shown(options.voxelSize) + "; give a length greater than 0");
  for (const int size : options.dimensions)
  {
    requireUsage(
      size >= 1, "--dims has " + std::to_string(size) + "; give 1 or more voxels per axis");
  }
  for (std::size_t axis = 0; axis < options.bounds.size() / 2; ++axis)
  {
    const double low = options.bounds[2 * axis], high = options.bounds[2 * axis + 1];
    requireUsage(low < high, std::string("--bounds along ") + "xyz"[axis] + " are " + shown(low) +
                               " to " + shown(high) + "; give the lower one first");
  }
}

void checkPointAreas(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.areas == Filter::CONSTANT || !wasGiven("--area"),
    "--area is for --areas constant; say that, too, or leave it out");
}

void checkMethod(const Options& options, const WasGiven& wasGiven)
{
  checkPointAreas(options, wasGiven);
  requireUsage(options.estimateNormals || !wasGiven("--toward"),
    "--toward is for --estimate-normals; say that, too, or leave it out");
  requireUsage(options.areas != Filter::MESH || options.asPoints,
    "--areas mesh is for meshes taken as points; say --points, too");
  requireUsage(options.rule != Filter::ODD || !wasGiven("--threshold"),
    "--rule odd has no threshold; leave --threshold out");
  requireUsage(!options.triangles || options.features != vtkWindingNumberSurface::SMOOTH,
    "--triangles is for --features sharp or voxels; say that, too, or leave it out");
  requireUsage(options.command != "surface" || options.shell > 0 || !wasGiven("--shell-side"),
    "--shell-side is for --shell; say that, too, or leave it out");
}

void checkOutput(const std::string& output, const std::string& whatWrites,
  const std::vector<std::string>& suffixes)
{
  if (std::find(suffixes.begin(), suffixes.end(), suffixOf(output)) == suffixes.end())
  {
    std::string names;
    for (const std::string& suffix : suffixes)
    {
      names += " " + suffix;
    }
    throw Failure(EXIT_USAGE, output,
      whatWrites + " writes" + names + "; give the output one of these suffixes");
  }
}

void checkFieldOptions(const Options& options, const WasGiven& wasGiven)
{
  checkGrid(options, wasGiven);
  requireUsage(options.verify == 0 || options.method != Filter::PARITY,
    "--verify compares winding numbers, which --method parity does not give; leave one out");
  requireUsage(options.verify == 0 || !options.insideOnly,
    "--verify compares winding numbers, which --inside-only does not make; leave one out");
  requireUsage(!options.insideOnly || options.command != "field" || !wasGiven("--array"),
    "--array names the winding numbers, which --inside-only does not make; leave one out");
  requireUsage(
    options.pieces >= 1, "--pieces is " + std::to_string(options.pieces) + "; give 1 or more");
}

void checkCheck(const Options& options, const WasGiven& wasGiven)
{
  for (const char* const option : {"--mirror", "--flat-base"})
  {
    requireUsage(!options.fixOrientation || !wasGiven(option),
      std::string(option) +
        " adds faces, and --fix-orientation turns faces of the file; leave one out");
  }
  if (wasGiven("--output"))
  {
    checkOutput(options.output, options.command, surfaceSuffixes);
  }
  if (wasGiven("--blocks"))
  {
    checkOutput(options.faults, "--blocks", {".vtm"});
  }
}

void checkNormals(const Options& options, const WasGiven& wasGiven)
{
  checkPointAreas(options, wasGiven);
  checkOutput(
    options.output, options.command, {".vtp", ".vtu", ".ply", ".xyz", ".pwn", ".csv", ".tsv"});
  const std::string suffix = suffixOf(options.output);
  requireUsage(!wasGiven("--areas") || (suffix != ".ply" && suffix != ".xyz" && suffix != ".pwn"),
    "--areas is for outputs that hold areas, .vtp .vtu .csv .tsv, which " + suffix +
      " does not; leave it out");
  requireUsage(options.areas != Filter::MESH || !options.replace,
    "--areas mesh needs the mesh, which --replace takes for points alone; leave one out");
}

void checkCoverage(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.coverage == Filter::FRACTION || !wasGiven("--coverage-samples"),
    "--coverage-samples is for --coverage fraction; say that, too, or leave it out");
}

void checkDistanceBand(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.distance || !wasGiven("--distance-band"),
    "--distance-band is for --distance; say that, too, or leave it out");
}

void checkLabels(const Options& options, const WasGiven& wasGiven)
{
  checkOutput(options.output, options.command,
    both(both({".vti", ".pvti"}, medicalSuffixes), surfaceSuffixes));
  checkMedical(options);
  checkFieldOptions(options, wasGiven);
  checkCoverage(options, wasGiven);
  requireUsage(options.coverage == Filter::FRACTION || !wasGiven("--shares"),
    "--shares is for --coverage fraction; say that, too, or leave it out");
  requireUsage(options.inputs.size() == 1 || !wasGiven("--region-array"),
    "--region-array is for one input, and several are a solid each; leave it out");
  requireUsage(!wasGiven("--label-offset") || wasGiven("--region-array"),
    "--label-offset is for --region-array; say that, too, or leave it out");
  const std::string suffix = suffixOf(options.output);
  requireUsage(suffix == ".vti" || suffix == ".pvti" || !wasGiven("--pieces"),
    "--pieces is for images; give the output the suffix .vti or .pvti, or leave it out");
}

/// Refuses what an image of the samples has no place for.
void checkImageOfSolid(const Options& options, const WasGiven& wasGiven)
{
  if (!isImage(suffixOf(options.output)))
  {
    return;
  }
  for (const char* const option : {"--features", "--triangles", "--close-border", "--double",
         "--fidelity", "--distance", "--nearest-cells", "--transfer-attributes"})
  {
    requireUsage(!wasGiven(option), std::string(option) + " is for surfaces, and " +
                                      suffixOf(options.output) +
                                      " holds an image; give the output the suffix .vtp or leave "
                                      "it out");
  }
}

void checkBoolean(const Options& options, const WasGiven& wasGiven)
{
  const std::size_t inputs = options.inputs.size();
  requireUsage(inputs > 1, "there is one input; give another, too");
  for (const auto& [option, count] :
    {std::pair("--thresholds", options.thresholds.size()), {"--rules", options.rules.size()}})
  {
    requireUsage(count == 0 || count == inputs,
      std::string(option) + " has " + std::to_string(count) + " for " + std::to_string(inputs) +
        " inputs; give as many, or leave it out");
  }
  for (const double threshold : options.thresholds)
  {
    requireUsage(
      std::isfinite(threshold), "--thresholds has " + shown(threshold) + "; give finite numbers");
  }
  const auto isOdd = [](int rule)
  {
    return rule == Filter::ODD;
  };
  const bool areOdd =
    !options.rules.empty() && std::all_of(options.rules.begin(), options.rules.end(), isOdd);
  for (const char* const option : {"--threshold", "--thresholds"})
  {
    requireUsage(!(areOdd || options.rule == Filter::ODD) || !wasGiven(option),
      std::string(areOdd ? "--rules" : "--rule") + " odd has no threshold; leave " + option +
        " out");
  }
}

/// Throws Failure for columns where no file that is read has some.
void checkColumns(const Options& options)
{
  const bool isOfSource = std::any_of(options.inputs.begin(), options.inputs.end(), hasColumns);
  const bool isOfQueries = hasColumns(options.queries);
  requireUsage(options.columns.empty() || isOfSource || isOfQueries,
    "--columns is for .csv .tsv .xyz .pwn; leave it out");
  requireUsage(options.queryColumns.empty() || isOfQueries,
    "--query-columns is for queries of .csv .tsv .xyz .pwn; leave it out");
}

} // namespace

void checkRanges(const CLI::App& command)
{
  for (const Range& range : rangesOfList())
  {
    const CLI::Option* option = command.get_option_no_throw(range.option);
    for (const std::string& word : option ? option->results() : std::vector<std::string>())
    {
      double value = 0;
      CLI::detail::lexical_cast(word, value); // as the option itself is read
      requireUsage(value >= range.lowest && value <= range.highest && std::isfinite(value),
        std::string(range.option) + " is " + shown(value) + "; give " + inWords(range));
    }
  }
}

void checkOptions(const Options& options, const WasGiven& wasGiven)
{
  checkColumns(options);
  if (options.command == "check")
  {
    checkCheck(options, wasGiven);
    return;
  }
  if (options.command == "bench")
  {
    for (const int resolution : options.resolutions)
    {
      requireUsage(resolution >= 1,
        "--resolution is " + std::to_string(resolution) + "; give 1 or more voxels");
    }
    return;
  }
  if (options.command == "normals")
  {
    checkNormals(options, wasGiven);
    return;
  }
  checkMethod(options, wasGiven);
  if (options.command == "probe")
  {
    checkOutput(
      options.output, options.command, {".vtp", ".vtu", ".csv", ".tsv", ".vti", ".vtr", ".vts"});
    requireUsage(!options.fraction || !isTable(options.output),
      "--fraction is for cells, and " + suffixOf(options.output) +
        " has none; give the output the suffix .vtu or leave it out");
    requireUsage(!options.fraction || !hasColumns(options.queries),
      "--fraction is for cells, and the points of " + suffixOf(options.queries) +
        " have none; give a mesh or leave it out");
  }
  else if (options.command == "labels")
  {
    checkLabels(options, wasGiven);
  }
  else if (options.command == "field")
  {
    checkOutput(options.output, options.command, both({".vti", ".pvti"}, medicalSuffixes));
    checkMedical(options);
    checkFieldOptions(options, wasGiven);
    checkCoverage(options, wasGiven);
    checkDistanceBand(options, wasGiven);
  }
  else
  {
    std::vector<std::string> suffixes = surfaceSuffixes;
    if (options.command == "voxels")
    {
      suffixes = both(suffixes, medicalSuffixes);
    }
    else
    {
      suffixes = both(both(suffixes, {".vti"}), medicalSuffixes);
      checkImageOfSolid(options, wasGiven);
    }
    checkOutput(options.output, options.command, suffixes);
    checkMedical(options);
    checkFieldOptions(options, wasGiven);
    if (options.command == "boolean")
    {
      checkBoolean(options, wasGiven);
    }
    if (options.command == "voxels")
    {
      checkCoverage(options, wasGiven);
    }
    requireUsage(!options.distance || suffixOf(options.output) == ".vtp",
      "--distance is for outputs .vtp; give the output that suffix or leave it out");
  }
  requireUsage(!options.array.empty(), "--array is empty; give the array a name");
  // VTK writes the name into XML without escaping it, and could not read the file again.
  const auto canBeWritten = [](char c)
  {
    return c >= ' ' && c <= '~' && !std::strchr("<>&\"'", c);
  };
  requireUsage(std::all_of(options.array.begin(), options.array.end(), canBeWritten),
    "--array has characters that a file cannot hold; use letters, digits and blanks");
}
