// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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
 * Tries several orientations and keeps the one with the smallest deviation. All of these
 * functions throw Interrupted.
 */
namespace winding
{

/// The mean square of w − 1/2.
double deviationOf(const Eigen::VectorXd& w);

/// How much w deviates from 1/2, where areas are known except for a common factor, as for noisy
/// points are: the least mean square of f w − 1/2 for any f that is not negative. It may be more
/// than 1, for w is small all over where noise is thicker than parts, even with right normals: with
/// no more than 1, one of three draws of the noisy tray of clouds.md fell from 0.46 to 0.27.
double deviationUpToScale(const Eigen::VectorXd& w);

/// The normals that fit best up to now. Those that were tried for several turns are shared.
class BestNormals
{
public:
  /// measure: deviationOf() or, for noisy points, deviationUpToScale().
  explicit BestNormals(const std::shared_ptr<const Normals>& first,
    double (*measure)(const Eigen::VectorXd&) = deviationOf)
    : normals(first)
    , turns(first->size(), 0)
    , measure_(measure)
  {
  }

  /// w: of the other normals after their turns.
  void keepIfBetter(
    const std::shared_ptr<const Normals>& others, const Turns& otherTurns, const Eigen::VectorXd& w)
  {
    const double other = measure_(w);
    if (other < deviation)
    {
      normals = others;
      turns = otherTurns;
      deviation = other;
    }
  }

  std::shared_ptr<const Normals> normals;
  Turns turns;
  double deviation = std::numeric_limits<double>::infinity();

private:
  double (*measure_)(const Eigen::VectorXd&);
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
