#pragma once

#include <Eigen/Geometry>

namespace winding
{

/// An axis-parallel box; empty until something is put into it.
using Bounds = Eigen::AlignedBox3d;

} // namespace winding
