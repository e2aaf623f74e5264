// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/BoundaryLoops.h"

namespace winding
{

/**
 * Makes a cap: a chain C of triangles over the vertices of M with ∂C = −∂M, which closes M. It may
 * cross anything, itself included; only its boundary matters, since w_M = χ_{M+C} − w_C with an
 * integer χ (Jacobson, Kavan, Sorkine-Hornung 2013 close open meshes so). `loops` make up ∂M.
 *
 * Each loop loses every other vertex as an ear (v₀ v₁ v₂), (v₂ v₃ v₄), … and what is left of it
 * loses ears in the same way until nothing is left: a loop of n vertices gets n − 2 triangles,
 * small ones at the rim and large ones in the middle, so that few of them are near any sample.
 */
TriangleList capOf(const BoundaryLoops& loops);

/// Makes the cap of one loop.
TriangleList capOf(const BoundaryLoop& loop);

/// The number of triangles that capOf() makes of a loop.
inline std::size_t trianglesOfCap(const BoundaryLoop& loop)
{
  return loop.size() - 2;
}

/**
 * Makes another cap, a fan, by joining each loop to one new vertex near it. Loops of more than 64
 * vertices come to these by rings that have half of the vertices of the last one, each about an
 * edge aside of it: so triangles are small at the rim. It is used where a sample lies on the cap of
 * capOf(): new vertices are put where a second coincidence would be an accident. `vertices` must
 * hold the loops' vertices; the new ones are appended to it.
 */
TriangleList fanOf(const BoundaryLoops& loops, std::vector<Eigen::Vector3d>& vertices);

/// The number of triangles that fanOf() makes of a loop.
std::size_t trianglesOfFan(const BoundaryLoop& loop);

} // namespace winding
