#pragma once

#include <cstddef>

namespace winding
{

/// The seconds that a surface is expected to take on one thread before it can be evaluated: to be
/// read, cleaned and welded, and for its boundary. points: those of the input. capTriangles: those
/// that close the boundary, about as many as it has edges.
double secondsToPrepareSurface(std::size_t triangles, std::size_t points, std::size_t capTriangles);

} // namespace winding
