#include "level/InsideOut.h"

#include "base/FieldOutput.h"
#include "cloud/CloudOrientation.h"

#include <algorithm>
#include <vector>

namespace winding
{

namespace
{

/// Whether |w| reaches the threshold at any of so many samples. evaluate(output): writes to output;
/// false when the executor was interrupted.
template <class Evaluate>
bool reachesThreshold(std::size_t samples, double threshold, const Evaluate& evaluate)
{
  std::vector<unsigned char> inside(samples);
  FieldOutput output;
  output.inside = inside.data();
  output.rule = InsideRule::absoluteThreshold;
  output.threshold = threshold;
  if (!evaluate(output))
  {
    throw Interrupted();
  }
  return std::find(inside.begin(), inside.end(), 1) != inside.end();
}

bool isCloudOutward(const Field& field, Executor& executor)
{
  return field.cloud() && !orientationOf(*field.cloud(), executor).isInward();
}

} // namespace

bool isInsideOut(const Field& field, const Grid& grid, double threshold, Executor& executor)
{
  const Extent whole = grid.wholeExtent();
  if (!(threshold > 0) || sampleCount(whole) == 0)
  {
    return false;
  }
  constexpr std::size_t mostSamples = 64 << 20;
  const Extent layer = {whole[0], whole[1], whole[2], whole[3], 0, 0};
  const auto layers = static_cast<int>(
    std::clamp<std::size_t>(mostSamples / sampleCount(layer), 1, grid.dimensions[2]));
  for (int k = 0; k < grid.dimensions[2]; k += layers)
  {
    Extent slab = whole;
    slab[4] = k;
    slab[5] = std::min(k + layers - 1, whole[5]);
    if (reachesThreshold(sampleCount(slab), threshold,
          [&](const FieldOutput& output) { return field.evaluate(grid, slab, output, executor); }))
    {
      return !isCloudOutward(field, executor);
    }
  }
  return false;
}

bool isInsideOut(
  const Field& field, const VectorsView& samples, double threshold, Executor& executor)
{
  return threshold > 0 &&
         reachesThreshold(samples.size(), threshold,
           [&](const FieldOutput& output) { return field.evaluate(samples, output, executor); }) &&
         !isCloudOutward(field, executor);
}

bool isInsideOut(const Field& field, double least, double threshold, Executor& executor)
{
  return threshold > 0 && least <= -threshold && !isCloudOutward(field, executor);
}

} // namespace winding
