#include "distance/SampleDistances.h"

#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

double distanceOf(const DistanceTree& tree, const Eigen::Vector3d& sample, double limit)
{
  if (!sample.allFinite())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double scale = tree.scale();
  const Eigen::Vector3d scaled(scaledCoordinate(sample[0], scale),
    scaledCoordinate(sample[1], scale), scaledCoordinate(sample[2], scale));
  Nearest nearest = {(limit * scale) * (limit * scale), {0, 0, 0}};
  if (!tree.empty())
  {
    tree.findNearest(scaled, 0, nearest);
  }
  return std::sqrt(nearest.squared) / scale;
}

} // namespace

bool evaluateDistances(const DistanceTree& tree, const VectorsView& samples,
  const FieldOutput& output, Executor& executor)
{
  constexpr std::size_t samplesPerBlock = 256;
  return executor.run((samples.size() + samplesPerBlock - 1) / samplesPerBlock,
    [&](std::size_t block)
    {
      const std::size_t first = block * samplesPerBlock;
      const std::size_t last = std::min(samples.size(), first + samplesPerBlock);
      for (std::size_t n = first; n < last; ++n)
      {
        output.writeDistance(distanceOf(tree, samples[n], output.distanceLimit), n);
      }
    });
}

} // namespace winding
