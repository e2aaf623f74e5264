#include "input/ReadInput.h"
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/Timing.h"
#include "laboratory/VtkContestants.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Threads.h"

#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <algorithm>

namespace
{

struct Taken
{
  double expected = 0;
  double seconds = 0;
  std::string method;
};

/// Runs filters that make() gives, new ones on a source that is new to them.
template <class Make> Taken taken(const Make& make)
{
  Taken result;
  const auto run = [&]
  {
    const auto filter = make();
    filter->Update();
    result.expected = filter->GetExpectedSeconds();
    result.method = filter->GetMethodUsed();
  };
  result.seconds = secondsOf(run, 3);
  interrupt::check();
  return result;
}

template <class Filter>
vtkSmartPointer<Filter> filterFor(bool withDistances, const BenchOptions& options)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetEstimateNormals(true);
  filter->SetGenerateSignedDistance(withDistances);
  filter->SetNumberOfThreads(options.threads);
  filter->SetLongestExpectedTime(0);
  return filter;
}

void addRow(BenchTable& table, const std::string& samples, bool withDistances, const Taken& run)
{
  table.add({{"samples", samples}, {"arrays", withDistances ? "w, distance" : "w"},
    {"method", run.method}, {"expected s", run.expected}, {"taken s", run.seconds},
    {"expected / taken", run.expected / std::max(run.seconds, 1e-6)}});
}

BenchTable tableOf(const std::string& file, vtkPointSet* source, const BenchOptions& options)
{
  BenchTable table(file + ", " + std::to_string(threadsUsed(options.threads)) + " threads",
    {"expected: what users are told before a field is evaluated; taken: everything from a source "
     "in "
     "memory to the result, the least of three runs",
      "the grids have cubic voxels, so many along the longest side; the points lie in the bounds"});
  for (const bool withDistances : {false, true})
  {
    for (const int resolution : givenOr(options.resolutions, {64, 128, 256, 512}))
    {
      const auto make = [&]
      {
        auto field = filterFor<vtkWindingNumberField>(withDistances, options);
        field->SetInputDataObject(source);
        field->SetResolution(resolution);
        return field;
      };
      addRow(table, "grid of " + std::to_string(resolution), withDistances, taken(make));
    }
    for (const int points : givenOr(options.points, {1000, 10'000, 100'000, 1'000'000}))
    {
      const double* const b = source->GetBounds();
      const winding::Bounds bounds(
        Eigen::Vector3d(b[0], b[2], b[4]), Eigen::Vector3d(b[1], b[3], b[5]));
      const auto queries = randomPoints(bounds, static_cast<std::size_t>(points));
      const auto make = [&]
      {
        auto probe = filterFor<vtkWindingNumberProbe>(withDistances, options);
        probe->SetInputData(queries);
        probe->SetSourceData(source);
        return probe;
      };
      addRow(table, std::to_string(points) + " points", withDistances, taken(make));
    }
  }
  return table;
}

} // namespace

std::vector<BenchTable> benchExpected(const BenchOptions& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  for (const std::string& file : options.files)
  {
    const auto source = readInput(file, messages);
    tables.push_back(tableOf(file, source, options));
    messages.throwIfError(file);
  }
  return tables;
}
