#include "commands/Commands.h"
#include "commands/FilesToKeep.h"
#include "commands/FilterOutcome.h"
#include "commands/FilterSettings.h"
#include "commands/ReportParts.h"
#include "files/Suffix.h"
#include "input/ReadInput.h"
#include "input/Table.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/Progress.h"
#include "program/Stopwatch.h"
#include "program/Threads.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberProbe.h"

#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace
{

/// The points asked about, and the table that they come from, if they come from one.
struct Queries
{
  std::optional<Table> table;
  vtkSmartPointer<vtkPointSet> points;
};

/// The names of the arrays that a probe adds, which are columns in a table.
std::vector<std::string> resultNames(const Options& options)
{
  std::vector<std::string> names = {options.array, "Inside"};
  if (options.distance)
  {
    names.push_back("SignedDistance");
  }
  return names;
}

/// Throws Failure for queries that have columns of such names.
void checkColumns(const std::function<bool(const std::string&)>& isColumn, const Options& options)
{
  for (const std::string& name : resultNames(options))
  {
    if (isColumn(name))
    {
      throw Failure(REFUSED, options.queries,
        "already has a column " + name + "; rename or remove it, or use --array");
    }
  }
}

/// Adds the columns of a table to its points as arrays, but for the coordinates.
void addColumns(const Table& table, vtkDataSet* points)
{
  for (std::size_t column = 0; column < table.columns(); ++column)
  {
    const std::string& name = table.name(column);
    if (name == "x" || name == "y" || name == "z")
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> array;
    if (table.isNumeric(column))
    {
      vtkNew<vtkDoubleArray> numbers;
      for (const double value : table.numbers(column))
      {
        numbers->InsertNextValue(value);
      }
      array = numbers;
    }
    else
    {
      vtkNew<vtkStringArray> texts;
      for (const std::string& text : table.texts(column))
      {
        texts->InsertNextValue(text);
      }
      array = texts;
    }
    array->SetName(name.c_str());
    points->GetPointData()->AddArray(array);
  }
}

Queries readQueries(const Options& options, Messages& messages)
{
  Queries queries;
  if (isTable(options.queries))
  {
    queries.table.emplace(options.queries);
    checkColumns(
      [&](const std::string& name) { return queries.table->find(name).has_value(); }, options);
    queries.points = queries.table->points();
    if (!isTable(options.output))
    {
      addColumns(*queries.table, queries.points);
    }
  }
  else
  {
    if (isTable(options.output))
    {
      checkColumns(
        [](const std::string& name) { return name == "x" || name == "y" || name == "z"; }, options);
    }
    queries.points = readInput(options.queries, messages);
  }
  return queries;
}

/// A number with 17 significant digits, with which every double comes back with the same bits.
std::string exact(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A name as a field of a table: in quotes where readers would take it apart or trim it otherwise.
std::string asField(const std::string& name, char separator)
{
  const bool isPlain = name.find(separator) == std::string::npos &&
                       name.find('"') == std::string::npos && name.front() != ' ' &&
                       name.back() != ' ';
  if (isPlain)
  {
    return name;
  }
  std::string field = "\"";
  for (const char c : name)
  {
    field += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return field + "\"";
}

/// Writes the rows that came in unchanged, or the coordinates of points that came in otherwise,
/// with a column more for each result: all of them, or with --extract those that are inside.
void writeTable(
  const Queries& queries, vtkWindingNumberProbe& probe, const Options& options, OutputFile& file)
{
  vtkDataSet* answer = probe.GetOutput();
  const char own = suffixOf(file.name()) == ".tsv" ? '\t' : ',';
  const char separator = queries.table ? queries.table->separator() : own;
  const char* lineEnd = queries.table ? queries.table->lineEnd() : "\n";
  if (separator != own)
  {
    throw Failure(REFUSED, file.name(),
      "the columns of the queries are kept as they are; give it their suffix " +
        suffixOf(options.queries));
  }
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  stream << (queries.table ? std::string(queries.table->header())
                           : std::string("x") + separator + "y" + separator + "z");
  std::vector<vtkDataArray*> results;
  for (const std::string& name : resultNames(options))
  {
    results.push_back(answer->GetPointData()->GetArray(name.c_str()));
    stream << separator << asField(name, separator);
  }
  stream << lineEnd;
  for (vtkIdType i = 0; i < answer->GetNumberOfPoints(); ++i)
  {
    if (options.extract && !probe.IsInside(i))
    {
      continue;
    }
    if (queries.table)
    {
      stream << queries.table->row(static_cast<std::size_t>(i));
    }
    else
    {
      double point[3];
      answer->GetPoint(i, point);
      stream << exact(point[0]) << separator << exact(point[1]) << separator << exact(point[2]);
    }
    for (vtkDataArray* result : results)
    {
      stream << separator << exact(result->GetTuple1(i));
    }
    stream << lineEnd;
  }
  stream.close();
  if (!stream)
  {
    file.refuseWriting();
  }
}

void printReport(const Options& options, vtkWindingNumberProbe& probe, vtkIdType queries,
  double readSeconds, double totalSeconds)
{
  vtkIdType taken = 0;
  for (vtkIdType i = 0; i < queries; ++i)
  {
    taken += probe.IsInside(i);
  }
  const char* const side = options.insideOut ? "outside" : "inside";
  const double prepare = probe.GetPrepareSeconds(), evaluate = probe.GetEvaluateSeconds();
  const Json report = {{"input", describeInput(options.input, probe)},
    {"method", probe.GetMethodUsed()}, {"why", probe.GetMethodReason()},
    {"tolerance", options.tolerance},
    {"expected", {{"seconds", probe.GetExpectedSeconds()}, {"memory", probe.GetExpectedMemory()}}},
    {"queries", {{"file", options.queries}, {"count", queries}, {side, taken}}},
    {"output", {{"file", options.output}}},
    {"seconds", {{"read", readSeconds}, {"prepare", prepare}, {"evaluate", evaluate},
                  {"write", std::max(0.0, totalSeconds - readSeconds - prepare - evaluate)},
                  {"total", totalSeconds}}},
    {"peak_memory", peakMemory()}, {"threads", threadsUsed(options.threads)}};
  if (options.json)
  {
    print(report);
  }
  else if (!options.quiet)
  {
    print(options.input + ": method " + probe.GetMethodUsed() + " (" + probe.GetMethodReason() +
          "), " + std::to_string(queries) + " queries, " + std::to_string(taken) + " " + side +
          ", " + shown(totalSeconds, 3) + " s\nwrote " + options.output);
  }
}

} // namespace

void runProbe(const Options& options, Messages& messages)
{
  const Stopwatch stopwatch;
  OutputFile output(options.output, filesToKeep(options));
  const Queries queries = readQueries(options, messages);
  const auto source = readInput(options.input, messages);
  const double readSeconds = stopwatch.seconds();

  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputDataObject(queries.points);
  probe->SetSourceData(source);
  applyMethod(options, probe);
  probe->GenerateInsideOn();
  probe->SetOutputScalarTypeToDouble();
  probe->SetInsideOut(options.insideOut);
  probe->SetExtractInside(
    options.extract && !isTable(options.output)); // writeTable() extracts rows
  {
    const Progress progress(probe, "probe", messages.isQuiet());
    probe->Update();
  }
  checkFilter(
    probe->GetStatus(), probe->GetQueriesWereRefused() ? options.queries : options.input, messages);
  warnOfIdleOptions(options, *probe, messages);
  if (isTable(options.output))
  {
    writeTable(queries, *probe, options, output);
  }
  else
  {
    writePoints(vtkPointSet::SafeDownCast(probe->GetOutput()), output, messages);
  }
  output.commit();
  printReport(
    options, *probe, queries.points->GetNumberOfPoints(), readSeconds, stopwatch.seconds());
}
