// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/DistinctPoints.h"
#include "source/UnitScale.h"
#include "support/Serial.h"

#include <vector>

namespace shapes
{

/// Finds the distinct points among positions.
inline winding::DistinctPoints placesOf(const std::vector<Eigen::Vector3d>& positions)
{
  return {positions, winding::unitScaleOf(positions), serial};
}

} // namespace shapes
