// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"

#include <cstddef>
#include <string>

namespace winding
{

/// Returns the direction of a side, as directionIn() does; 0 for an empty text. Throws Refusal for
/// other texts.
Eigen::Vector3d sheetSideIn(const std::string& text);

/// The open parts of a surface that divide space.
struct Sheets
{
  std::size_t count = 0;
  double height = 0; ///< of their middle along a side, in the unit of the source
  /// The number of them with faces that look along the side so little, by a twentieth of their area
  /// at most, that rounding decides.
  std::size_t unclear = 0;
  bool areStacked = false; ///< whether some lie over each other, as layers do
};

/**
 * Turns the open components of a surface (Components.h) so that what lies on one side of them is
 * inside: their vector areas look away from `side`. Closed ones stay as they are.
 *
 * A sheet that ends nowhere has w = ½ on that side and −½ on the other. A half sphere at infinity
 * closes it and adds ½, so that w is 1 and 0 there. The same half is added for a sheet with a rim:
 * w passes ½ at the sheet, and beyond its rim on a smooth surface that goes on from it.
 *
 * Throws Interrupted.
 */
Sheets turnSheets(
  Surface& surface, const PolygonParts& parts, const Eigen::Vector3d& side, Executor& executor);

} // namespace winding
