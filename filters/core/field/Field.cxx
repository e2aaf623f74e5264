// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/Field.h"

#include "base/Evaluator.h"
#include "base/Progress.h"
#include "distance/GridDistances.h"
#include "distance/PlaceBuckets.h"
#include "distance/SampleDistances.h"
#include "source/SourceArea.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/**
 * The number of samples in a block of work: many, so that what is done per block costs nothing, but
 * few enough that a block over all primitives ends in a fraction of a second and an interrupt is
 * answered soon.
 */
std::size_t samplesPerBlock(std::size_t primitives)
{
  constexpr std::size_t pairsPerBlock = 100'000'000;
  const std::size_t samples = pairsPerBlock / std::max<std::size_t>(primitives, 1);
  // Multiples of 16 fill the widest vectors.
  return std::clamp<std::size_t>(samples / 16 * 16, 16, SampleBlock::capacity);
}

/// Calls work(block, number of its first sample) for blocks of samples at positionOf(number).
template <class PositionOf, class Work>
void forEachBlock(std::size_t samples, std::size_t blockSize, const PositionOf& positionOf,
  const Work& work, Executor& executor)
{
  executor.run((samples + blockSize - 1) / blockSize,
    [&](std::size_t number)
    {
      const std::size_t first = number * blockSize;
      SampleBlock block;
      block.count = std::min(blockSize, samples - first);
      for (std::size_t i = 0; i < block.count; ++i)
      {
        block.set(i, positionOf(first + i));
      }
      work(block, first);
    });
}

/// Gives NaN to samples that are NaN or infinite, and so at no place, whatever the method. There
/// are `components` values per sample.
void markNonFinite(const SampleBlock& block, std::size_t components, double* values)
{
  for (std::size_t i = 0; i < block.count; ++i)
  {
    if (!std::isfinite(block.x[i]) || !std::isfinite(block.y[i]) || !std::isfinite(block.z[i]))
    {
      std::fill_n(values + components * i, components, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

} // namespace

const char* nameOf(Method method)
{
  switch (method)
  {
  case Method::automatic:
    return "automatic";
  case Method::rows:
    return "rows";
  case Method::hierarchical:
    return "hierarchical";
  case Method::direct:
    return "direct";
  case Method::parity:
    return "parity";
  }
  return "";
}

Field::Field() = default;
Field::~Field() = default;

void Field::prepare(const Grid&, Executor&) const {}

void Field::prepare(const VectorsView&, Executor&) const {}

template <class PositionOf>
void Field::evaluateBlocks(std::size_t samples, const PositionOf& positionOf,
  const FieldOutput& output, Executor& executor) const
{
  const Evaluator& method = this->evaluator();
  forEachBlock(
    samples, samplesPerBlock(this->info().distinct), positionOf,
    [&](const SampleBlock& block, std::size_t first)
    {
      double values[SampleBlock::capacity];
      method.evaluate(block, values);
      markNonFinite(block, 1, values);
      output.write(values, first, block.count);
    },
    executor);
}

void Field::evaluateValues(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  this->evaluateBlocks(
    sampleCount(extent), [&](std::size_t n) { return grid.sample(extent, n); }, output, executor);
}

void Field::evaluateValues(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  this->evaluateBlocks(
    samples.size(), [&](std::size_t n) { return samples[n]; }, output, executor);
}

const Field& Field::turned(Executor& executor) const
{
  const auto& turned = turned_.get([&] { return this->makeTurned(executor); });
  return turned ? *turned : *this;
}

const DistanceTree& Field::distanceTree(Executor& executor) const
{
  return *distanceTree_.get([&] { return this->makeDistanceTree(executor); });
}

void Field::prepareDistances(Executor& executor) const
{
  this->distanceTree(executor);
}

std::vector<double> Field::distances(const VectorsView& samples, Executor& executor) const
{
  return distancesFrom(this->distanceTree(executor), samples, executor);
}

SampledSource Field::sampledSource(std::size_t samples) const
{
  const FieldInfo& info = this->info();
  SampledSource source;
  source.kind = info.isSurface ? Primitive::triangle : Primitive::point;
  source.primitives = info.distinct;
  source.samples = samples;
  const double step = distanceBetweenSamples(info.bounds, samples);
  // Areas beyond the range of doubles come to a finite number of samples, too.
  constexpr double most = 1e15;
  source.area = step > 0 ? std::min(this->area() / step / step, most) : 0;
  return source;
}

std::size_t Field::expectedBytesOfDistances(std::size_t samples) const
{
  const FieldInfo& info = this->info();
  return DistanceTree::bytesFor(info.isSurface, info.distinct) +
         (info.isScattered ? sizeof(Place) * samples : 0);
}

/// Evaluates values first, then distances, whose signs come from the values or sides.
template <class EvaluateValues, class EvaluateDistances>
void Field::evaluateBoth(std::size_t samples, const FieldOutput& output, Executor& executor,
  const EvaluateValues& evaluateValues, const EvaluateDistances& evaluateDistances) const
{
  FieldOutput signedOutput = output;
  signedOutput.added = this->info().added;
  if (!output.hasDistances())
  {
    evaluateValues(signedOutput);
    return;
  }
  std::vector<unsigned char> inside;
  if (!output.values && !output.doubleValues && !output.inside)
  {
    inside.resize(samples);
    signedOutput.inside = inside.data();
  }
  // Rows of a closed surface take no time to speak of.
  const double share = this->integerRows() ? 0.05 : 0.5;
  Progress progress(executor);
  progress.set(0, share);
  evaluateValues(signedOutput);
  progress.set(share, 1);
  evaluateDistances(this->distanceTree(executor), signedOutput);
}

void Field::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  this->evaluateBoth(
    sampleCount(extent), output, executor,
    [&](const FieldOutput& values) { this->evaluateValues(grid, extent, values, executor); },
    [&](const DistanceTree& tree, const FieldOutput& distances)
    { GridDistances(tree, grid, extent, distances).evaluate(executor); });
}

void Field::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  this->evaluateBoth(
    samples.size(), output, executor,
    [&](const FieldOutput& values) { this->evaluateValues(samples, values, executor); },
    [&](const DistanceTree& tree, const FieldOutput& distances)
    { evaluateDistances(tree, samples, distances, executor); });
}

void Field::gradient(const VectorsView& samples, double* gradients, Executor& executor) const
{
  const FieldInfo& info = this->info();
  const GradientEvaluator& method = this->gradientEvaluator();
  forEachBlock(
    samples.size(), samplesPerBlock(info.isSurface ? info.netBoundaryEdges : info.primitives),
    [&](std::size_t n) { return samples[n]; },
    [&](const SampleBlock& block, std::size_t first)
    {
      method.evaluateGradients(block, gradients + 3 * first);
      markNonFinite(block, 3, gradients + 3 * first);
    },
    executor);
}

} // namespace winding
