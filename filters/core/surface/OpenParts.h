// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Message.h"
#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include <cstddef>
#include <string>
#include <vector>

namespace winding
{

/// The open parts of a surface that lie inside of closed ones, as the baffles of a tank.
struct OpenParts
{
  std::vector<char> isInside; ///< by triangle; empty where there are none
  std::size_t count = 0;
};

/**
 * Finds the open parts inside of closed ones: they bound nothing, but add to w all around them. A
 * part is a set of triangles connected through edges that two of them share. Each other edge of it
 * is used by it alone, or lies on a surface that is closed without it, as all edges of a partition
 * do. The middles of triangles,
 * and corners off the rest, lie where w of the closed and nearly closed rest is not 0
 * (NearlyClosed.h). Parts that are nearly closed themselves do not count.
 *
 * Takes the time of PointCrossings for candidates.
 * The same for every executor. Throws Interrupted.
 */
OpenParts openPartsInside(const Surface& surface, const SurfaceEdges& edges, Executor& executor);

/// Returns what to do about open parts; `facts` counts them.
inline Message openPartsAdvice(const std::string& facts)
{
  return {"open parts lie inside of closed ones",
    {{"leave them out", {{Parameter::ignoreOpenParts, 1}}}}, facts};
}

} // namespace winding
