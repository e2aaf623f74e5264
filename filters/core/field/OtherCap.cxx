// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/OtherCap.h"

#include "base/FieldOutput.h"
#include "farfield/PointCells.h"
#include "farfield/TriangleFarField.h"
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
  std::vector<double>& values, Executor& executor)
{
  std::vector<char> areOnTriangles(places.size(), 0);
  sum.watch(
    places.size(), [&](std::size_t n) { return positionOf(places[n]); },
    [&](std::size_t n, double value, bool isSuspect)
    {
      values[places[n]] = value;
      areOnTriangles[n] = isSuspect;
    },
    executor);
  Places onTriangles;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    if (areOnTriangles[n])
    {
      onTriangles.push_back(places[n]);
    }
  }
  return onTriangles;
}

/// Keeps the values of the fan's far field.
class FanSink final : public PointSink
{
public:
  explicit FanSink(FanValues& fan)
    : fan_(fan)
  {
  }

  void askFor(std::size_t) const override {}
  void point(std::size_t sample, double value, bool isSuspect) const override
  {
    fan_.values[sample] = -value;
    fan_.areOnFan[sample] = isSuspect;
  }

private:
  FanValues& fan_;
};

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

OtherCap::OtherCap(const Surface& surface, const RepeatedLoops& repeated, const TriangleList& cap,
  const std::optional<FarFieldAccuracy>& accuracy)
  : surface_(surface)
  , cap_(cap)
  , capMultiplicities_(repeated.multiplicities(trianglesOfCap))
  , fanMultiplicities_(repeated.multiplicities(trianglesOfFan))
  , capRows_(vertices_, {cap_, capMultiplicities_})
  , fanRows_(vertices_, {fan_, fanMultiplicities_})
  , between_(vertices_, {fan_, fanMultiplicities_}, {turnedCap_, capMultiplicities_}, bounds_)
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
  for (const auto& [a, b, c] : cap_)
  {
    turnedCap_.push_back({a, c, b});
  }
  bounds_ = surface.bounds;
  for (const Eigen::Vector3d& vertex : vertices_)
  {
    bounds_.extend(vertex);
  }
  if (accuracy)
  {
    fanFarField_ = std::make_unique<const TriangleFarField>(
      vertices_, ChainView(fan_, fanMultiplicities_), surface.bounds, *accuracy);
  }
}

OtherCap::~OtherCap() = default;

/// Writes to `values` what sums give: the surface's, or −w of the fan at the places that are
/// returned, where χ of the surface and the fan is to be added.
template <class PositionOf>
Places OtherCap::sumsAt(std::size_t count, const PositionOf& positionOf, const FanValues* fan,
  std::vector<double>& values, Executor& executor) const
{
  values.resize(count);
  Places places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  const bool isSumFirst = !fan && surface_.triangles.size() <= cap_.size() + fan_.size();
  if (isSumFirst)
  {
    places = sumAt(surfaceSum_, positionOf, places, values, executor);
  }
  FanValues own;
  Places onBoth;
  if (fan)
  {
    std::copy_if(places.begin(), places.end(), std::back_inserter(onBoth),
      [fan](std::size_t place) { return fan->areOnFan[place] != 0; });
  }
  else
  {
    own.values.resize(count);
    onBoth = sumAt(fanSum_, positionOf, places, own.values, executor);
    for (double& value : own.values)
    {
      value = -value;
    }
  }
  if (!isSumFirst)
  {
    sumAt(surfaceSum_, positionOf, onBoth, values, executor);
  }
  Places byFan;
  std::set_difference(
    places.begin(), places.end(), onBoth.begin(), onBoth.end(), std::back_inserter(byFan));
  for (const std::size_t place : byFan)
  {
    values[place] = (fan ? *fan : own).values[place];
  }
  return byFan;
}

void OtherCap::resolve(const Grid& grid, const std::vector<SampleOnCap>& samples,
  const FanValues* fan, std::vector<double>& values) const
{
  SerialExecutor serial; // samples are resolved in blocks that run in parallel
  Places byFan = this->sumsAt(
    samples.size(),
    [&](std::size_t n) { return grid.sample(samples[n].i, samples[n].j, samples[n].k); }, fan,
    values, serial);
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

void OtherCap::resolve(const std::vector<PointOnCap>& samples, bool byFarField,
  std::vector<double>& values, Executor& executor) const
{
  std::vector<Eigen::Vector3d> positions;
  for (const PointOnCap& sample : samples)
  {
    positions.push_back(sample.position);
  }
  const VectorsView view(positions.empty() ? nullptr : positions[0].data(), positions.size());
  FanValues fan;
  if (byFarField)
  {
    fan.values.resize(samples.size());
    fan.areOnFan.resize(samples.size());
    fanFarField_->suiting(view, executor)->evaluate(view, FanSink(fan), true, executor);
  }
  const Places byFan = this->sumsAt(
    samples.size(), [&](std::size_t n) { return positions[n]; }, byFarField ? &fan : nullptr,
    values, executor);
  std::vector<double> crossings(samples.size());
  FieldOutput output;
  output.doubleValues = crossings.data();
  between_.evaluate(view, output, executor);
  for (const std::size_t place : byFan)
  {
    values[place] += samples[place].integer + crossings[place];
  }
}

} // namespace winding
