// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/BandRoots.h"

#include "distance/CellDescent.h"
#include "distance/GridSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Roots may be off by this share of an edge.
constexpr double shareOfEdge = 1.0 / (1 << 20);

/// The search for the place on an edge at a distance from the surface.
struct Search
{
  std::uint32_t edge;
  double near, far; ///< fractions of the edge: the distance at `near` is less, at `far` it is not
  double limit;     ///< the distance, in the tree's coordinates
};

/// The line through an edge in the coordinates of a tree.
struct Line
{
  Eigen::Vector3d begin, along;

  Eigen::Vector3d at(double fraction) const { return begin + fraction * along; }
};

/// Searches as CellDescent.h wants them: a part is a range of them, which gets sorted into halves.
class Searches
{
public:
  struct Part
  {
    Search *first, *last;
  };
  using Name = std::monostate;

  /// Keeps references.
  Searches(const DistanceTree& tree, const Grid& grid, const LevelEdges& edges, EdgeRoots& roots)
    : tree_(tree)
    , grid_(grid)
    , edges_(edges)
    , roots_(roots)
  {
  }

  static std::size_t count(const Part& part)
  {
    return static_cast<std::size_t>(part.last - part.first);
  }

  static bool isAskedFor(const Part& part) { return part.first != part.last; }

  /// Returns the box of the whole edges.
  Bounds boxOf(const Part& part) const
  {
    const auto [low, high] = this->rangeOf(part);
    return {this->scaled(low), this->scaled(high)};
  }

  /// Halves a part across the longest side of its box.
  std::pair<Part, Part> halves(const Part& part) const
  {
    const auto [low, high] = this->rangeOf(part);
    int axis;
    (high - low).cast<double>().cwiseProduct(grid_.spacing).maxCoeff(&axis);
    const auto along = static_cast<std::size_t>(axis);
    Search* const middle = part.first + (part.last - part.first) / 2;
    std::nth_element(part.first, middle, part.last,
      [this, along](const Search& a, const Search& b)
      { return edges_[a.edge].sample[along] < edges_[b.edge].sample[along]; });
    return {{part.first, middle}, {middle, part.last}};
  }

  double settle(const Part& part, const std::uint32_t* items, std::size_t count) const;

private:
  struct Place;
  class Steps;

  /// Returns the lowest and the highest indices of the edges' samples.
  std::pair<Eigen::Vector3i, Eigen::Vector3i> rangeOf(const Part& part) const
  {
    Eigen::Vector3i low = Eigen::Vector3i::Constant(std::numeric_limits<int>::max()), high = -low;
    for (const Search* search = part.first; search != part.last; ++search)
    {
      const GridEdge& edge = edges_[search->edge];
      Eigen::Vector3i sample(edge.sample[0], edge.sample[1], edge.sample[2]);
      low = low.cwiseMin(sample);
      ++sample[edge.axis];
      high = high.cwiseMax(sample);
    }
    return {low, high};
  }

  Eigen::Vector3d scaled(const Eigen::Vector3i& sample) const
  {
    return scaledSample(grid_, sample[0], sample[1], sample[2], tree_.scale());
  }

  Line lineOf(std::uint32_t number) const
  {
    const GridEdge& edge = edges_[number];
    Eigen::Vector3i sample(edge.sample[0], edge.sample[1], edge.sample[2]);
    const Eigen::Vector3d begin = this->scaled(sample);
    ++sample[edge.axis];
    return {begin, this->scaled(sample) - begin};
  }

  const DistanceTree& tree_;
  const Grid& grid_;
  const LevelEdges& edges_;
  EdgeRoots& roots_;
};

/// A fraction of an edge, and an item there.
struct Searches::Place
{
  double fraction;
  Nearest nearest;

  double distance() const { return std::sqrt(nearest.squared); }
};

/// The steps of one search. They are done with the nearest item at one place after another.
class Searches::Steps
{
public:
  Steps() = default;
  Steps(const DistanceTree& tree, const Search& search, const Line& line)
    : tree_(&tree)
    , search_(search)
    , line_(line)
    , next_(0.5 * (search.near + search.far))
    , isDone_(false)
  {
  }

  const Search& search() const { return search_; }
  bool isDone() const { return isDone_; }

  /// The place at which to evaluate next, and the root once done.
  double fraction() const { return next_; }
  Eigen::Vector3d position() const { return line_.at(next_); }

  /// Takes what is nearest to the place, and finds the next one.
  void take(const Nearest& nearest)
  {
    // Bisection follows where items take turns too often.
    constexpr int mostByItems = 8;
    const Place here = {next_, nearest};
    const double distance = here.distance();
    (distance < search_.limit ? search_.near : search_.far) = next_;
    const double middle = 0.5 * (search_.near + search_.far);
    isDone_ = std::abs(distance - search_.limit) <= shareOfEdge * line_.along.norm() ||
              std::abs(search_.far - search_.near) <= shareOfEdge;
    if (isDone_)
    {
      return;
    }
    next_ = middle;
    if (++steps_ <= mostByItems)
    {
      const Place near =
        distance < search_.limit ? here : this->placeFrom(nearest.item, search_.near);
      const Place far =
        distance < search_.limit ? this->placeFrom(nearest.item, search_.far) : here;
      if (near.distance() < search_.limit && far.distance() > search_.limit)
      {
        next_ = this->rootOfItem(near, far);
      }
    }
  }

private:
  Place placeFrom(std::uint32_t item, double fraction) const
  {
    Place place = {fraction, {infinite, {0, 0, 0}, item}};
    tree_->compare(line_.at(fraction), item, place.nearest);
    return place;
  }

  /// Returns where the distance from an item is the limit, between two places where it is less and
  /// more.
  double rootOfItem(const Place& near, const Place& far) const
  {
    constexpr int mostSteps = 64; // about three do, and bisection needs 52
    const double limit = search_.limit;
    // The distance is convex: its chord's root is on the near side of the root.
    double low = near.fraction, high = far.fraction;
    double next =
      low + (high - low) * (limit - near.distance()) / (far.distance() - near.distance());
    for (int step = 0; step < mostSteps; ++step)
    {
      const Place place = this->placeFrom(near.nearest.item, next);
      const double distance = place.distance(), off = distance - limit;
      (off < 0 ? low : high) = next;
      const auto [least, most] = std::minmax(low, high);
      const double middle = 0.5 * (least + most);
      if (std::abs(off) <= 4 * std::numeric_limits<double>::epsilon() * limit ||
          !(middle > least && middle < most))
      {
        break;
      }
      const double slope = Eigen::Vector3d(place.nearest.offset).dot(line_.along) / distance;
      const double newton = next - off / slope; // NaN on the item: the middle follows
      next = newton > least && newton < most ? newton : middle;
    }
    return next;
  }

  const DistanceTree* tree_ = nullptr;
  Search search_ = {};
  Line line_;
  double next_ = 0;
  int steps_ = 0;
  bool isDone_ = true;
};

/// Settles searches, some of them at once, and writes their roots.
double Searches::settle(const Part& part, const std::uint32_t* items, std::size_t count) const
{
  double work = 0;
  SampleBlock block;
  for (const Search* first = part.first; first < part.last; first += samplesAtOnce)
  {
    block.count = std::min(samplesAtOnce, static_cast<std::size_t>(part.last - first));
    Steps steps[samplesAtOnce];
    for (std::size_t n = 0; n < block.count; ++n)
    {
      steps[n] = Steps(tree_, first[n], this->lineOf(first[n].edge));
    }
    Nearest nearest[samplesAtOnce];
    for (bool isLeft = true; isLeft;)
    {
      for (std::size_t n = 0; n < block.count; ++n)
      {
        block.set(n, steps[n].position());
      }
      if (count > 0)
      {
        tree_.findNearestOfEach(items, count, block, nearest);
        work += static_cast<double>(samplesAtOnce * count);
      }
      isLeft = false;
      for (std::size_t n = 0; n < block.count; ++n)
      {
        if (steps[n].isDone())
        {
          continue;
        }
        if (count == 0)
        {
          nearest[n].squared = infinite;
          const std::size_t looked = tree_.findNearest(steps[n].position(), 0, nearest[n]);
          work += static_cast<double>(samplesAtOnce * looked);
        }
        steps[n].take(nearest[n]);
        isLeft = isLeft || !steps[n].isDone();
        if (steps[n].isDone())
        {
          const std::uint32_t edge = steps[n].search().edge;
          roots_.fractions[edge] = steps[n].fraction();
          roots_.normals[edge] =
            Eigen::Vector3d(nearest[n].offset).stableNormalized().cast<float>();
        }
      }
    }
  }
  return work;
}

/// The edges of a solid's shape, the solid's own, and the limits between them.
class Limits
{
public:
  Limits(const DistanceTree& tree, const Grid& grid, const LevelEdges& edges,
    const LevelEdges& solid, const EdgeRoots& solidRoots, const DistanceBand& band)
    : tree_(tree)
    , grid_(grid)
    , edges_(edges)
    , solid_(solid)
    , solidRoots_(solidRoots)
    , band_(band)
  {
  }

  /// Returns the search for the root on an edge. Its limit is 0 where the solid's root is the root,
  /// and `near` is that.
  Search searchOf(std::uint32_t number) const
  {
    const GridEdge& edge = edges_[number];
    std::array<int, 3> ends[2] = {edge.sample, edge.sample};
    ++ends[1][edge.axis];
    const int out = edge.firstIsInside ? 1 : 0;
    const bool isOutInside = solid_.isSampleInside(ends[out]);
    const bool isHigh = band_.low <= 0 && band_.high >= 0
                          ? !isOutInside
                          : band_.isAbove(isOutInside, this->distanceOf(ends[out]));
    const double limit = isHigh ? band_.high : band_.low;
    Search search = {number, 0, 0, std::abs(limit) * tree_.scale()};
    // The limit is on one side of the solid's surface. The edge may cross that, too.
    const std::size_t crossing = solid_.find(edge.sample, edge.axis);
    if (crossing != solid_.size())
    {
      search.near = solidRoots_.fractions[crossing];
      search.far = solid_[crossing].firstIsInside == (limit < 0) ? 0 : 1;
    }
    else
    {
      search.far = isHigh == (limit > 0) ? out : 1 - out;
      search.near = 1 - search.far;
    }
    return search;
  }

private:
  double distanceOf(const std::array<int, 3>& sample) const
  {
    Nearest nearest = {infinite, {0, 0, 0}};
    tree_.findNearest(
      scaledSample(grid_, sample[0], sample[1], sample[2], tree_.scale()), 0, nearest);
    return std::sqrt(nearest.squared) / tree_.scale();
  }

  const DistanceTree& tree_;
  const Grid& grid_;
  const LevelEdges& edges_;
  const LevelEdges& solid_;
  const EdgeRoots& solidRoots_;
  const DistanceBand& band_;
};

} // namespace

EdgeRoots bandRoots(const DistanceTree& tree, const Grid& grid, const LevelEdges& edges,
  const LevelEdges& solid, const EdgeRoots& solidRoots, const DistanceBand& band,
  Executor& executor, const LevelEdges* others)
{
  EdgeRoots roots(edges.size());
  if (tree.empty())
  {
    return roots;
  }
  const Limits limits(tree, grid, edges, solid, solidRoots, band);
  std::vector<Search> searches(edges.size());
  forEachItem(
    edges.size(),
    [&](std::size_t n)
    {
      Search& search = searches[n];
      search = limits.searchOf(static_cast<std::uint32_t>(n));
      if (search.limit == 0)
      {
        const std::size_t crossing = solid.find(edges[n].sample, edges[n].axis);
        roots.fractions[n] = search.near;
        roots.normals[n] = solidRoots.normals[crossing];
      }
    },
    executor);
  const auto isLeftOut = [&](const Search& search)
  {
    const GridEdge& edge = edges[search.edge];
    return search.limit == 0 || edges.isAtBorder(edge) ||
           (others && others->find(edge.sample, edge.axis) < others->size());
  };
  searches.erase(std::remove_if(searches.begin(), searches.end(), isLeftOut), searches.end());
  // Edges come by layers; some layers together make a part.
  constexpr int layersPerPart = 16;
  std::vector<Searches::Part> parts;
  int last = 0;
  for (Search& search : searches)
  {
    const int layer = edges[search.edge].sample[2] / layersPerPart;
    if (parts.empty() || layer != last)
    {
      parts.push_back({&search, &search});
      last = layer;
    }
    ++parts.back().last;
  }
  evaluateByCells(tree, infinite, Searches(tree, grid, edges, roots), std::move(parts), executor);
  return roots;
}

} // namespace winding
