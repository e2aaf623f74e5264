#include "BenchTools.h"

#include "Failure.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "ReadInput.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Refusal.h"
#include "base/Views.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <ctime>
#include <random>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

/// Seconds that are worth spending on a whole grid.
constexpr double longTime = 2;

void evaluateAt(
  const winding::Field& field, const std::vector<double>& samples, winding::Executor& executor)
{
  std::vector<float> values(samples.size() / 3);
  winding::FieldOutput output;
  output.values = values.data();
  field.evaluate(winding::VectorsView(samples.data(), values.size()), output, executor);
  interrupt::check();
}

} // namespace

bool ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& work)
{
  const vtkIdType last = static_cast<vtkIdType>(count);
  const auto workOn = [&work](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end && !interrupt::requested(); ++block)
    {
      work(static_cast<std::size_t>(block));
    }
  };
  if (threads_ == 1)
  {
    workOn(0, last); // no thread but the caller's, and nothing to start
    return !interrupt::requested();
  }
  const auto onThreads = [&]
  {
    vtkSMPTools::For(0, last, std::max<vtkIdType>(1, last / 256), workOn);
  };
  if (threads_ == 0)
  {
    onThreads();
  }
  else
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads_), onThreads);
  }
  return !interrupt::requested();
}

winding::Grid benchGrid(const winding::Bounds& bounds, int resolution)
{
  winding::GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = resolution;
  return winding::layOutGrid(request);
}

std::string sizeOf(const winding::Grid& grid)
{
  return std::to_string(grid.dimensions[0]) + " x " + std::to_string(grid.dimensions[1]) + " x " +
         std::to_string(grid.dimensions[2]);
}

void forEachMesh(const Options& options, std::size_t firstSubject, Messages& messages,
  const std::function<void(const std::string& file, const Triangles& triangles)>& measure)
{
  for (std::size_t i = firstSubject; i < options.subjects.size(); ++i)
  {
    const std::string& file = options.subjects[i];
    const Triangles triangles = trianglesOf(readInput(file, options, messages));
    messages.throwIfError(file);
    if (triangles.triangles() == 0)
    {
      throw Failure(REFUSED, file, "has no triangles; bench compares the methods for surfaces");
    }
    try
    {
      measure(file, triangles);
    }
    catch (const winding::Refusal& refusal)
    {
      throw Failure(REFUSED, file, refusal.what());
    }
  }
}

vtkSmartPointer<vtkPolyData> polyDataOf(const Triangles& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(triangles.points()));
  for (std::size_t i = 0; i < triangles.points(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &triangles.coordinates[3 * i]);
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < triangles.triangles(); ++i)
  {
    const std::int64_t* const ids = &triangles.ids[3 * i];
    cells->InsertNextCell({ids[0], ids[1], ids[2]});
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

std::unique_ptr<float[]> freshArray(std::size_t size)
{
#ifdef __GLIBC__
  // Else what was freed before, and has been touched, would be used again.
  malloc_trim(0);
#endif
  return std::unique_ptr<float[]>(new float[size]);
}

double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double secondsToFill(std::size_t samples)
{
  double best = 0;
  for (int run = 0; run < 5; ++run)
  {
    const std::unique_ptr<float[]> values = freshArray(samples);
    const double seconds = secondsOf(
      [&]
      {
        std::fill_n(values.get(), samples, 1.0f);
        volatile float* written = values.get(); // or nobody would need them
        written[samples / 2] = 0;
      },
      1);
    best = run == 0 ? seconds : std::min(best, seconds);
    interrupt::check();
  }
  return best;
}

std::vector<double> randomSamples(const winding::Grid& grid, std::size_t count)
{
  std::mt19937_64 random(20260101);
  std::vector<double> samples;
  samples.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Eigen::Vector3i index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = std::uniform_int_distribution<int>(0, grid.dimensions[axis] - 1)(random);
    }
    const Eigen::Vector3d sample = grid.sample(index[0], index[1], index[2]);
    samples.insert(samples.end(), sample.data(), sample.data() + 3);
  }
  return samples;
}

double scaledSeconds(
  const winding::Grid& grid, const std::function<void(const Eigen::Vector3d& sample)>& work)
{
  const std::vector<double> samples = randomSamples(grid, 4096);
  std::size_t next = 0;
  double best = 0;
  for (int round = 0; round < 3; ++round)
  {
    const Stopwatch stopwatch;
    std::size_t done = 0;
    double seconds = 0;
    while (seconds < 0.1)
    {
      for (int i = 0; i < 4; ++i, ++done)
      {
        work(Eigen::Vector3d(&samples[3 * (next++ % 4096)]));
      }
      interrupt::check();
      seconds = stopwatch.total();
    }
    const double perSample = seconds / static_cast<double>(done);
    best = round == 0 ? perSample : std::min(best, perSample);
  }
  return best * static_cast<double>(winding::sampleCount(grid.wholeExtent()));
}

Measurement measure(
  const std::function<std::shared_ptr<const winding::Field>(winding::Executor&)>& build,
  const winding::Grid& grid, int threads)
{
  Measurement result;
  ThreadExecutor executor(threads);
  result.prepare = secondsOf(
    [&]
    {
      result.field = build(executor);
      result.field->prepare(grid, executor);
    });
  interrupt::check();

  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const winding::Method method = result.field->info().method;
  if (method == winding::Method::direct || method == winding::Method::parity)
  {
    std::size_t few = std::min<std::size_t>(samples, 1024);
    double perSample =
      secondsOf(
        [&, some = randomSamples(grid, few)] { evaluateAt(*result.field, some, executor); }, 2) /
      static_cast<double>(few);
    if (perSample * static_cast<double>(samples) > longTime)
    {
      few = std::clamp(static_cast<std::size_t>(longTime / 4 / perSample), few, samples);
      const std::vector<double> some = randomSamples(grid, few);
      perSample =
        secondsOf([&] { evaluateAt(*result.field, some, executor); }, 3) / static_cast<double>(few);
      result.evaluate = perSample * static_cast<double>(samples);
      result.isScaled = true;
      return result;
    }
  }
  const Stopwatch all;
  for (int run = 0; run < 5 && (run == 0 || all.total() < longTime); ++run)
  {
    result.values = nullptr; // the old array must go before the new one comes
    result.values = freshArray(samples);
    winding::FieldOutput output;
    output.values = result.values.get();
    const double start = processorSeconds();
    const double seconds =
      secondsOf([&] { result.field->evaluate(grid, grid.wholeExtent(), output, executor); }, 1);
    const double onProcessors = processorSeconds() - start;
    interrupt::check();
    result.evaluate = run == 0 ? seconds : std::min(result.evaluate, seconds);
    result.evaluateOnProcessors =
      run == 0 ? onProcessors : std::min(result.evaluateOnProcessors, onProcessors);
  }
  return result;
}

winding::Verification verified(
  const Measurement& measured, const winding::Grid& grid, std::size_t samples)
{
  const winding::Extent extent = grid.wholeExtent();
  ThreadExecutor executor;
  const winding::Verification found = winding::verify(
    *measured.field, grid, extent,
    [&](std::size_t n) -> double
    {
      if (measured.values)
      {
        return measured.values[n];
      }
      const Eigen::Vector3i index = winding::sampleIndex(extent, n);
      const Eigen::Vector3d sample = grid.sample(index[0], index[1], index[2]);
      float value = 0;
      winding::FieldOutput output;
      output.values = &value;
      winding::SerialExecutor serial;
      measured.field->evaluate(winding::VectorsView(sample.data(), 1), output, serial);
      return value;
    },
    samples, 20260101, executor);
  interrupt::check();
  return found;
}
