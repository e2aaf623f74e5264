// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "field/InputPlaces.h"

#include <algorithm>
#include <limits>
#include <vector>

using namespace winding::c;
using winding::InputPlace;
using winding::InputPlaces;

namespace
{

/// The arrays of a caller that receive places.
struct PlaceArrays
{
  std::int64_t* nearest;
  std::int64_t* corners; ///< may be null
  double* weights;       ///< may be null

  void write(std::size_t sample, std::int64_t found, const std::int64_t (&ids)[3],
    const std::array<double, 3>& shares) const
  {
    nearest[sample] = found;
    if (corners)
    {
      std::copy(ids, ids + 3, corners + 3 * sample);
    }
    if (weights)
    {
      std::copy(shares.begin(), shares.end(), weights + 3 * sample);
    }
  }

  void writeNone(std::size_t sample) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    this->write(sample, -1, {-1, -1, -1}, {nan, nan, nan});
  }
};

/// Finds the places of all samples, with weights where these are wanted: without, samples share the
/// search. describe(place, sample) writes one that exists.
template <class Describe>
void findPlaces(const InputPlaces& input, const winding::VectorsView& samples, Call& call,
  const PlaceArrays& to, const Describe& describe)
{
  // Parts bound the memory of places, which is of no use to the caller.
  constexpr std::size_t atOnce = std::size_t{1} << 20;
  std::vector<InputPlace> places(std::min(samples.size(), atOnce));
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t first = 0; first < samples.size(); first += atOnce)
  {
    const std::size_t count = std::min(atOnce, samples.size() - first);
    const auto positionOf = [&](std::size_t n)
    {
      return samples[first + n];
    };
    if (to.weights)
    {
      input.find(count, positionOf, places.data(), call.executor);
    }
    else
    {
      positions.resize(count);
      for (std::size_t n = 0; n < count; ++n)
      {
        positions[n] = positionOf(n);
      }
      input.findAt({positions.data()->data(), count}, places.data(), call.executor);
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      if (places[n].exists())
      {
        describe(places[n], first + n);
      }
      else
      {
        to.writeNone(first + n);
      }
    }
  }
}

} // namespace

winding_status winding_nearest(winding_array points, const winding_polygons* polygons,
  const winding_options* options, winding_array samples, int64_t* nearest, int64_t* corners,
  double* weights, const winding_run* run, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding::FieldOptions wished = optionsOf(options);
      const winding::VectorsView places = vectorsOf(samples, "samples");
      if (places.size() > 0 && !nearest)
      {
        throw Misuse("nearest is null");
      }
      const PlaceArrays to = {nearest, corners, weights};
      Call call(run);
      if (!polygons)
      {
        const std::vector<winding::OrientedPointsView> views = {
          {vectorsOf(points, "points"), {}, {}}};
        const InputPlaces input(views, wished.mirror, call.executor);
        findPlaces(input, places, call, to,
          [&](const InputPlace& place, std::size_t sample)
          {
            const auto point = static_cast<std::int64_t>(place.primitive);
            to.write(sample, point, {point, point, point}, place.weights);
          });
        return;
      }
      Triangles triangles(points, polygons);
      if (wished.weldTolerance > 0)
      {
        triangles.weld(wished.weldTolerance, call.executor);
      }
      std::vector<std::int64_t> polygonOf;
      for (std::size_t polygon = 0;
           triangles.polygons() != triangles.triangles() && polygon < triangles.polygons();
           ++polygon)
      {
        polygonOf.resize(triangles.firstOf(polygon + 1), static_cast<std::int64_t>(polygon));
      }
      const InputPlaces input(triangles.views(), wished.mirror, call.executor);
      const winding::TriangleIdsView& ids = triangles.view().triangles;
      findPlaces(input, places, call, to,
        [&](const InputPlace& place, std::size_t sample)
        {
          const std::size_t triangle = place.primitive;
          to.write(sample,
            polygonOf.empty() ? static_cast<std::int64_t>(triangle) : polygonOf[triangle],
            {ids(triangle, 0), ids(triangle, 1), ids(triangle, 2)}, place.weights);
        });
    });
}
