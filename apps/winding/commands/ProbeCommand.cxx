// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/AnswerTable.h"
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FilterSettings.h"
#include "commands/ReportParts.h"
#include "files/Formats.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Stopwatch.h"
#include "program/Threads.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberProbe.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace
{

/// Times in seconds, the largest of all ranks, and the peaks of their memory in bytes.
struct Figures
{
  double read, prepare, evaluate, total;
  std::vector<double> peakMemories;
};

/// The names of the arrays that a probe adds, which are columns in a table.
std::vector<std::string> resultNames(const Options& options)
{
  std::vector<std::string> names = {options.array, "Inside"};
  if (options.distance)
  {
    names.push_back("SignedDistance");
  }
  if (options.nearestCells)
  {
    names.push_back("NearestCell");
    names.push_back("NearestBlock"); // for several inputs
  }
  return names;
}

/// Throws Failure for queries that have columns of these names.
void checkColumns(const std::function<bool(const std::string&)>& isColumn, const Options& options)
{
  for (const std::string& name : resultNames(options))
  {
    if (isColumn(name))
    {
      throw Failure(EXIT_REFUSED, options.queries,
        "already has a column " + name + "; rename or remove it, or use --array");
    }
  }
}

/// The columns of the queries: their own choice, or the one for a source without columns.
const std::string& columnsOfQueries(const Options& options)
{
  const bool isOfSource = std::any_of(options.inputs.begin(), options.inputs.end(), hasColumns);
  return options.queryColumns.empty() && !isOfSource ? options.columns : options.queryColumns;
}

/// Reads the queries into a place where they stay.
void takeQueries(const Options& options, Messages& messages, Queries& queries)
{
  const std::string& columns = columnsOfQueries(options);
  const std::string unpacked = unpackedName(options.queries);
  if (isTable(unpacked))
  {
    const bool isHandedOn = isTable(options.output);
    if (isHandedOn && suffixOf(unpacked) != suffixOf(options.output))
    {
      throw Failure(EXIT_REFUSED, options.output,
        "the columns of the queries are kept as they are; give it their suffix " +
          suffixOf(unpacked));
    }
    const auto with = isHandedOn ? QueryTable::With::rows : QueryTable::With::columns;
    queries.table.emplace(options.queries, with, columns, messages);
    checkColumns([&](const std::string& name) { return queries.table->hasColumn(name); }, options);
    queries.points = queries.table->points();
    return;
  }
  if (isTable(options.output))
  {
    checkColumns(
      [](const std::string& name) { return name == "x" || name == "y" || name == "z"; }, options);
  }
  queries.points = readQueries(options.queries, messages, {columns, true});
}

void printReport(const Options& options, vtkWindingNumberProbe& probe, const ProbeAnswer& probed,
  const Figures& figures)
{
  const auto queries = static_cast<vtkIdType>(probed.inside.size());
  const vtkIdType taken = std::accumulate(probed.inside.begin(), probed.inside.end(), vtkIdType(0));
  const double prepare = figures.prepare, evaluate = figures.evaluate, read = figures.read;
  const double total = figures.total;
  const char* const side = options.insideOut ? "outside" : "inside";
  Json report = {{"input", describeInput(options.input, probe)}, {"method", probe.GetMethodUsed()},
    {"why", probe.GetMethodReason()}, {"tolerance", options.tolerance},
    {"expected", {{"seconds", probe.GetExpectedSeconds()}, {"memory", probe.GetExpectedMemory()}}},
    {"queries", {{"file", options.queries}, {"count", queries}, {side, taken}}},
    {"output", {{"file", options.output}}},
    {"seconds", {{"read", read}, {"prepare", prepare}, {"evaluate", evaluate},
                  {"write", std::max(0.0, total - read - prepare - evaluate)}, {"total", total}}},
    {"peak_memory", largestMemory(figures.peakMemories)},
    {"threads", threadsUsed(options.threads)}};
  addRanks(report, figures.peakMemories);
  if (options.json)
  {
    print(report);
  }
  else if (!options.quiet)
  {
    print(options.input + ": method " + probe.GetMethodUsed() + " (" + probe.GetMethodReason() +
          "), " + std::to_string(queries) + " queries, " + std::to_string(taken) + " " + side +
          ", " + shown(total, 3) + " s\nwrote " + options.output);
  }
}

/// Warns of a table that no row is extracted for, as the filter does of an empty part.
void warnOfEmptyTable(const Options& options, vtkWindingNumberProbe& probe,
  const ProbeAnswer& probed, Messages& messages)
{
  const bool isEmpty =
    std::find(probed.inside.begin(), probed.inside.end(), 1) == probed.inside.end();
  if (options.extract && isEmpty && !probed.inside.empty() && !probe.GetSourceIsInsideOut() &&
      probe.GetNumberOfPrimitives() > 0)
  {
    messages.warn(options.queries + ": no point is " + (options.insideOut ? "outside" : "inside") +
                  ", so the result is empty");
  }
}

} // namespace

void runProbe(const Options& options, Messages& messages)
{
  const Stopwatch stopwatch;
  const auto output = openOnFirstRank(options);
  Queries queries;
  queries.points = vtkSmartPointer<vtkPolyData>::New();
  parallel::agreeOnFirst([&] { takeQueries(options, messages, queries); });
  const auto source = readSource(options, messages);
  const double readSeconds = stopwatch.seconds();

  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetSourceData(source);
  probe->SetSourceDistribution(vtkWindingNumberAlgorithm::DISTRIBUTED);
  applyMethod(options, probe);
  probe->GenerateInsideOn();
  probe->SetGenerateSignedDistance(options.distance);
  probe->SetGenerateFraction(options.fraction);
  probe->SetGenerateNearestCells(options.nearestCells);
  probe->SetResultArrayName(options.array.c_str());
  probe->SetOutputScalarTypeToDouble();
  probe->SetInsideOut(options.insideOut);
  probe->SetExtractInside(
    options.extract && !isTable(options.output)); // writeTable() extracts rows
  const ProbeAnswer probed = probeOnAllRanks(*probe, queries.points, options, messages);
  warnOfIdleOptions(options, *probe, messages);
  parallel::agreeOnFirst(
    [&]
    {
      if (isTable(options.output))
      {
        warnOfEmptyTable(options, *probe, probed, messages);
        std::vector<std::string> names = resultNames(options);
        const auto isMissing = [&probed](const std::string& name)
        {
          return !probed.data->GetPointData()->HasArray(name.c_str());
        };
        names.erase(std::remove_if(names.begin(), names.end(), isMissing), names.end());
        writeTable({queries, probed, names, options.extract}, *output);
      }
      else
      {
        writePoints(probed.data, *output, messages);
      }
      output->commit();
    });
  const Figures figures = {parallel::maximum(readSeconds),
    parallel::maximum(probe->GetPrepareSeconds()), parallel::maximum(probe->GetEvaluateSeconds()),
    parallel::maximum(stopwatch.seconds()), parallel::allGather(static_cast<double>(peakMemory()))};
  parallel::agreeOnFirst([&] { printReport(options, *probe, probed, figures); });
}
