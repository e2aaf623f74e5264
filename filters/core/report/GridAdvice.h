#pragma once

#include "base/Bounds.h"
#include "base/Message.h"
#include "source/Grid.h"

#include <optional>

namespace winding
{

/**
 * Returns what to do about a grid that does not show a source with these bounds: where it misses
 * them, where the source has less than three voxels along an axis, or where no sample is inside,
 * which `isEmpty` says. An axis without any extent does not count: no grid would help.
 */
std::optional<Message> gridAdvice(const Grid& grid, const Bounds& source, bool isEmpty);

/// Returns whether a grid has no voxel in common with the bounds of a source.
bool missesSource(const Grid& grid, const Bounds& source);

} // namespace winding
