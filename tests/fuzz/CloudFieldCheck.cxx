// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Pi.h"
#include "base/Refusal.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "sums/ReferenceSum.h"
#include "sums/SolidAngle.h"
#include "support/NaiveDistance.h"
#include "support/Serial.h"
#include "support/Shuffled.h"

#include <algorithm>
#include <cmath>

/**
 * @file
 * The direct sum of a cloud is compared with the definition in long double, and the far field with
 * the direct sum; either with itself on the same points in another order, to the bit. Samples that
 * lie on a point as far as coordinates can tell must be finite only.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Point;
using shapes::serial;

/// Options for a cloud of this size, with which areas are in proportion.
FieldOptions randomOptions(Choices& choices, double size)
{
  FieldOptions options;
  options.tolerance = randomTolerance(choices);
  options.regularization = choices.oneIn(3) ? choices.between(0, mostRegularization) : 0;
  options.neighbors = 3 + choices.below(20);
  options.estimateNormals = choices.oneIn(6);
  options.normalEstimation = static_cast<NormalEstimation>(choices.below(3));
  options.scattered = choices.oneIn(4);
  if (choices.oneIn(4))
  {
    options.pointAreaMethod = PointAreaMethod::constant;
    options.pointArea = choices.oneIn(2) ? choices.between(0, size * size) : 0;
  }
  return options;
}

/// The sum of the sizes of all points' shares of w, and how much rounding may change it.
struct Shares
{
  double strength = 0;
  double rounding = 0;
  bool isOnPoint = false;
};

Shares sharesAt(const PointCloud& cloud, const Point& sample)
{
  Shares shares;
  shares.rounding = 1e-12;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
  {
    const Point offset = cloud.positions[i] - sample;
    const double size =
      std::max(cloud.positions[i].cwiseAbs().maxCoeff(), sample.cwiseAbs().maxCoeff());
    const double distance = offset.stableNorm();
    const double length = cloud.regularizationLengths.empty() ? 0 : cloud.regularizationLengths[i];
    const double reach = std::max(distance, length);
    shares.isOnPoint = shares.isOnPoint || !(reach > 0x1p-42 * size);
    if (!shares.isOnPoint)
    {
      const double share = cloud.areas[i] / reach / reach / (4 * pi);
      shares.strength += share;
      shares.rounding += share * (0x1p-46 + 0x1p-48 * size / reach);
    }
  }
  return shares;
}

std::vector<Shares> sharesAt(const PointCloud& cloud, const std::vector<Point>& samples)
{
  std::vector<Shares> shares;
  for (const Point& sample : samples)
  {
    shares.push_back(sharesAt(cloud, sample));
  }
  return shares;
}

std::string compareWithDefinition(const PointCloud& cloud, const std::vector<Point>& samples,
  const std::vector<Shares>& shares, const FieldValues& direct)
{
  std::vector<double> expected, distances;
  for (const Point& sample : samples)
  {
    expected.push_back(static_cast<double>(referenceSum<long double>(cloud, cloud.areas, sample)));
    distances.push_back(shapes::naiveDistance(sample, cloud.positions));
  }
  const std::string failure = compare("direct", samples, direct.values, expected,
    [&](std::size_t i) { return shares[i].isOnPoint ? HUGE_VAL : shares[i].rounding; });
  return !failure.empty() ? failure
                          : compare("distance", samples, direct.distances, distances,
                              [&](std::size_t i) { return 1e-12 * distances[i]; });
}

std::string compareWithDirect(const std::string& name, const std::vector<Point>& samples,
  const std::vector<Shares>& shares, const FieldValues& found, const FieldValues& direct,
  double tolerance)
{
  return compare(name, samples, found.values, direct.values,
    [&](std::size_t i)
    {
      // The far field promises the tolerance and some 1e-7 of all shares; points that are taken for
      // pure dipoles may lose a hundredth of the tolerance (FarFieldAccuracy.h).
      const double strength = shares[i].strength;
      return shares[i].isOnPoint
               ? HUGE_VAL
               : shares[i].rounding + tolerance * std::max(1.0, strength / 50) + 1e-6 * strength;
    });
}

std::string checkCloud(const PointCloud& cloud)
{
  const bool areGood = std::all_of(cloud.areas.begin(), cloud.areas.end(),
                         [](double area) { return area >= 0 && std::isfinite(area); }) &&
                       std::all_of(cloud.normals.begin(), cloud.normals.end(),
                         [](const Point& normal) { return std::abs(normal.norm() - 1) < 1e-6; });
  return areGood ? std::string() : "areas or normals of the cloud are not what they should be";
}

/// The same points in another order.
RandomCloud shuffled(const RandomCloud& random, Choices& choices)
{
  const std::vector<std::size_t> order = shapes::shuffledNumbers(
    random.cloud.positions.size(), [&](std::size_t count) { return choices.below(count); });
  const auto inOrder = [&order](const auto& items)
  {
    return items.empty() ? items : shapes::inOrder(items, order);
  };
  return {{inOrder(random.cloud.positions), inOrder(random.cloud.normals)}, inOrder(random.areas)};
}

} // namespace

std::string checkCloudField(Choices& choices)
{
  RandomCloud random = randomCloud(choices, choices.oneIn(50) ? 400 : 24);
  Bounds bounds;
  for (const Point& position : random.cloud.positions)
  {
    bounds.extend(position);
  }
  FieldOptions options = randomOptions(choices, bounds.sizes().maxCoeff());
  if (options.estimateNormals)
  {
    random.cloud.normals.clear();
  }
  options.method = Method::direct;
  std::shared_ptr<const Field> direct;
  try
  {
    direct = Field::build(viewsOf(random), options, serial);
  }
  catch (const Refusal& refusal)
  {
    for (std::size_t i = 0; i < random.cloud.positions.size(); ++i)
    {
      if (isUsable(random.view(), i))
      {
        return std::string("a cloud with usable points is refused: ") + refusal.what();
      }
    }
    return {};
  }
  const PointCloud& cloud = *direct->cloud();
  std::string failure = checkCloud(cloud);
  if (cloud.positions.empty() || !failure.empty())
  {
    return failure;
  }
  const Grid grid = randomGrid(choices, cloud.bounds);
  const std::vector<Point> onGrid = samplesOf(grid);
  const std::vector<Point> samples = randomSamples(choices, cloud.positions, 1 + choices.below(24));
  const std::vector<Shares> gridShares = sharesAt(cloud, onGrid);
  const std::vector<Shares> sampleShares = sharesAt(cloud, samples);
  const FieldValues directOnGrid = valuesOf(*direct, grid, grid.wholeExtent(), true, serial);
  const FieldValues directAtSamples = valuesOf(*direct, samples, true, serial);
  failure = compareWithDefinition(cloud, onGrid, gridShares, directOnGrid);
  if (failure.empty())
  {
    failure = compareWithDefinition(cloud, samples, sampleShares, directAtSamples);
  }
  if (!failure.empty())
  {
    return failure;
  }
  const Method methods[] = {
    Method::direct, Method::hierarchical, Method::hierarchical, Method::automatic};
  options.method = choices.oneOf(methods);
  const auto field = Field::build(viewsOf(random), options, serial);
  const FieldValues grids = valuesOf(*field, grid, grid.wholeExtent(), true, serial);
  const FieldValues others = valuesOf(*field, samples, true, serial);
  const std::string name = nameOf(field->info().method);
  for (const std::string& found : {grids.failure, others.failure,
         compareWithDirect(
           name + " on the grid", onGrid, gridShares, grids, directOnGrid, options.tolerance),
         compareWithDirect(
           name + " at samples", samples, sampleShares, others, directAtSamples, options.tolerance),
         checkBits(choices, *field, grid, grids, samples, others), checkGradients(*field, samples),
         checkNonFinite(*field)})
  {
    failure = failure.empty() ? found : failure;
  }
  if (!failure.empty())
  {
    return failure;
  }
  const auto other = Field::build(viewsOf(shuffled(random, choices)), options, serial);
  return checkShuffled(*other, grid, grids, samples, others);
}

} // namespace fuzz
