// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/PlacesField.h"
#include "source/DistinctPoints.h"

namespace winding
{

/**
 * Estimates the normals of a cloud whose spanning tree is not right everywhere.
 *
 * The tree's patches are turned for solids that lie in each other (OverlappingNormals.h). These
 * normals are taken at once where walls go through solids. Elsewhere consistent ones
 * (ConsistentNormals.h) are found, too, and taken unless they have far more faults. Where solids do
 * not meet, one within another might as well be a cavity, which consistent normals take it for.
 *
 * If points are noisy, some of their places are moved onto planes through many neighbours, and the
 * same is done with these. The gradient of their w turns the normals of all planes.
 *
 * byTree: the outward normals of the spanning tree, by point. neighbors: the most neighbours that
 * planes go through, at least 3. There must be two places or more. The bits are the same for any
 * executor and any order of the points. Takes the time and memory of consistentNormals() at most,
 * and up to 15 % more of the time. Throws Interrupted.
 */
Normals automaticNormals(
  const DistinctPoints& places, Normals byTree, int neighbors, Executor& executor);

} // namespace winding
