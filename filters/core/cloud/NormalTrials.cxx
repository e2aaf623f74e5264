// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NormalTrials.h"

#include "base/Progress.h"
#include "cloud/NormalPatches.h"
#include "cloud/PatchSigns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace winding
{

namespace
{

/// Bounds of doubt that are tried: small ones leave patches that end at edges and thin parts, large
/// ones leave few patches of noisy clouds.
constexpr float doubts[] = {0.05f, 0.1f, 0.15f, 0.2f, 0.3f};

/// Patches of fewer places, and the smallest of many patches, follow the others.
constexpr std::size_t fewestPlaces = 5, mostPatches = 256;

/// The places that are none of those given.
std::vector<std::uint32_t> othersThan(const std::vector<std::uint32_t>& some, std::size_t places)
{
  std::vector<unsigned char> isOther(places, 1);
  for (const std::uint32_t place : some)
  {
    isOther[place] = 0;
  }
  std::vector<std::uint32_t> others;
  others.reserve(places - some.size());
  for (std::size_t place = 0; place < places; ++place)
  {
    if (isOther[place])
    {
      others.push_back(static_cast<std::uint32_t>(place));
    }
  }
  return others;
}

} // namespace

Turns turnsUphill(const Normals& gradients, const Normals& normals)
{
  Turns turns(normals.size());
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    turns[place] = gradients[place].dot(normals[place]) > 0;
  }
  return turns;
}

double deviationOf(const Eigen::VectorXd& w)
{
  return (w.array() - 0.5).square().mean();
}

double deviationUpToScale(const Eigen::VectorXd& w)
{
  const double mean = std::max(w.mean(), 0.0), square = w.array().square().mean();
  return square > 0 ? 0.25 * (1 - mean * mean / square) : 0.25;
}

void tryAsTheyAre(
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, BestNormals& best)
{
  const Eigen::VectorXd w = field.valuesOf(*normals, Turns(normals->size(), 0));
  best.keepIfBetter(normals, Turns(normals->size(), 0), w);
  best.keepIfBetter(normals, Turns(normals->size(), 1), -w);
}

void tryPatches(const DistinctPoints& places, const NeighborGraph& graph,
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Executor& executor,
  BestNormals& best)
{
  Progress progress(executor);
  progress.set(0, 0.1);
  NormalPatches patches(places, graph, *normals, executor);
  std::size_t before = 0;
  for (std::size_t i = 0; i < std::size(doubts); ++i)
  {
    constexpr double ofDoubt = 0.9 / std::size(doubts);
    const double begin = 0.1 + ofDoubt * static_cast<double>(i);
    progress.set(begin, begin + ofDoubt / 2);
    patches.grow(doubts[i]);
    const NormalPatches::Largest largest = patches.largest(fewestPlaces, mostPatches);
    if (largest.count() == 0 || (before == 1 && largest.count() == 1))
    {
      continue;
    }
    before = largest.count();
    Turns turns = patches.areOpposite();
    const Eigen::MatrixXd shares = field.sharesOf(*normals, turns, largest);
    const Eigen::VectorXd signs = patchSigns(shares);
    for (std::size_t patch = 0; patch < largest.count(); ++patch)
    {
      for (std::size_t place = largest.starts[patch];
           signs[static_cast<Eigen::Index>(patch)] < 0 && place < largest.starts[patch + 1];
           ++place)
      {
        turns[largest.places[place]] ^= 1;
      }
    }
    patches.propagate(largest, turns);
    progress.set(begin + ofDoubt / 2, begin + ofDoubt);
    const Eigen::VectorXd ofOthers =
      field.sharesOf(*normals, turns, othersThan(largest.places, places.size()));
    best.keepIfBetter(normals, turns, shares * signs + ofOthers);
  }
}

void trySheets(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<std::size_t>& sizes, const PlacesField& field, Executor& executor,
  BestNormals& best)
{
  const Normals oriented = turned(*best.normals, best.turns);
  for (const std::size_t size : sizes)
  {
    const auto normals =
      std::make_shared<const Normals>(sheetNormals(places, graph, oriented, size, executor));
    const Turns none(normals->size(), 0);
    best.keepIfBetter(normals, none, field.valuesOf(*normals, none));
  }
}

void turnSinglePoints(
  const DistinctPoints& places, const PlacesField& field, Executor& executor, BestNormals& best)
{
  constexpr int mostRounds = 3;
  Progress progress(executor);
  for (int round = 0; round < mostRounds; ++round)
  {
    const double before = best.deviation;
    const double rest = std::pow(0.3, round); // a round is the last one mostly
    progress.set(1 - rest, 1 - 0.4 * rest);
    const Turns turns =
      turnsUphill(field.gradients(*best.normals, best.turns, places.positions()), *best.normals);
    progress.set(1 - 0.4 * rest, 1 - 0.3 * rest);
    best.keepIfBetter(best.normals, turns, field.valuesOf(*best.normals, turns));
    if (best.deviation == before)
    {
      return;
    }
  }
}

} // namespace winding
