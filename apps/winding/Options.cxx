#include "Options.h"

#include "Failure.h"

#include "vtkWindingNumberField.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace
{

using Filter = vtkWindingNumberField;

using Choices = std::vector<std::pair<std::string, int>>;

/// Turns a name into its number. (CLI11's own would take numbers too, and say less.)
CLI::Validator oneOf(const Choices& choices)
{
  CLI::Validator validator;
  validator.operation(
    [choices](std::string& word)
    {
      std::string names;
      for (const auto& [name, number] : choices)
      {
        if (word == name)
        {
          word = std::to_string(number);
          return std::string();
        }
        names += (names.empty() ? "" : " | ") + name;
      }
      return word + " is not one of " + names;
    });
  return validator;
}

void addGrid(CLI::App* command, Options& options)
{
  const std::string group = "Grid";
  CLI::Option* resolution = command->add_option(
    "--resolution", options.resolution, "Cubic voxels along the longest side (64)");
  CLI::Option* voxelSize = command->add_option(
    "--voxel-size", options.voxelSize, "Side of the cubic voxels, in the unit of the input");
  CLI::Option* dimensions = command->add_option(
    "--dims", options.dimensions, "Voxels along each axis, which need not be cubic then");
  CLI::Option* bounds = command->add_option("--bounds", options.bounds,
    "Outer faces of the voxels: xmin xmax ymin ymax zmin zmax (those of the input)");
  CLI::Option* padding = command->add_option("--padding", options.padding,
    "Margin around the input's bounds, as a fraction of their longest side (0.05)");
  CLI::Option* cells = command->add_flag("--cells", options.cells,
    options.command == "field" ? "Make the samples cells of the image, not points"
                               : "As of field; makes no difference to the surface");
  dimensions->expected(3)->type_name("NX NY NZ");
  bounds->expected(6)->type_name("X0 X1 Y0 Y1 Z0 Z1");
  resolution->excludes(voxelSize)->excludes(dimensions);
  voxelSize->excludes(dimensions);
  bounds->excludes(padding);
  for (CLI::Option* option : {resolution, voxelSize, dimensions, bounds, padding, cells})
  {
    option->group(group);
  }
}

void addMethod(CLI::App* command, Options& options)
{
  const std::string group = "Method";
  command
    ->add_option("--method", options.method,
      command->get_name() == "probe"
        ? "auto | rows | hierarchical | direct | parity (auto). Rows counts signed crossings, for "
          "closed surfaces; parity is ray casting, for the same"
        : "auto | rows | hierarchical | direct | parity (auto). Rows is for surfaces; parity is "
          "ray "
          "casting, for closed ones")
    ->transform(oneOf(
      {{"auto", Filter::AUTOMATIC}, {"rows", Filter::ROWS}, {"hierarchical", Filter::HIERARCHICAL},
        {"direct", Filter::DIRECT}, {"parity", Filter::PARITY}}))
    ->type_name("NAME")
    ->group(group);
  command
    ->add_option("--tolerance", options.tolerance,
      "Largest absolute error that an approximation may make (0.001); below 1e-6, none is made")
    ->group(group);
  command
    ->add_option("--areas", options.areas,
      "Areas of a cloud's points: voronoi, each point's cell among its neighbours | mesh, a third "
      "of "
      "the triangles around it (with --points) | constant | array, the point data array \"Area\" "
      "(voronoi)")
    ->transform(oneOf({{"voronoi", Filter::VORONOI}, {"mesh", Filter::MESH},
      {"constant", Filter::CONSTANT}, {"array", Filter::ARRAY}}))
    ->type_name("NAME")
    ->group(group);
  command
    ->add_option("--area", options.area,
      "The area of every point of a cloud, for --areas constant (the mean of those of voronoi)")
    ->group(group);
  command
    ->add_option("--neighbors", options.neighbors,
      "How many neighbours of a point tell its area and, if estimated, its normal (20)")
    ->group(group);
  command
    ->add_option("--regularization", options.regularization,
      "Spread each point of a cloud over so many spacings, so that values beside points stay about "
      "between 0 and 1: 1 does; up to 4; 0, not at all (0)")
    ->group(group);
  command
    ->add_flag("--estimate-normals", options.estimateNormals,
      "Estimate the normals of points that have none, orient them, and check them by the field")
    ->group(group);
  command->add_flag("--points", options.asPoints, "Take a mesh as a cloud of its vertices")
    ->group(group);
}

void addThreshold(CLI::App* command, Options& options)
{
  command
    ->add_option(
      "--threshold", options.threshold, "The winding number from which on is inside (0.5)")
    ->group("Output");
  command
    ->add_option("--rule", options.rule,
      "Inside is where: signed, w >= threshold | absolute, |w| >= threshold | odd, w rounds to an "
      "odd number (signed)")
    ->transform(
      oneOf({{"signed", Filter::SIGNED}, {"absolute", Filter::ABSOLUTE}, {"odd", Filter::ODD}}))
    ->type_name("NAME")
    ->group("Output");
}

void addCoverage(CLI::App* command, Options& options)
{
  command
    ->add_option("--coverage", options.coverage,
      std::string("A voxel is inside if: center, its centre is | any, it overlaps the solid or its "
                  "surface | fraction, half of it is (center)") +
        (options.command == "field" ? ". The latter two add the array Inside, fraction the array "
                                      "Coverage, the share of each voxel"
                                    : ""))
    ->transform(
      oneOf({{"center", Filter::CENTER}, {"any", Filter::ANY}, {"fraction", Filter::FRACTION}}))
    ->type_name("NAME")
    ->group("Output");
  command
    ->add_option("--coverage-samples", options.coverageSamples,
      "Samples along each axis of a voxel for --coverage fraction, 1 to 10 (4)")
    ->type_name("N")
    ->group("Output");
}

void addDistance(CLI::App* command, Options& options)
{
  command
    ->add_flag("--distance", options.distance,
      "Add the array SignedDistance: from the nearest point of the input, negative inside")
    ->group("Output");
}

void addDistanceBand(CLI::App* command, Options& options)
{
  command
    ->add_option("--distance-band", options.distanceBand,
      "Distances up to so many voxels only, which takes less time; farther voxels get that "
      "distance (0: all)")
    ->type_name("N")
    ->group("Output");
}

void addArrayName(CLI::App* command, Options& options)
{
  command
    ->add_option("--array", options.array, "Name of the array of winding numbers (WindingNumber)")
    ->group("Output");
}

CLI::Option* addDouble(CLI::App* command, Options& options)
{
  return command->add_flag("--double", options.asDouble, "Numbers in double precision, not float")
    ->group("Output");
}

/// What commands have that make a field.
void addFieldLike(CLI::App* command, Options& options)
{
  addGrid(command, options);
  addMethod(command, options);
  command
    ->add_option("--verify", options.verify,
      "Compare this many random samples, and as many near the surface, with the direct sum")
    ->group("Run");
}

void addThreads(CLI::App* command, Options& options)
{
  command->add_option("--threads", options.threads, "Most threads to use (all)")->group("Run");
}

void addReporting(CLI::App* command, Options& options)
{
  command->add_flag("--json", options.json, "Print one JSON object on standard output")
    ->group("Run");
  command->add_flag("--quiet", options.quiet, "No progress, warnings or summary")->group("Run");
}

CLI::App* addCommand(CLI::App& app, Options& options, const char* name, const char* description)
{
  CLI::App* command = app.add_subcommand(name, description);
  options.command = name; // for the descriptions that depend on it
  command
    ->add_option("IN", options.input,
      "Surface or oriented points: .vtp .vtk .vtu .ply .stl .obj .off .xyz .pwn .csv")
    ->required()
    ->type_name("");
  return command;
}

void addOutput(CLI::App* command, Options& options, const char* suffixes)
{
  command->add_option("-o,--output", options.output, std::string("The file to write: ") + suffixes)
    ->required()
    ->type_name("OUT")
    ->group("Output");
}

void addCheck(CLI::App* command, Options& options)
{
  CLI::Option* fix = command->add_flag("--fix-orientation", options.fixOrientation,
    "Turn polygons round so that neighbours agree, and closed components so that they are outward, "
    "those inside an odd number of others inward; then report on the result");
  CLI::Option* output = command->add_option("-o,--output", options.output,
    "With --fix-orientation: the surface that results, .vtp .ply .stl .obj");
  CLI::Option* faults = command->add_option("--blocks", options.faults,
    "Write what is wrong with a surface, to look at, .vtm: the blocks Boundary, Caps, "
    "NonManifoldEdges and InconsistentEdges");
  output->needs(fix);
  output->type_name("OUT");
  faults->type_name("OUT");
  for (CLI::Option* option : {fix, output, faults})
  {
    option->group("Output");
  }
}

CLI::App* addBench(CLI::App& app, Options& options)
{
  CLI::App* bench =
    app.add_subcommand("bench", "How long the methods take, and how exact they are");
  bench
    ->add_option("FILE", options.subjects,
      "Surfaces, each measured with every method; or: seed, the published tables | kernels, the "
      "parts that the methods are made of | clouds FILE..., the vertices of surfaces as clouds, "
      "with "
      "each kind of areas, beside the surfaces | vtk FILE..., VTK's own filters at the same "
      "samples | "
      "hierarchical FILE..., the far field of surfaces, "
      "of "
      "their vertices and of their caps, in its parts | hierarchical, the same of spheres with few "
      "and many sources")
    ->required()
    ->type_name("");
  bench
    ->add_option("--resolution", options.resolutions,
      "Cubic voxels along the longest side, one or more (64 128 256; clouds: 128; vtk: 64; "
      "hierarchical: 64 128 256 512 for files, 128 for spheres)")
    ->type_name("N...")
    ->group("Grid");
  bench
    ->add_option("--points", options.points,
      "vtk: scattered points to ask about, one or more (1000 10000 100000)")
    ->type_name("N...")
    ->group("Grid");
  bench
    ->add_option("--tolerance", options.tolerances,
      "hierarchical: largest absolute errors, 1e-6 or more, one or more (0.001)")
    ->type_name("T...")
    ->group("Method");
  bench
    ->add_option("--sources", options.sources,
      "hierarchical: triangles and points of the spheres, one or more (1000 10000 100000 1000000)")
    ->type_name("N...")
    ->group("Method");
  bench
    ->add_option(
      "--data", options.data, "seed: the folder with the published meshes (../shared/data)")
    ->type_name("FOLDER")
    ->group("Grid");
  return bench;
}

void addCommands(CLI::App& app, Options& options)
{
  CLI::App* field = addCommand(app, options, "field", "Winding field on a grid of voxels");
  addOutput(field, options, ".vti");
  addThreshold(field, options);
  addCoverage(field, options);
  field->add_flag("--inside", options.inside, "Add the array Inside")->group("Output");
  CLI::Option* insideOnly =
    field
      ->add_flag("--inside-only", options.insideOnly,
        "The array Inside and no winding numbers, which take four times the memory")
      ->group("Output");
  addDistance(field, options);
  addDistanceBand(field, options);
  addArrayName(field, options);
  insideOnly->excludes(addDouble(field, options));
  addFieldLike(field, options);
  field
    ->add_option("--pieces", options.pieces,
      "Make and write the field in this many pieces, to save memory (1)")
    ->group("Run");

  CLI::App* surface =
    addCommand(app, options, "surface", "Smooth surface where the winding field is the threshold");
  addOutput(surface, options, ".vtp .ply .stl .obj");
  addThreshold(surface, options);
  surface
    ->add_flag("--close-border", options.closeBorder,
      "Close the surface where it reaches the border of the grid")
    ->group("Output");
  addDouble(surface, options);
  addFieldLike(surface, options);

  CLI::App* voxels = addCommand(app, options, "voxels", "Surface of the voxels that are inside");
  addOutput(voxels, options, ".vtp .ply .stl .obj");
  addThreshold(voxels, options);
  addCoverage(voxels, options);
  voxels
    ->add_flag("--double", options.asDouble,
      "Compare winding numbers in double precision with the threshold, not in float")
    ->group("Output");
  addFieldLike(voxels, options);

  CLI::App* probe = addCommand(app, options, "probe", "Winding numbers at given points");
  probe
    ->add_option("QUERIES", options.queries,
      "The points: any of the formats of IN; .csv or .tsv with columns x,y,z")
    ->required()
    ->type_name("");
  addOutput(probe, options, ".vtp .vtu .csv .tsv");
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
  addDistance(probe, options);
  addArrayName(probe, options);
  addMethod(probe, options);

  CLI::App* check = addCommand(app, options, "check", "Health of a surface or cloud");
  addCheck(check, options);

  CLI::App* bench = addBench(app, options);

  for (CLI::App* command : {field, surface, voxels, probe, bench})
  {
    addThreads(command, options);
  }
  for (CLI::App* command : {field, surface, voxels, probe, check, bench})
  {
    addReporting(command, options);
  }
}

/// What the parser has to say, on one line, with where to look further.
std::string explanation(const CLI::App& app, const CLI::ParseError& error, const std::string& first)
{
  std::string text = error.what();
  std::replace(text.begin(), text.end(), '\n', ' ');
  const auto commands = app.get_subcommands();
  if (commands.empty() && !first.empty() && first[0] != '-')
  {
    text = "\"" + first + "\" is no subcommand";
  }
  return text + "; see winding " + (commands.empty() ? "" : commands[0]->get_name() + " ") +
         "--help";
}

} // namespace

std::optional<Options> parseCommandLine(int argc, char** argv)
{
  Options options;
  options.areas = Filter::VORONOI;
  CLI::App app(
    "Winding numbers of surfaces and oriented point clouds: what is inside, and how often",
    "winding");
  app.set_version_flag("--version", WINDING_VERSION);
  app.require_subcommand(1);
  addCommands(app, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& wish)
  {
    app.exit(wish); // prints the help or the version
    return {};
  }
  catch (const CLI::ParseError& error)
  {
    throw Failure(USAGE, explanation(app, error, argc > 1 ? argv[1] : ""));
  }
  const CLI::App* command = app.get_subcommands()[0];
  options.command = command->get_name();
  checkOptions(options, [command](const char* option) { return command->count(option) > 0; });
  return options;
}

std::string suffixOf(const std::string& fileName)
{
  std::string suffix = std::filesystem::path(fileName).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}
