#pragma once

#include "Report.h"

#include "Field.h"
#include "Verify.h"

#include <algorithm>
#include <memory>
#include <vector>

/**
 * @file
 * What the measurements have in common. Times are the least of several runs: what else the machine
 * does only adds to them. An interrupt ends them with a Failure.
 */

/// Runs the core's blocks on the program's threads.
class ThreadExecutor final : public winding::Executor
{
public:
  bool run(std::size_t count, const std::function<void(std::size_t)>& work) override;
};

/// Has every large array come fresh from the system, and its pages be touched for the first time
/// when it is written, as in a program that makes one field.
void keepArraysFresh();

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
  /// Whether evaluate comes from random samples, because all of them would have taken long.
  bool isScaled = false;
  std::unique_ptr<float[]> values; ///< none if it does
};

/// Throws Refusal as Field::build() does.
Measurement measure(
  const std::function<std::shared_ptr<const winding::Field>(winding::Executor&)>& build,
  const winding::Grid& grid);

/// Errors at so many random samples, and as many near the surface.
winding::Verification verified(
  const Measurement& measured, const winding::Grid& grid, std::size_t samples);
