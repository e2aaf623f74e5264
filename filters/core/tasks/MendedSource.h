// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"
#include "base/SideCounts.h"
#include "field/Field.h"
#include "tasks/Task.h"

#include <optional>

namespace winding
{

/// The mends that a task allows. Nothing is mended with another rule or threshold than the default:
/// its owner has thought of that himself.
struct Mending
{
  bool isWished = false;
  bool mayThicken = true; ///< whether open sheets may become plates: no other shape is asked for
  InsideTest isInside;
  double thickness = 0; ///< of these plates; 0 for three voxels
};

/**
 * The source of a task, mended where that is wished and its diagnosis asks for it: faces or normals
 * are turned, and open sheets become a plate of three voxels of the grid, half on either side.
 * Each mend is said once, and what it mends is not warned of.
 *
 * Some faults show by the sides of samples alone. For those the task asks decide(), and takes the
 * field anew if that turned it.
 */
class MendedSource
{
public:
  /// Keeps references to `field` and `run`, and decides what the source alone shows. Throws
  /// Interrupted.
  MendedSource(const Field& field, const Grid& grid, const Mending& mending, Run& run);

  const Field& field() const { return *field_; }

  /// The thickness of the plate, or 0 for none.
  double plate() const { return plate_; }

  /// Decides by the sides of all samples of the grid. Returns whether field() is another one now,
  /// whose sides are to be found and decided by anew.
  bool decide(const SideCounts& sides);

  /// Decides by a tenth of the layers of the grid that the source reaches, six at most, so that
  /// parts of the grid are decided as the whole is.
  void decideByLayers();

private:
  bool turn(const Message& fault);
  void take(const Field& turned, const Message& fault);
  void thicken();

  const Field* field_;
  const Grid& grid_;
  Mending mending_;
  Run& run_;
  double plate_ = 0;
  bool haveTriedParts_ = false;
};

} // namespace winding
