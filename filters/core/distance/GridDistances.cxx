#include "distance/GridDistances.h"

#include "distance/NearestLists.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

/// Cells of this size are best: those of 32 and 128 samples take up to twice as long (measured at
/// 128³ and 256³).
constexpr std::size_t samplesPerCell = 64;

/// Lists with more items than this are too long for a small cell, as where many triangles lie
/// between neighbouring samples: it is cut into cells of a few samples, which are searched for one
/// by one if their lists are as long. A scene of 247 000 triangles takes 0.7 s at 128 samples along
/// its longest side instead of 1.1 s; with 512 items it takes as long, but finer grids take a
/// twentieth longer (measured).
constexpr std::size_t mostItems = 2048, fewSamples = 8;

/// Blocks of this size make several tasks of small grids, too. Blocks of 512 samples take up to a
/// fifth longer (measured).
constexpr double samplesPerBlock = 4096;

/// A task leaves its rest to other tasks after so many samples times items. These begin with the
/// lists of the block again, so that a smaller number would take longer. Where all of a source is
/// equally near, as at the centre of a sphere, tasks take 0.6 s for 80 000 triangles, and 2 s for
/// 300 000.
constexpr double mostWorkPerTask = 1 << 28;

bool isEmpty(const Extent& extent)
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

Extent common(const Extent& a, const Extent& b)
{
  Extent both;
  for (int axis = 0; axis < 3; ++axis)
  {
    both[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

/// The numbers of samples along each axis of blocks that are about cubes: powers of two.
Eigen::Vector3i blockSizeOf(const Grid& grid)
{
  double side = 0; // base-2 logarithm of the cube's side
  int axes = 0;
  double samples = std::log2(samplesPerBlock);
  for (int axis = 0; axis < 3; ++axis)
  {
    side += grid.dimensions[axis] > 1 ? std::log2(grid.spacing[axis]) : 0;
    axes += grid.dimensions[axis] > 1;
  }
  side = (side + samples) / std::max(axes, 1);
  Eigen::Vector3i size = Eigen::Vector3i::Ones();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.dimensions[axis] > 1)
    {
      const double exponent = std::round(side - std::log2(grid.spacing[axis]));
      size[axis] = 1 << static_cast<int>(std::clamp(exponent, 0.0, samples));
    }
  }
  return size;
}

} // namespace

GridDistances::GridDistances(
  const DistanceTree& tree, const Grid& grid, const Extent& extent, const FieldOutput& output)
  : tree_(tree)
  , grid_(grid)
  , extent_(extent)
  , output_(output)
  , blockSize_(blockSizeOf(grid))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    firstBlock_[axis] = extent[2 * axis] / blockSize_[axis];
    blocks_[axis] =
      isEmpty(extent) ? 0 : extent[2 * axis + 1] / blockSize_[axis] - firstBlock_[axis] + 1;
  }
}

/// The samples of a block of the whole grid, whether asked for or not.
Extent GridDistances::samplesOfBlock(std::size_t number) const
{
  const Extent blocks = {0, blocks_[0] - 1, 0, blocks_[1] - 1, 0, blocks_[2] - 1};
  const Eigen::Vector3i first =
    (firstBlock_ + sampleIndex(blocks, number)).cwiseProduct(blockSize_);
  const Eigen::Vector3i last = (first + blockSize_).cwiseMin(grid_.dimensions);
  return {first[0], last[0] - 1, first[1], last[1] - 1, first[2], last[2] - 1};
}

/// The way from a block down to its samples. Each task has its own, which holds the task's lists.
class GridDistances::Descent
{
public:
  explicit Descent(const GridDistances& of, const Piece& piece)
    : of_(of)
    , block_(piece.block)
    , asked_(common(piece.samples, of.extent_))
    , lists_(of.tree_, of.output_.distanceLimit * of.tree_.scale())
  {
  }

  /// Goes the way, and returns the pieces that it left undone.
  std::vector<Piece> run()
  {
    this->descend(of_.samplesOfBlock(block_), 0, nullptr);
    return std::move(left_);
  }

private:
  /// A cell with its first and last samples along each axis.
  struct Cell : NearestLists::Cell
  {
    Extent samples;
  };

  Eigen::Vector3d positionOf(int i, int j, int k) const;
  void descend(
    const Extent& samples, std::size_t firstNode, const NearestLists::SourcePoint* nearby);
  void cut(const Cell& cell, int times, std::size_t enough, std::size_t firstNode);
  void searchEach(const Cell& cell);
  void evaluate(const Cell& cell, std::size_t firstNode);
  bool isAskedFor(const Eigen::Vector3i& index) const;
  void write(double squared, const Eigen::Vector3i& index) const;

  const GridDistances& of_;
  const std::size_t block_;
  const Extent asked_;        ///< samples of the block that are asked for
  double work_ = 0;           ///< samples times items of the cells evaluated so far
  bool hasEvaluated_ = false; ///< true after the first cell, so that every task gets on
  std::vector<Piece> left_;
  NearestLists lists_;
};

Eigen::Vector3d GridDistances::Descent::positionOf(int i, int j, int k) const
{
  const Eigen::Vector3d position = of_.grid_.sample(i, j, k);
  const double scale = of_.tree_.scale();
  return {scaledCoordinate(position[0], scale), scaledCoordinate(position[1], scale),
    scaledCoordinate(position[2], scale)};
}

/// firstNode: where the list of the cell begins that this one lies in; nearby: a point of the
/// source, or null.
void GridDistances::Descent::descend(
  const Extent& samples, std::size_t firstNode, const NearestLists::SourcePoint* nearby)
{
  if (isEmpty(common(samples, asked_)))
  {
    return;
  }
  if (work_ + lists_.work() > mostWorkPerTask && hasEvaluated_)
  {
    left_.push_back({block_, samples});
    return;
  }
  Cell cell;
  cell.samples = samples;
  cell.low = this->positionOf(samples[0], samples[2], samples[4]);
  cell.high = this->positionOf(samples[1], samples[3], samples[5]);
  const std::size_t count = sampleCount(samples);
  const bool isSmall = count <= samplesPerCell;
  const std::size_t lastNode = lists_.size();
  lists_.append(cell, firstNode, nearby, isSmall);
  const bool isLong = isSmall && lists_.itemsFrom(lastNode) > mostItems;
  if (isLong && count <= fewSamples)
  {
    this->searchEach(cell);
  }
  else if ((isSmall && !isLong) || lists_.size() == lastNode)
  {
    this->evaluate(cell, lastNode);
  }
  else
  {
    this->cut(cell, 3, isSmall ? fewSamples : samplesPerCell, lastNode);
  }
  lists_.removeFrom(lastNode);
}

/// Halves a cell along its longest side, some times over, but no part of so few samples that they
/// are enough.
void GridDistances::Descent::cut(
  const Cell& cell, int times, std::size_t enough, std::size_t firstNode)
{
  if (times == 0 || sampleCount(cell.samples) <= enough)
  {
    this->descend(cell.samples, firstNode, &cell.nearest);
    return;
  }
  int longest = 0;
  double length = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int steps = cell.samples[2 * axis + 1] - cell.samples[2 * axis];
    if (steps > 0 && steps * of_.grid_.spacing[axis] > length)
    {
      longest = axis;
      length = steps * of_.grid_.spacing[axis];
    }
  }
  const auto& first = cell.samples[2 * longest];
  const auto& last = cell.samples[2 * longest + 1];
  Cell half = cell;
  half.samples[2 * longest + 1] = first + (last - first) / 2;
  this->cut(half, times - 1, enough, firstNode);
  half.samples[2 * longest + 1] = last;
  half.samples[2 * longest] = first + (last - first) / 2 + 1;
  this->cut(half, times - 1, enough, firstNode);
}

/// Writes the distances of a cell's samples, each found from the point that is nearest to the
/// cell's centre.
void GridDistances::Descent::searchEach(const Cell& cell)
{
  hasEvaluated_ = true;
  const double limit = of_.output_.distanceLimit * of_.tree_.scale();
  const std::size_t count = sampleCount(cell.samples);
  for (std::size_t n = 0; n < count; ++n)
  {
    const Eigen::Vector3i index = sampleIndex(cell.samples, n);
    if (!this->isAskedFor(index))
    {
      continue;
    }
    const Eigen::Vector3d position = this->positionOf(index[0], index[1], index[2]);
    Nearest nearest = {limit * limit, {0, 0, 0}};
    of_.tree_.compare(position, cell.nearest.item, nearest);
    of_.tree_.findNearest(position, 0, nearest);
    this->write(nearest.squared, index);
  }
}

bool GridDistances::Descent::isAskedFor(const Eigen::Vector3i& index) const
{
  return asked_[0] <= index[0] && index[0] <= asked_[1] && asked_[2] <= index[1] &&
         index[1] <= asked_[3] && asked_[4] <= index[2] && index[2] <= asked_[5];
}

void GridDistances::Descent::write(double squared, const Eigen::Vector3i& index) const
{
  of_.output_.writeDistance(
    std::sqrt(squared) / of_.tree_.scale(), sampleNumber(of_.extent_, index));
}

/// Writes the distances of a cell's samples from the nodes that are left: leaves, or none where all
/// of the source is beyond the limit.
void GridDistances::Descent::evaluate(const Cell& cell, std::size_t firstNode)
{
  hasEvaluated_ = true;
  const Extent& s = cell.samples;
  const std::size_t count = sampleCount(s);
  // A few samples are compared with an item as fast as the corners of their cell.
  const std::vector<NearItems>& kept =
    count <= fewSamples ? lists_.items(firstNode) : lists_.nearItems(cell, firstNode);
  SampleBlock block;
  alignas(64) double squared[SampleBlock::capacity];
  for (const NearItems& run : kept)
  {
    work_ += static_cast<double>(count) * (run.last - run.first);
  }
  for (std::size_t first = 0; first < count; first += block.count)
  {
    block.count = std::min(count - first, SampleBlock::capacity);
    std::fill_n(squared, SampleBlock::capacity, std::numeric_limits<double>::infinity());
    for (std::size_t n = 0; !kept.empty() && n < block.count; ++n)
    {
      const Eigen::Vector3i index = sampleIndex(s, first + n);
      block.set(n, this->positionOf(index[0], index[1], index[2]));
    }
    of_.tree_.lowerSquaredDistances(kept, block, squared);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      const Eigen::Vector3i index = sampleIndex(s, first + n);
      if (this->isAskedFor(index))
      {
        this->write(squared[n], index);
      }
    }
  }
}

bool GridDistances::evaluate(Executor& executor) const
{
  std::vector<Piece> pieces(static_cast<std::size_t>(blocks_.cast<std::int64_t>().prod()));
  for (std::size_t number = 0; number < pieces.size(); ++number)
  {
    pieces[number] = {number, this->samplesOfBlock(number)};
  }
  for (bool isFirst = true; !pieces.empty(); isFirst = false)
  {
    std::vector<std::vector<Piece>> left(pieces.size());
    const auto work = [&](std::size_t n)
    {
      left[n] = Descent(*this, pieces[n]).run();
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

} // namespace winding
