// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/OtherCap.h"

#include "rays/RayTriangle.h"
#include "source/UnitScale.h"
#include "surface/Cap.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>
#include <tuple>

namespace winding
{

namespace
{

using Samples = std::vector<SampleOnCap>;
using Places = std::vector<std::size_t>;

/// Sums at some of the samples, and returns the places of those that lie on a triangle.
template <class PositionOf>
Places sumAt(const TriangleSum& sum, const PositionOf& positionOf, const Places& places,
  std::vector<double>& values)
{
  Places onTriangles;
  SampleBlock block;
  for (std::size_t first = 0; first < places.size(); first += block.count)
  {
    block.count = std::min(SampleBlock::capacity, places.size() - first);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      block.set(n, positionOf(places[first + n]));
    }
    double sums[SampleBlock::capacity];
    bool isSuspect[SampleBlock::capacity];
    const bool any = sum.evaluateWatching(block, sums, isSuspect);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      values[places[first + n]] = sums[n];
      if (any && isSuspect[n])
      {
        onTriangles.push_back(places[first + n]);
      }
    }
  }
  return onTriangles;
}

bool isBefore(const SampleOnCap& a, const SampleOnCap& b)
{
  return std::tie(a.k, a.j, a.i) < std::tie(b.k, b.j, b.i);
}

/// Adds χ of a chain, times a factor, at samples in the order of isBefore().
void addRows(const RowCrossings& rows, int factor, const Grid& grid, const Samples& samples,
  std::vector<int>& sums)
{
  Extent extent = {
    samples[0].i, samples[0].i, samples[0].j, samples[0].j, samples.front().k, samples.back().k};
  for (const SampleOnCap& sample : samples)
  {
    extent[0] = std::min(extent[0], sample.i);
    extent[1] = std::max(extent[1], sample.i);
    extent[2] = std::min(extent[2], sample.j);
    extent[3] = std::max(extent[3], sample.j);
  }
  SerialExecutor serial; // samples are resolved in blocks that run in parallel
  const std::unique_ptr<const RowCrossings::OnGrid> onGrid =
    rows.on(grid, extent, {extent[2], extent[3] - extent[2] + 1}, serial);
  for (std::size_t next = 0; next < samples.size();)
  {
    // The rows of a layer come in ascending order, as the samples do.
    onGrid->evaluate(samples[next].k, 0,
      [&](int j, int k, const std::vector<RowRun>& runs)
      {
        auto run = runs.begin();
        for (; next < samples.size() && samples[next].j == j && samples[next].k == k; ++next)
        {
          while (run->end <= samples[next].i)
          {
            ++run;
          }
          sums[next] += factor * run->value;
        }
      });
  }
}

} // namespace

OtherCap::OtherCap(const Surface& surface, const RepeatedLoops& repeated, const TriangleList& cap)
  : surface_(surface)
  , cap_(cap)
  , capMultiplicities_(repeated.multiplicities(trianglesOfCap))
  , fanMultiplicities_(repeated.multiplicities(trianglesOfFan))
  , capRows_(vertices_, {cap_, capMultiplicities_})
  , fanRows_(vertices_, {fan_, fanMultiplicities_})
  , surfaceSum_(surface)
  , fanSum_(vertices_, {fan_, fanMultiplicities_}, surface.bounds)
{
  // Only the loops' vertices are kept, for each resolve() looks at all that there are.
  std::vector<std::int32_t> places(surface.vertices.size(), -1);
  for (std::size_t i = 0; i < repeated.loops.size(); ++i)
  {
    for (const std::int32_t vertex : repeated.loops[i])
    {
      places[vertex] = 0;
    }
  }
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
  {
    if (places[vertex] == 0)
    {
      places[vertex] = static_cast<std::int32_t>(vertices_.size());
      vertices_.push_back(surface.vertices[vertex]);
    }
  }
  const auto placeOf = [&places](std::int32_t vertex)
  {
    return places[vertex];
  };
  for (Triangle& triangle : cap_)
  {
    std::transform(triangle.begin(), triangle.end(), triangle.begin(), placeOf);
  }
  BoundaryLoops loops;
  std::vector<std::int32_t> ofLoop;
  for (std::size_t i = 0; i < repeated.loops.size(); ++i)
  {
    const BoundaryLoop loop = repeated.loops[i];
    ofLoop.resize(loop.size());
    std::transform(loop.begin(), loop.end(), ofLoop.begin(), placeOf);
    loops.add({ofLoop.data(), ofLoop.data() + ofLoop.size()});
  }
  fan_ = fanOf(loops, vertices_);
}

/// Writes to `values` what sums give: the surface's, or −w of the fan at the places that are
/// returned, where χ of the surface and the fan is to be added.
template <class PositionOf>
Places OtherCap::sumsAt(
  std::size_t count, const PositionOf& positionOf, std::vector<double>& values) const
{
  values.resize(count);
  Places places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  const bool isSumFirst = surface_.triangles.size() <= cap_.size() + fan_.size();
  if (isSumFirst)
  {
    places = sumAt(surfaceSum_, positionOf, places, values);
  }
  std::vector<double> fanValues(count);
  const Places onBoth = sumAt(fanSum_, positionOf, places, fanValues);
  if (!isSumFirst)
  {
    sumAt(surfaceSum_, positionOf, onBoth, values);
  }
  Places byFan;
  std::set_difference(
    places.begin(), places.end(), onBoth.begin(), onBoth.end(), std::back_inserter(byFan));
  for (const std::size_t place : byFan)
  {
    values[place] = -fanValues[place];
  }
  return byFan;
}

void OtherCap::resolve(
  const Grid& grid, const std::vector<SampleOnCap>& samples, std::vector<double>& values) const
{
  Places byFan = this->sumsAt(
    samples.size(),
    [&](std::size_t n) { return grid.sample(samples[n].i, samples[n].j, samples[n].k); }, values);
  if (byFan.empty())
  {
    return;
  }
  std::sort(byFan.begin(), byFan.end(),
    [&samples](std::size_t a, std::size_t b) { return isBefore(samples[a], samples[b]); });
  Samples ordered;
  std::vector<int> integers;
  for (const std::size_t place : byFan)
  {
    ordered.push_back(samples[place]);
    integers.push_back(samples[place].rowValue);
  }
  addRows(capRows_, -1, grid, ordered, integers);
  addRows(fanRows_, 1, grid, ordered, integers);
  for (std::size_t n = 0; n < byFan.size(); ++n)
  {
    values[byFan[n]] += integers[n];
  }
}

void OtherCap::resolve(const std::vector<PointOnCap>& samples, std::vector<double>& values) const
{
  const Places byFan = this->sumsAt(
    samples.size(), [&](std::size_t n) { return samples[n].position; }, values);
  if (byFan.empty())
  {
    return;
  }
  std::vector<double> integers(samples.size());
  for (const std::size_t place : byFan)
  {
    integers[place] = samples[place].integer;
  }
  this->addCrossings({cap_, capMultiplicities_}, -1, samples, byFan, integers);
  this->addCrossings({fan_, fanMultiplicities_}, 1, samples, byFan, integers);
  for (const std::size_t place : byFan)
  {
    values[place] += integers[place];
  }
}

/// Adds the crossings of the rays from some of the samples with a chain, times a factor.
void OtherCap::addCrossings(const ChainView& chain, int factor,
  const std::vector<PointOnCap>& samples, const Places& places, std::vector<double>& values) const
{
  const double scale = unitScale(surface_.bounds);
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Triangle& ids = chain[i];
    const RayTriangle triangle(
      vertices_[ids[0]] * scale, vertices_[ids[1]] * scale, vertices_[ids[2]] * scale);
    for (const std::size_t place : places)
    {
      values[place] +=
        factor * chain.multiplicity(i) * triangle.crossing(samples[place].position * scale);
    }
  }
}

} // namespace winding
