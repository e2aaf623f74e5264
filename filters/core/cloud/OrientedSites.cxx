// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/OrientedSites.h"

#include "source/CompareCoordinates.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Sets `points` to the points of a place, in an order that their normals alone decide.
const std::vector<std::uint32_t>& inOrderOfNormals(const PointCloud& cloud,
  const DistinctPoints& places, std::size_t place, std::vector<std::uint32_t>& points)
{
  points.assign(places.begin(place), places.end(place));
  std::sort(points.begin(), points.end(),
    [&cloud](std::uint32_t a, std::uint32_t b)
    { return compareCoordinates(cloud.normals[a], cloud.normals[b]) < 0; });
  return points;
}

} // namespace

OrientedSites::OrientedSites(
  const PointCloud& cloud, const DistinctPoints& places, Executor& executor)
  : starts_(places.size() + 1)
  , siteOf_(cloud.positions.size())
{
  // Each place's points are put into groups numbered from 0 first; the sums of the places' numbers
  // of groups then say where each place's sites begin.
  constexpr std::size_t placesPerBlock = 4096;
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<std::uint32_t> founders, points;
      for (std::size_t place = first; place < last; ++place)
      {
        founders.clear();
        for (const std::uint32_t point : inOrderOfNormals(cloud, places, place, points))
        {
          std::uint32_t group = 0;
          while (group < founders.size() &&
                 !areSimilar(cloud.normals[founders[group]], cloud.normals[point]))
          {
            ++group;
          }
          if (group == founders.size())
          {
            founders.push_back(point);
          }
          siteOf_[point] = group;
        }
        starts_[place + 1] = static_cast<std::uint32_t>(founders.size());
      }
    },
    executor);
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    starts_[place + 1] += starts_[place];
  }
  sites_.assign(starts_.back(), {Eigen::Vector3d::Zero(), 0});
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<std::uint32_t> points;
      for (std::size_t place = first; place < last; ++place)
      {
        for (const std::uint32_t point : inOrderOfNormals(cloud, places, place, points))
        {
          siteOf_[point] += starts_[place];
          OrientedSite& site = sites_[siteOf_[point]];
          site.normal += cloud.normals[point];
          ++site.points;
        }
        for (std::size_t site = this->begin(place); site < this->end(place); ++site)
        {
          sites_[site].normal.normalize();
        }
      }
    },
    executor);
}

} // namespace winding
