#pragma once

#include "base/Executor.h"
#include "source/DistinctPoints.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/**
 * Returns whether some normals turn a region round that is cut out of smooth sheets, rather than
 * whole parts of the surface. Where solids overlap, the walls of one inside the other see a winding
 * number of 3/2, and turning them round makes it 1/2; but the walls go on outside smoothly, and the
 * sheet is then cut where the surfaces cross. A cavity or a part that is the wrong way round has no
 * cut.
 *
 * `smooth` are normals that change their sense along no smooth sheet, and `turned` the same ones in
 * other senses. A cut is a place that has one of its six nearest neighbours on its sheet
 * (stepBetween()) with the same sense in `smooth` and the opposite one in `turned`. The answer is
 * yes from 1.25 √n cuts on for n turned points: a compact region of n points has a rim of some
 * 3.5 √n. Measured on 50 000 points: 1.7 to 5.2 √n for two balls through each other, up to 1.03 √n
 * for separate rods, boxes and plates, and none for nested shells.
 *
 * Takes linear time except for the search for neighbours, and 100 bytes per point. Throws
 * Interrupted.
 */
bool cutSheets(const DistinctPoints& places, const std::vector<Eigen::Vector3d>& smooth,
  const std::vector<Eigen::Vector3d>& turned, Executor& executor);

} // namespace winding
