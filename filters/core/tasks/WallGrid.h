// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "source/Grid.h"

#include <string>

namespace winding
{

class Field;

/**
 * The number of cubic voxels along the longest side of a grid, where none is given: 128, or more
 * where walls ask for them.
 *
 * Walls ask for one and a half voxels, until less than a twentieth of the surface bounds thinner
 * ones. They are measured at the points that warn of thin walls (Diagnosis.h). The time of a
 * surface grows with the square of the number, so there are 286 at most: five times the time of
 * 128. What these do not show is told as for any grid.
 *
 * Guaranteed: the same number for any threads, and for any order of triangles and solids.
 */
class WallGrid
{
public:
  static constexpr int plain = 128, most = 286;

  /// Takes a request of any resolution. Throws Refusal for one that makes no grid.
  explicit WallGrid(const GridRequest& request);

  /// Adds a solid, whose source may be mended first (MendedSource.h). Throws Interrupted.
  void add(const Field& field, const InsideTest& isInside, bool mendsSource, Executor& executor);

  /// Returns the number of voxels, and that whole tens beyond the plain one.
  int resolution() const;

  /// Returns the number and why it is not the plain one; an empty text where it is.
  std::string reason() const;

private:
  Grid plain_;
  double voxel_;         ///< the edge that walls ask for
  double thinShare_ = 0; ///< the largest share of a surface that asks for it
};

} // namespace winding
