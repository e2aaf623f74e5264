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

/// The normals that fit best so far. Those that were tried for several turns are shared.
struct Best
{
  explicit Best(const std::shared_ptr<const Normals>& first)
    : normals(first)
    , turns(first->size(), 0)
  {
  }

  std::shared_ptr<const Normals> normals;
  Turns turns;
  double deviation = std::numeric_limits<double>::infinity();

  void take(const std::shared_ptr<const Normals>& others, const Turns& otherTurns, double other)
  {
    if (other < deviation)
    {
      normals = others;
      turns = otherTurns;
      deviation = other;
    }
  }
};

/// The mean square of w − 1/2.
double deviationOf(const Eigen::VectorXd& w);

/// Whether w increases along each normal.
Turns uphill(const Normals& gradients, const Normals& normals);

/// Takes normals as they are, or all turned round.
void tryAsTheyAre(
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Best& best);

/// Tries patches of some normals for all bounds of doubt.
void tryPatches(const DistinctPoints& places, const NeighborGraph& graph,
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Executor& executor,
  Best& best);

/// Tries directions of the planes of single sheets, which are known where senses are.
void trySheets(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<std::size_t>& sizes, const PlacesField& field, Executor& executor, Best& best);

/// Turns points one by one as long as that helps.
void polish(const DistinctPoints& places, const PlacesField& field, Executor& executor, Best& best);

} // namespace winding
