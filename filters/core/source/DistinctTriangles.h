// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"

#include <optional>
#include <vector>

namespace winding
{

/// Triangles that stand for all of a list; see distinctTriangles().
struct DistinctTriangles
{
  TriangleList triangles;
  Multiplicities multiplicities; ///< by triangle, ascending
};

/**
 * Takes triangles with the same three vertices together, so that each stands there once: as the
 * chain that n equal triangles are, n times one of them; an opposite one takes one off.
 * Sums over the result cost what its distinct triangles cost, however many there were.
 *
 * `mayRepeat` says by vertex where triangles may be equal: only triangles with three such vertices
 * are compared. Triangles that cancel entirely stay, with multiplicity 0, since distances are
 * measured to them, too. Triangles of equal multiplicity keep the order in which each occurs first.
 *
 * Returns nothing if no two triangles are equal. Takes O(n log n) time for the n triangles that are
 * compared, and 24 bytes for each.
 */
std::optional<DistinctTriangles> distinctTriangles(
  const TriangleList& triangles, const std::vector<char>& mayRepeat);

} // namespace winding
