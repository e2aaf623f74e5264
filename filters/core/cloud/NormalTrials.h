#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"
#include "cloud/PlacesField.h"
#include "source/DistinctPoints.h"

#include <limits>
#include <memory>
#include <vector>

/**
 * @file
 * Normals of places that are tried, and of which those are kept that w fits best. All of these
 * functions throw Interrupted.
 */
namespace winding
{

/// The mean square of w − 1/2.
double deviationOf(const Eigen::VectorXd& w);

/// How much w deviates from 1/2, where areas are known but for a common factor, as those of noisy
/// points are: the least mean square of f w − 1/2 for any f that is not negative.
double deviationUpToScale(const Eigen::VectorXd& w);

/// The normals that fit best so far. Those that were tried for several turns are shared.
struct BestNormals
{
  /// howMuch: deviationOf() or, for noisy points, deviationUpToScale().
  explicit BestNormals(const std::shared_ptr<const Normals>& first,
    double (*howMuch)(const Eigen::VectorXd&) = deviationOf)
    : measure(howMuch)
    , normals(first)
    , turns(first->size(), 0)
  {
  }

  double (*measure)(const Eigen::VectorXd&); ///< how much w deviates

  std::shared_ptr<const Normals> normals;
  Turns turns;
  double deviation = std::numeric_limits<double>::infinity();

  void keepIfBetter(
    const std::shared_ptr<const Normals>& others, const Turns& otherTurns, double other)
  {
    if (other < deviation)
    {
      normals = others;
      turns = otherTurns;
      deviation = other;
    }
  }
};

/// The turns after which w decreases along all normals, as it does from inside to outside.
Turns turnsUphill(const Normals& gradients, const Normals& normals);

/// Tries normals as they are, and all turned round.
void tryAsTheyAre(
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, BestNormals& best);

/// Tries patches of some normals for all bounds of doubt.
void tryPatches(const DistinctPoints& places, const NeighborGraph& graph,
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Executor& executor,
  BestNormals& best);

/// Tries directions of the planes of single sheets, which are known where senses are.
void trySheets(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<std::size_t>& sizes, const PlacesField& field, Executor& executor,
  BestNormals& best);

/// Turns the normals along which w increases, each by itself, as long as that helps.
void turnSinglePoints(
  const DistinctPoints& places, const PlacesField& field, Executor& executor, BestNormals& best);

} // namespace winding
