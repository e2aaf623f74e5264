// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/Candidates.h"
#include "distance/NearestCell.h"

#include <vector>

namespace winding
{

/**
 * The items of a DistanceTree that may be nearest to any sample of a small cell, and of cells in
 * it: those that pass the test of Candidates, with the rounding of NearestRounding.
 *
 * Guaranteed: the items that are left hold, for each sample of the cell within the limit of the
 * lists that they come from, the one whose distance is the smallest of all items' as the loops
 * compute it: so the least computed distance of a sample does not depend on its cell.
 */
class NearestItems
{
public:
  /// Keeps a reference.
  explicit NearestItems(const DistanceTree& tree);

  /// Sets `to` to the indices of the leaves' items that may be nearest to a sample of a cell.
  void keep(const NearestCell& cell, const std::vector<NearItems>& runs, Candidates& to);

  /// Sets `nearest` and squaredReach of up to samplesAtOnce cells, from the candidates of a cell
  /// around them, at least one.
  void findNearest(NearestCell* cells, std::size_t count, const Candidates& candidates);

  /// Sets `to` to the indices of a cell's candidates that may be nearest to a sample of a cell in
  /// it.
  void keep(const NearestCell& cell, const Candidates& candidates, Candidates& to);

  /// Returns the indices of the parent's candidates that may be nearest to a sample of `cell`.
  /// Faster than keep(), but keeps a few more: large triangles are not tested again.
  const std::vector<std::uint32_t>& numbers(const NearestCell& cell, const Candidates& candidates);

  /// The samples times items that have been looked at.
  double work() const { return work_; }

private:
  void findPlaces(const NearestCell& cell, const Candidates& candidates);
  void removeFar(const NearestCell& cell, const Candidates& candidates);
  void setCorners(const NearestCell& cell, double* squaredLimits);

  const DistanceTree& tree_;
  const NearestRounding rounding_;
  double work_ = 0;
  Candidates all_; ///< of the leaves looked at
  std::vector<std::uint32_t> places_, numbers_;
  SampleBlock block_;
};

} // namespace winding
