#include "options/OptionChecks.h"

#include "files/Suffix.h"
#include "options/Options.h"
#include "program/Failure.h"
#include "program/Print.h"

#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace
{

using Filter = vtkWindingNumberField;

/// The limit that the filters document for their property Regularization.
constexpr double mostRegularization = 4;

const std::vector<std::string> surfaceSuffixes = {".vtp", ".ply", ".stl", ".obj"};

void checkGrid(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.resolution >= 1,
    "--resolution is " + std::to_string(options.resolution) + "; give 1 or more voxels");
  requireUsage(
    !wasGiven("--voxel-size") || (options.voxelSize > 0 && std::isfinite(options.voxelSize)),
    "--voxel-size is " + shown(options.voxelSize) + "; give a length greater than 0");
  for (const int size : options.dimensions)
  {
    requireUsage(
      size >= 1, "--dims has " + std::to_string(size) + "; give 1 or more voxels per axis");
  }
  for (std::size_t axis = 0; axis < options.bounds.size() / 2; ++axis)
  {
    const double low = options.bounds[2 * axis], high = options.bounds[2 * axis + 1];
    requireUsage(low < high && std::isfinite(low) && std::isfinite(high),
      std::string("--bounds along ") + "xyz"[axis] + " are " + shown(low) + " to " + shown(high) +
        "; give the lower one first");
  }
  requireUsage(options.padding >= 0 && std::isfinite(options.padding),
    "--padding is " + shown(options.padding) + "; give 0 or more");
}

void checkPointAreas(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.area >= 0 && std::isfinite(options.area),
    "--area is " + shown(options.area) + "; give 0 (estimate it) or more");
  requireUsage(options.areas == Filter::CONSTANT || !wasGiven("--area"),
    "--area is for --areas constant; say that, too, or leave it out");
  requireUsage(options.neighbors >= 3 && options.neighbors <= 1000,
    "--neighbors is " + shown(options.neighbors) + "; give 3 to 1000");
}

void checkMethod(const Options& options, const WasGiven& wasGiven)
{
  checkPointAreas(options, wasGiven);
  requireUsage(options.tolerance >= 0 && std::isfinite(options.tolerance),
    "--tolerance is " + shown(options.tolerance) + "; give 0 or more");
  requireUsage(options.longestExpectedTime >= 0 && std::isfinite(options.longestExpectedTime),
    "--longest-expected-time is " + shown(options.longestExpectedTime) + "; give 0 or more");
  requireUsage(options.areas != Filter::MESH || options.asPoints,
    "--areas mesh is for meshes taken as points; say --points, too");
  requireUsage(options.regularization >= 0 && options.regularization <= mostRegularization,
    "--regularization is " + shown(options.regularization) + "; give 0 (none) to 4 spacings");
  requireUsage(std::isfinite(options.threshold),
    "--threshold is " + shown(options.threshold) + "; give a finite number");
  requireUsage(options.rule != Filter::ODD || !wasGiven("--threshold"),
    "--rule odd has no threshold; leave --threshold out");
  requireUsage(options.fidelity >= 0,
    "--fidelity is " + shown(options.fidelity) + "; give a number of points, 0 (none) or more");
  requireUsage(!options.triangles || options.features == vtkWindingNumberSurface::SHARP,
    "--triangles is for --features sharp; say that, too, or leave it out");
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
    throw Failure(
      USAGE, output, whatWrites + " writes" + names + "; give the output one of these suffixes");
  }
}

void checkFieldOptions(const Options& options, const WasGiven& wasGiven)
{
  checkGrid(options, wasGiven);
  requireUsage(options.verify >= 0,
    "--verify is " + std::to_string(options.verify) + "; give a number of samples");
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
  requireUsage(options.coverageSamples >= 1 && options.coverageSamples <= 10,
    "--coverage-samples is " + std::to_string(options.coverageSamples) + "; give 1 to 10");
  requireUsage(options.coverage == Filter::FRACTION || !wasGiven("--coverage-samples"),
    "--coverage-samples is for --coverage fraction; say that, too, or leave it out");
}

void checkDistanceBand(const Options& options, const WasGiven& wasGiven)
{
  requireUsage(options.distanceBand >= 0 && std::isfinite(options.distanceBand),
    "--distance-band is " + shown(options.distanceBand) +
      "; give 0 (all distances) or more voxels");
  requireUsage(options.distance || !wasGiven("--distance-band"),
    "--distance-band is for --distance; say that, too, or leave it out");
}

void checkHyperTree(const Options& options, const WasGiven& wasGiven)
{
  const bool isHyperTree = suffixOf(options.output) == ".htg";
  requireUsage(options.mergeTolerance >= 0 && std::isfinite(options.mergeTolerance),
    "--merge-tolerance is " + shown(options.mergeTolerance) + "; give 0 (none) or more");
  requireUsage(isHyperTree || !wasGiven("--merge-tolerance"),
    "--merge-tolerance is for outputs .htg; leave it out");
  requireUsage(!options.insideOnly || !wasGiven("--merge-tolerance"),
    "--merge-tolerance is for winding numbers, which --inside-only does not make; leave one out");
  requireUsage(!isHyperTree || !options.distance,
    "--distance needs an image, which .htg is not; give the output the suffix .vti or leave it "
    "out");
  requireUsage(!isHyperTree || !wasGiven("--pieces"),
    "--pieces is for images; a .htg is always made a few bricks of voxels at a time, so leave it "
    "out");
}

void checkLabels(const Options& options, const WasGiven& wasGiven)
{
  std::vector<std::string> suffixes = surfaceSuffixes;
  suffixes.insert(suffixes.begin(), {".vti", ".pvti"});
  checkOutput(options.output, options.command, suffixes);
  checkFieldOptions(options, wasGiven);
  checkCoverage(options, wasGiven);
  requireUsage(options.coverage == Filter::FRACTION || !wasGiven("--shares"),
    "--shares is for --coverage fraction; say that, too, or leave it out");
  requireUsage(options.inputs.size() == 1 || !wasGiven("--region-array"),
    "--region-array is for one input, and several are a solid each; leave it out");
  requireUsage(!wasGiven("--label-offset") || wasGiven("--region-array"),
    "--label-offset is for --region-array; say that, too, or leave it out");
  requireUsage(options.labelOffset >= -65535 && options.labelOffset <= 65535,
    "--label-offset is " + std::to_string(options.labelOffset) + "; give -65535 to 65535");
  const std::string suffix = suffixOf(options.output);
  requireUsage(suffix == ".vti" || suffix == ".pvti" || !wasGiven("--pieces"),
    "--pieces is for images; give the output the suffix .vti or .pvti, or leave it out");
}

} // namespace

void checkOptions(const Options& options, const WasGiven& wasGiven)
{
  if (options.command == "check")
  {
    checkCheck(options, wasGiven);
    return;
  }
  requireUsage(options.threads >= 0,
    "--threads is " + std::to_string(options.threads) + "; give 1 or more, or 0 for all");
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
    checkOutput(options.output, options.command, {".vtp", ".vtu", ".csv", ".tsv"});
  }
  else if (options.command == "labels")
  {
    checkLabels(options, wasGiven);
  }
  else if (options.command == "field")
  {
    checkOutput(options.output, options.command, {".vti", ".pvti", ".htg"});
    checkFieldOptions(options, wasGiven);
    checkCoverage(options, wasGiven);
    checkDistanceBand(options, wasGiven);
    checkHyperTree(options, wasGiven);
  }
  else
  {
    std::vector<std::string> suffixes = surfaceSuffixes;
    if (options.command == "voxels")
    {
      suffixes.emplace_back(".htg");
    }
    checkOutput(options.output, options.command, suffixes);
    checkFieldOptions(options, wasGiven);
    if (options.command == "voxels")
    {
      checkCoverage(options, wasGiven);
    }
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
