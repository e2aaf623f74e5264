#pragma once

#include "base/Executor.h"
#include "level/EdgeCrossings.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace winding
{

/**
 * Where a level of a field crosses the edges of a grid whose two samples lie on different sides of it: all
 * of them at once, in rounds, each of which evaluates one scattered sample for every edge that is not
 * done.
 *
 * The field of a surface jumps at its triangles, so the crossings of an edge with them are asked
 * first. Where the surface is closed the field changes nowhere else: an edge whose only crossing is
 * the change from one sample to the other needs no evaluation. If it is not, a sample lies on the
 * surface, and the field may change right beside it: that is where it is asked, too. Where the
 * surface is open, the samples just before and behind a crossing tell whether the level is there.
 * What is left, and clouds, is found by ITP (Oliveira, Takahashi, An enhancement of the bisection
 * method average performance preserving minmax optimality, 2020), which takes a round more than
 * bisection at most, and far fewer where the field is smooth.
 *
 * Guaranteed: a root is a crossing of the surface at which the field jumps over the level (where
 * both samples of an edge lie on the surface, or a triangle lies along the edge, one by which it
 * changes as much as from one to the other); or, where the surface is open and of clouds, a place where it is off the level by a
 * twentieth of the tolerance at most; or one within 2⁻¹⁵ of the edge from samples on either side of
 * the level.
 */
class LevelRoots
{
public:
  /// Keeps references to field, grid and edges. tolerance: as of the field. Throws Interrupted.
  LevelRoots(const Field& field, const Grid& grid, const LevelEdges& edges, InsideRule rule,
    double threshold, double tolerance, Executor& executor);

  /// Whether every root is found.
  bool isDone() const { return searches_.empty(); }

  /// The next round; mostly there are less than 20. False when the executor was interrupted.
  bool advance(Executor& executor);

  /// The roots, one for each edge: 0 at its first sample, 1 at its second; 0.5 at the border.
  const std::vector<double>& fractions() const { return fractions_; }

  /// For each root, the unit normal of the triangle that it lies on, 0 where that is not known: where the
  /// level is off the surface, at the border, and of clouds.
  const std::vector<Eigen::Vector3f>& normals() const { return normals_; }

private:
  /// The bracket of a root that is not found yet: fractions of an edge, and what is known there.
  struct Search
  {
    std::uint32_t edge;
    int steps = 0; ///< of ITP
    double low = 0, high = 1;
    double lowWinding, highWinding;
    double lowLevel, highLevel;
    double next = 0; ///< where to evaluate
  };

  using CrossingRange = std::pair<const EdgeCrossings::Crossing*, const EdgeCrossings::Crossing*>;
  CrossingRange crossingsBetween(std::size_t edge, double low, double high) const;
  bool isFoundByCrossings(const Search& search);
  bool isFound(const Search& search);
  void chooseNext(Search& search) const;
  void narrow(Search& search, double windingNumber) const;
  bool dropFound(Executor& executor);

  const Field& field_;
  const Grid& grid_;
  const LevelEdges& edges_;
  InsideRule rule_;
  double threshold_;
  double levelTolerance_;
  bool jumpsOnly_; ///< whether the field changes at crossings of the surface only
  bool isParity_;  ///< whether it is w modulo 2
  std::unique_ptr<const EdgeCrossings> crossings_; ///< null for clouds
  std::vector<double> fractions_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<Search> searches_; ///< those that are not done
};

} // namespace winding
