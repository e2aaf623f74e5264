// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/LevelEdges.h"

#include <algorithm>
#include <vector>

namespace winding
{

/// Where a surface crosses the edges of a grid, and how it lies there.
struct EdgeRoots
{
  /// Vertices keep this far away from the ends of their edges: far less than anybody sees, but more
  /// than what single precision rounds.
  static constexpr double margin = 1.0 / (1 << 12);

  /// Makes a place for each of `edges` edges: the middle, without a normal.
  explicit EdgeRoots(std::size_t edges)
    : fractions(edges, 0.5)
    , normals(edges, Eigen::Vector3f::Zero())
  {
  }

  /// Returns the place on an edge in units of the grid, as Grid::inGridUnits() has them. It keeps
  /// the margin from both samples.
  Eigen::Vector3d place(const GridEdge& edge, std::size_t number) const
  {
    Eigen::Vector3d place(edge.sample[0], edge.sample[1], edge.sample[2]);
    place[edge.axis] += std::clamp(fractions[number], margin, 1 - margin);
    return place;
  }

  /// One for each edge: 0 at its first sample, 1 at its second; 0.5 at the border.
  std::vector<double> fractions;
  /// The unit normals of the surface there, turned either way; 0 where no normal is known.
  std::vector<Eigen::Vector3f> normals;
};

} // namespace winding
