// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "support/Serial.h"
#include "support/ThreadSeconds.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <sstream>

/**
 * @file
 * Method automatic takes no more than 1.5 times as long as the direct sum, and 10 ms, whatever the
 * triangles: Field.h promises so. Times are those of the processor for this thread, so that other
 * programs matter little, and a time that is too long must be so in each of several attempts.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

constexpr int attempts = 5;

/// The seconds to build a field and to evaluate it at samples or, if there are none, on a grid.
double secondsOf(const Mesh& mesh, const FieldOptions& options, const Grid& grid,
  const std::vector<Point>& samples)
{
  const double start = shapes::threadSeconds();
  const auto field = Field::build(viewsOf(mesh), options, serial);
  samples.empty() ? valuesOf(*field, grid, grid.wholeExtent(), false, serial)
                  : valuesOf(*field, samples, false, serial);
  return shapes::threadSeconds() - start;
}

/// A mesh, and the samples at which both methods are timed.
struct Timed
{
  Mesh mesh;
  double tolerance;
  int resolution;             ///< of a grid, unless there are samples
  std::vector<Point> samples; ///< scattered samples
};

std::mutex worstMutex;
double worstRatio = 0;
std::string worstTimed;

void keepWorst(double ratio, const std::string& timed)
{
  const std::lock_guard<std::mutex> lock(worstMutex);
  if (ratio > worstRatio)
  {
    worstRatio = ratio;
    worstTimed = timed;
  }
}

/// Compares the times of both methods, and returns what is wrong.
std::string compareTimes(const Timed& timed)
{
  FieldOptions options;
  options.tolerance = timed.tolerance;
  options.scattered = !timed.samples.empty();
  FieldOptions direct = options;
  direct.method = Method::direct;
  Bounds bounds;
  try
  {
    bounds = Field::build(viewsOf(timed.mesh), direct, serial)->info().bounds;
  }
  catch (const Refusal&)
  {
  }
  if (bounds.isEmpty() || !(bounds.sizes().minCoeff() > 0))
  {
    return {};
  }
  GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = timed.resolution;
  const Grid grid = setUpGrid(request);
  double least = HUGE_VAL, longest = 0, allowed = 0;
  for (int attempt = 0; attempt < attempts && !(least <= allowed); ++attempt)
  {
    longest = std::max(longest, secondsOf(timed.mesh, direct, grid, timed.samples));
    allowed = 1.5 * longest + 0.01;
    least = std::min(least, secondsOf(timed.mesh, options, grid, timed.samples));
  }
  std::ostringstream text;
  text << timed.mesh.triangles.size() << " triangles, tolerance " << timed.tolerance << ", "
       << (options.scattered ? timed.samples.size() : sampleCount(grid.wholeExtent()))
       << (options.scattered ? " scattered samples" : " samples of a grid");
  keepWorst(std::max(0.0, least - 0.01) / longest, text.str());
  if (least <= allowed)
  {
    return {};
  }
  std::ostringstream failure;
  failure << nameOf(options.method) << " takes " << least << " s, more than " << allowed << ": "
          << text.str();
  return failure.str();
}

/// A mesh of triangles of one size from a twentieth of the box to all of it, in a box that may be
/// flat, with corners anywhere or on a lattice; some are needles.
Mesh denseSoup(Choices& choices, int triangles)
{
  const double size = std::exp2(choices.between(-4.3, 0.5));
  const int lattice = choices.oneIn(3) ? 2 + choices.below(32) : 0;
  const double flatness = choices.oneIn(3) ? std::exp2(choices.between(-7, 0)) : 1;
  const double width = choices.oneIn(4) ? std::exp2(choices.between(-10, 0)) : 1;
  const bool isFan = choices.oneIn(6);
  Mesh mesh;
  const auto add = [&](Point corner)
  {
    if (lattice > 0)
    {
      corner = (corner * lattice).array().round() / lattice;
    }
    corner[2] *= flatness;
    mesh.points.push_back(corner);
  };
  for (int i = 0; i < triangles; ++i)
  {
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    const Point center = isFan ? Point(0, 0, 0) : choices.point(-1, 1);
    const Point side = size * choices.point(-1, 1);
    add(isFan ? center : Point(center - side));
    add(center + side);
    add(center + side + width * size * choices.point(-1, 1));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

} // namespace

std::string checkTime(Choices& choices)
{
  Timed timed;
  timed.mesh = randomMesh(choices, choices.oneIn(4) ? 4000 : 600);
  timed.tolerance = randomTolerance(choices);
  timed.resolution = 2 + choices.below(31);
  if (choices.oneIn(3))
  {
    timed.samples = randomSamples(choices, timed.mesh.points, 1 + choices.below(3000));
  }
  return compareTimes(timed);
}

std::string checkSoupTime(Choices& choices)
{
  // The direct sum takes 0.1 to 0.4 s, unless there are few samples.
  constexpr double mostPairs = 1e8;
  Timed timed;
  const auto triangles = static_cast<int>(500 * std::pow(100, choices.between(0, 1)));
  timed.mesh = denseSoup(choices, triangles);
  timed.tolerance = randomTolerance(choices);
  const double most = std::min(mostPairs / triangles, 1e5);
  const double samples = choices.oneIn(4) ? std::pow(most, choices.between(0, 1)) : most;
  timed.resolution = std::max(2, static_cast<int>(std::cbrt(samples)));
  if (choices.oneIn(3))
  {
    timed.samples =
      randomSamples(choices, timed.mesh.points, std::max(1, static_cast<int>(samples)));
  }
  return compareTimes(timed);
}

std::string worstTime()
{
  const std::lock_guard<std::mutex> lock(worstMutex);
  std::ostringstream text;
  text << "at worst " << worstRatio
       << " times as long as the direct sum, and 10 ms: " << worstTimed;
  return text.str();
}

} // namespace fuzz
