// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchGrid.h"
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/FarFieldSubject.h"
#include "laboratory/Measurement.h"
#include "laboratory/Meshes.h"
#include "laboratory/Shapes.h"
#include "laboratory/ThreadExecutor.h"
#include "laboratory/Timing.h"
#include "program/Interrupt.h"
#include "program/Threads.h"

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "source/Sanitize.h"
#include "source/Surface.h"

#include <cmath>
#include <map>
#include <utility>

namespace
{

using winding::FarField;
using winding::FarFieldAccuracy;
using winding::FarFieldWork;
using winding::Grid;

/// The tolerance that the filters have by default.
constexpr double usualTolerance = 1e-3;

/// How often each thing is done in an evaluation of the far field on a grid.
FarFieldWork workOf(const FarFieldSubject& subject, const Grid& grid, double tolerance)
{
  ThreadExecutor executor;
  FarFieldWork work;
  const std::shared_ptr<const FarField> farField = subject.farField(tolerance, grid, executor);
  if (farField)
  {
    const std::unique_ptr<float[]> values = freshArray(winding::sampleCount(grid.wholeExtent()));
    winding::FieldOutput output;
    output.values = values.get();
    farField->evaluate(grid, grid.wholeExtent(), output, executor, &work);
  }
  interrupt::check();
  return work;
}

/// Seconds of each part: how often its things are done, times what each of them costs.
std::vector<std::pair<const char*, double>> partsOf(
  const FarFieldWork& work, const FarFieldCosts& costs, const ExactCosts& exact)
{
  const auto times = [](std::uint64_t count, double cost)
  {
    return static_cast<double>(count) * cost;
  };
  return {{"tests", times(work.nodeTests, costs.nodeTest)},
    {"translations", times(work.translationBatches, costs.firstNode) +
                       times(work.translations - work.translationBatches, costs.nextNode) +
                       times(work.receivers, costs.receiver)},
    {"shifts", times(work.shifts, costs.shift) + times(work.leaves, costs.polynomial)},
    {"rows", times(work.rows, costs.row) + times(work.rowSamples, costs.rowSample)},
    {"blocks", times(work.blockSamples + work.nearSamples, costs.blockSample)},
    {"moments", times(work.momentValues, costs.momentValue)},
    {"exact", times(work.exactSamples, exact.sample) + times(work.exactPairs, exact.pair)}};
}

Json rowOf(const FarFieldWork& work)
{
  return {{"cells", work.cells}, {"leaves", work.leaves}, {"near leaves", work.nearLeaves},
    {"node tests", work.nodeTests}, {"near tests", work.nearTests},
    {"translations", work.translations}, {"batches", work.translationBatches},
    {"receivers", work.receivers}, {"shifts", work.shifts}, {"rows", work.rows},
    {"row samples", work.rowSamples}, {"block samples", work.blockSamples},
    {"near samples", work.nearSamples}, {"moment values", work.momentValues},
    {"exact samples", work.exactSamples}, {"exact pairs", work.exactPairs}};
}

/// The tables of some subjects: times, parts of the evaluation, and counts of what is done.
class Tables
{
public:
  Tables(const std::string& title, int threads)
    : threads_(threads)
    , times_(title + ": times",
        {"triangles: the mesh as a soup; points: its vertices; cap: method rows",
          "CPU s: of all threads; speed-up: against one thread; fill: one thread writes a constant "
          "to a fresh array of floats; times fill: prepare and evaluate beside it",
          "errors: against the direct sum done term by term at 300 random voxels, and 300 near the "
          "sources"})
    , parts_(title + ": parts of the evaluation, ms on one thread",
        {"how often each thing is done, times the processor time that it takes alone; output: "
         "fill; rest: of CPU s, what that does not explain"})
    , counts_(title + ": how often each thing is done", {"the same for any number of threads"})
  {
  }

  void add(const FarFieldSubject& subject, int resolution, double tolerance)
  {
    const Grid grid = benchGrid(subject.bounds(), resolution);
    const Json key = {{"of", subject.name()}, {"sources", subject.sources()},
      {"voxels", sizeOf(grid)}, {"tolerance", tolerance}};
    const double fill = secondsToFill(winding::sampleCount(grid.wholeExtent()));
    const Measurement serial = this->addTimes(subject, grid, tolerance, key, fill);
    const FarFieldWork work = workOf(subject, grid, tolerance);
    Json counts = key;
    counts.update(rowOf(work));
    counts_.add(counts);
    Json parts = key;
    parts.update(this->rowOfParts(subject, grid, FarFieldAccuracy::of(tolerance).order, work, fill,
      serial.evaluateOnProcessors));
    parts_.add(parts);
  }

  void appendTo(std::vector<BenchTable>& tables) const
  {
    tables.insert(tables.end(), {times_, parts_, counts_});
  }

private:
  /// Adds rows for one thread and for all, and returns the measurement on one thread.
  Measurement addTimes(const FarFieldSubject& subject, const Grid& grid, double tolerance,
    const Json& key, double fill)
  {
    const auto build = [&](winding::Executor& executor)
    {
      return subject.field(tolerance, executor);
    };
    const auto samples = static_cast<double>(winding::sampleCount(grid.wholeExtent()));
    const auto rowOfTimes = [&](const Measurement& measured, int threads)
    {
      Json row = key;
      row.update({{"threads", threads}, {"prepare s", measured.prepare},
        {"evaluate s", measured.evaluate}, {"CPU s", measured.evaluateOnProcessors},
        {"ns/voxel", 1e9 * measured.evaluate / samples}, {"speed-up", nullptr}, {"fill s", fill},
        {"times fill", (measured.prepare + measured.evaluate) / fill}, {"max error", nullptr},
        {"near max error", nullptr}});
      return row;
    };
    Measurement serial = measure(build, grid, 1);
    Json first = rowOfTimes(serial, 1);
    const winding::Verification errors = verified(serial, grid, 300);
    first["max error"] = errors.everywhere.max;
    first["near max error"] = errors.nearSurface.max;
    serial.values = nullptr; // two arrays of 512³ need not fit into memory
    times_.add(first);
    if (threads_ > 1)
    {
      const Measurement parallel = measure(build, grid, threads_);
      Json second = rowOfTimes(parallel, threads_);
      second["speed-up"] = serial.evaluate / parallel.evaluate;
      times_.add(second);
    }
    return serial;
  }

  Json rowOfParts(const FarFieldSubject& subject, const Grid& grid, int order,
    const FarFieldWork& work, double fill, double seconds)
  {
    if (costs_.count(order) == 0)
    {
      costs_[order] = measureFarFieldCosts(order);
    }
    Json row = {{"order", order}};
    double explained = 0;
    const auto add = [&](const char* part, double cost)
    {
      row[part] = 1e3 * cost;
      explained += cost;
    };
    for (const auto& [part, cost] : partsOf(work, costs_[order], subject.exactCosts()))
    {
      add(part, cost);
    }
    add("crossings", subject.secondsForRows(grid));
    add("output", fill);
    row.update({{"rest", 1e3 * (seconds - explained)}, {"CPU", 1e3 * seconds},
      {"rest %", 100 * (seconds - explained) / seconds}});
    return row;
  }

  int threads_;
  std::map<int, FarFieldCosts> costs_; ///< costs by order
  BenchTable times_, parts_, counts_;
};

void addAll(Tables& tables, const FarFieldSubject& subject, const std::vector<int>& resolutions,
  const std::vector<double>& tolerances)
{
  for (const double tolerance : tolerances)
  {
    for (const int resolution : resolutions)
    {
      tables.add(subject, resolution, tolerance);
    }
  }
}

void addSpheres(const BenchOptions& options, std::vector<BenchTable>& result)
{
  Tables tables("Lumpy spheres", threadsUsed(options.threads));
  const auto surfaceOf = [](const Triangles& sphere)
  {
    ThreadExecutor executor;
    return winding::sanitize({sphere.view()}, executor);
  };
  const std::vector<int> resolutions = givenOr(options.resolutions, {128});
  const std::vector<double> tolerances = givenOr(options.tolerances, {usualTolerance});
  const std::vector<int> counts = givenOr(options.sources, {1000, 10'000, 100'000, 1'000'000});
  for (const int sources : counts)
  {
    const Triangles sphere = lumpySphere(static_cast<int>(std::lround(std::sqrt(sources / 2.0))));
    const winding::Surface surface = surfaceOf(sphere);
    addAll(tables, *soupOf(sphere, surface), resolutions, tolerances);
  }
  for (const int sources : counts)
  {
    const Triangles sphere = lumpySphere(static_cast<int>(std::lround(std::sqrt(sources))));
    addAll(tables, *cloudOf(surfaceOf(sphere)), resolutions, tolerances);
  }
  tables.appendTo(result);
}

} // namespace

std::vector<BenchTable> benchHierarchical(const BenchOptions& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  const auto measureMesh = [&](const std::string& file, const Triangles& triangles)
  {
    const std::vector<int> resolutions = givenOr(options.resolutions, {64, 128, 256, 512});
    const std::vector<double> tolerances = givenOr(options.tolerances, {usualTolerance});
    ThreadExecutor executor;
    const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
    Tables ofFile(file, threadsUsed(options.threads));
    addAll(ofFile, *soupOf(triangles, surface), resolutions, tolerances);
    addAll(ofFile, *cloudOf(surface), resolutions, tolerances);
    if (const auto cap = capOf(triangles, surface))
    {
      addAll(ofFile, *cap, resolutions, tolerances);
    }
    ofFile.appendTo(tables);
  };
  forEachMesh(options, messages, measureMesh);
  if (options.files.empty())
  {
    addSpheres(options, tables);
  }
  return tables;
}
