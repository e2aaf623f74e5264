// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NormalPatches.h"

#include <algorithm>
#include <numeric>

namespace winding
{

NormalPatches::NormalPatches(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor)
  : sets_(places.size())
  , places_(places.size())
{
  constexpr std::size_t stepsPerPlace = 10, placesPerBlock = 4096;
  const std::size_t perPlace = std::min(stepsPerPlace, graph.neighborsPerPlace());
  // A step and the one back are one link, which the lower place has.
  const auto hasLink = [&](std::size_t place, std::uint32_t to)
  {
    const std::uint32_t* const end = graph.end(to, perPlace);
    return to > place || std::find(graph.begin(to), end, place) == end;
  };
  // Links are counted before there are any, so that they take no more memory than they need.
  std::vector<std::size_t> starts((places.size() + placesPerBlock - 1) / placesPerBlock + 1);
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t place = first; place < last; ++place)
      {
        starts[block + 1] += static_cast<std::size_t>(std::count_if(graph.begin(place),
          graph.end(place, perPlace), [&](std::uint32_t to) { return hasLink(place, to); }));
      }
    },
    executor);
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  links_.resize(starts.back());
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      Link* link = links_.data() + starts[block];
      for (std::size_t place = first; place < last; ++place)
      {
        for (const std::uint32_t* to = graph.begin(place); to != graph.end(place, perPlace); ++to)
        {
          if (hasLink(place, *to))
          {
            const NeighborStep step = stepBetween(places, normals, place, *to);
            const bool areOpposite = normals[place].dot(normals[*to]) < 0;
            *link++ = {step.doubt, step.from, step.to, areOpposite};
          }
        }
      }
    },
    executor);
  std::sort(links_.begin(), links_.end(),
    [](const Link& a, const Link& b)
    {
      return a.doubt != b.doubt ? a.doubt < b.doubt
             : a.from != b.from ? a.from < b.from
                                : a.to < b.to;
    });
}

void NormalPatches::grow(float doubt)
{
  for (; joined_ < links_.size() && links_[joined_].doubt <= doubt; ++joined_)
  {
    const Link& link = links_[joined_];
    sets_.unite(static_cast<std::int32_t>(link.from), static_cast<std::int32_t>(link.to),
      link.areOpposite != 0);
  }
}

NormalPatches::Largest NormalPatches::largest(
  std::size_t fewestPlaces, std::size_t mostPatches) const
{
  std::vector<std::uint32_t> sizes(places_), roots(places_);
  for (std::size_t place = 0; place < places_; ++place)
  {
    roots[place] =
      static_cast<std::uint32_t>(sets_.find(static_cast<std::int32_t>(place)).representative);
    ++sizes[roots[place]];
  }
  std::vector<std::uint32_t> patches;
  for (std::size_t place = 0; place < places_; ++place)
  {
    if (sizes[place] >= fewestPlaces)
    {
      patches.push_back(static_cast<std::uint32_t>(place));
    }
  }
  std::sort(patches.begin(), patches.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return sizes[a] != sizes[b] ? sizes[a] > sizes[b] : a < b; });
  patches.resize(std::min(patches.size(), mostPatches));
  constexpr std::uint32_t none = ~std::uint32_t(0);
  std::vector<std::uint32_t> patchOf(places_, none);
  Largest largest;
  largest.starts.push_back(0);
  for (const std::uint32_t root : patches)
  {
    patchOf[root] = static_cast<std::uint32_t>(largest.starts.size() - 1);
    largest.starts.push_back(largest.starts.back() + sizes[root]);
  }
  largest.places.resize(largest.starts.back());
  std::vector<std::size_t> next(largest.starts.begin(), largest.starts.end());
  for (std::size_t place = 0; place < places_; ++place)
  {
    const std::uint32_t patch = patchOf[roots[place]];
    if (patch != none)
    {
      largest.places[next[patch]++] = static_cast<std::uint32_t>(place);
    }
  }
  return largest;
}

std::vector<unsigned char> NormalPatches::areOpposite() const
{
  std::vector<unsigned char> areOpposite(places_);
  for (std::size_t place = 0; place < places_; ++place)
  {
    areOpposite[place] = sets_.find(static_cast<std::int32_t>(place)).isOpposite;
  }
  return areOpposite;
}

NormalPatches::Followers NormalPatches::followersOf(const Largest& patches) const
{
  SensedSets sets = sets_;
  const auto none = static_cast<std::uint32_t>(patches.count());
  // Sets with a patch are never united with each other. Patches and senses are kept by
  // representative.
  Followers followers = {std::vector<std::uint32_t>(places_), std::vector<unsigned char>(places_)};
  std::vector<std::uint32_t> patchOfRoot(places_, none);
  std::vector<unsigned char> isRootOpposite(places_, 0);
  for (std::uint32_t patch = 0; patch < none; ++patch)
  {
    const std::uint32_t place = patches.places[patches.starts[patch]];
    patchOfRoot[static_cast<std::size_t>(
      sets.find(static_cast<std::int32_t>(place)).representative)] = patch;
  }
  for (std::size_t i = joined_; i < links_.size(); ++i)
  {
    const Link& link = links_[i];
    const SensedSets::Place a = sets.find(static_cast<std::int32_t>(link.from));
    const SensedSets::Place b = sets.find(static_cast<std::int32_t>(link.to));
    const auto first = static_cast<std::size_t>(a.representative);
    const auto second = static_cast<std::size_t>(b.representative);
    if (first == second || (patchOfRoot[first] != none && patchOfRoot[second] != none))
    {
      continue;
    }
    const bool areRootsOpposite = (link.areOpposite != 0) != (a.isOpposite != b.isOpposite);
    const std::size_t low = std::min(first, second);
    const std::size_t known = patchOfRoot[second] != none ? second : first;
    const std::uint32_t patch = patchOfRoot[known];
    const bool isKnownOpposite = isRootOpposite[known] != 0;
    sets.unite(static_cast<std::int32_t>(link.from), static_cast<std::int32_t>(link.to),
      link.areOpposite != 0);
    patchOfRoot[low] = patch;
    isRootOpposite[low] = isKnownOpposite != (known != low && areRootsOpposite);
  }
  for (std::size_t place = 0; place < places_; ++place)
  {
    const SensedSets::Place found = sets.find(static_cast<std::int32_t>(place));
    const auto root = static_cast<std::size_t>(found.representative);
    followers.patchOf[place] = patchOfRoot[root];
    followers.areOpposite[place] = (isRootOpposite[root] != 0) != found.isOpposite;
  }
  return followers;
}

void NormalPatches::propagate(const Largest& patches, std::vector<unsigned char>& isTurned) const
{
  const Followers followers = this->followersOf(patches);
  std::vector<unsigned char> isPatchTurned(patches.count() + 1, 0);
  for (std::size_t patch = 0; patch < patches.count(); ++patch)
  {
    const std::uint32_t place = patches.places[patches.starts[patch]];
    isPatchTurned[patch] = isTurned[place] != followers.areOpposite[place];
  }
  for (std::size_t place = 0; place < places_; ++place)
  {
    isTurned[place] = isPatchTurned[followers.patchOf[place]] != followers.areOpposite[place];
  }
}

} // namespace winding
