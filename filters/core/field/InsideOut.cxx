#include "field/InsideOut.h"

#include "base/FieldOutput.h"
#include "cloud/CloudOrientation.h"

#include <algorithm>
#include <vector>

namespace winding
{

namespace
{

/// Counts the negative ones of `samples` samples. `evaluate` is called with the output to write to.
template <class Evaluate>
SideCounts countSamples(std::size_t samples, double threshold, const Evaluate& evaluate)
{
  std::vector<float> values(samples);
  FieldOutput output;
  output.values = values.data();
  evaluate(output);
  SideCounts counts;
  counts.samples = samples;
  counts.negative = static_cast<std::size_t>(
    std::count_if(values.begin(), values.end(), [&](float w) { return w <= -threshold; }));
  return counts;
}

} // namespace

bool looksInward(const Field& field, const SideCounts& sides, Executor& executor)
{
  if (field.cloud())
  {
    return sides.negative > sides.inside && orientationOf(*field.cloud(), executor).isInward();
  }
  return sides.negative > 0 && 100 * sides.negative >= sides.negative + sides.inside;
}

SideCounts countNegative(const Field& field, const Grid& grid, double threshold, Executor& executor)
{
  const Extent whole = grid.wholeExtent();
  SideCounts counts;
  if (!(threshold > 0) || sampleCount(whole) == 0)
  {
    return counts;
  }
  constexpr std::size_t mostSamples = 16 << 20;
  const Extent layer = {whole[0], whole[1], whole[2], whole[3], 0, 0};
  const auto layers = static_cast<int>(
    std::clamp<std::size_t>(mostSamples / sampleCount(layer), 1, grid.dimensions[2]));
  for (int k = 0; k < grid.dimensions[2] && counts.negative == 0; k += layers)
  {
    Extent slab = whole;
    slab[4] = k;
    slab[5] = std::min(k + layers - 1, whole[5]);
    counts += countSamples(sampleCount(slab), threshold,
      [&](const FieldOutput& output) { field.evaluate(grid, slab, output, executor); });
  }
  return counts;
}

SideCounts countNegative(
  const Field& field, const VectorsView& samples, double threshold, Executor& executor)
{
  return threshold > 0
           ? countSamples(samples.size(), threshold,
               [&](const FieldOutput& output) { field.evaluate(samples, output, executor); })
           : SideCounts();
}

} // namespace winding
