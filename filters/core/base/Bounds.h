// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace winding
{

/// An axis-parallel box; empty until something is put into it.
using Bounds = Eigen::AlignedBox3d;

} // namespace winding
