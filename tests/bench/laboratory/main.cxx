// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the methods and what they are made of. Usage: laboratory <subject> [files…] [options];
// --help lists the subjects.
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Print.h"
#include "program/Threads.h"

#include "farfield/FarFieldAccuracy.h"

#include <CLI/CLI.hpp>

#include <iterator>

namespace
{

/// A kind of measurement, and what its command line may have.
struct Subject
{
  std::vector<BenchTable> (*measure)(const BenchOptions&, Messages&);
  const char* name;
  const char* help;
  bool takesFiles, needsFiles;
  const char* points; ///< help of --points; null where there is no such option
};

const Subject subjects[] = {
  {benchKernels, "kernels", "The parts that the methods are made of", false, false, nullptr},
  {benchHierarchical, "hierarchical",
    "The far field of surfaces, of their vertices and of their caps, in its parts; without files "
    "the same of spheres with few and many sources",
    true, false, nullptr},
  {benchClouds, "clouds",
    "The vertices of surfaces as clouds, with each kind of areas, against the surfaces", true, true,
    nullptr},
  {benchVtk, "vtk", "VTK's own filters at the same samples", true, true,
    "Scattered points to ask about (1000 10000 100000)"},
  {benchOrientation, "orientation", "Points on surfaces with estimated normals", true, true,
    "Points on the surfaces (50000)"}};

void addSubject(CLI::App& app, const Subject& subject, BenchOptions& options)
{
  CLI::App* const command = app.add_subcommand(subject.name, subject.help);
  if (subject.takesFiles)
  {
    command->add_option("FILE", options.files, "Surfaces")->required(subject.needsFiles);
    command
      ->add_option(
        "--resolution", options.resolutions, "Voxels along the longest side, one or more")
      ->check(CLI::PositiveNumber);
  }
  if (subject.points)
  {
    command->add_option("--points", options.points, subject.points)->check(CLI::PositiveNumber);
  }
  if (subject.measure == benchHierarchical)
  {
    command
      ->add_option(
        "--tolerance", options.tolerances, "Largest absolute errors, one or more (0.001)")
      ->check(CLI::Range(winding::FarFieldAccuracy::finest, 1.0));
    // The spheres are round.
    command
      ->add_option("--sources", options.sources,
        "Triangles and points of the spheres, one or more (1000 10000 100000 1000000)")
      ->check(CLI::Range(100, 1'000'000'000));
  }
  command->add_option("--threads", options.threads, "0 stands for all")
    ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", options.json, "Print JSON");
}

void measure(const BenchOptions& options)
{
  Messages& messages = Messages::install(false);
  limitThreads(options.threads);
  const auto subject = std::find_if(std::begin(subjects), std::end(subjects),
    [&options](const Subject& candidate) { return candidate.name == options.subject; });
  printTables(subject->measure(options, messages), options.threads, options.json);
}

} // namespace

int main(int argc, char** argv)
{
  interrupt::install();
  BenchOptions options;
  CLI::App app("Measures the methods and what they are made of", "laboratory");
  app.require_subcommand(1);
  for (const Subject& subject : subjects)
  {
    addSubject(app, subject, options);
  }
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? EXIT_DONE : EXIT_USAGE;
  }
  options.subject = app.get_subcommands()[0]->get_name();
  try
  {
    measure(options);
    return EXIT_DONE;
  }
  catch (const Failure& failure)
  {
    printLine(std::string("laboratory: ") + failure.what());
    return failure.status;
  }
}
