#include "distance/SampleDistances.h"

#include "base/BucketSort.h"
#include "distance/CellDescent.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace winding
{

namespace
{

/// A bucket has about so many samples, and makes a task.
constexpr std::size_t samplesPerBucket = 4096;

/// Fewer samples are searched for one by one, as those in cells lie far from each other.
constexpr std::size_t fewestForCells = 4096;

/// A sample in the tree's coordinates, and its number.
struct Place
{
  Eigen::Vector3d position;
  std::size_t sample;
};

Eigen::Vector3d scaled(const Eigen::Vector3d& sample, double scale)
{
  return {scaledCoordinate(sample[0], scale), scaledCoordinate(sample[1], scale),
    scaledCoordinate(sample[2], scale)};
}

/// Puts places into buckets of about as many samples each, however they are distributed: a k-d tree
/// that is balanced for a few of them.
class PlaceBuckets
{
public:
  PlaceBuckets(const VectorsView& samples, double scale)
  {
    while (this->count() < mostBuckets && samples.size() / this->count() > samplesPerBucket)
    {
      ++depth_;
    }
    constexpr std::size_t perBucket = 16;
    std::vector<Eigen::Vector3d> some;
    const std::size_t step = std::max<std::size_t>(1, samples.size() / (perBucket * this->count()));
    for (std::size_t i = 0; i < samples.size(); i += step)
    {
      if (samples[i].allFinite())
      {
        some.push_back(scaled(samples[i], scale));
      }
    }
    cuts_.resize(this->count());
    this->cut(some.data(), some.data() + some.size(), 1);
  }

  std::size_t count() const { return std::size_t{1} << depth_; }

  std::size_t of(const Eigen::Vector3d& position) const
  {
    std::size_t node = 1;
    for (int i = 0; i < depth_; ++i)
    {
      node = 2 * node + (position[cuts_[node].axis] >= cuts_[node].at);
    }
    return node - this->count();
  }

private:
  /// Positions whose coordinate is less than `at` are on the lower side.
  struct Cut
  {
    double at = 0;
    int axis = 0;
  };

  void cut(Eigen::Vector3d* first, Eigen::Vector3d* last, std::size_t node)
  {
    if (node >= cuts_.size() || first == last)
    {
      return;
    }
    Bounds box;
    std::for_each(first, last, [&box](const Eigen::Vector3d& position) { box.extend(position); });
    int axis;
    box.sizes().maxCoeff(&axis);
    Eigen::Vector3d* const middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
      [axis](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[axis] < b[axis]; });
    cuts_[node] = {(*middle)[axis], axis};
    this->cut(first, middle, 2 * node);
    this->cut(middle, last, 2 * node + 1);
  }

  int depth_ = 0;
  std::vector<Cut> cuts_; ///< from 1 on: the children of node n are 2n and 2n + 1
};

/// Places as CellDescent.h wants them: a part is a range of them, which gets sorted into halves.
class PlaceSamples
{
public:
  struct Part
  {
    Place* first;
    Place* last;
  };
  using Name = std::size_t;

  PlaceSamples(double scale, const FieldOutput& output)
    : scale_(scale)
    , output_(output)
  {
  }

  static std::size_t count(const Part& part)
  {
    return static_cast<std::size_t>(part.last - part.first);
  }

  static Bounds boxOf(const Part& part)
  {
    Bounds box;
    for (const Place* place = part.first; place != part.last; ++place)
    {
      box.extend(place->position);
    }
    return box;
  }

  static bool isAskedFor(const Part& part) { return part.first != part.last; }

  /// Halves a part across the longest side of its box.
  static std::pair<Part, Part> halves(const Part& part)
  {
    int axis;
    boxOf(part).sizes().maxCoeff(&axis);
    Place* const middle = part.first + (part.last - part.first) / 2;
    std::nth_element(part.first, middle, part.last,
      [axis](const Place& a, const Place& b) { return a.position[axis] < b.position[axis]; });
    return {{part.first, middle}, {middle, part.last}};
  }

  template <class Function> static void forEach(const Part& part, const Function& f)
  {
    for (const Place* place = part.first; place != part.last; ++place)
    {
      f(place->position, place->sample);
    }
  }

  void write(double squared, std::size_t sample) const
  {
    output_.writeDistance(std::sqrt(squared) / scale_, sample);
  }

private:
  double scale_;
  const FieldOutput& output_;
};

bool searchAll(const DistanceTree& tree, const VectorsView& samples, const FieldOutput& output,
  Executor& executor)
{
  constexpr std::size_t samplesPerBlock = 256;
  const PlaceSamples places(tree.scale(), output);
  const double limit = output.distanceLimit * tree.scale();
  return executor.run((samples.size() + samplesPerBlock - 1) / samplesPerBlock,
    [&](std::size_t block)
    {
      const std::size_t first = block * samplesPerBlock;
      const std::size_t last = std::min(samples.size(), first + samplesPerBlock);
      for (std::size_t n = first; n < last; ++n)
      {
        const Eigen::Vector3d sample = samples[n];
        Nearest nearest = {limit * limit, {0, 0, 0}};
        if (!sample.allFinite())
        {
          nearest.squared = std::numeric_limits<double>::quiet_NaN();
        }
        else if (!tree.empty())
        {
          tree.findNearest(scaled(sample, tree.scale()), 0, nearest);
        }
        places.write(nearest.squared, n);
      }
    });
}

} // namespace

bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor)
try
{
  if (tree.empty() || samples.size() < fewestForCells)
  {
    return searchAll(tree, samples, output, executor);
  }
  const PlaceBuckets buckets(samples, tree.scale());
  // Samples that are not finite come into a bucket of their own.
  Buckets<Place> places = distribute<Place>(
    samples.size(), buckets.count() + 1,
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t n = first; n < last; ++n)
      {
        const Eigen::Vector3d sample = samples[n];
        const Eigen::Vector3d position = scaled(sample, tree.scale());
        put(sample.allFinite() ? buckets.of(position) : buckets.count(), Place{position, n});
      }
    },
    executor);
  for (const Place* place = places.begin(buckets.count()); place != places.end(buckets.count());
       ++place)
  {
    output.writeDistance(std::numeric_limits<double>::quiet_NaN(), place->sample);
  }
  std::vector<PlaceSamples::Part> parts(buckets.count());
  for (std::size_t bucket = 0; bucket < parts.size(); ++bucket)
  {
    parts[bucket] = {places.begin(bucket), places.end(bucket)};
  }
  return evaluateByCells(tree, output.distanceLimit * tree.scale(),
    PlaceSamples(tree.scale(), output), std::move(parts), executor);
}
catch (const Interrupted&)
{
  return false;
}

} // namespace winding
