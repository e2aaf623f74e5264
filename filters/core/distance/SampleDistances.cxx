// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/SampleDistances.h"

#include "distance/CellDescent.h"
#include "distance/NearestLists.h"
#include "distance/OrderedSearch.h"
#include "distance/PlaceBuckets.h"
#include "distance/PlaceSamples.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace winding
{

namespace
{

using Parts = std::vector<PlaceSamples::Part>;

/// The number of samples that make a task: so few that all threads have some to the end, and so
/// many that tasks have little to begin with.
std::size_t samplesPerTask(std::size_t samples)
{
  constexpr std::size_t tasks = 64, fewest = 32, most = 4096;
  return std::clamp(samples / tasks, fewest, most);
}

/// Whether the samples of a part lie so far from each other that the list of what may be nearest to
/// any of them is long compared with their number. A place alone needs no list.
bool areSparse(const DistanceTree& tree, double limit, const PlaceSamples::Part& part)
{
  constexpr std::size_t itemsPerSample = 32;
  NearestCell cell = cellOf(PlaceSamples::boxOf(part));
  if (cell.isOnePlace())
  {
    return true;
  }
  NearestLists lists(tree, limit);
  const std::size_t first = lists.size();
  lists.append(cell, 0, nullptr);
  return lists.itemsFrom(first) > itemsPerSample * PlaceSamples::count(part);
}

} // namespace

namespace
{

/// Writes the distances of samples, or the numbers of what is nearest to them if these are wanted.
void evaluate(const DistanceTree& tree, const VectorsView& samples, const FieldOutput& output,
  const NumberOutput& numbers, Executor& executor)
{
  const double limit = output.distanceLimit * tree.scale();
  Buckets<Place> buckets =
    sortIntoBuckets(samples, tree.scale(), samplesPerTask(samples.size()), executor);
  const PlaceSamples places(tree.scale(), output, numbers);
  Parts parts(buckets.count());
  for (std::size_t bucket = 0; bucket < parts.size(); ++bucket)
  {
    parts[bucket] = {buckets.begin(bucket), buckets.end(bucket)};
  }
  PlaceSamples::forEach(parts.back(), [&](const Eigen::Vector3d&, std::size_t sample)
    { places.write(std::numeric_limits<double>::quiet_NaN(), NearestNumbers::none, sample); });
  parts.pop_back();

  const bool areFew = !tree.empty() && samples.size() < tree.node(0).size();
  std::vector<Parts> left(parts.size());
  const auto work = [&](std::size_t n)
  {
    const PlaceSamples::Part& part = parts[n];
    const bool searches = areFew && places.isAskedFor(part) && areSparse(tree, limit, part);
    left[n] = searches ? OrderedSearch(tree, limit, places).run(part)
                       : CellDescent<PlaceSamples>(tree, limit, places, numbers.numbers).run(part);
  };
  executor.run(parts.size(), work);
  evaluateByCells(
    tree, limit, places, joined(left), executor, TaskProgress::hidden, numbers.numbers);
}

} // namespace

void evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor)
{
  evaluate(tree, samples, output, {}, executor);
}

void findNearestNumbers(const DistanceTree& tree, const VectorsView& samples,
  const NumberOutput& output, Executor& executor)
{
  evaluate(tree, samples, {}, output, executor);
}

std::vector<double> distancesFrom(
  const DistanceTree& tree, const VectorsView& samples, Executor& executor)
{
  std::vector<double> distances(samples.size());
  std::vector<unsigned char> outside(samples.size(), 0); // gives no sample a sign
  FieldOutput output;
  output.doubleDistances = distances.data();
  output.inside = outside.data();
  evaluateDistances(tree, samples, output, executor);
  return distances;
}

} // namespace winding
