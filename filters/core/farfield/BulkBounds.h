#pragma once

#include "base/Bounds.h"

#include <vector>

namespace winding
{

/**
 * Where nearly all points are: what the unit of length is to be taken from where single precision
 * computes. One point a million sizes away would leave it no digits for all others.
 *
 * The given bounds of the points, unless the middle nine tenths of them along every axis take less than
 * a sixteenth: then a box of four times that size, but of no less than 1e-7 of the bounds. Looks at 4096
 * points at most, so that it takes no time.
 */
Bounds bulkBounds(const std::vector<Eigen::Vector3d>& points, const Bounds& bounds);

} // namespace winding
