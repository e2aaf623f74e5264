// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laboratory/Triangles.h"

#include "source/Surface.h"

/**
 * @file
 * Shapes that measurements are made on, by all programs of tests/bench.
 */

/// A closed sphere of 2 n² triangles whose radius varies, without common points, as in a .stl file.
/// n is at least 3.
Triangles lumpySphere(int n);

/// The surface without every `period`-th triangle, from the first one on; each leaves a hole.
winding::Surface withHoles(const winding::Surface& surface, std::size_t period);
