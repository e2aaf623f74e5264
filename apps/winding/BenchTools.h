#pragma once

#include "Report.h"
#include "Triangles.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "field/Field.h"
#include "level/Verify.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class Messages;
class vtkPolyData;
struct Options;

/**
 * @file
 * What the measurements have in common. Times are the least of several runs: what else the machine
 * does only adds to them. An interrupt ends them with a Failure.
 */

/// Runs the core's blocks on the program's threads, all or so many of them.
class ThreadExecutor final : public winding::Executor
{
public:
  explicit ThreadExecutor(int threads = 0)
    : threads_(threads)
  {
  }
  bool run(std::size_t count, const std::function<void(std::size_t)>& work) override;

private:
  int threads_;
};

/// An array whose pages are touched for the first time when it is written, as in a program that makes
/// one field.
std::unique_ptr<float[]> freshArray(std::size_t size);

/// Calls measure(file, triangles) for each file from a subject on. Throws Failure for one without
/// triangles, and where measure() throws Refusal.
void forEachMesh(const Options& options, std::size_t firstSubject, Messages& messages,
  const std::function<void(const std::string& file, const Triangles& triangles)>& measure);

/// The triangles as a new data set.
vtkSmartPointer<vtkPolyData> polyDataOf(const Triangles& triangles);

/// Seconds that work() takes: the least of up to `runs` runs, fewer where they take long together.
template <class Work> double secondsOf(const Work& work, int runs = 5)
{
  double best = 0;
  const Stopwatch all;
  for (int run = 0; run < runs && (run == 0 || all.total() < 2); ++run)
  {
    const Stopwatch one;
    work();
    const double seconds = one.total();
    best = run == 0 ? seconds : std::min(best, seconds);
  }
  return best;
}

/// Seconds that processors have spent on this program.
double processorSeconds();

/// Seconds that one call of work() takes on one processor, and be they few nanoseconds: what else the
/// machine does has no part in them.
template <class Work> double secondsOfOne(const Work& work)
{
  const auto secondsOfMany = [&work](std::size_t calls)
  {
    const double start = processorSeconds();
    for (std::size_t i = 0; i < calls; ++i)
    {
      work();
    }
    return processorSeconds() - start;
  };
  constexpr double worthTiming = 2e-4;
  std::size_t calls = 1;
  double best = secondsOfMany(calls);
  while (best < worthTiming)
  {
    calls *= 2;
    best = secondsOfMany(calls);
  }
  const Stopwatch all;
  for (int run = 0; run < 20 && all.total() < 0.5; ++run)
  {
    best = std::min(best, secondsOfMany(calls));
  }
  return best / static_cast<double>(calls);
}

/// The surfaces' grid: cubic voxels with a margin of a twentieth.
winding::Grid benchGrid(const winding::Bounds& bounds, int resolution);

/// Its dimensions, for tables.
std::string sizeOf(const winding::Grid& grid);

/// Seconds to write a constant to a fresh array of so many floats, by one thread.
double secondsToFill(std::size_t samples);

/// Positions of random samples of a grid, x y z for each.
std::vector<double> randomSamples(const winding::Grid& grid, std::size_t count);

/// Seconds that one thread would take for the whole grid by work(sample), found from random samples
/// of it in about a third of a second.
double scaledSeconds(
  const winding::Grid& grid, const std::function<void(const Eigen::Vector3d& sample)>& work);

/// One method on one grid.
struct Measurement
{
  std::shared_ptr<const winding::Field> field;
  double prepare = 0;
  double evaluate = 0;
  double evaluateOnProcessors = 0; ///< seconds of all threads together; 0 if it is scaled
  /// Whether evaluate comes from random samples, because all of them would have taken long.
  bool isScaled = false;
  std::unique_ptr<float[]> values; ///< none if it does
};

/// threads: 0 for all. Throws Refusal as Field::build() does.
Measurement measure(
  const std::function<std::shared_ptr<const winding::Field>(winding::Executor&)>& build,
  const winding::Grid& grid, int threads = 0);

/// Errors at so many random samples, and as many near the surface.
winding::Verification verified(
  const Measurement& measured, const winding::Grid& grid, std::size_t samples);
