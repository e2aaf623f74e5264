#include "distance/GridDistances.h"

#include "distance/CellDescent.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

namespace
{

/// Blocks of this size make several tasks of small grids, too. Blocks of 512 samples take up to a
/// fifth longer (measured).
constexpr double samplesPerBlock = 4096;

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

/// The samples of a grid as CellDescent.h wants them: a part is an extent.
class GridSamples
{
public:
  using Part = Extent;
  using Name = std::size_t; ///< its number in the output

  GridSamples(const Grid& grid, const Extent& asked, double scale, const FieldOutput& output)
    : grid_(grid)
    , asked_(asked)
    , scale_(scale)
    , output_(output)
  {
  }

  static std::size_t count(const Extent& part) { return sampleCount(part); }

  bool isAskedFor(const Extent& part) const { return !isEmpty(common(part, asked_)); }

  Bounds boxOf(const Extent& part) const
  {
    return {
      this->positionOf(part[0], part[2], part[4]), this->positionOf(part[1], part[3], part[5])};
  }

  /// Halves a part along its longest side.
  std::pair<Extent, Extent> halves(const Extent& part) const
  {
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int steps = part[2 * axis + 1] - part[2 * axis];
      if (steps > 0 && steps * grid_.spacing[static_cast<int>(axis)] > length)
      {
        longest = axis;
        length = steps * grid_.spacing[static_cast<int>(axis)];
      }
    }
    const int first = part[2 * longest], last = part[2 * longest + 1];
    std::pair<Extent, Extent> halves = {part, part};
    halves.first[2 * longest + 1] = first + (last - first) / 2;
    halves.second[2 * longest] = first + (last - first) / 2 + 1;
    return halves;
  }

  template <class Function> void forEach(const Extent& part, const Function& f) const
  {
    const Extent asked = common(part, asked_);
    for (int k = asked[4]; k <= asked[5]; ++k)
    {
      for (int j = asked[2]; j <= asked[3]; ++j)
      {
        for (int i = asked[0]; i <= asked[1]; ++i)
        {
          f(this->positionOf(i, j, k), sampleNumber(asked_, {i, j, k}));
        }
      }
    }
  }

  void write(double squared, std::size_t sample) const
  {
    output_.writeDistance(std::sqrt(squared) / scale_, sample);
  }

private:
  Eigen::Vector3d positionOf(int i, int j, int k) const
  {
    const Eigen::Vector3d position = grid_.sample(i, j, k);
    return {scaledCoordinate(position[0], scale_), scaledCoordinate(position[1], scale_),
      scaledCoordinate(position[2], scale_)};
  }

  const Grid& grid_;
  const Extent asked_;
  const double scale_;
  const FieldOutput& output_;
};

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

void GridDistances::evaluate(Executor& executor) const
{
  std::vector<Extent> parts(static_cast<std::size_t>(blocks_.cast<std::int64_t>().prod()));
  for (std::size_t number = 0; number < parts.size(); ++number)
  {
    parts[number] = this->samplesOfBlock(number);
  }
  evaluateByCells(tree_, output_.distanceLimit * tree_.scale(),
    GridSamples(grid_, extent_, tree_.scale(), output_), std::move(parts), executor);
}

} // namespace winding
