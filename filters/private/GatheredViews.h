#pragma once

#include "base/Views.h"
#include "private/Ranks.h"

#include <vector>

namespace winding
{

/// The way in which the parts of a source come together.
struct Gathering
{
  /// Whether parts that are all the same are taken for copies of one source, and not gathered.
  bool findsCopies = true;
  bool onlyOnFirst = false; ///< whether the first rank alone gets all parts; others keep their own
};

/// The parts of a source that ranks have, brought together. Views live as long as this object; each
/// is the part of a rank, in the order of ranks.
class GatheredViews
{
public:
  /// Brings triangles together. False if this rank keeps its own. Collective.
  bool gather(Ranks& ranks, const std::vector<TrianglesView>& own, const Gathering& gathering);

  /// Brings oriented points together. Normals and areas stay only if all points have them. False if
  /// this rank keeps its own. Collective.
  bool gather(Ranks& ranks, const std::vector<OrientedPointsView>& own, const Gathering& gathering);

  const std::vector<TrianglesView>& triangles() const { return triangles_; }
  const std::vector<OrientedPointsView>& orientedPoints() const { return points_; }

private:
  OfRanks<double> positions_, normals_, areas_;
  OfRanks<int> ids_;
  std::vector<TrianglesView> triangles_;
  std::vector<OrientedPointsView> points_;
};

} // namespace winding
