#pragma once

#include <cstddef>

namespace winding
{

/// The work that the normals of a cloud's points take.
enum class NormalWork
{
  none,   ///< they are given
  tree,   ///< planes and a spanning tree (NormalEstimation.h)
  patches ///< signs of patches, too (ConsistentNormals.h)
};

/// The seconds that a cloud is expected to take on one thread before it can be evaluated: to be
/// read and cleaned, for Voronoi areas, where they are needed, and for normals that are estimated
/// from so many neighbours. Noise is not known here: it makes normals take about twice as long
/// where parts are as thin as the noise.
double secondsToPrepareCloud(
  std::size_t points, int neighbors, bool needsAreas, NormalWork normals);

} // namespace winding
