#include "Failure.h"
#include "Options.h"
#include "Report.h"

#include "farfield/FarFieldAccuracy.h"
#include "field/Field.h"

#include "vtkWindingNumberField.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{

using Filter = vtkWindingNumberField;

using WasGiven = std::function<bool(const char* option)>;

const std::vector<std::string> surfaceSuffixes = {".vtp", ".ply", ".stl", ".obj"};

void require(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw Failure(USAGE, message);
  }
}

void checkGrid(const Options& options, const WasGiven& wasGiven)
{
  require(options.resolution >= 1,
    "--resolution is " + std::to_string(options.resolution) + "; give 1 or more voxels");
  require(!wasGiven("--voxel-size") || (options.voxelSize > 0 && std::isfinite(options.voxelSize)),
    "--voxel-size is " + shown(options.voxelSize) + "; give a length greater than 0");
  for (const int size : options.dimensions)
  {
    require(size >= 1, "--dims has " + std::to_string(size) + "; give 1 or more voxels per axis");
  }
  for (std::size_t axis = 0; axis < options.bounds.size() / 2; ++axis)
  {
    const double low = options.bounds[2 * axis], high = options.bounds[2 * axis + 1];
    require(low < high && std::isfinite(low) && std::isfinite(high),
      std::string("--bounds along ") + "xyz"[axis] + " are " + shown(low) + " to " + shown(high) +
        "; give the lower one first");
  }
  require(options.padding >= 0 && std::isfinite(options.padding),
    "--padding is " + shown(options.padding) + "; give 0 or more");
}

void checkMethod(const Options& options, const WasGiven& wasGiven)
{
  require(
    options.tolerance >= 0, "--tolerance is " + shown(options.tolerance) + "; give 0 or more");
  require(options.area >= 0 && std::isfinite(options.area),
    "--area is " + shown(options.area) + "; give 0 (estimate it) or more");
  require(options.areas == Filter::CONSTANT || !wasGiven("--area"),
    "--area is for --areas constant; say that, too, or leave it out");
  require(options.areas != Filter::MESH || options.asPoints,
    "--areas mesh is for meshes taken as points; say --points, too");
  require(options.regularization >= 0 && options.regularization <= winding::mostRegularization,
    "--regularization is " + shown(options.regularization) + "; give 0 (none) to 4 spacings");
  require(options.neighbors >= 3 && options.neighbors <= 1000,
    "--neighbors is " + shown(options.neighbors) + "; give 3 to 1000");
  require(std::isfinite(options.threshold),
    "--threshold is " + shown(options.threshold) + "; give a finite number");
  require(options.rule != Filter::ODD || !wasGiven("--threshold"),
    "--rule odd has no threshold; leave --threshold out");
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

void checkFieldLike(const Options& options, const WasGiven& wasGiven)
{
  checkGrid(options, wasGiven);
  require(options.verify >= 0,
    "--verify is " + std::to_string(options.verify) + "; give a number of samples");
  require(options.verify == 0 || options.method != Filter::PARITY,
    "--verify compares winding numbers, which --method parity does not give; leave one out");
  require(options.verify == 0 || !options.insideOnly,
    "--verify compares winding numbers, which --inside-only does not make; leave one out");
  require(!options.insideOnly || options.command != "field" || !wasGiven("--array"),
    "--array names the winding numbers, which --inside-only does not make; leave one out");
  require(
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

void checkCoverage(const Options& options, const WasGiven& wasGiven)
{
  require(options.coverageSamples >= 1 && options.coverageSamples <= 10,
    "--coverage-samples is " + std::to_string(options.coverageSamples) + "; give 1 to 10");
  require(options.coverage == Filter::FRACTION || !wasGiven("--coverage-samples"),
    "--coverage-samples is for --coverage fraction; say that, too, or leave it out");
}

void checkDistanceBand(const Options& options, const WasGiven& wasGiven)
{
  require(options.distanceBand >= 0 && std::isfinite(options.distanceBand),
    "--distance-band is " + shown(options.distanceBand) +
      "; give 0 (all distances) or more voxels");
  require(options.distance || !wasGiven("--distance-band"),
    "--distance-band is for --distance; say that, too, or leave it out");
}

void checkBench(const Options& options, const WasGiven& wasGiven)
{
  const std::pair<const char*, const char*> optionsOf[] = {{"--points", "vtk"},
    {"--tolerance", "hierarchical"}, {"--sources", "hierarchical"}, {"--data", "seed"}};
  for (const auto& [option, subject] : optionsOf)
  {
    require(options.subjects.front() == subject || !wasGiven(option),
      std::string(option) + " is for bench " + subject + "; leave it out");
  }
  for (const int resolution : options.resolutions)
  {
    require(
      resolution >= 1, "--resolution is " + std::to_string(resolution) + "; give 1 or more voxels");
  }
  for (const double tolerance : options.tolerances)
  {
    require(tolerance >= winding::FarFieldAccuracy::finest,
      "--tolerance is " + shown(tolerance) +
        "; give 1e-6 or more: below that there is no hierarchical method");
  }
  for (const int sources : options.sources)
  {
    require(sources >= 100,
      "--sources is " + std::to_string(sources) + "; give 100 or more, the spheres are round");
  }
  for (const int points : options.points)
  {
    require(points >= 1, "--points is " + std::to_string(points) + "; give 1 or more");
  }
  const auto& subjects = options.subjects;
  for (const char* name : {"hierarchical", "clouds", "vtk"})
  {
    require(std::count(subjects.begin() + 1, subjects.end(), name) == 0,
      std::string("bench ") + name + " comes before its files; for a file of that name give ./" +
        name);
  }
  require(subjects.front() != "clouds" || subjects.size() > 1,
    "bench clouds needs files: meshes, whose vertices are taken as clouds");
  require(subjects.front() != "vtk" || subjects.size() > 1,
    "bench vtk needs files: surfaces, which VTK's filters are compared at");
  for (const char* name : {"seed", "kernels"})
  {
    require(subjects.size() == 1 || std::count(subjects.begin(), subjects.end(), name) == 0,
      std::string("bench ") + name + " stands alone; for a file of that name give ./" + name);
  }
}

} // namespace

void checkOptions(const Options& options, const WasGiven& wasGiven)
{
  if (options.command == "check")
  {
    checkCheck(options, wasGiven);
    return;
  }
  require(options.threads >= 0,
    "--threads is " + std::to_string(options.threads) + "; give 1 or more, or 0 for all");
  if (options.command == "bench")
  {
    checkBench(options, wasGiven);
    return;
  }
  checkMethod(options, wasGiven);
  if (options.command == "probe")
  {
    checkOutput(options.output, options.command, {".vtp", ".vtu", ".csv", ".tsv"});
  }
  else if (options.command == "field")
  {
    checkOutput(options.output, options.command, {".vti"});
    checkFieldLike(options, wasGiven);
    checkCoverage(options, wasGiven);
    checkDistanceBand(options, wasGiven);
  }
  else
  {
    checkOutput(options.output, options.command, surfaceSuffixes);
    checkFieldLike(options, wasGiven);
    if (options.command == "voxels")
    {
      checkCoverage(options, wasGiven);
    }
  }
  require(!options.array.empty(), "--array is empty; give the array a name");
  // VTK writes names into XML as they are, and could not read the file again.
  require(std::all_of(options.array.begin(), options.array.end(),
            [](char c) { return c >= ' ' && c <= '~' && !std::strchr("<>&\"'", c); }),
    "--array has characters that a file cannot hold; use letters, digits and blanks");
}
