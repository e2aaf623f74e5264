#include "distance/GridDistances.h"

#include "base/Bounds.h"
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

/// Blocks of this size make several tasks of small grids, too. Blocks of 512 samples take up to a
/// fifth longer (measured).
constexpr double samplesPerBlock = 4096;

/// A task leaves its rest to other tasks after so many samples times items. These begin with the
/// lists of the block again, so that a smaller number would take longer. Where all of a source is
/// equally near, as at the centre of a sphere, tasks take 0.6 s for 80 000 triangles, and 2 s for
/// 300 000.
constexpr double mostWorkPerTask = 1 << 28;

/// An item is compared with this many samples at once; with fewer samples it takes as long.
constexpr double samplesAtOnce = 8;

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
    , limit_(of.output_.distanceLimit * of.tree_.scale())
  {
    if (!of.tree_.empty())
    {
      const Bounds& box = of.tree_.box(0);
      sourceSize_ = box.sizes().norm();
      farthest_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    }
  }

  /// Goes the way, and returns the pieces that it left undone.
  std::vector<Piece> run()
  {
    nodes_.assign(of_.tree_.empty() ? 0 : 1, 0);
    this->descend(of_.samplesOfBlock(block_), 0, nullptr);
    return std::move(left_);
  }

private:
  struct SourcePoint
  {
    Eigen::Vector3d position;
    double rounding;    ///< how far from the source rounding may have put it
    std::uint32_t item; ///< number of the item that it lies on
  };

  /// A cell: its first and last samples along each axis, and the source's point nearest to its
  /// centre.
  struct Cell
  {
    Extent samples;
    Eigen::Vector3d low, high; ///< positions of the first and last samples, scaled
    SourcePoint nearest;
    double squaredReach; ///< at least the square of the distance of `nearest` from any sample

    Eigen::Vector3d center() const { return low + 0.5 * (high - low); }
  };

  Eigen::Vector3d positionOf(int i, int j, int k) const;
  void descend(const Extent& samples, std::size_t firstNode, const SourcePoint* nearby);
  void cut(const Cell& cell, int times, std::size_t firstNode);
  void findNearest(Cell& cell, std::size_t firstNode, const SourcePoint* nearby);
  double roundingOf(const Cell& cell) const;
  void keepNear(const Cell& cell, std::size_t firstNode, std::size_t lastNode);
  bool isBeyond(const Cell& cell, const Bounds& box) const;
  static bool canBeNearest(const Cell& cell, const Bounds& box, double slack);
  void keepNearItems(const Cell& cell);
  void evaluate(const Cell& cell, std::size_t firstNode);

  const GridDistances& of_;
  const std::size_t block_;
  const Extent asked_;        ///< samples of the block that are asked for
  double work_ = 0;           ///< samples times items, so far
  bool hasEvaluated_ = false; ///< true after the first cell, so that every task gets on
  std::vector<Piece> left_;
  const double limit_;               ///< scaled; infinite if there is none
  double sourceSize_ = 0;            ///< no distance of two points of the source is larger
  double farthest_ = 0;              ///< no coordinate of the source is larger
  std::vector<std::uint32_t> nodes_; ///< nodes of the cell at work, after those of cells around it
  std::vector<std::uint32_t> opened_;
  std::vector<NearItems> runs_, kept_;
};

Eigen::Vector3d GridDistances::Descent::positionOf(int i, int j, int k) const
{
  const Eigen::Vector3d position = of_.grid_.sample(i, j, k);
  const double scale = of_.tree_.scale();
  return {scaledCoordinate(position[0], scale), scaledCoordinate(position[1], scale),
    scaledCoordinate(position[2], scale)};
}

/// nodes_ from firstNode on are those of the cell that this one lies in; nearby: a point of the
/// source, or null.
void GridDistances::Descent::descend(
  const Extent& samples, std::size_t firstNode, const SourcePoint* nearby)
{
  if (isEmpty(common(samples, asked_)))
  {
    return;
  }
  if (work_ > mostWorkPerTask && hasEvaluated_)
  {
    left_.push_back({block_, samples});
    return;
  }
  Cell cell;
  cell.samples = samples;
  cell.low = this->positionOf(samples[0], samples[2], samples[4]);
  cell.high = this->positionOf(samples[1], samples[3], samples[5]);
  const std::size_t lastNode = nodes_.size();
  if (lastNode > firstNode)
  {
    this->findNearest(cell, firstNode, nearby);
    this->keepNear(cell, firstNode, lastNode);
  }
  if (sampleCount(samples) <= samplesPerCell || nodes_.size() == lastNode)
  {
    this->evaluate(cell, lastNode);
  }
  else
  {
    this->cut(cell, 3, lastNode);
  }
  nodes_.resize(lastNode);
}

/// Halves a cell along its longest side, some times over.
void GridDistances::Descent::cut(const Cell& cell, int times, std::size_t firstNode)
{
  if (times == 0 || sampleCount(cell.samples) <= samplesPerCell)
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
  this->cut(half, times - 1, firstNode);
  half.samples[2 * longest + 1] = last;
  half.samples[2 * longest] = first + (last - first) / 2 + 1;
  this->cut(half, times - 1, firstNode);
}

void GridDistances::Descent::findNearest(
  Cell& cell, std::size_t firstNode, const SourcePoint* nearby)
{
  const Eigen::Vector3d center = cell.center();
  Nearest nearest = {std::numeric_limits<double>::infinity(), {0, 0, 0}};
  if (nearby)
  {
    cell.nearest = *nearby;
    nearest.squared = (center - nearby->position).squaredNorm();
  }
  const double known = nearest.squared;
  std::size_t closest = firstNode;
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    const double square = squaredDistance(of_.tree_.box(nodes_[n]), center);
    if (square < squared)
    {
      closest = n;
      squared = square;
    }
  }
  std::size_t items = of_.tree_.findNearest(center, nodes_[closest], nearest);
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    if (n != closest && squaredDistance(of_.tree_.box(nodes_[n]), center) < nearest.squared)
    {
      items += of_.tree_.findNearest(center, nodes_[n], nearest);
    }
  }
  work_ += samplesAtOnce * static_cast<double>(items);
  if (nearest.squared < known)
  {
    cell.nearest.position = center - Eigen::Map<const Eigen::Vector3d>(nearest.offset);
    // Three coordinates are rounded by half an epsilon each.
    cell.nearest.rounding = roundingOfOffset(std::sqrt(nearest.squared), sourceSize_) +
                            std::numeric_limits<double>::epsilon() * farthest_;
    cell.nearest.item = nearest.item;
  }
  cell.squaredReach = (cell.low - cell.nearest.position).squaredNorm() +
                      (cell.high - cell.nearest.position).squaredNorm();
}

/// The sum δ + ε of the class: the rounding of the nearest point and of the distances from it that
/// are compared.
double GridDistances::Descent::roundingOf(const Cell& cell) const
{
  return cell.nearest.rounding + roundingOfOffset(std::sqrt(cell.squaredReach), sourceSize_);
}

/// Whether all of a box is farther than the limit from all of a cell.
bool GridDistances::Descent::isBeyond(const Cell& cell, const Bounds& box) const
{
  const Eigen::Vector3d apart = (box.min() - cell.high).cwiseMax(cell.low - box.max()).cwiseMax(0);
  return apart.norm() > limit_;
}

/// Whether a box may hold the nearest point of a sample of the cell, by the test of the class.
/// slack: the rounding of the difference of squares.
bool GridDistances::Descent::canBeNearest(const Cell& cell, const Bounds& box, double slack)
{
  double least = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = cell.nearest.position[axis];
    const double low = box.min()[axis], high = box.max()[axis];
    const auto difference = [&](double q)
    {
      const double apart = std::max(0.0, std::max(low - q, q - high));
      return apart * apart - (q - x) * (q - x);
    };
    least += std::min(difference(cell.low[axis]), difference(cell.high[axis]));
  }
  return least <= slack;
}

/// Appends the nodes of a list that matter to a cell, opened until they are no larger than it.
void GridDistances::Descent::keepNear(const Cell& cell, std::size_t firstNode, std::size_t lastNode)
{
  const bool isLast = sampleCount(cell.samples) <= samplesPerCell;
  const double side = (cell.high - cell.low).maxCoeff();
  const double rounding = this->roundingOf(cell);
  const double slack = (2 * std::sqrt(cell.squaredReach) + rounding) * rounding +
                       32 * std::numeric_limits<double>::epsilon() * cell.squaredReach;
  for (std::size_t n = firstNode; n < lastNode; ++n)
  {
    opened_.assign(1, nodes_[n]);
    while (!opened_.empty())
    {
      const std::uint32_t number = opened_.back();
      opened_.pop_back();
      const Bounds& box = of_.tree_.box(number);
      const SourceNode& node = of_.tree_.node(number);
      const bool hasNearest = node.begin <= cell.nearest.item && cell.nearest.item < node.end;
      if ((limit_ < std::numeric_limits<double>::infinity() && this->isBeyond(cell, box)) ||
          !(hasNearest || canBeNearest(cell, box, slack)))
      {
        continue;
      }
      if (node.children > 0 && (isLast || box.sizes().maxCoeff() > side))
      {
        for (std::uint32_t i = 0; i < node.children; ++i)
        {
          opened_.push_back(node.firstChild + i);
        }
        continue;
      }
      nodes_.push_back(number);
    }
  }
}

/// Keeps the items that may be nearest to a sample of the cell: the test of canBeNearest() with the
/// distances of the items instead of boxes.
void GridDistances::Descent::keepNearItems(const Cell& cell)
{
  const double rounding = this->roundingOf(cell);
  SampleBlock corners;
  corners.count = 8;
  alignas(64) double squared[8];
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Eigen::Vector3d corner((i & 1 ? cell.high : cell.low)[0],
      (i & 2 ? cell.high : cell.low)[1], (i & 4 ? cell.high : cell.low)[2]);
    corners.set(i, corner);
    const double distance = (corner - cell.nearest.position).norm() + rounding;
    squared[i] = distance * distance;
  }
  of_.tree_.keepNearer(runs_, corners, squared, kept_);
  for (const NearItems& run : runs_)
  {
    work_ += samplesAtOnce * (run.last - run.first);
  }
  const std::uint32_t item = cell.nearest.item;
  if (std::none_of(kept_.begin(), kept_.end(),
        [item](const NearItems& run) { return run.first <= item && item < run.last; }))
  {
    kept_.push_back({item, item + 1});
  }
}

/// Writes the distances of a cell's samples from the nodes that are left: leaves, or none where all
/// of the source is beyond the limit.
void GridDistances::Descent::evaluate(const Cell& cell, std::size_t firstNode)
{
  hasEvaluated_ = true;
  const Extent& s = cell.samples;
  runs_.clear();
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    const SourceNode& node = of_.tree_.node(nodes_[n]);
    runs_.push_back({node.begin, node.end});
  }
  kept_.clear();
  if (!runs_.empty())
  {
    this->keepNearItems(cell);
  }
  SampleBlock block;
  alignas(64) double squared[SampleBlock::capacity];
  const std::size_t count = sampleCount(s);
  for (const NearItems& run : kept_)
  {
    work_ += static_cast<double>(count) * (run.last - run.first);
  }
  for (std::size_t first = 0; first < count; first += block.count)
  {
    block.count = std::min(count - first, SampleBlock::capacity);
    std::fill_n(squared, SampleBlock::capacity, std::numeric_limits<double>::infinity());
    for (std::size_t n = 0; !runs_.empty() && n < block.count; ++n)
    {
      const Eigen::Vector3i index = sampleIndex(s, first + n);
      block.set(n, this->positionOf(index[0], index[1], index[2]));
    }
    of_.tree_.lowerSquaredDistances(kept_, block, squared);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      const Eigen::Vector3i index = sampleIndex(s, first + n);
      const Extent& asked = of_.extent_;
      if (asked[0] <= index[0] && index[0] <= asked[1] && asked[2] <= index[1] &&
          index[1] <= asked[3] && asked[4] <= index[2] && index[2] <= asked[5])
      {
        of_.output_.writeDistance(
          std::sqrt(squared[n]) / of_.tree_.scale(), sampleNumber(asked, index));
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
