// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options/OptionGroups.h"

#include "files/Formats.h"

#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"

namespace
{

using Filter = vtkWindingNumberField;

void addGrid(CLI::App* command, Options& options)
{
  const std::string group = "Grid";
  const bool isImage = command->get_name() == "field" || command->get_name() == "labels";
  CLI::Option* resolution = command->add_option("--resolution", options.resolution,
    isImage ? "Cubic voxels along the longest side (128)"
            : "Cubic voxels along the longest side; by default 0: 128, or more for thin walls");
  CLI::Option* voxelSize = command->add_option(
    "--voxel-size", options.voxelSize, "Side of the cubic voxels, in the unit of the input");
  CLI::Option* dimensions = command->add_option(
    "--dims", options.dimensions, "Voxels along each axis, which need not be cubic then");
  CLI::Option* bounds = command->add_option("--bounds", options.bounds,
    "Outer faces of the voxels: xmin xmax ymin ymax zmin zmax (the bounds of the input)");
  CLI::Option* padding = command->add_option("--padding", options.padding,
    "Margin around the input's bounds, as a fraction of their longest side, or with --dims of each "
    "axis's own (0.05)");
  CLI::Option* cells = command->add_flag("--cells", options.cells,
    isImage ? "Make the samples cells of the image, not points"
            : "As for field; makes no difference here");
  dimensions->expected(3)->type_name("NX NY NZ");
  bounds->expected(6)->type_name("X0 X1 Y0 Y1 Z0 Z1");
  resolution->excludes(voxelSize)->excludes(dimensions);
  voxelSize->excludes(dimensions);
  bounds->excludes(padding);
  if (command->get_name() != "surface" && command->get_name() != "boolean")
  {
    command
      ->add_option("--like", options.like,
        "Lie on this image: its voxels, origin, spacing and directions; .vti, or the header of a "
        "medical image: .mha .mhd .nrrd .nhdr .nii .nii.gz")
      ->type_name("IMAGE")
      ->group(group)
      ->excludes(resolution)
      ->excludes(voxelSize)
      ->excludes(dimensions)
      ->excludes(bounds)
      ->excludes(padding);
  }
  for (CLI::Option* option : {resolution, voxelSize, dimensions, bounds, padding, cells})
  {
    option->group(group);
  }
}

/// Adds the columns of tables, which `name` chooses into `columns`.
void addColumns(
  CLI::App* command, std::string& columns, const std::string& name, const std::string& of)
{
  command
    ->add_option_function<std::vector<std::string>>(
      name,
      [&columns, name](const std::vector<std::string>& words)
      {
        for (const std::string& word : words)
        {
          if (word.find('=') == std::string::npos)
          {
            throw CLI::ValidationError(name, word + " is not like x=Easting; give the files first");
          }
          columns += (columns.empty() ? "" : " ") + word;
        }
      },
      "Columns of " + of +
        ".csv .tsv .xyz .pwn by names, or by numbers from 1 on: x=Easting "
        "y=Northing z=Height nx=4 ny=5 nz=6 area=7 vx=8 vy=9 vz=10, where points were seen from")
    ->type_name("NAME=COLUMN...");
}

} // namespace

void addSurfaceCells(CLI::App* command, Options& options)
{
  command
    ->add_flag("--surface-cells", options.surfaceCells,
      "Take the faces of a mesh that has cells with volume, too, rather than these cells' surface")
    ->group("Method");
}

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
  std::string names;
  for (const auto& choice : choices)
  {
    names += (names.empty() ? "" : " ") + choice.first;
  }
  return validator.name(names);
}

CLI::Validator rules()
{
  return oneOf({{"signed", Filter::SIGNED}, {"absolute", Filter::ABSOLUTE}, {"odd", Filter::ODD}});
}

void addInputs(CLI::App* command, Options& options)
{
  const std::string several =
    command->get_name() == "boolean" ? "two or more, a solid each: "
    : command->get_name() == "labels"
      ? "a solid each; or one surface, whose solids are the values of --region-array, or "
        "its parts, as the file names them or by connectivity: "
      : "all together one source: ";
  command
    ->add_option("IN", options.inputs, "Surfaces or oriented points, " + several + inputSuffixes())
    ->required()
    ->type_name("");
  addColumns(command, options.columns, "--columns", "");
}

void addInputsAndQueries(CLI::App* command, Options& options)
{
  command
    ->add_option("IN", options.inputs,
      "Surfaces or oriented points, all together one source; last, QUERIES, the points that are "
      "asked about, of any of the formats, .csv and .tsv with columns x,y,z: " +
        inputSuffixes() + "; QUERIES may also be an image or a grid: " + imageSuffixes())
    ->required()
    ->type_name("");
  addColumns(command, options.columns, "--columns", "the source, or of queries about a mesh, ");
  addColumns(command, options.queryColumns, "--query-columns", "the queries, ");
}

void addPointsInput(CLI::App* command, Options& options)
{
  command->add_option("IN", options.inputs, "Points, or a mesh, for its points: " + inputSuffixes())
    ->required()
    ->expected(1)
    ->type_name("");
  addColumns(command, options.columns, "--columns", "");
}

void addOutput(CLI::App* command, Options& options, const std::string& suffixes)
{
  command->add_option("-o,--output", options.output, "The file to write: " + suffixes)
    ->required()
    ->type_name("OUT")
    ->group("Output");
  addOverwrite(command, options);
}

void addOverwrite(CLI::App* command, Options& options)
{
  command
    ->add_flag("--overwrite", options.overwrite,
      "Replace a file that is read, if it is the output, too; without it, that is refused")
    ->group("Output");
}

void addPointAreas(
  CLI::App* command, Options& options, const std::string& description, const Choices& methods)
{
  const std::string group = "Method";
  command->add_option("--areas", options.areas, description)
    ->transform(oneOf(methods))
    ->type_name("NAME")
    ->group(group);
  command
    ->add_option("--area", options.area,
      "The area of every point of a cloud, for --areas constant (the mean of the voronoi areas)")
    ->group(group);
  command
    ->add_option("--neighbors", options.neighbors,
      "How many neighbours of a point tell its area and, if estimated, its normal (20)")
    ->group(group);
  command
    ->add_option_function<std::vector<std::string>>(
      "--toward",
      [&options](const std::vector<std::string>& words)
      {
        const bool isFile = words.size() == 1 && words[0].find('.') != std::string::npos;
        options.towardFile = isFile ? words[0] : "";
        for (const std::string& word : isFile ? std::vector<std::string>() : words)
        {
          options.toward += (options.toward.empty() ? "" : " ") + word;
        }
      },
      "Where points were seen from, so that estimated normals look there: a position X Y Z; a file "
      "of positions, the nearest for each point; up, down or direction X Y Z")
    ->expected(1, 4)
    ->type_name("X Y Z | FILE | up")
    ->group(group);
  command
    ->add_option("--normal-estimation", options.normalEstimation,
      "How normals are estimated: tree, handed on from neighbour to neighbour | consistent, such "
      "that w is 1/2 at the points, for thin, close and separate parts | auto, tree where its "
      "check finds it right (auto)")
    ->transform(oneOf({{"auto", Filter::ESTIMATION_AUTOMATIC}, {"tree", Filter::SPANNING_TREE},
      {"consistent", Filter::WINDING_CONSISTENT}}))
    ->type_name("NAME")
    ->group(group);
}

void addCompletion(CLI::App* command, Options& options)
{
  const std::string group = "Method";
  command
    ->add_option("--mirror", options.mirror,
      "Add the mirror image of what is half of a solid, at x=0, y=0 or z=2, say, or at 'A B C=D'; "
      "may be given again for a quarter")
    ->multi_option_policy(CLI::MultiOptionPolicy::Join)
    ->type_name("PLANE")
    ->group(group);
  command
    ->add_option("--flat-base", options.flatBase,
      "Close a surface that is open below by walls and a flat base: down, up, +x, ... where it "
      "ends, or a plane as z=-5")
    ->type_name("SIDE|PLANE")
    ->group(group);
  command
    ->add_option("--weld-tolerance", options.weldTolerance,
      "Make points of faces one that are up to this far from each other, so that slits close (0)")
    ->group(group);
}

void addMethod(CLI::App* command, Options& options)
{
  const std::string group = "Method";
  const std::string about =
    command->get_name() == "probe"
      ? "Rows counts signed crossings, for closed surfaces; parity is ray casting, for the same"
      : "Rows is for surfaces; parity is ray casting, for closed ones";
  command
    ->add_option(
      "--method", options.method, "auto | rows | hierarchical | direct | parity (auto). " + about)
    ->transform(oneOf(
      {{"auto", Filter::AUTOMATIC}, {"rows", Filter::ROWS}, {"hierarchical", Filter::HIERARCHICAL},
        {"direct", Filter::DIRECT}, {"parity", Filter::PARITY}}))
    ->type_name("NAME")
    ->group(group);
  command
    ->add_option("--tolerance", options.tolerance,
      "Largest absolute error that an approximation may make (0.001); below 1e-6, none is made")
    ->group(group);
  addPointAreas(command, options,
    "Areas of a cloud's points: voronoi, each point's cell among its neighbours | mesh, a third "
    "of the triangles around it (with --points) | constant | array, the point data array "
    "\"Area\" (voronoi)",
    {{"voronoi", Filter::VORONOI}, {"mesh", Filter::MESH}, {"constant", Filter::CONSTANT},
      {"array", Filter::ARRAY}});
  command
    ->add_option("--regularization", options.regularization,
      "Spread each point of a cloud over this number of spacings, so that values near points stay "
      "about between 0 and 1: 1 does; up to 4; 0, not at all (0)")
    ->group(group);
  command
    ->add_flag("--estimate-normals", options.estimateNormals,
      "Estimate the normals of points that have none, orient them, and check them by the field")
    ->group(group);
  command->add_flag("--points", options.asPoints, "Take a mesh as a cloud of its vertices")
    ->group(group);
  addSurfaceCells(command, options);
  command
    ->add_flag("--orient", options.orientFaces,
      "Turn faces first so that solids look outward, and take faces once that are there more often")
    ->group(group);
  command
    ->add_flag("--ignore-open-parts", options.ignoreOpenParts,
      "Leave out open sheets inside of closed parts, as baffles")
    ->group(group);
  addCompletion(command, options);
  command
    ->add_option("--sheet-side", options.sheetSide,
      "The side of open sheets that is inside, as down for what is below a terrain: down, up, +x, "
      "... or 'direction X Y Z'. A half is added to w; beyond the rim the side is a guess")
    ->type_name("SIDE")
    ->group(group);
}

void addMending(CLI::App* command, Options& options)
{
  command
    ->add_flag("--as-is", options.asIs,
      "Leave the input as it is. Otherwise, where a warning would say that it bounds nothing, "
      "faces or normals are turned, points get normals, open sheets become plates of three voxels, "
      "and surfaces are closed at the border of the grid")
    ->group("Method");
}

void addFieldOptions(CLI::App* command, Options& options)
{
  addGrid(command, options);
  addMethod(command, options);
  command
    ->add_option("--verify", options.verify,
      "Compare this many random samples, and as many near the surface, with the direct sum")
    ->group("Run");
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
    ->transform(rules())
    ->type_name("NAME")
    ->group("Output");
}

void addFeatures(CLI::App* command, Options& options)
{
  command
    ->add_option("--features", options.features,
      "Edges of the source: smooth, cut off inside of voxels | sharp, kept | voxels, a surface of "
      "the sides of voxels (smooth)")
    ->transform(oneOf({{"smooth", vtkWindingNumberSurface::SMOOTH},
      {"sharp", vtkWindingNumberSurface::SHARP}, {"voxels", vtkWindingNumberSurface::VOXELS}}))
    ->type_name("NAME")
    ->group("Output");
  command
    ->add_flag("--triangles", options.triangles,
      "With --features sharp or voxels: triangles, not quads (.stl has no others)")
    ->group("Output");
  command
    ->add_flag("--close-border", options.closeBorder,
      "Close the surface where it reaches the border of the grid")
    ->group("Output");
  command->add_flag("--double", options.asDouble, "Numbers in double precision, not float")
    ->group("Output");
}

void addShape(CLI::App* command, Options& options)
{
  command
    ->add_flag("--fill-cavities", options.fillCavities,
      "Make inside what the outside does not reach, as in a hollow scan")
    ->group("Output");
  command
    ->add_option("--gap-width", options.gapWidth,
      "Width of openings that do not let the outside into cavities")
    ->needs("--fill-cavities")
    ->type_name("LENGTH")
    ->group("Output");
  command
    ->add_option("--offset", options.offset,
      "Move the surface outward by this length, inward if it is negative")
    ->type_name("LENGTH")
    ->group("Output");
  command
    ->add_option("--shell", options.shell,
      "Make a shell of this thickness about the surface, in place of the "
      "solid")
    ->type_name("LENGTH")
    ->group("Output");
  command
    ->add_option("--shell-side", options.shellSide,
      "The side of the surface that the shell lies on: inward | outward | centered (inward)")
    ->transform(oneOf(
      {{"inward", vtkWindingNumberSurface::INWARD}, {"outward", vtkWindingNumberSurface::OUTWARD},
        {"centered", vtkWindingNumberSurface::CENTERED}}))
    ->type_name("NAME")
    ->group("Output");
}

void addComparison(CLI::App* command, Options& options)
{
  command
    ->add_flag("--distance", options.distance,
      "Add the distance of each point from the input, for .vtp: the array DistanceToInput")
    ->group("Output");
  command
    ->add_option("--fidelity", options.fidelity,
      "Tell distances between input and output by this many points of each, volumes, lost parts "
      "and self-intersections")
    ->group("Run");
}

void addNearestCells(CLI::App* command, Options& options)
{
  command
    ->add_flag("--nearest-cells", options.nearestCells,
      "Add the array NearestCell, the number of the input's nearest cell or point, and, for "
      "several "
      "inputs, NearestBlock, which input it is in: 1 for the first")
    ->group("Output");
}

void addNearest(CLI::App* command, Options& options)
{
  command
    ->add_flag("--transfer-attributes", options.transferAttributes,
      "Take colours, texture coordinates, labels and other arrays over from the input: points get "
      "what its nearest triangle has there, faces what the cell nearest to their middle has")
    ->group("Output");
  addNearestCells(command, options);
}

void addCoverage(CLI::App* command, Options& options)
{
  std::string description = "A voxel is inside if: center, its centre is | any, it overlaps the "
                            "solid or its surface | fraction, half of it is (center)";
  if (command->get_name() == "labels")
  {
    description += ". The latter adds the shares of each voxel, see --shares";
  }
  if (command->get_name() == "field")
  {
    description += ". The latter two add the array Inside, fraction the array Coverage, the share "
                   "of each voxel";
  }
  command->add_option("--coverage", options.coverage, description)
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

void addArrayName(CLI::App* command, Options& options)
{
  command
    ->add_option("--array", options.array, "Name of the array of winding numbers (WindingNumber)")
    ->group("Output");
}

void addThreads(CLI::App* command, Options& options)
{
  command->add_option("--threads", options.threads, "Most threads to use (all)")->group("Run");
}

void addLongestTime(CLI::App* command, Options& options)
{
  command
    ->add_option("--longest-expected-time", options.longestExpectedTime,
      "Refuse, after a second, what is expected to take more than this; 0: no limit (0)")
    ->group("Run");
}

void addReporting(CLI::App* command, Options& options)
{
  command->add_flag("--json", options.json, "Print one JSON object on standard output")
    ->group("Run");
  command->add_flag("--quiet", options.quiet, "No progress, warnings or summary")->group("Run");
}
