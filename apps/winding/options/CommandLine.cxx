// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/CommandLine.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "options/OptionChecks.h"
#include "options/OptionGroups.h"
#include "program/Failure.h"
#include "program/ParallelRun.h"
#include "program/Print.h"

#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"

#include <algorithm>
#include <climits>
#include <cmath>

namespace
{

constexpr const char* surfaceFormats = ".vtp .ply .stl .obj";
constexpr const char* medicalFormats = ".mha .nrrd .nii .nii.gz";
constexpr const char* solidFormats =
  ".vtp .ply .stl .obj; or what is inside as an image: .vti .mha .nrrd .nii .nii.gz";

CLI::App* addCommand(
  CLI::App& app, Options& options, const std::string& name, const std::string& description)
{
  CLI::App* command = app.add_subcommand(name, description);
  addInputs(command, options);
  return command;
}

void addField(CLI::App& app, Options& options)
{
  CLI::App* field = addCommand(app, options, "field", "Winding field on a grid of voxels");
  addOutput(field, options,
    std::string(".vti, .pvti, or a medical image with one array: ") + medicalFormats);
  addThreshold(field, options);
  addCoverage(field, options);
  field->add_flag("--inside", options.inside, "Add the array Inside")->group("Output");
  CLI::Option* insideOnly = field->add_flag("--inside-only", options.insideOnly,
    "The array Inside and no winding numbers, which take four times the memory");
  addDistance(field, options);
  addNearestCells(field, options);
  CLI::Option* band = field->add_option("--distance-band", options.distanceBand,
    "Distances up to this number of voxels, which takes less time; farther voxels get that "
    "distance (0: all)");
  addArrayName(field, options);
  CLI::Option* asDouble =
    field->add_flag("--double", options.asDouble, "Numbers in double precision, not float");
  for (CLI::Option* option : {insideOnly, band, asDouble})
  {
    option->group("Output");
  }
  band->type_name("N");
  insideOnly->excludes(asDouble);
  addFieldOptions(field, options);
  field
    ->add_option("--pieces", options.pieces,
      "Make and write the field in this many pieces, to save memory; each rank that many (1)")
    ->group("Run");
  addThreads(field, options);
  addLongestTime(field, options);
  addReporting(field, options);
}

void addSurface(CLI::App& app, Options& options)
{
  CLI::App* surface =
    addCommand(app, options, "surface", "Smooth surface where the winding field is the threshold");
  addOutput(surface, options, solidFormats);
  addThreshold(surface, options);
  addFeatures(surface, options);
  addShape(surface, options);
  addComparison(surface, options);
  addNearest(surface, options);
  addFieldOptions(surface, options);
  addMending(surface, options);
  addThreads(surface, options);
  addLongestTime(surface, options);
  addReporting(surface, options);
}

void addBoolean(CLI::App& app, Options& options)
{
  CLI::App* boolean =
    addCommand(app, options, "boolean", "Union, intersection or difference of solids");
  addOutput(boolean, options, solidFormats);
  boolean
    ->add_option("--operation", options.operation,
      "What to keep: union | intersection | difference, the first without the others | xor, what "
      "an odd number of them have (union)")
    ->transform(oneOf({{"union", vtkWindingNumberBoolean::UNION},
      {"intersection", vtkWindingNumberBoolean::INTERSECTION},
      {"difference", vtkWindingNumberBoolean::DIFFERENCE},
      {"xor", vtkWindingNumberBoolean::SYMMETRIC_DIFFERENCE}}))
    ->type_name("NAME");
  addThreshold(boolean, options);
  boolean
    ->add_option("--thresholds", options.thresholds,
      "The threshold of each input, separated by commas, in place of one for all")
    ->delimiter(',')
    ->type_name("T,...")
    ->excludes("--threshold");
  boolean
    ->add_option("--rules", options.rules,
      "The rule of each input, separated by commas, in place of one for all")
    ->delimiter(',')
    ->transform(rules())
    ->type_name("NAME,...")
    ->excludes("--rule");
  for (const char* option : {"--operation", "--thresholds", "--rules"})
  {
    boolean->get_option(option)->group("Output");
  }
  addFeatures(boolean, options);
  addNearest(boolean, options);
  addFieldOptions(boolean, options);
  addMending(boolean, options);
  addThreads(boolean, options);
  addLongestTime(boolean, options);
  addReporting(boolean, options);
}

void addVoxels(CLI::App& app, Options& options)
{
  CLI::App* voxels = addCommand(app, options, "voxels", "Surface of the voxels that are inside");
  addOutput(voxels, options,
    std::string(surfaceFormats) + "; or the voxels themselves as a mask: " + medicalFormats);
  addThreshold(voxels, options);
  addCoverage(voxels, options);
  voxels
    ->add_flag("--double", options.asDouble,
      "Compare winding numbers in double precision with the threshold, not in float")
    ->group("Output");
  addNearest(voxels, options);
  addFieldOptions(voxels, options);
  addMending(voxels, options);
  addThreads(voxels, options);
  addLongestTime(voxels, options);
  addReporting(voxels, options);
}

void addLabels(CLI::App& app, Options& options)
{
  CLI::App* labels =
    addCommand(app, options, "labels", "Which of several solids each voxel lies in, as labels");
  addOutput(labels, options,
    std::string(".vti .pvti ") + medicalFormats +
      ", the labels; or the surface between voxels of different ones: " + surfaceFormats);
  labels
    ->add_option("--overlap", options.overlap,
      "A voxel in several solids gets the label of: first | last | largest, the one with the "
      "largest winding number | smallest, the one of the smallest volume (first)")
    ->transform(
      oneOf({{"first", vtkWindingNumberLabels::FIRST}, {"last", vtkWindingNumberLabels::LAST},
        {"largest", vtkWindingNumberLabels::LARGEST_WINDING_NUMBER},
        {"smallest", vtkWindingNumberLabels::SMALLEST_VOLUME}}))
    ->type_name("NAME");
  labels->add_flag(
    "--count", options.count, "Add the array SolidCount: how many solids each voxel lies in");
  labels
    ->add_option("--shares", options.shares,
      "The shares that --coverage fraction adds: two, the largest two with their labels | each, "
      "an array for each solid (two)")
    ->transform(oneOf(
      {{"two", vtkWindingNumberLabels::TWO_LARGEST}, {"each", vtkWindingNumberLabels::EACH_LABEL}}))
    ->type_name("NAME");
  labels
    ->add_option("--region-array", options.regionArray,
      "For one input: the cell array whose values, integers or texts, are the solids. Integers are "
      "the labels themselves, or are counted from 1 where they are not all 1 to 65535")
    ->type_name("ARRAY");
  labels
    ->add_option(
      "--label-offset", options.labelOffset, "For --region-array: added to the integers (0)")
    ->type_name("N");
  for (const char* option :
    {"--overlap", "--count", "--shares", "--region-array", "--label-offset"})
  {
    labels->get_option(option)->group("Output");
  }
  addThreshold(labels, options);
  addCoverage(labels, options);
  addFieldOptions(labels, options);
  addMending(labels, options);
  labels
    ->add_option("--pieces", options.pieces,
      "Make and write the labels in this many pieces, to save memory (1)")
    ->group("Run");
  addThreads(labels, options);
  addLongestTime(labels, options);
  addReporting(labels, options);
}

void addProbe(CLI::App& app, Options& options)
{
  CLI::App* probe = app.add_subcommand("probe", "Winding numbers at given points");
  addInputsAndQueries(probe, options);
  addOutput(probe, options, ".vtp .vtu .csv .tsv; for an image or a grid also .vti .vtr .vts");
  addThreshold(probe, options);
  probe
    ->add_flag("--inside-out", options.insideOut,
      "Take what is outside for inside; the winding numbers stay what they are")
    ->group("Output");
  probe
    ->add_flag("--extract", options.extract,
      "Write only what is inside: cells with all their points, points without cells, rows of "
      "tables")
    ->group("Output");
  probe
    ->add_flag("--fraction", options.fraction,
      "Add the cell array Fraction: the share of each cell of the points' mesh that is inside")
    ->group("Output");
  addDistance(probe, options);
  addNearestCells(probe, options);
  addArrayName(probe, options);
  addMethod(probe, options);
  addThreads(probe, options);
  addLongestTime(probe, options);
  addReporting(probe, options);
}

void addNormals(CLI::App& app, Options& options)
{
  CLI::App* normals = app.add_subcommand(
    "normals", "Outward normals, and areas, for points that have none, as a file of points");
  addPointsInput(normals, options);
  addOutput(
    normals, options, ".ply .xyz .pwn, points with normals; .vtp .vtu .csv .tsv, with areas, too");
  normals
    ->add_flag("--replace", options.replace,
      "Estimate normals for points that have some, or for points of a mesh; without it, they keep "
      "theirs, and points of a mesh get the normals of its faces")
    ->group("Method");
  addPointAreas(normals, options,
    "Areas of the points: voronoi, each point's cell among its neighbours | mesh, a third of the "
    "triangles around it | constant (voronoi)",
    {{"voronoi", vtkWindingNumberNormals::VORONOI}, {"mesh", vtkWindingNumberNormals::MESH},
      {"constant", vtkWindingNumberNormals::CONSTANT}});
  addThreads(normals, options);
  addReporting(normals, options);
}

void addCheck(CLI::App& app, Options& options)
{
  CLI::App* check = addCommand(app, options, "check", "Health of a surface or cloud");
  CLI::Option* fix = check->add_flag("--fix-orientation,--orient", options.fixOrientation,
    "Turn polygons round so that neighbours agree, and closed components so that they are outward, "
    "those inside an odd number of others inward; keep one of doubled ones; then report on the "
    "result");
  CLI::Option* output = check->add_option("-o,--output", options.output,
    "With --fix-orientation: the surface that results, .vtp .ply .stl .obj");
  CLI::Option* faults = check->add_option("--blocks", options.faults,
    "Write what is wrong with a surface, to look at, .vtm: the blocks Boundary, Caps, "
    "NonManifoldEdges and InconsistentEdges");
  addSurfaceCells(check, options);
  addCompletion(check, options);
  output->needs(fix);
  output->type_name("OUT");
  faults->type_name("OUT");
  for (CLI::Option* option : {fix, output, faults})
  {
    option->group("Output");
  }
  addOverwrite(check, options);
  addReporting(check, options);
}

void addBench(CLI::App& app, Options& options)
{
  CLI::App* bench =
    app.add_subcommand("bench", "How long the methods take, and how exact they are");
  bench
    ->add_option(
      "FILE", options.inputs, "Surfaces, each measured with every method: " + inputSuffixes())
    ->required()
    ->type_name("");
  bench
    ->add_option("--resolution", options.resolutions,
      "Cubic voxels along the longest side, one or more (64 128 256)")
    ->type_name("N...")
    ->group("Grid");
  addThreads(bench, options);
  addReporting(bench, options);
}

/// One file, or the first of several and how many there are.
std::string nameOfAll(const std::vector<std::string>& files)
{
  return files.size() == 1 ? files[0]
                           : files[0] + " and " + std::to_string(files.size() - 1) + " more";
}

/// Returns what to give in place of a word that is no number for its option, by the parser's words
/// "Could not convert: --option = word". Returns nothing for other words.
std::string wordsForNumber(const std::string& text)
{
  const std::string before = "Could not convert: ", between = " = ";
  const std::size_t at = text.find(between);
  if (text.rfind(before, 0) != 0 || at == std::string::npos)
  {
    return "";
  }
  const std::string option = text.substr(before.size(), at - before.size());
  const std::string word = text.substr(at + between.size());
  double value = 0;
  const bool isNumber = parseNumber(word, value) && std::isfinite(value);
  const bool isLarge = isNumber && std::abs(value) > INT_MAX;
  return option + " is " + word + "; give " +
         (isLarge     ? "a smaller number"
           : isNumber ? "a whole number, like " + std::to_string(std::lround(value))
                      : "a number");
}

/// The words of the parser on one line, and where to look further.
std::string explanation(const CLI::App& app, const CLI::ParseError& error, const std::string& first)
{
  std::string text = error.what();
  std::replace(text.begin(), text.end(), '\n', ' ');
  const std::string number = wordsForNumber(text);
  text = number.empty() ? text : number;
  const auto commands = app.get_subcommands();
  if (commands.empty() && !first.empty() && first[0] != '-')
  {
    text = "\"" + first + "\" is no subcommand";
  }
  return text + "; see winding " + (commands.empty() ? "" : commands[0]->get_name() + " ") +
         "--help";
}

/// Returns the arguments of the program, the last one first, as the parser takes them. Numbers like
/// -.5 get a zero, for it takes words for options whose minus no digit follows.
std::vector<std::string> wordsOf(int argc, char** argv)
{
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  for (std::string& word : words)
  {
    if (startsWith(word, "-.") && word.find_first_of("0123456789") == 2)
    {
      word.insert(1, "0");
    }
  }
  std::reverse(words.begin(), words.end());
  return words;
}

} // namespace

void addCommands(CLI::App& app, Options& options)
{
  app.name("winding");
  app.description(
    "Winding numbers of surfaces and oriented point clouds: what is inside, and how often");
  app.set_version_flag("--version", WINDING_VERSION);
  app.require_subcommand(1);
  for (const auto add : {addField, addSurface, addBoolean, addVoxels, addLabels, addProbe,
         addNormals, addCheck, addBench})
  {
    add(app, options);
  }
}

std::optional<Options> parseCommandLine(int argc, char** argv)
{
  Options options;
  CLI::App app;
  addCommands(app, options);
  try
  {
    app.parse(wordsOf(argc, argv));
  }
  catch (const CLI::Success& wish)
  {
    if (parallel::isFirst())
    {
      app.exit(wish); // prints the help or the version
      requirePrinted();
    }
    return {};
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(EXIT_USAGE, explanation(app, error, argc > 1 ? argv[1] : ""));
  }
  const CLI::App* command = app.get_subcommands()[0];
  options.command = command->get_name();
  if (options.command == "probe")
  {
    requireUsage(options.inputs.size() > 1,
      "QUERIES is required: give the file of the points that are asked about last");
    options.queries = options.inputs.back();
    options.inputs.pop_back();
  }
  options.input = nameOfAll(options.inputs);
  checkRanges(*command);
  checkOptions(options,
    [command](const char* name)
    {
      const CLI::Option* option = command->get_option_no_throw(name);
      return option && option->count() > 0;
    });
  return options;
}
