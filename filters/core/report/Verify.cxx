// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Verify.h"

#include "base/Bounds.h"
#include "base/Pi.h"
#include "base/UnitRandom.h"
#include "source/PointCloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

bool contains(const Extent& extent, const Eigen::Vector3i& index)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < extent[2 * axis] || index[axis] > extent[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

std::vector<Eigen::Vector3i> drawEverywhere(
  const Grid& grid, std::size_t samples, UnitRandom& random)
{
  std::vector<Eigen::Vector3i> drawn(samples);
  for (Eigen::Vector3i& index : drawn)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = random.below(grid.dimensions[axis]);
    }
  }
  return drawn;
}

std::vector<Eigen::Vector3i> drawNear(
  const Field& field, const Grid& grid, std::size_t samples, UnitRandom& random)
{
  std::vector<Eigen::Vector3i> drawn;
  if (field.info().primitives == 0)
  {
    return drawn;
  }
  const Field::PointOnSource pointOnSource = field.pointOnSource();
  constexpr double farthest = 2; // voxels
  // A grid may miss the source altogether, so there is an end to the tries.
  for (std::size_t tries = 0; tries < 20 * samples && drawn.size() < samples; ++tries)
  {
    const double u = random(), v = random(), t = random();
    const Eigen::Array3d position = grid.inGridUnits(pointOnSource(u, v, t)).array();
    Eigen::Array3d jittered = position;
    for (int axis = 0; axis < 3; ++axis)
    {
      jittered[axis] += (2 * random() - 1) * farthest;
    }
    const Eigen::Array3d nearest = jittered.round();
    const Eigen::Array3d last = (grid.dimensions.array() - 1).cast<double>();
    if ((nearest >= 0).all() && (nearest <= last).all() &&
        (nearest - position).matrix().norm() <= farthest)
    {
      drawn.push_back(nearest.cast<int>().matrix());
    }
  }
  return drawn;
}

/**
 * The distance up to which coordinates cannot decide a sample's side. The unit here is 2⁻⁵³ of the
 * largest coordinate. Along an axis, a sample is rounded by up to 3 units, and a vertex by up to 4
 * where rows move it into units of the grid (RowCrossings.h), which makes 12 in space. A distance
 * is rounded by up to 32 (roundingOfOffset()). The distance returned has 64.
 */
double undecidedDistance(const Field& field, const Grid& grid)
{
  const Bounds& source = field.info().bounds;
  if (source.isEmpty())
  {
    return 0;
  }
  const Eigen::Vector3i last = grid.dimensions - Eigen::Vector3i::Ones();
  const Eigen::Vector3d lastSample = grid.sample(last);
  double largest = 0;
  for (const Eigen::Vector3d& corner : {source.min(), source.max(), grid.firstSample, lastSample})
  {
    largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  }
  return 0x1p-47 * largest;
}

/// Sums add up to this to a choice between sides: an approximation errs by up to 1e-2, and samples
/// that lie in the plane of a triangle up to rounding, near one of its sides, were seen to err by
/// 0.03.
constexpr double mostBesideTheChoice = 0.1;

/**
 * Whether an error is what a sample's place on the surface explains; jump comes from
 * Field::jumpWithin(). On one triangle, values are the ones on its sides or their mean, so errors
 * are 0, ½ or 1. On an edge or a vertex, rounding also decides about the solid angle of each
 * triangle there, which is any part of a half turn: errors are up to 1, and ½ more for each
 * triangle.
 */
bool isChoiceOfSide(double error, double jump)
{
  const double size = std::abs(error);
  if (jump == 0 || !std::isfinite(size))
  {
    return false;
  }
  if (jump == 1)
  {
    return size <= 1 + mostBesideTheChoice &&
           std::abs(2 * size - std::round(2 * size)) <= 2 * mostBesideTheChoice;
  }
  return size <= 1 + jump / 2 + mostBesideTheChoice;
}

/// Whether the share of one point of a cloud alone may be 1 or more at a sample.
bool isBesidePoint(const PointCloud* cloud, const Eigen::Vector3d& sample)
{
  if (!cloud || !cloud->regularizationLengths.empty())
  {
    return false;
  }
  for (std::size_t i = 0; i < cloud->positions.size(); ++i)
  {
    if ((cloud->positions[i] - sample).squaredNorm() * 4 * pi < cloud->areas[i])
    {
      return true;
    }
  }
  return false;
}

enum class Place
{
  free,        ///< the value is compared with the reference
  besidePoint, ///< it is compared, and counted apart
  onSurface    ///< it is not compared
};

} // namespace

void ErrorStatistics::add(double error)
{
  ++samples;
  // A value that is no number must not hide: it counts as infinitely wrong.
  const double size = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
  max = std::max(max, size);
  sumOfSquares += size * size;
}

void ErrorStatistics::add(const ErrorStatistics& other)
{
  samples += other.samples;
  max = std::max(max, other.max);
  sumOfSquares += other.sumOfSquares;
}

double ErrorStatistics::rms() const
{
  return samples == 0 ? 0 : std::sqrt(sumOfSquares / static_cast<double>(samples));
}

Verification verify(const Field& field, const Grid& grid, const Extent& extent,
  const std::function<double(std::size_t)>& valueOf, std::size_t samples, unsigned seed,
  Executor& executor)
{
  UnitRandom random(seed);
  std::vector<Eigen::Vector3i> drawn = drawEverywhere(grid, samples, random);
  const std::vector<Eigen::Vector3i> near = drawNear(field, grid, samples, random);
  drawn.insert(drawn.end(), near.begin(), near.end());

  const double undecided = undecidedDistance(field, grid);
  std::vector<double> errors(drawn.size());
  std::vector<Place> places(drawn.size(), Place::free);
  executor.run(drawn.size(),
    [&](std::size_t i)
    {
      const Eigen::Vector3i& index = drawn[i];
      if (contains(extent, index))
      {
        const Eigen::Vector3d sample = grid.sample(index);
        errors[i] = valueOf(sampleNumber(extent, index)) - field.reference(sample);
        if (isChoiceOfSide(errors[i], field.jumpWithin(sample, undecided)))
        {
          places[i] = Place::onSurface;
        }
        else if (isBesidePoint(field.cloud(), sample))
        {
          places[i] = Place::besidePoint;
        }
      }
    });

  Verification result;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    if (!contains(extent, drawn[i]))
    {
      continue;
    }
    if (places[i] == Place::onSurface)
    {
      ++result.onSurface;
    }
    else if (places[i] == Place::besidePoint)
    {
      result.besidePoints.add(errors[i]);
    }
    else
    {
      (i < samples ? result.everywhere : result.nearSurface).add(errors[i]);
    }
  }
  return result;
}

} // namespace winding
