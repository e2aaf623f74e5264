// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/PlaceNormals.h"
#include "source/DistinctPoints.h"

#include <vector>

namespace winding
{

/// Orients a noisy cloud. Noise about as large as its parts are thick hides the sheets from planes
/// through some of its places; then all places are oriented, by the planes of sheets that are apart
/// still, and by planes through many places, which belong to whole parts. Either is taken only
/// where it deviates by less than 0.6 of what the first way does, for noisy points decide little:
/// measured, normals that deviated by 0.69 of it were worse all the same, by 0.54 of it better.
/// Whichever is taken, senses and directions are found again from it.
///
/// spacings: by place. byTree: as for orientDensely(). Throws Interrupted.
OrientedPlaces orientNoisy(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Normals byTree, Executor& executor);

} // namespace winding
