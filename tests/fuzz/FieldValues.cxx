// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FieldValues.h"

#include "RandomSources.h"
#include "support/Serial.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace fuzz
{

namespace
{

using shapes::Point;
using shapes::serial;

template <class Evaluate>
FieldValues evaluated(std::size_t samples, bool withDistances, const Evaluate& evaluate)
{
  FieldValues found;
  found.values.assign(samples, std::nan(""));
  found.inside.assign(samples, 7);
  winding::FieldOutput output;
  output.doubleValues = found.values.data();
  output.inside = found.inside.data();
  if (withDistances)
  {
    found.distances.assign(samples, std::nan(""));
    output.doubleDistances = found.distances.data();
  }
  evaluate(output);
  for (std::size_t i = 0; i < samples && found.failure.empty(); ++i)
  {
    const bool isInside = output.isInside(found.values[i]);
    if (found.inside[i] != isInside)
    {
      found.failure = "inside contradicts the value " + std::to_string(found.values[i]);
    }
    if (withDistances && std::signbit(found.distances[i]) != isInside && found.distances[i] != 0)
    {
      found.failure = "the sign of a distance contradicts inside";
    }
  }
  for (double& distance : found.distances)
  {
    distance = std::abs(distance);
  }
  return found;
}

/// Whether two numbers have the same bits, where NaN is NaN.
bool isSame(double a, double b)
{
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): zeros of both signs differ.
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

} // namespace

FieldValues valuesOf(const winding::Field& field, const winding::Grid& grid,
  const winding::Extent& extent, bool withDistances, winding::Executor& executor)
{
  return evaluated(winding::sampleCount(extent), withDistances,
    [&](const winding::FieldOutput& output) { field.evaluate(grid, extent, output, executor); });
}

FieldValues valuesOf(const winding::Field& field, const std::vector<Point>& samples,
  bool withDistances, winding::Executor& executor)
{
  return evaluated(samples.size(), withDistances,
    [&](const winding::FieldOutput& output) { field.evaluate(viewOf(samples), output, executor); });
}

std::vector<Point> samplesOf(const winding::Grid& grid)
{
  std::vector<Point> samples(winding::sampleCount(grid.wholeExtent()));
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    samples[n] = grid.sample(n);
  }
  return samples;
}

std::vector<std::size_t> numbersIn(const winding::Grid& grid, const winding::Extent& extent)
{
  std::vector<std::size_t> numbers(winding::sampleCount(extent));
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    numbers[n] = winding::sampleNumber(grid.wholeExtent(), winding::sampleIndex(extent, n));
  }
  return numbers;
}

winding::VectorsView viewOf(const std::vector<Point>& samples)
{
  return {samples.empty() ? nullptr : samples[0].data(), samples.size()};
}

std::string compare(const std::string& what, const std::vector<Point>& samples,
  const std::vector<double>& values, const std::vector<double>& expected,
  const std::function<double(std::size_t)>& mayDiffer)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double most = mayDiffer(i);
    const double difference = std::abs(values[i] - expected[i]);
    if (!(difference <= most) || !std::isfinite(values[i]))
    {
      std::ostringstream text;
      text.precision(17);
      text << what << " gives " << values[i] << ", not " << expected[i] << " within " << most
           << ", at sample " << i << " (" << samples[i].transpose() << ")";
      return text.str();
    }
  }
  return {};
}

std::string checkBits(Choices& choices, const winding::Field& field, const winding::Grid& grid,
  const FieldValues& onGrid, const std::vector<Point>& samples, const FieldValues& atSamples)
{
  const std::string name = nameOf(field.info().method);
  BackwardExecutor backward;
  const bool withDistances = !onGrid.distances.empty();
  const winding::Extent extent = randomExtent(choices, grid);
  const FieldValues piece = valuesOf(field, grid, extent, withDistances, backward);
  const std::vector<std::size_t> numbers = numbersIn(grid, extent);
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    if (!isSame(piece.values[n], onGrid.values[numbers[n]]))
    {
      return name + " gives other bits for a piece of the grid";
    }
    if (withDistances && !isSame(piece.distances[n], onGrid.distances[numbers[n]]))
    {
      return "distances have other bits for a piece of the grid";
    }
  }
  const FieldValues again = valuesOf(field, samples, withDistances, backward);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!isSame(again.values[i], atSamples.values[i]))
    {
      return name + " gives other bits for samples in another order of blocks";
    }
  }
  if (field.info().method == winding::Method::hierarchical || samples.empty())
  {
    return {};
  }
  // Open surfaces by method rows may have a far field for scattered samples, whose values depend on
  // the other samples; that of closed ones and of all other methods do not.
  const bool isOpen = field.info().isSurface && field.info().netBoundaryEdges > 0;
  if (field.info().method == winding::Method::rows && isOpen)
  {
    return {};
  }
  const std::size_t alone = choices.below(samples.size());
  const FieldValues single = valuesOf(field, {samples[alone]}, withDistances, backward);
  if (!isSame(single.values[0], atSamples.values[alone]))
  {
    return name + " gives other bits for a sample alone";
  }
  if (withDistances && !isSame(single.distances[0], atSamples.distances[alone]))
  {
    return "the distance of a sample alone has other bits";
  }
  return {};
}

std::string checkShuffled(const winding::Field& shuffled, const winding::Grid& grid,
  const FieldValues& onGrid, const std::vector<Point>& samples, const FieldValues& atSamples)
{
  BackwardExecutor backward;
  const bool withDistances = !onGrid.distances.empty();
  const FieldValues grids = valuesOf(shuffled, grid, grid.wholeExtent(), withDistances, backward);
  const FieldValues others = valuesOf(shuffled, samples, withDistances, backward);
  const auto areSame = [](const std::vector<double>& a, const std::vector<double>& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
  };
  const std::string name = nameOf(shuffled.info().method);
  if (!areSame(grids.values, onGrid.values) || !areSame(grids.distances, onGrid.distances))
  {
    return name + " gives other bits on the grid for the same source shuffled";
  }
  return areSame(others.values, atSamples.values) && areSame(others.distances, atSamples.distances)
           ? std::string()
           : name + " gives other bits at samples for the same source shuffled";
}

std::string checkGradients(const winding::Field& field, const std::vector<Point>& samples)
{
  std::vector<Point> gradients(samples.size());
  field.gradient(viewOf(samples), samples.empty() ? nullptr : gradients[0].data(), serial);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!gradients[i].allFinite())
    {
      std::ostringstream text;
      text.precision(17);
      text << nameOf(field.info().method) << " gives the gradient " << gradients[i].transpose()
           << " at " << samples[i].transpose();
      return text.str();
    }
  }
  return {};
}

std::string checkNonFinite(const winding::Field& field)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<Point> samples = {Point(0, inf, 0), Point(std::nan(""), 0, 0), Point(0, 0, 0)};
  const FieldValues found = valuesOf(field, samples, false, serial);
  std::vector<Point> gradients(samples.size());
  field.gradient(viewOf(samples), gradients[0].data(), serial);
  for (std::size_t i = 0; i < 2; ++i)
  {
    if (!std::isnan(found.values[i]) || !gradients[i].array().isNaN().all())
    {
      return std::string(nameOf(field.info().method)) +
             " gives a value or a gradient at a sample that is not finite";
    }
  }
  return std::isfinite(found.values[2]) ? std::string()
                                        : "a sample among others that are not finite has no value";
}

} // namespace fuzz
