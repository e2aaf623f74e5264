#pragma once

#include <cstddef>

namespace winding
{

/// The seconds that a cloud is expected to take on one thread before it can be evaluated: to be
/// read and cleaned, for Voronoi areas and for estimated normals from so many neighbours, where
/// they are needed.
double secondsToPrepareCloud(std::size_t points, int neighbors, bool needsAreas, bool needsNormals);

} // namespace winding
