// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

namespace winding
{

/**
 * Returns a surface with caps (Cap.h) over the edges that an odd number of triangles use, so that
 * even numbers use all. The caps follow its own triangles. Where triangles agree about the outside
 * and each wall between two solids is there twice, those edges bound the holes. The senses of
 * triangles make no difference, nor does their order, nor the order of vertices. Takes O(n log n)
 * time for n of these edges.
 */
Surface withOddCaps(const Surface& surface, const SurfaceEdges& edges);

} // namespace winding
