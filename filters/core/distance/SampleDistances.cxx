#include "distance/SampleDistances.h"

#include "base/BucketSort.h"
#include "distance/NearestLists.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace winding
{

namespace
{

/// Samples are searched for one by one if there are fewer than one for so many items: lists for
/// samples that are so far from each other are long. Lists take twice as long as searches for
/// 10 000 random samples of 70 000 triangles, and two thirds as long for 100 000 (measured).
constexpr std::size_t itemsPerSample = 4;

/// Cells of this size are evaluated, unless their lists are long.
constexpr std::size_t samplesPerCell = 64;

/// Lists with more items than this for each sample are too long: the cell is cut further, down to
/// so few samples that they are searched for one by one.
constexpr std::size_t mostItemsPerSample = 64, fewSamples = 8;

/// A bucket has about so many samples, and makes a task.
constexpr std::size_t samplesPerBucket = 4096;

/// A task leaves its rest to other tasks after so many samples times items, which take some tenths
/// of a second.
constexpr double mostWorkPerTask = 1 << 28;

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

/// Samples that are still to be done: a part of a bucket.
struct Piece
{
  Place* first;
  Place* last;
};

/// The way from a piece down to its samples. Each task has its own, which holds the task's lists.
class Descent
{
public:
  Descent(const DistanceTree& tree, const FieldOutput& output)
    : tree_(tree)
    , output_(output)
    , lists_(tree, output.distanceLimit * tree.scale())
  {
  }

  /// Goes the way, and returns the pieces that it left undone.
  std::vector<Piece> run(const Piece& piece)
  {
    if (piece.first != piece.last)
    {
      this->descend(piece, 0, nullptr);
    }
    return std::move(left_);
  }

  /// Searches for the nearest item of a sample, from one that may be near.
  double searched(const Eigen::Vector3d& position, const NearestLists::SourcePoint* nearby) const
  {
    const double limit = output_.distanceLimit * tree_.scale();
    Nearest nearest = {limit * limit, {0, 0, 0}};
    if (!tree_.empty())
    {
      if (nearby)
      {
        tree_.compare(position, nearby->item, nearest);
      }
      tree_.findNearest(position, 0, nearest);
    }
    return nearest.squared;
  }

  void write(double squared, std::size_t sample) const
  {
    output_.writeDistance(std::sqrt(squared) / tree_.scale(), sample);
  }

private:
  using Cell = NearestLists::Cell;

  void descend(const Piece& piece, std::size_t firstNode, const NearestLists::SourcePoint* nearby)
  {
    if (work_ + lists_.work() > mostWorkPerTask && hasEvaluated_)
    {
      left_.push_back(piece);
      return;
    }
    Bounds box;
    for (const Place* place = piece.first; place != piece.last; ++place)
    {
      box.extend(place->position);
    }
    Cell cell;
    cell.low = box.min();
    cell.high = box.max();
    const auto samples = static_cast<std::size_t>(piece.last - piece.first);
    const bool isSmall = samples <= samplesPerCell || cell.low == cell.high;
    const std::size_t lastNode = lists_.size();
    lists_.append(cell, firstNode, nearby, isSmall);
    const bool isLong = isSmall && lists_.itemsFrom(lastNode) > mostItemsPerSample * samples;
    if (isLong && samples <= fewSamples)
    {
      this->searchEach(piece, cell);
    }
    else if (lists_.size() == lastNode || (isSmall && !isLong) || cell.low == cell.high)
    {
      this->evaluate(piece, cell, lastNode);
    }
    else
    {
      this->cut(piece, box, isSmall ? 1 : 3, cell, lastNode);
    }
    lists_.removeFrom(lastNode);
  }

  /// Halves a piece across the longest side of its box, some times over.
  void cut(
    const Piece& piece, const Bounds& box, int times, const Cell& cell, std::size_t firstNode)
  {
    const auto samples = static_cast<std::size_t>(piece.last - piece.first);
    if (times == 0 || samples <= fewSamples)
    {
      this->descend(piece, firstNode, &cell.nearest);
      return;
    }
    int axis;
    box.sizes().maxCoeff(&axis);
    Place* const middle = piece.first + (piece.last - piece.first) / 2;
    std::nth_element(piece.first, middle, piece.last,
      [axis](const Place& a, const Place& b) { return a.position[axis] < b.position[axis]; });
    const double at = middle->position[axis];
    Eigen::Vector3d low = box.min(), high = box.max();
    low[axis] = high[axis] = at;
    this->cut({piece.first, middle}, Bounds(box.min(), high), times - 1, cell, firstNode);
    this->cut({middle, piece.last}, Bounds(low, box.max()), times - 1, cell, firstNode);
  }

  void searchEach(const Piece& piece, const Cell& cell)
  {
    hasEvaluated_ = true;
    for (const Place* place = piece.first; place != piece.last; ++place)
    {
      this->write(this->searched(place->position, &cell.nearest), place->sample);
    }
  }

  /// Writes the distances from what the list of leaves from firstNode on holds: nothing where all
  /// of the source is beyond the limit.
  void evaluate(const Piece& piece, const Cell& cell, std::size_t firstNode)
  {
    hasEvaluated_ = true;
    const std::vector<NearItems>& kept = lists_.nearItems(cell, firstNode);
    if (cell.low == cell.high)
    {
      this->evaluateEqual(piece, kept);
      return;
    }
    for (const NearItems& run : kept)
    {
      work_ += static_cast<double>(piece.last - piece.first) * (run.last - run.first);
    }
    SampleBlock block;
    alignas(64) double squared[SampleBlock::capacity];
    for (const Place* first = piece.first; first != piece.last; first += block.count)
    {
      block.count = std::min(static_cast<std::size_t>(piece.last - first), SampleBlock::capacity);
      std::fill_n(squared, SampleBlock::capacity, std::numeric_limits<double>::infinity());
      for (std::size_t n = 0; n < block.count; ++n)
      {
        block.set(n, first[n].position);
      }
      tree_.lowerSquaredDistances(kept, block, squared);
      for (std::size_t n = 0; n < block.count; ++n)
      {
        this->write(squared[n], first[n].sample);
      }
    }
  }

  /// Writes the distance of samples at one place, found once: there may be any number of them.
  void evaluateEqual(const Piece& piece, const std::vector<NearItems>& kept) const
  {
    SampleBlock block;
    alignas(64) double squared[SampleBlock::capacity];
    std::fill_n(squared, SampleBlock::capacity, std::numeric_limits<double>::infinity());
    block.count = 1;
    block.set(0, piece.first->position);
    tree_.lowerSquaredDistances(kept, block, squared);
    for (const Place* place = piece.first; place != piece.last; ++place)
    {
      this->write(squared[0], place->sample);
    }
  }

  const DistanceTree& tree_;
  const FieldOutput& output_;
  NearestLists lists_;
  double work_ = 0;           ///< samples times items of the cells evaluated so far
  bool hasEvaluated_ = false; ///< true after the first cell, so that every task gets on
  std::vector<Piece> left_;
};

bool searchAll(const DistanceTree& tree, const VectorsView& samples, const FieldOutput& output,
  Executor& executor)
{
  constexpr std::size_t samplesPerBlock = 256;
  return executor.run((samples.size() + samplesPerBlock - 1) / samplesPerBlock,
    [&](std::size_t block)
    {
      const Descent descent(tree, output);
      const std::size_t first = block * samplesPerBlock;
      const std::size_t last = std::min(samples.size(), first + samplesPerBlock);
      for (std::size_t n = first; n < last; ++n)
      {
        const Eigen::Vector3d sample = samples[n];
        descent.write(sample.allFinite() ? descent.searched(scaled(sample, tree.scale()), nullptr)
                                         : std::numeric_limits<double>::quiet_NaN(),
          n);
      }
    });
}

} // namespace

bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor)
try
{
  const std::size_t items = tree.empty() ? 0 : tree.node(0).size();
  if (items == 0 || samples.size() < std::max(items / itemsPerSample, samplesPerBucket))
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
  std::vector<Piece> pieces(buckets.count());
  for (std::size_t bucket = 0; bucket < pieces.size(); ++bucket)
  {
    pieces[bucket] = {places.begin(bucket), places.end(bucket)};
  }
  for (bool isFirst = true; !pieces.empty(); isFirst = false)
  {
    std::vector<std::vector<Piece>> left(pieces.size());
    const auto work = [&](std::size_t n)
    {
      left[n] = Descent(tree, output).run(pieces[n]);
    };
    // Pieces that were left run without showing progress, which would begin again.
    const bool complete =
      isFirst ? executor.run(pieces.size(), work) : executor.runBriefly(pieces.size(), work);
    if (!complete)
    {
      return false;
    }
    pieces.clear();
    for (const std::vector<Piece>& some : left)
    {
      pieces.insert(pieces.end(), some.begin(), some.end());
    }
  }
  return true;
}
catch (const Interrupted&)
{
  return false;
}

} // namespace winding
