#pragma once

#include "source/Surface.h"
#include "surface/Boundary.h"

namespace winding
{

/**
 * A chain C of triangles with ∂C = −∂M, over the vertices of M: put onto M it closes M. It may cross
 * anything, itself included; only its boundary matters, since w_M = χ_{M+C} − w_C with an integer χ
 * (Jacobson, Kavan, Sorkine-Hornung 2013 close open meshes so).
 *
 * Each loop loses every other vertex as an ear (v₀ v₁ v₂), (v₂ v₃ v₄), … then the same again on what is
 * left: n − 2 triangles for a loop of n, small ones at the rim and large ones in the middle, so that
 * few of them are near any sample.
 */
std::vector<Triangle> capOf(const std::vector<BoundaryLoop>& loops);

/**
 * Another such chain: each loop joined to one new vertex beside it. The vertices are appended to
 * `vertices`, whose loops' vertices must be there already. Used where a sample lies on the first cap:
 * the apex is put where a second coincidence would be an accident.
 */
std::vector<Triangle> fanOf(
  const std::vector<BoundaryLoop>& loops, std::vector<Eigen::Vector3d>& vertices);

} // namespace winding
