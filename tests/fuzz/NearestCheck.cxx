// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "field/InputPlaces.h"
#include "source/Sanitize.h"
#include "support/NaiveDistance.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/**
 * @file
 * Places of random inputs that are nearest to samples: no triangle or point is nearer, in long
 * double, and none before it is as near; weights make the nearest point; threads and the order of
 * samples change nothing.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

std::vector<InputPlace> placesOf(
  const InputPlaces& input, const std::vector<Point>& samples, Executor& executor)
{
  std::vector<InputPlace> places(samples.size());
  input.find(
    samples.size(), [&](std::size_t n) { return samples[n]; }, places.data(), executor);
  return places;
}

bool areSame(const InputPlace& a, const InputPlace& b)
{
  return a.view == b.view && a.primitive == b.primitive && a.weights == b.weights;
}

/// Checks places by the distances of all primitives from each sample, which are infinite for those
/// that are not usable.
template <class DistanceOf>
std::string checkNearest(const std::vector<InputPlace>& places, const std::vector<Point>& samples,
  std::size_t primitives, double size, double largest, const DistanceOf& distanceOf)
{
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    std::vector<double> distances(primitives);
    for (std::size_t i = 0; i < primitives; ++i)
    {
      distances[i] = distanceOf(samples[n], i);
    }
    distances.push_back(std::numeric_limits<double>::infinity());
    const double nearest = *std::min_element(distances.begin(), distances.end());
    if (!places[n].exists())
    {
      return std::isinf(nearest) ? "" : "a sample has no place, though there are primitives";
    }
    // Rounding of the samples' own coordinates and of thin triangles is larger than that of sums.
    const double rounding = 1e-9 * (size + nearest) + 1e-13 * (largest + samples[n].norm());
    if (!(distances[places[n].primitive] <= nearest + rounding))
    {
      return "a place is " + std::to_string(distances[places[n].primitive]) +
             " away, and the nearest " + std::to_string(nearest);
    }
    for (std::size_t before = 0; before < places[n].primitive; ++before)
    {
      if (distances[before] == 0 && distances[places[n].primitive] == 0)
      {
        return "a sample lies on a primitive before the one that was found";
      }
    }
  }
  return "";
}

std::string checkSame(
  const InputPlaces& input, const std::vector<Point>& samples, std::vector<InputPlace> places)
{
  shapes::ShuffledThreads threads(1);
  const std::vector<InputPlace> again = placesOf(input, samples, threads);
  const std::vector<Point> backward(samples.rbegin(), samples.rend());
  std::vector<InputPlace> reversed = placesOf(input, backward, threads);
  std::reverse(reversed.begin(), reversed.end());
  std::vector<InputPlace> together(samples.size());
  input.findAt({samples.front().data(), samples.size()}, together.data(), threads);
  const auto areOnSame = [](const InputPlace& a, const InputPlace& b)
  {
    return a.view == b.view && a.primitive == b.primitive;
  };
  if (!std::equal(places.begin(), places.end(), together.begin(), areOnSame))
  {
    return "places of samples depend on whether they are searched for together";
  }
  const bool same = std::equal(places.begin(), places.end(), again.begin(), areSame) &&
                    std::equal(places.begin(), places.end(), reversed.begin(), areSame);
  return same ? "" : "places depend on threads or on the order of samples";
}

std::string checkMesh(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, 40);
  const std::vector<TrianglesView> views = viewsOf(mesh);
  if (mesh.points.empty())
  {
    return "";
  }
  const Bounds bounds = boundsOf(views);
  const InputPlaces input(views, "", serial);
  const std::vector<Point> samples = randomSamples(choices, mesh.points, 30);
  const std::vector<InputPlace> places = placesOf(input, samples, serial);
  const double size = bounds.isEmpty() ? 0 : bounds.sizes().norm();
  const double largest =
    bounds.isEmpty() ? 0 : bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).maxCoeff();
  const std::string fault = checkNearest(places, samples, mesh.triangles.size(), size, largest,
    [&](const Point& sample, std::size_t i)
    {
      const auto& t = mesh.triangles[i];
      return isUsable(views.front(), i)
               ? shapes::naiveDistance(sample, mesh.points[static_cast<std::size_t>(t[0])],
                   mesh.points[static_cast<std::size_t>(t[1])],
                   mesh.points[static_cast<std::size_t>(t[2])])
               : std::numeric_limits<double>::infinity();
    });
  return fault.empty() ? checkSame(input, samples, places) : fault;
}

std::string checkCloud(Choices& choices)
{
  const RandomCloud cloud = randomCloud(choices, 60);
  const std::vector<OrientedPointsView> views = viewsOf(cloud);
  const Bounds bounds = boundsOf(views);
  const InputPlaces input(views, "", serial);
  const std::vector<Point> samples = randomSamples(choices, cloud.cloud.positions, 30);
  const std::vector<InputPlace> places = placesOf(input, samples, serial);
  const double size = bounds.isEmpty() ? 0 : bounds.sizes().norm();
  const double largest =
    bounds.isEmpty() ? 0 : bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).maxCoeff();
  const std::string fault =
    checkNearest(places, samples, cloud.cloud.positions.size(), size, largest,
      [&](const Point& sample, std::size_t i)
      {
        return isUsable(views.front(), i) ? (sample - cloud.cloud.positions[i]).stableNorm()
                                          : std::numeric_limits<double>::infinity();
      });
  return fault.empty() ? checkSame(input, samples, places) : fault;
}

} // namespace

std::string checkNearest(Choices& choices)
{
  try
  {
    return choices.oneIn(3) ? checkCloud(choices) : checkMesh(choices);
  }
  catch (const Refusal&)
  {
    return ""; // coordinates out of range
  }
}

} // namespace fuzz
