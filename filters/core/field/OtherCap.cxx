#include "field/OtherCap.h"

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
Places sumAt(const TriangleSum& sum, const Grid& grid, const Samples& samples, const Places& places,
  std::vector<double>& values)
{
  Places onTriangles;
  SampleBlock block;
  for (std::size_t first = 0; first < places.size(); first += block.count)
  {
    block.count = std::min(SampleBlock::capacity, places.size() - first);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      const SampleOnCap& sample = samples[places[first + n]];
      block.set(n, grid.sample(sample.i, sample.j, sample.k));
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

OtherCap::OtherCap(
  const Surface& surface, const RepeatedLoops& repeated, const std::vector<Triangle>& cap)
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
  for (const BoundaryLoop& loop : repeated.loops)
  {
    for (const std::int32_t vertex : loop)
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
  std::vector<BoundaryLoop> loops = repeated.loops;
  for (BoundaryLoop& loop : loops)
  {
    std::transform(loop.begin(), loop.end(), loop.begin(), placeOf);
  }
  fan_ = fanOf(loops, vertices_);
}

void OtherCap::resolve(
  const Grid& grid, const std::vector<SampleOnCap>& samples, std::vector<double>& values) const
{
  values.resize(samples.size());
  Places places(samples.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const bool isSumFirst = surface_.triangles.size() <= cap_.size() + fan_.size();
  if (isSumFirst)
  {
    places = sumAt(surfaceSum_, grid, samples, places, values);
  }
  std::vector<double> fanValues(samples.size());
  const Places onBoth = sumAt(fanSum_, grid, samples, places, fanValues);
  if (!isSumFirst)
  {
    sumAt(surfaceSum_, grid, samples, onBoth, values);
  }

  Places byFan;
  std::set_difference(
    places.begin(), places.end(), onBoth.begin(), onBoth.end(), std::back_inserter(byFan));
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
    values[byFan[n]] = integers[n] - fanValues[byFan[n]];
  }
}

} // namespace winding
