#include "distance/SampleDistances.h"

#include "distance/CellDescent.h"
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

/// Searches for what is nearest to each sample, and leaves some parts undone (OrderedSearch.h).
/// Returns false when the executor was interrupted.
bool searchInOrder(const DistanceTree& tree, double limit, const PlaceSamples& samples,
  Parts& parts, Executor& executor)
{
  std::vector<Parts> left(parts.size());
  const bool isComplete = executor.run(parts.size(),
    [&](std::size_t n) { left[n] = OrderedSearch(tree, limit, samples).run(parts[n]); });
  parts = joined(left);
  return isComplete;
}

} // namespace

bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor)
try
{
  const double limit = output.distanceLimit * tree.scale();
  Buckets<Place> buckets =
    sortIntoBuckets(samples, tree.scale(), samplesPerTask(samples.size()), executor);
  const PlaceSamples places(tree.scale(), output);
  Parts parts(buckets.count());
  for (std::size_t bucket = 0; bucket < parts.size(); ++bucket)
  {
    parts[bucket] = {buckets.begin(bucket), buckets.end(bucket)};
  }
  PlaceSamples::forEach(parts.back(), [&](const Eigen::Vector3d&, std::size_t sample)
    { output.writeDistance(std::numeric_limits<double>::quiet_NaN(), sample); });
  parts.pop_back();

  const bool areSparse = !tree.empty() && samples.size() < tree.node(0).size();
  if (areSparse && !searchInOrder(tree, limit, places, parts, executor))
  {
    return false;
  }
  const auto progress = areSparse ? TaskProgress::hidden : TaskProgress::shown;
  return evaluateByCells(tree, limit, places, std::move(parts), executor, progress);
}
catch (const Interrupted&)
{
  return false;
}

} // namespace winding
