// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "pipeline/Ranks.h"

#include <vector>

namespace winding
{

///@{
/// A hash of the part of a source that a rank has, by which ranks find out whether their parts are
/// copies.
Ranks::Number hashOf(const std::vector<TrianglesView>& part);
Ranks::Number hashOf(const std::vector<OrientedPointsView>& part);
///@}

/// The parts of a source that ranks have, brought together: on every rank, or on the first only,
/// where the others keep their own. Views live as long as this object; each is the part of a rank,
/// in the order of ranks.
class GatheredViews
{
public:
  /// Brings triangles together. False if this rank keeps its own. Collective.
  bool gather(Ranks& ranks, const std::vector<TrianglesView>& own, bool onlyOnFirst);

  /// Brings oriented points together. Normals and areas stay only if all points have them. False if
  /// this rank keeps its own. Collective.
  bool gather(Ranks& ranks, const std::vector<OrientedPointsView>& own, bool onlyOnFirst);

  const std::vector<TrianglesView>& triangles() const { return triangles_; }
  const std::vector<OrientedPointsView>& orientedPoints() const { return points_; }

private:
  OfRanks<double> positions_, normals_, areas_;
  OfRanks<int> ids_, continued_;
  std::vector<std::vector<char>> isContinued_; ///< by rank
  std::vector<TrianglesView> triangles_;
  std::vector<OrientedPointsView> points_;
};

} // namespace winding
