// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/EdgeCrossings.h"
#include "level/EdgeRoots.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace winding
{

/**
 * Finds where a level of a field crosses the edges of a grid whose two samples lie on different
 * sides of it, on all of them at once, in rounds, each of which evaluates one scattered sample for
 * every edge that is not done.
 *
 * The field of a surface jumps at its triangles, so the crossings of an edge with them are asked
 * first. Where the surface is closed the field changes nowhere else: an edge with a single crossing
 * that explains the change from one sample to the other needs no evaluation. If none explains it, a
 * sample lies on the surface, and the field may change right next to that sample: it is evaluated
 * there, too. Where the surface is open, evaluations just before and behind a crossing show whether
 * the level is there. All other roots, and all of clouds, are found by ITP (Oliveira, Takahashi,
 * An enhancement of the bisection method average performance preserving minmax optimality, 2020),
 * which takes a round more than bisection at most, and far fewer where the field is smooth.
 *
 * Guaranteed: a root is one of these: (1) a crossing of the surface at which the field jumps over
 * the level; where both samples of an edge lie on the surface, or a triangle lies along the edge, a
 * crossing at which the field changes as much as from one sample to the other; (2) for open
 * surfaces and clouds, a place where the field is off the level by at most a twentieth of the
 * tolerance, or of 1e-6 if the tolerance is less; (3) a place within 2⁻¹⁵ of the edge's length from
 * samples on either side of the level.
 */
class LevelRoots
{
public:
  /// Keeps references to field, grid and edges; `tolerance` is the field's. Throws Interrupted.
  LevelRoots(const Field& field, const Grid& grid, const LevelEdges& edges,
    const InsideTest& isInside, double tolerance, Executor& executor);

  /// Whether every root is found.
  bool isDone() const { return searches_.empty(); }

  /// Goes through the next round; mostly there are less than 20. Throws Interrupted.
  void advance(Executor& executor);

  /// Gives roots that lie on no triangle the direction of the gradient of the field as a normal, if
  /// it is not 0. The roots must be done. Throws Interrupted.
  void addGradients(Executor& executor);

  /// The roots. Their normals are the unit normals of the triangles that they lie on; none is known
  /// for clouds, at the border, and where the level is off the surface.
  const EdgeRoots& roots() const { return roots_; }

  /// Hands the roots over.
  EdgeRoots take() { return std::move(roots_); }

private:
  /// The bracket of a root that is not found yet: two fractions of an edge, and the field there.
  struct Search
  {
    std::uint32_t edge;
    int steps = 0; ///< evaluations chosen otherwise than at crossings
    double low = 0, high = 1;
    double lowWinding, highWinding;
    double lowLevel, highLevel;
    double next = 0; ///< fraction at which to evaluate
  };

  using CrossingRange = std::pair<const EdgeCrossings::Crossing*, const EdgeCrossings::Crossing*>;
  CrossingRange crossingsBetween(std::size_t edge, double low, double high) const;
  bool isFoundByCrossings(const Search& search);
  bool isFound(const Search& search);
  void chooseNext(Search& search) const;
  void narrow(Search& search, double windingNumber) const;
  void dropFound(Executor& executor);

  const Field& field_;
  const Grid& grid_;
  const LevelEdges& edges_;
  InsideTest isInside_;
  double levelTolerance_;
  bool jumpsOnly_; ///< whether the field changes at crossings of the surface only
  bool isParity_;  ///< whether the field is w modulo 2
  std::unique_ptr<const EdgeCrossings> crossings_; ///< null for clouds
  EdgeRoots roots_;
  std::vector<Search> searches_; ///< searches that are not done
};

} // namespace winding
