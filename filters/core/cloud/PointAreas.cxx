// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PointAreas.h"

#include "base/Digits.h"
#include "base/Pi.h"
#include "base/Progress.h"
#include "base/Refusal.h"
#include "cloud/NeighborSearch.h"
#include "cloud/OrientedSites.h"
#include "cloud/VoronoiCell.h"
#include "source/DistinctPoints.h"
#include "source/Sanitize.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace winding
{

namespace
{

/// The distance at which a cell ends that no neighbours close, in units of the distance up to which
/// the point's neighbours are known, `neighbors` in number. All bisectors within half of that
/// distance are known, too. Among points at random, a disk of the radius returned holds seven, and
/// so nearly all of a cell: e^−7 of it is farther away.
double farthestCorner(std::size_t neighbors)
{
  return std::max(0.6, std::sqrt(7.0 / static_cast<double>(neighbors)));
}

/**
 * Returns how many points a spot of the cloud has, as several scans of one place leave it: more
 * than `least` that lie far nearer to each other than the points around them. On a surface the
 * squared distance doubles with the number of neighbours; around a spot it grows sixfold. Some
 * places are tried, and the median counts. Returns 0 where fewer than half of them lie in spots.
 */
std::size_t pointsOfSpots(
  const DistinctPoints& places, const NeighborSearch& search, std::size_t least)
{
  constexpr std::size_t tried = 32, most = 1280, leastSpots = 50; // that make a surface
  constexpr double growth = 6;
  const std::size_t count = std::min(most, places.size() / leastSpots);
  std::vector<std::size_t> found;
  std::vector<Neighbor> neighbors;
  NeighborSearch::Last last;
  for (std::size_t i = 0; i < tried && count > 2 * least; ++i)
  {
    search.find(i * places.size() / tried, count, neighbors, last);
    const auto squared = [&neighbors](std::size_t n)
    {
      return neighbors[n - 1].squaredDistance;
    };
    std::size_t n = least;
    while (2 * n <= neighbors.size() && squared(2 * n) < growth * squared(n))
    {
      ++n;
    }
    if (2 * n <= neighbors.size())
    {
      std::size_t ofSpot = n;
      for (std::size_t other = n + 1; other < 2 * n; ++other)
      {
        const bool isFarther =
          squared(other + 1) * squared(ofSpot) > squared(ofSpot + 1) * squared(other);
        ofSpot = isFarther ? other : ofSpot;
      }
      found.push_back(ofSpot + 1);
    }
  }
  std::sort(found.begin(), found.end());
  return 2 * found.size() >= tried ? found[found.size() / 2] : 0;
}

class VoronoiAreas
{
public:
  VoronoiAreas(
    const PointCloud& cloud, const DistinctPoints& places, int neighbors, Executor& executor)
    : cloud_(cloud)
    , places_(places)
    , sites_(cloud, places_, executor)
    , search_(places_, executor)
    , neighbors_(static_cast<std::size_t>(std::max(neighbors, 3)))
    , spot_(pointsOfSpots(places_, search_, (neighbors_ + 7) / 8))
    , areasAround_(places_.size())
    , areas_(sites_.size())
  {
  }

  std::vector<double> compute(Executor& executor);

private:
  /// The range of directions between two neighbours that follow each other around a point.
  struct Gap
  {
    double from, to;
  };

  /// The memory that one thread works with, reused from site to site.
  struct Workspace
  {
    std::vector<Neighbor> neighbors;
    NeighborSearch::Last last;
    std::vector<Eigen::Vector2d> around;        ///< neighbours that count, in the tangent plane
    std::vector<double> angles, openDirections; ///< angles in [0, 2π)
    std::vector<Gap> gaps;
    VoronoiCell cell;
    double reach = 0; ///< distance of the farthest neighbour that counts
  };

  template <class Work>
  void forEachSiteOf(const std::vector<std::uint32_t>& places, std::size_t neighbors,
    const Work& work, Executor& executor);

  void flatten(std::size_t place, std::size_t site, Workspace& space) const;
  void makeCell(Workspace& space) const;
  void closeBorder(Workspace& space) const;
  double mostAreaOf(const Workspace& space, double coveredAngle) const;

  const PointCloud& cloud_;
  const DistinctPoints& places_;
  const OrientedSites sites_;
  const NeighborSearch search_;
  const std::size_t neighbors_, spot_;
  /// By place: the area of the disk that holds its neighbours, divided by their number.
  std::vector<double> areasAround_;
  std::vector<double> areas_; ///< by site: area of its cell in scaled coordinates
};

/// Projects the neighbours that count into the tangent plane: those with similar normals, or all
/// where nearly none are similar. There the site's own normal is at fault, and without the others
/// it would have the area of many.
void VoronoiAreas::flatten(std::size_t place, std::size_t site, Workspace& space) const
{
  const Eigen::Vector3d& normal = sites_[site].normal;
  const auto isSimilar = [&](const Neighbor& neighbor)
  {
    return sites_.hasSimilar(neighbor.place, normal);
  };
  const auto similar = std::count_if(space.neighbors.begin(), space.neighbors.end(), isSimilar);
  // Fewer than a quarter are nearly none: only one point in 200 of thin parts, where half of the
  // neighbours belong to the other side, has fewer.
  const bool takesAll = 4 * static_cast<std::size_t>(similar) < space.neighbors.size();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  space.around.clear();
  space.reach = 0;
  for (const Neighbor& neighbor : space.neighbors)
  {
    if (takesAll || isSimilar(neighbor))
    {
      const Eigen::Vector3d offset =
        places_.positions()[neighbor.place] - places_.positions()[place];
      const Eigen::Vector2d flat(offset.dot(u), offset.dot(v));
      // A neighbour straight above or below is put at the origin, where it cuts nothing: rounding
      // alone would decide where it cuts.
      constexpr double rounding = 1e-9;
      space.around.push_back(flat.squaredNorm() > rounding * rounding * neighbor.squaredDistance
                               ? flat
                               : Eigen::Vector2d(0, 0));
      space.reach = std::sqrt(neighbor.squaredDistance);
    }
  }
}

void VoronoiAreas::makeCell(Workspace& space) const
{
  if (space.around.empty())
  {
    space.reach = std::sqrt(space.neighbors.back().squaredDistance);
  }
  space.cell.start(space.reach * farthestCorner(std::max<std::size_t>(space.around.size(), 1)));
  for (const Eigen::Vector2d& neighbor : space.around)
  {
    space.cell.cut(neighbor);
  }
}

/// The largest area that a point at a border may stand for: its share of the sector where its
/// neighbours are, and not much more than they have themselves, or a far outlier would outweigh
/// all.
double VoronoiAreas::mostAreaOf(const Workspace& space, double coveredAngle) const
{
  double largest = 0;
  for (const Neighbor& neighbor : space.neighbors)
  {
    largest = std::max(largest, areasAround_[neighbor.place]);
  }
  const double sector = std::max(coveredAngle, pi / 3) / 2 * space.reach * space.reach;
  const auto count = static_cast<double>(std::max<std::size_t>(space.around.size(), 1));
  return space.around.empty() ? largest : std::min(sector / count, 2 * largest);
}

/// Cuts the cell as if neighbours stood also where it is open, as far apart as they do elsewhere.
void VoronoiAreas::closeBorder(Workspace& space) const
{
  std::vector<double>&angles = space.angles, &open = space.openDirections;
  angles.clear();
  for (const Eigen::Vector2d& neighbor : space.around)
  {
    if (neighbor != Eigen::Vector2d::Zero())
    {
      const double angle = std::atan2(neighbor[1], neighbor[0]);
      angles.push_back(angle < 0 ? angle + 2 * pi : angle);
    }
  }
  if (angles.empty())
  {
    angles.push_back(0);
  }
  std::sort(angles.begin(), angles.end());
  open.clear();
  space.cell.appendOpenDirections(open);
  std::vector<Gap>& gaps = space.gaps;
  gaps.clear();
  double coveredAngle = 2 * pi;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    const bool isLast = i + 1 == angles.size();
    const Gap gap = {angles[i], isLast ? angles[0] + 2 * pi : angles[i + 1]};
    const bool isOpen = std::any_of(open.begin(), open.end(),
      [&](double angle)
      { return (gap.from < angle && angle < gap.to) || (isLast && angle < angles[0]); });
    if (isOpen)
    {
      gaps.push_back(gap);
      coveredAngle -= gap.to - gap.from;
    }
  }
  // The distance is the one of neighbours in a hexagonal lattice whose points have the area
  // mostAreaOf().
  const double distance = std::sqrt(2 / std::sqrt(3.0) * this->mostAreaOf(space, coveredAngle));
  for (const auto& [from, to] : gaps)
  {
    const int parts = std::max(2, static_cast<int>(std::ceil((to - from) / (pi / 3))));
    for (int part = 1; part < parts; ++part)
    {
      const double angle = from + (to - from) * part / parts;
      space.cell.cut(distance * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
}

/// Calls work(place, site, space) for the sites of some places, once `neighbors` neighbours are
/// found and flattened.
template <class Work>
void VoronoiAreas::forEachSiteOf(const std::vector<std::uint32_t>& places, std::size_t neighbors,
  const Work& work, Executor& executor)
{
  constexpr std::size_t placesPerBlock = 512;
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Workspace space;
      for (std::size_t i = first; i < last; ++i)
      {
        const std::size_t place = places[i];
        search_.find(place, neighbors, space.neighbors, space.last);
        for (std::size_t site = sites_.begin(place); site < sites_.end(place); ++site)
        {
          this->flatten(place, site, space);
          work(place, site, space);
        }
      }
    },
    executor);
}

std::vector<double> VoronoiAreas::compute(Executor& executor)
{
  std::vector<double> areas(cloud_.positions.size());
  if (places_.size() < 2)
  {
    return areas;
  }
  std::vector<std::uint32_t> places(places_.size());
  std::iota(places.begin(), places.end(), 0);
  std::vector<unsigned char> needsMore(places_.size());
  Progress progress(executor);
  progress.set(0, 0.6);
  this->forEachSiteOf(
    places, std::max(neighbors_, 2 * spot_),
    [&](std::size_t place, std::size_t site, Workspace& space)
    {
      areasAround_[place] =
        pi * space.neighbors.back().squaredDistance / static_cast<double>(space.neighbors.size());
      this->makeCell(space);
      areas_[site] = space.cell.area();
      // In thin parts half of the neighbours belong to the other side.
      const bool areFew = 4 * space.around.size() < 3 * space.neighbors.size();
      needsMore[place] = needsMore[place] || areFew || space.cell.isOpen();
    },
    executor);

  constexpr std::size_t spotsAround = 30; // leave 1 in 400 of the area out; 20 leave 1 in 50
  // The places left are done again with more neighbours, and with areasAround_ of all places known.
  const auto isDone = [&](std::uint32_t place)
  {
    return !needsMore[place];
  };
  progress.set(0.6, 1);
  places.erase(std::remove_if(places.begin(), places.end(), isDone), places.end());
  this->forEachSiteOf(
    places, std::max(4 * neighbors_, spotsAround * spot_),
    [&](std::size_t, std::size_t site, Workspace& space)
    {
      this->makeCell(space);
      if (space.cell.isOpen())
      {
        this->closeBorder(space);
      }
      areas_[site] = space.cell.area();
    },
    executor);

  forEachItem(
    areas.size(),
    [&](std::size_t point)
    {
      const std::size_t site = sites_.siteOf(point);
      areas[point] = areas_[site] / sites_[site].points / places_.scale() / places_.scale();
    },
    executor);
  return areas;
}

} // namespace

std::vector<double> voronoiAreas(
  const PointCloud& cloud, const DistinctPoints& places, int neighbors, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.2);
  VoronoiAreas areas(cloud, places, neighbors, executor);
  progress.set(0.2, 1);
  return areas.compute(executor);
}

double meanPointArea(
  const PointCloud& cloud, const DistinctPoints& places, int neighbors, Executor& executor)
{
  // Areas are sorted before they are summed, so that the mean does not depend on the order of the
  // points.
  std::vector<double> areas = voronoiAreas(cloud, places, neighbors, executor);
  std::sort(areas.begin(), areas.end());
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  return areas.empty() ? 0 : sum / static_cast<double>(areas.size());
}

void checkPointArea(double pointArea)
{
  if (!(pointArea >= 0) || !std::isfinite(pointArea))
  {
    throw Refusal(Message(Parameter::pointArea,
      "is " + inDigits(pointArea) + "; it must be more than 0, or 0 to have it estimated"));
  }
}

Message missingPointArea(const std::string& consequence)
{
  return {"points at one place have no areas", {{"", {Parameter::pointArea}}}, consequence};
}

std::vector<double> pointAreas(
  const PointCloud& cloud, const PointAreaOptions& options, Executor& executor)
{
  const bool needsPlaces = options.method == PointAreaMethod::voronoi || !(options.pointArea > 0);
  static const std::vector<Eigen::Vector3d> none;
  const DistinctPoints places(
    needsPlaces ? cloud.positions : none, unitScale(cloud.bounds), executor);
  return pointAreas(cloud, places, options, executor);
}

std::vector<double> pointAreas(const PointCloud& cloud, const DistinctPoints& places,
  const PointAreaOptions& options, Executor& executor)
{
  const double pointArea = options.pointArea;
  if (options.method == PointAreaMethod::voronoi)
  {
    return voronoiAreas(cloud, places, options.neighbors, executor);
  }
  const double largest = largestArea(cloud.bounds);
  if (pointArea > largest)
  {
    throw Refusal(Message(Parameter::pointArea,
      joined("is ", pointArea, "; in a cloud of this size it may be up to ", largest)));
  }
  const double area =
    pointArea > 0 ? pointArea : meanPointArea(cloud, places, options.neighbors, executor);
  return std::vector<double>(cloud.positions.size(), area);
}

} // namespace winding
