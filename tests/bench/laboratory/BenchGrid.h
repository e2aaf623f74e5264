// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Grid.h"

#include <string>
#include <vector>

/// A grid of cubic voxels around bounds, as the program lays it by default: `resolution` along
/// the longest side, with a margin of a twentieth of it.
winding::Grid benchGrid(const winding::Bounds& bounds, int resolution);

/// The dimensions of a grid, for tables.
std::string sizeOf(const winding::Grid& grid);

/// Positions of random samples of a grid, x y z for each; the same in every run.
std::vector<double> randomSamples(const winding::Grid& grid, std::size_t count);
