#pragma once

#include <cstddef>

namespace winding
{

/// The seconds that a surface is expected to take on one thread before it can be evaluated: to be
/// read, cleaned and welded, and for its boundary. points: those of the input.
double secondsToPrepareSurface(std::size_t triangles, std::size_t points);

} // namespace winding
