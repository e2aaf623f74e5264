// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/OverlappingNormals.h"

#include "base/Progress.h"
#include "cloud/CloudNoise.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace winding
{

namespace
{

/// The most doubt of a step along one sheet: 45 degrees between normals, or half as much and steps
/// out of their planes.
constexpr float mostDoubt = 0.3f;

/// The cost of √n cuts that leave no doubt. Of 0.008, 0.016 and 0.032 it is the best one for random
/// overlaps.
constexpr double costOfCuts = 0.016;

/// Returns up to 1024 places, evenly chosen, near which there is one sheet only: small planes
/// deviate little.
std::vector<std::uint32_t> placesOnSheets(
  const std::vector<double>& deviations, const std::vector<double>& spacings)
{
  constexpr double clean = 0.2; // spacings, as for isNoisy(): a quarter of all places is below
  constexpr std::size_t most = 1024;
  std::vector<std::uint32_t> onSheets, chosen;
  for (std::size_t place = 0; place < deviations.size(); ++place)
  {
    if (deviations[place] <= clean * spacings[place])
    {
      onSheets.push_back(static_cast<std::uint32_t>(place));
    }
  }
  const std::size_t step = std::max<std::size_t>(1, (onSheets.size() + most - 1) / most);
  for (std::size_t i = step / 2; i < onSheets.size(); i += step)
  {
    chosen.push_back(onSheets[i]);
  }
  return chosen;
}

/// Returns all places in order of the patches that they follow.
NormalPatches::Largest inOrderOfPatches(
  const NormalPatches::Followers& followers, std::size_t patches)
{
  NormalPatches::Largest grouped;
  grouped.starts.assign(patches + 1, 0);
  for (const std::uint32_t patch : followers.patchOf)
  {
    ++grouped.starts[patch + 1];
  }
  std::partial_sum(grouped.starts.begin(), grouped.starts.end(), grouped.starts.begin());
  std::vector<std::size_t> next = grouped.starts;
  grouped.places.resize(followers.patchOf.size());
  for (std::size_t place = 0; place < followers.patchOf.size(); ++place)
  {
    grouped.places[next[followers.patchOf[place]]++] = static_cast<std::uint32_t>(place);
  }
  return grouped;
}

/// Returns the signs of patches that most of their places' senses ask for.
Eigen::VectorXd majorities(const NormalPatches::Followers& followers, std::size_t patches,
  const Normals& normals, const Normals& senses)
{
  Eigen::VectorXd votes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(patches));
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    const bool isTurned = normals[place].dot(senses[place]) < 0;
    votes[followers.patchOf[place]] += isTurned == (followers.areOpposite[place] != 0) ? 1 : -1;
  }
  return votes.unaryExpr([](double vote) { return vote < 0 ? -1.0 : 1.0; });
}

/// The signs of patches after those have been turned that have an odd number of solids around them.
struct Parity
{
  Eigen::VectorXd signs;
  double contrary = 0; ///< the share of places that their patches were turned for, or not, wrongly
};

/// Finds parities by w at the places looked at; most places of a patch decide.
Parity parityOf(const Eigen::VectorXd& w, const std::vector<std::uint32_t>& lookedAt,
  const NormalPatches::Followers& followers, Eigen::VectorXd signs)
{
  Eigen::VectorXd even = Eigen::VectorXd::Zero(signs.size()), odd = even;
  for (std::size_t i = 0; i < lookedAt.size(); ++i)
  {
    const double around = std::max(0.0, std::floor(w[static_cast<Eigen::Index>(i)]));
    (std::fmod(around, 2) == 0 ? even : odd)[followers.patchOf[lookedAt[i]]] += 1;
  }
  signs = (odd.array() > even.array()).select(-signs, signs);
  return {std::move(signs), even.cwiseMin(odd).sum() / static_cast<double>(lookedAt.size())};
}

Turns turnsBy(const Eigen::VectorXd& signs, const NormalPatches::Followers& followers)
{
  Turns turns = followers.areOpposite;
  for (std::size_t place = 0; place < turns.size(); ++place)
  {
    turns[place] ^= signs[followers.patchOf[place]] < 0 ? 1 : 0;
  }
  return turns;
}

/// Whether the normals at both ends of a step have opposite senses after some turns.
bool isCut(const NormalPatches::Link& link, const Turns& turns)
{
  return (turns[link.from] != turns[link.to]) != (link.areOpposite != 0);
}

} // namespace

OverlappingNormals::OverlappingNormals(
  const DistinctPoints& places, const NeighborGraph& graph, Executor& executor)
  : places_(places)
  , executor_(executor)
  , spacings_(spacingsOf(places, graph))
  // Planes through few places are on one sheet mostly, and through more they are not as rough.
  , planes_(planeNormals(places, graph, (fewNeighbors + graph.neighborsPerPlace()) / 2, executor))
  , patches_(places, graph, planes_, executor)
  , field_(places, spacings_, 1,
      placesOnSheets(planeDeviations(places, graph, fewNeighbors, executor), spacings_), executor)
{
}

/// Returns what a cut through a step costs.
double OverlappingNormals::costOf(const NormalPatches::Link& link) const
{
  return costOfCuts * (1 - link.doubt / mostDoubt) / std::sqrt(static_cast<double>(places_.size()));
}

/// Returns the costs of cuts between the planes' normals after some turns.
double OverlappingNormals::cutsOf(const Turns& turns) const
{
  double cuts = 0;
  for (const NormalPatches::Link& link : patches_.links())
  {
    if (link.doubt >= mostDoubt)
    {
      break;
    }
    cuts += isCut(link, turns) ? this->costOf(link) : 0;
  }
  return cuts;
}

double OverlappingNormals::faultsOf(const Normals& normals) const
{
  Turns turns(places_.size());
  for (std::size_t place = 0; place < turns.size(); ++place)
  {
    turns[place] = planes_[place].dot(normals[place]) < 0;
  }
  return faultsAtWalls(field_.valuesOf(normals, Turns(places_.size(), 0))) + this->cutsOf(turns);
}

/// Returns the search for signs of patches, with bonds for the steps between them.
OverlapSigns OverlappingNormals::signsOf(
  const NormalPatches::Followers& followers, std::size_t patches) const
{
  const auto size = static_cast<Eigen::Index>(patches);
  Eigen::MatrixXd bonds = Eigen::MatrixXd::Zero(size, size);
  for (const NormalPatches::Link& link : patches_.links())
  {
    if (link.doubt >= mostDoubt)
    {
      break;
    }
    const std::uint32_t from = followers.patchOf[link.from], to = followers.patchOf[link.to];
    if (from != to)
    {
      const double bond = (isCut(link, followers.areOpposite) ? -1 : 1) * this->costOf(link);
      bonds(from, to) += bond;
      bonds(to, from) += bond;
    }
  }
  return {field_.sharesOf(planes_, followers.areOpposite, inOrderOfPatches(followers, patches)),
    std::move(bonds)};
}

OverlappingNormals::Found OverlappingNormals::improved(const Normals& senses) const
{
  constexpr std::size_t fewestPlaces = 5, mostPatches = 256;
  constexpr double mostFault = 0.25;
  constexpr float doubts[] = {0.1f, 0.15f, 0.2f};
  Found found;
  found.faults = std::numeric_limits<double>::infinity();
  Turns best(places_.size(), 0);
  NormalPatches growing(patches_);
  Progress progress(executor_);
  for (std::size_t i = 0; i < std::size(doubts); ++i)
  {
    constexpr double ofDoubt = 1.0 / std::size(doubts);
    progress.set(ofDoubt * static_cast<double>(i), ofDoubt * static_cast<double>(i + 1));
    growing.grow(doubts[i]);
    const NormalPatches::Largest largest = growing.largest(fewestPlaces, mostPatches);
    const std::size_t patches = largest.count() + 1;
    const NormalPatches::Followers followers = growing.followersOf(largest);
    const OverlapSigns search = this->signsOf(followers, patches);
    const auto faultsOfSigns = [&](const Eigen::VectorXd& signs)
    {
      return faultsAtWalls(search.valuesOf(signs)) + this->cutsOf(turnsBy(signs, followers));
    };
    const Eigen::VectorXd signs = search.improved(majorities(followers, patches, planes_, senses));
    const double faults = faultsOfSigns(signs);
    if (faults < found.faults)
    {
      found.faults = faults;
      const Eigen::VectorXd w = search.valuesOf(signs);
      found.withinSolids = (w.array() >= 1).cast<double>().mean();
      const Parity parity = parityOf(w, field_.lookedAt(), followers, signs);
      found.faultsByParity = faultsOfSigns(parity.signs) + mostFault * parity.contrary;
      best = turnsBy(signs, followers);
    }
  }
  found.normals = turned(planes_, best);
  return found;
}

bool areFarMore(double faults, double others)
{
  return faults > 1.5 * others + costOfCuts / 4;
}

} // namespace winding
