// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/probe/CutDistances.h"

#include "base/Progress.h"
#include "field/Field.h"
#include "pipeline/FreeMemory.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace winding
{

namespace
{

constexpr double bytesPerCutSample = 72;

/// The samples of cells that have both samples that are kept and others.
std::vector<std::size_t> samplesOfCutCells(const ProbeQueries& queries, const unsigned char* kept)
{
  std::vector<unsigned char> isOfCutCell(static_cast<std::size_t>(queries.size()));
  vtkNew<vtkIdList> ids;
  for (const ProbeLeaf& leaf : queries.leaves())
  {
    const unsigned char* const keptHere = kept + leaf.first;
    unsigned char* const found = isOfCutCell.data() + leaf.first;
    const auto isKept = [keptHere](vtkIdType id)
    {
      return keptHere[id] != 0;
    };
    const vtkIdType cells = leaf.data->GetNumberOfCells();
    for (vtkIdType cell = 0; cell < cells; ++cell)
    {
      leaf.data->GetCellPoints(cell, ids);
      if (std::any_of(ids->begin(), ids->end(), isKept) &&
          !std::all_of(ids->begin(), ids->end(), isKept))
      {
        std::for_each(ids->begin(), ids->end(), [found](vtkIdType id) { found[id] = 1; });
      }
    }
  }
  std::vector<std::size_t> samples;
  for (std::size_t i = 0; i < isOfCutCell.size(); ++i)
  {
    if (isOfCutCell[i])
    {
      samples.push_back(i);
    }
  }
  return samples;
}

/// The distances of samples from the end of what is kept, 0 or more.
std::vector<double> distancesAt(
  const VectorsView& samples, const Field& field, const InsideTest& isInside, Executor& executor)
{
  std::vector<double> values(samples.size()), distances(samples.size());
  std::vector<double> gradients;
  FieldOutput output;
  output.doubleValues = values.data();
  output.doubleDistances = distances.data();
  output.isInside = isInside;
  Progress progress(executor);
  const double shareOfDistances = field.info().jumpsOnly() ? 1 : 0.5;
  progress.set(0, shareOfDistances);
  field.evaluate(samples, output, executor);
  if (!field.info().jumpsOnly())
  {
    progress.set(shareOfDistances, 1);
    gradients.resize(3 * samples.size());
    field.gradient(samples, gradients.data(), executor);
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    distances[i] = std::abs(distances[i]);
    const double slope =
      gradients.empty() ? 0 : Eigen::Map<const Eigen::Vector3d>(&gradients[3 * i]).stableNorm();
    if (slope > 0)
    {
      distances[i] = std::min(distances[i], std::abs(isInside.levelOf(values[i])) / slope);
    }
  }
  return distances;
}

} // namespace

std::size_t bytesOfCutDistances(const Field& field, std::size_t samples)
{
  constexpr double samplesPerArea = 4; // an area in squares of the distance between samples
  const double count =
    std::min(samplesPerArea * field.sampledSource(samples).area, static_cast<double>(samples));
  const auto cut = static_cast<std::size_t>(count);
  // Gradients of clouds come through the same hierarchy once more.
  const std::size_t hierarchies = field.info().isSurface ? 1 : 2;
  return hierarchies * field.expectedBytes(cut) + field.expectedBytesOfDistances(cut) +
         static_cast<std::size_t>(bytesPerCutSample * count);
}

std::vector<double> cutDistances(const Field& field, const ProbeQueries& queries,
  const unsigned char* kept, const InsideTest& isInside, Executor& executor)
{
  const auto size = static_cast<std::size_t>(queries.size());
  refuseBeyondFreeMemory(bytesPerSampleOfCuts * static_cast<double>(size),
    "the clip of " + std::to_string(size) + " points", wordsOfClip.remedies);
  const std::vector<std::size_t> cut = samplesOfCutCells(queries, kept);
  refuseBeyondFreeMemory(bytesPerCutSample * static_cast<double>(cut.size()),
    "the clip at " + std::to_string(cut.size()) + " points", wordsOfClip.remedies);
  std::vector<double> positions(3 * cut.size());
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    const Eigen::Vector3d position = queries.position(cut[i]);
    std::copy_n(position.data(), 3, &positions[3 * i]);
  }
  const std::vector<double> distances =
    distancesAt(VectorsView(positions.data(), cut.size()), field, isInside, executor);

  std::vector<double> numbers(size, 1);
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    // Versions of VTK differ in the side of 0. NaN, of samples that are nowhere, becomes 1.
    const double smallest = std::numeric_limits<double>::min();
    const double largest = std::numeric_limits<double>::max();
    numbers[cut[i]] = distances[i] <= largest ? std::max(distances[i], smallest) : 1;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    numbers[i] = kept[i] ? numbers[i] : -numbers[i];
  }
  return numbers;
}

} // namespace winding
