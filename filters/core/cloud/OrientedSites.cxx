#include "cloud/OrientedSites.h"

namespace winding
{

OrientedSites::OrientedSites(
  const PointCloud& cloud, const DistinctPoints& places, Executor& executor)
  : starts_(places.size() + 1)
  , siteOf_(cloud.positions.size())
{
  // Each place's points are put into groups numbered from 0 first; the sums of the places' numbers
  // of groups then tell where each place's sites begin.
  constexpr std::size_t placesPerBlock = 4096;
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<std::uint32_t> founders;
      for (std::size_t place = first; place < last; ++place)
      {
        founders.clear();
        for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
        {
          std::uint32_t group = 0;
          while (group < founders.size() &&
                 !areSimilar(cloud.normals[founders[group]], cloud.normals[*point]))
          {
            ++group;
          }
          if (group == founders.size())
          {
            founders.push_back(*point);
          }
          siteOf_[*point] = group;
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
      for (std::size_t place = first; place < last; ++place)
      {
        for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
        {
          siteOf_[*point] += starts_[place];
          OrientedSite& site = sites_[siteOf_[*point]];
          site.normal += cloud.normals[*point];
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
