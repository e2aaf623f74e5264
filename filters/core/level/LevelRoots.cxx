// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelRoots.h"

#include "base/Views.h"
#include "farfield/FarFieldAccuracy.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Brackets are halved until they are `shortest` long, as a fraction of an edge: a power of 2.
constexpr int halvings = 14;
constexpr double shortest = 1.0 / (1 << halvings);

/// The field is evaluated this far before and behind a crossing, as a fraction of an edge: far more
/// than the rounding of crossings, far less than what matters.
constexpr double besideCrossing = 1.0 / (1 << 20);

constexpr std::size_t edgesPerBlock = 4096;

/// The place where ITP evaluates next, with κ₁ = 0.2, κ₂ = 2 and n₀ = 1, on a bracket that was of
/// length 1.
double nextByItp(double low, double high, double lowLevel, double highLevel, int step)
{
  const double middle = 0.5 * (low + high), width = high - low;
  const double slope = highLevel - lowLevel;
  const double secant =
    slope != 0 ? std::clamp((highLevel * low - lowLevel * high) / slope, low, high) : middle;
  const double towardsMiddle = std::copysign(1.0, middle - secant);
  const double shift = 0.2 * width * width;
  const double truncated =
    shift <= std::abs(middle - secant) ? secant + towardsMiddle * shift : middle;
  const double slack = std::max(0.0, std::ldexp(shortest, halvings - step) - 0.5 * width);
  return std::abs(truncated - middle) <= slack ? truncated : middle - towardsMiddle * slack;
}

} // namespace

LevelRoots::LevelRoots(const Field& field, const Grid& grid, const LevelEdges& edges,
  const InsideTest& isInside, double tolerance, Executor& executor)
  : field_(field)
  , grid_(grid)
  , edges_(edges)
  , isInside_(isInside)
  , levelTolerance_(0.05 * std::max(tolerance, FarFieldAccuracy::finest))
  , jumpsOnly_(field.info().jumpsOnly())
  , isParity_(field.info().method == Method::parity)
  , roots_(edges.size())
{
  if (field.surface())
  {
    crossings_ =
      std::make_unique<const EdgeCrossings>(*field.distinctSurface(), grid, edges, executor);
  }
  // Most edges of closed surfaces are done by their crossings alone: no search takes memory for
  // them.
  std::vector<std::vector<Search>> found((edges.size() + edgesPerBlock - 1) / edgesPerBlock);
  runBlocks(
    edges.size(), edgesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        if (edges.isAtBorder(edges[i]))
        {
          continue;
        }
        Search search = {};
        search.edge = static_cast<std::uint32_t>(i);
        const std::array<float, 2>* values = edges.values(i);
        search.lowWinding = values ? (*values)[0] : edges[i].windings[0];
        search.highWinding = values ? (*values)[1] : edges[i].windings[1];
        if (this->isFoundByCrossings(search))
        {
          continue;
        }
        search.lowLevel = isInside_.levelOf(search.lowWinding);
        search.highLevel = isInside_.levelOf(search.highWinding);
        found[block].push_back(search);
      }
    },
    executor);
  for (const std::vector<Search>& some : found)
  {
    searches_.insert(searches_.end(), some.begin(), some.end());
  }
  this->dropFound(executor);
}

/// The crossings of an edge from one fraction to another, both included; clouds have none.
LevelRoots::CrossingRange LevelRoots::crossingsBetween(
  std::size_t edge, double low, double high) const
{
  if (!crossings_)
  {
    return {};
  }
  const EdgeCrossings::Crossing *first = crossings_->begin(edge), *last = crossings_->end(edge);
  while (first != last && first->fraction < low)
  {
    ++first;
  }
  while (first != last && last[-1].fraction > high)
  {
    --last;
  }
  return {first, last};
}

/// Keeps the crossing in a bracket as the root if w changes at only one there, by as much as the
/// field does in all. Returns whether it did.
bool LevelRoots::isFoundByCrossings(const Search& search)
{
  const auto changes = [](const EdgeCrossings::Crossing& crossing)
  {
    return crossing.change != 0;
  };
  const auto [first, last] = this->crossingsBetween(search.edge, search.low, search.high);
  if (!jumpsOnly_ || std::count_if(first, last, changes) != 1)
  {
    return false;
  }
  const auto* const crossing = std::find_if(first, last, changes);
  double unexplained = search.highWinding - search.lowWinding - crossing->change;
  unexplained = isParity_ ? std::remainder(unexplained, 2) : unexplained;
  // The field of a closed surface is inexact, but close to integers off the surface.
  if (std::abs(unexplained) > 0.25)
  {
    return false;
  }
  roots_.fractions[search.edge] = crossing->fraction;
  roots_.normals[search.edge] = crossing->normal;
  return true;
}

/// Keeps the best root known, and returns whether it is good enough.
bool LevelRoots::isFound(const Search& search)
{
  if (this->isFoundByCrossings(search))
  {
    return true;
  }
  double& root = roots_.fractions[search.edge];
  if (search.high - search.low <= shortest)
  {
    root = 0.5 * (search.low + search.high);
    const auto [first, last] = this->crossingsBetween(search.edge, search.low, search.high);
    if (first != last)
    {
      roots_.normals[search.edge] = first[(last - first) / 2].normal;
    }
    return true;
  }
  const bool lowIsCloser = std::abs(search.lowLevel) < std::abs(search.highLevel);
  root = lowIsCloser ? search.low : search.high;
  // A field that only jumps has the level by accident only, where a sample on the surface has a
  // mean of the values around it.
  return !jumpsOnly_ &&
         std::min(std::abs(search.lowLevel), std::abs(search.highLevel)) <= levelTolerance_;
}

void LevelRoots::chooseNext(Search& search) const
{
  auto [first, last] = this->crossingsBetween(search.edge, search.low, search.high);
  while (first != last && first->fraction == search.low)
  {
    ++first;
  }
  while (first != last && last[-1].fraction == search.high)
  {
    --last;
  }
  if (first != last)
  {
    const double crossing = first[(last - first) / 2].fraction;
    const double before = crossing - besideCrossing, behind = crossing + besideCrossing;
    search.next = before > search.low ? before : std::min(behind, 0.5 * (crossing + search.high));
    return;
  }
  // The field changes next to one of the two samples, which lies on the surface.
  const double beside = std::min(besideCrossing, 0.5 * (search.high - search.low));
  if (jumpsOnly_ && search.steps < 2)
  {
    search.next = search.steps == 0 ? search.low + beside : search.high - beside;
    ++search.steps;
    return;
  }
  search.next = nextByItp(search.low, search.high, search.lowLevel, search.highLevel, search.steps);
  ++search.steps;
}

void LevelRoots::narrow(Search& search, double windingNumber) const
{
  const double level = isInside_.levelOf(windingNumber);
  if (isInside_(windingNumber) == edges_[search.edge].firstIsInside)
  {
    search.low = search.next;
    search.lowWinding = windingNumber;
    search.lowLevel = level;
  }
  else
  {
    search.high = search.next;
    search.highWinding = windingNumber;
    search.highLevel = level;
  }
}

/// Drops the searches whose roots are found, and keeps the others in their order.
void LevelRoots::dropFound(Executor& executor)
{
  std::vector<unsigned char> goesOn(searches_.size());
  runBlocks(
    searches_.size(), edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        goesOn[i] = !this->isFound(searches_[i]);
        if (goesOn[i])
        {
          this->chooseNext(searches_[i]);
        }
      }
    },
    executor);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < searches_.size(); ++i)
  {
    if (goesOn[i])
    {
      searches_[kept++] = searches_[i];
    }
  }
  searches_.resize(kept);
}

void LevelRoots::advance(Executor& executor)
{
  std::vector<double> positions(3 * searches_.size()), values(searches_.size());
  for (std::size_t i = 0; i < searches_.size(); ++i)
  {
    const GridEdge& edge = edges_[searches_[i].edge];
    Eigen::Vector3d steps(edge.sample[0], edge.sample[1], edge.sample[2]);
    steps[edge.axis] += searches_[i].next;
    const Eigen::Vector3d position = grid_.firstSample + steps.cwiseProduct(grid_.spacing);
    std::copy_n(position.data(), 3, &positions[3 * i]);
  }
  FieldOutput output;
  output.doubleValues = values.data();
  field_.evaluate(VectorsView(positions.data(), searches_.size()), output, executor);
  for (std::size_t i = 0; i < searches_.size(); ++i)
  {
    this->narrow(searches_[i], values[i]);
  }
  this->dropFound(executor);
}

void LevelRoots::addGradients(Executor& executor)
{
  std::vector<std::size_t> without;
  std::vector<double> positions;
  for (std::size_t edge = 0; edge < edges_.size(); ++edge)
  {
    if (roots_.normals[edge].isZero(0) && !edges_.isAtBorder(edges_[edge]))
    {
      const Eigen::Vector3d position =
        grid_.firstSample + roots_.place(edges_[edge], edge).cwiseProduct(grid_.spacing);
      without.push_back(edge);
      positions.insert(positions.end(), position.data(), position.data() + 3);
    }
  }
  std::vector<double> gradients(positions.size());
  field_.gradient(VectorsView(positions.data(), without.size()), gradients.data(), executor);
  for (std::size_t n = 0; n < without.size(); ++n)
  {
    const Eigen::Map<const Eigen::Vector3d> gradient(&gradients[3 * n]);
    roots_.normals[without[n]] = gradient.stableNormalized().cast<float>();
  }
}

} // namespace winding
