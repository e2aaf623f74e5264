// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/Measurement.h"

#include "laboratory/BenchGrid.h"
#include "laboratory/ThreadExecutor.h"
#include "laboratory/Timing.h"
#include "program/Interrupt.h"
#include "program/Stopwatch.h"

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"

#include <algorithm>
#include <optional>

namespace
{

/// The seconds that a measurement on a whole grid may take.
constexpr double longTime = 2;

/// Evaluates a field at scattered samples, x y z for each.
void evaluateAt(
  const winding::Field& field, const std::vector<double>& samples, winding::Executor& executor)
{
  std::vector<float> values(samples.size() / 3);
  winding::FieldOutput output;
  output.values = values.data();
  field.evaluate(winding::VectorsView(samples.data(), values.size()), output, executor);
  interrupt::check();
}

/// Seconds to evaluate a whole grid, found from random samples of it, if they are more than
/// longTime.
std::optional<double> scaledIfLong(
  const winding::Field& field, const winding::Grid& grid, winding::Executor& executor)
{
  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const auto secondsPerSample = [&](std::size_t count, int runs)
  {
    const std::vector<double> some = randomSamples(grid, count);
    const auto evaluate = [&]
    {
      evaluateAt(field, some, executor);
    };
    return secondsOf(evaluate, runs) / static_cast<double>(count);
  };
  const std::size_t few = std::min<std::size_t>(samples, 1024);
  const double estimate = secondsPerSample(few, 2);
  if (estimate * static_cast<double>(samples) <= longTime)
  {
    return {};
  }
  const auto more = static_cast<std::size_t>(longTime / 4 / estimate);
  return secondsPerSample(std::clamp(more, few, samples), 3) * static_cast<double>(samples);
}

} // namespace

Measurement measure(
  const std::function<std::shared_ptr<const winding::Field>(winding::Executor&)>& build,
  const winding::Grid& grid, int threads)
{
  Measurement result;
  ThreadExecutor executor(threads);
  const auto prepare = [&]
  {
    result.field = build(executor);
    result.field->prepare(grid, executor);
  };
  result.prepare = secondsOf(prepare);
  interrupt::check();

  const winding::Method method = result.field->info().method;
  if (method == winding::Method::direct || method == winding::Method::parity)
  {
    if (const auto seconds = scaledIfLong(*result.field, grid, executor))
    {
      result.evaluate = *seconds;
      result.isScaled = true;
      return result;
    }
  }
  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const Stopwatch all;
  for (int run = 0; run < 5 && (run == 0 || all.seconds() < longTime); ++run)
  {
    result.values = nullptr; // the old array must go before the new one comes
    result.values = freshArray(samples);
    winding::FieldOutput output;
    output.values = result.values.get();
    const double start = processorSeconds();
    const auto evaluate = [&]
    {
      result.field->evaluate(grid, grid.wholeExtent(), output, executor);
    };
    const double seconds = secondsOf(evaluate, 1);
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
  const auto valueOf = [&](std::size_t n) -> double
  {
    if (measured.values)
    {
      return measured.values[n];
    }
    const Eigen::Vector3d sample = grid.sample(n);
    float value = 0;
    winding::FieldOutput output;
    output.values = &value;
    winding::SerialExecutor serial;
    measured.field->evaluate(winding::VectorsView(sample.data(), 1), output, serial);
    return value;
  };
  const winding::Verification found =
    winding::verify(*measured.field, grid, extent, valueOf, samples, 20260101, executor);
  interrupt::check();
  return found;
}
