#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/Grid.h"

namespace winding
{

/// The samples that are inside by InsideRule::signedThreshold, and those that would be if all faces
/// or normals were turned round: w is −threshold or less there.
struct SideCounts
{
  std::size_t samples = 0;
  std::size_t inside = 0;
  std::size_t negative = 0;

  /// Counts one more value `times` times. A threshold of 0 or less has no other side.
  void add(double value, double threshold, std::size_t times = 1)
  {
    samples += times;
    inside += value >= threshold ? times : 0;
    negative += threshold > 0 && value <= -threshold ? times : 0;
  }

  SideCounts& operator+=(const SideCounts& other)
  {
    samples += other.samples;
    inside += other.inside;
    negative += other.negative;
    return *this;
  }
};

/// Counts about 100 000 of the `values` values, evenly spread over them, or all where there are
/// fewer.
template <class ValueAt>
SideCounts countSides(std::size_t values, double threshold, const ValueAt& valueAt)
{
  constexpr std::size_t most = 100'000;
  const std::size_t step = values / most + 1;
  SideCounts counts;
  for (std::size_t i = 0; i < values; i += step)
  {
    counts.add(valueAt(i), threshold);
  }
  return counts;
}

/**
 * Returns whether faces or normals look inward, so that w is negative where it should be positive.
 * For surfaces that is where a hundredth or more of the samples off the outside are negative.
 * Near single points of a cloud w has any value; so for clouds most of these samples must be
 * negative, and most normals must point inward as well (CloudOrientation.h). Throws Interrupted.
 */
bool looksInward(const Field& field, const SideCounts& sides, Executor& executor);

///@{
/**
 * Counts the negative samples, of a grid or scattered ones, and stops a slab after the first.
 *
 * They take the time of the field, and less where one is negative. Memory: 4 bytes for each sample;
 * a grid is looked at in slabs of at least one layer along z, and of 64 MB at most where one layer
 * is not larger. Throws Interrupted.
 */
SideCounts countNegative(
  const Field& field, const Grid& grid, double threshold, Executor& executor);
SideCounts countNegative(
  const Field& field, const VectorsView& samples, double threshold, Executor& executor);
///@}

} // namespace winding
