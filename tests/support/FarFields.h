// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Pi.h"
#include "base/Views.h"
#include "farfield/FarField.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "support/Grids.h"
#include "support/RowValues.h"
#include "support/Serial.h"
#include "surface/BoundaryGradient.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

/**
 * @file
 * Sources of far fields with their direct sums, and grids and samples to compare the two at.
 */
namespace shapes
{

class FarSource
{
public:
  virtual ~FarSource() = default;

  virtual const winding::Bounds& bounds() const = 0;

  /// The sources of a far field. Triangles are cut to sizes that suit a grid of these bounds and
  /// spacing; a spacing of 0 leaves them whole.
  virtual std::unique_ptr<winding::FarFieldSources> sources(
    const winding::Bounds& region, double spacing) const = 0;

  std::unique_ptr<winding::FarFieldSources> sources() const { return this->sources({}, 0); }

  /// The direct sum in double; NaN where a sample lies on a triangle, so that no value is right.
  virtual std::vector<double> values(const std::vector<Point>& samples) const = 0;

  /// The exact gradients at samples.
  virtual std::vector<Point> gradients(const std::vector<Point>& samples) const = 0;

  /// The distance to the nearest point of a cloud or vertex of a mesh, and at least the shortest of
  /// the lengths over which points are spread.
  virtual double distance(const Point& sample) const = 0;

  /// The sum, roughly, of the absolute values that the direct sum adds.
  virtual std::vector<double> strengths(const std::vector<Point>& samples) const = 0;

  /// Places on random points or triangles of the source.
  virtual std::vector<Point> places(std::size_t count, unsigned seed) const = 0;
};

inline double distanceBetween(const Point& sample, const std::vector<Point>& points)
{
  double squared = HUGE_VAL;
  for (const Point& point : points)
  {
    squared = std::min(squared, (point - sample).squaredNorm());
  }
  return std::sqrt(squared);
}

class CloudSource final : public FarSource
{
public:
  /// FieldOptions explains `regularization`.
  CloudSource(const Cloud& cloud, std::vector<double> areas, double regularization)
    : cloud_(clean(cloud))
    , areas_(std::move(areas))
    , sum_(cloud_, areas_)
  {
    for (std::size_t i = 0; regularization > 0 && i < areas_.size(); ++i)
    {
      cloud_.regularizationLengths.push_back(regularization * std::sqrt(areas_[i]));
      shortest_ = std::min(i > 0 ? shortest_ : HUGE_VAL, cloud_.regularizationLengths[i]);
    }
  }

  const winding::Bounds& bounds() const override { return cloud_.bounds; }

  using FarSource::sources;
  std::unique_ptr<winding::FarFieldSources> sources(const winding::Bounds&, double) const override
  {
    return winding::farFieldSources(cloud_, areas_, serial);
  }

  std::vector<double> values(const std::vector<Point>& samples) const override
  {
    return valuesOf(sum_, samples);
  }

  std::vector<Point> gradients(const std::vector<Point>& samples) const override
  {
    return gradientsOf(sum_, samples);
  }

  double distance(const Point& sample) const override
  {
    return std::max(shortest_, distanceBetween(sample, cloud_.positions));
  }

  std::vector<double> strengths(const std::vector<Point>& samples) const override
  {
    std::vector<double> strengths;
    for (const Point& q : samples)
    {
      double sum = 0;
      for (std::size_t i = 0; i < areas_.size(); ++i)
      {
        // The share of a point that is spread over e is at most 0.43 a/e², at a distance of 0.97 e.
        const double least = shortest_ > 0 ? 2.3 * std::pow(cloud_.regularizationLengths[i], 2) : 0;
        sum += areas_[i] / std::max((cloud_.positions[i] - q).squaredNorm(), least);
      }
      strengths.push_back(sum / (4 * winding::pi));
    }
    return strengths;
  }

  std::vector<Point> places(std::size_t count, unsigned seed) const override
  {
    Random random(seed);
    std::vector<Point> places;
    for (std::size_t i = 0; i < count && !cloud_.positions.empty(); ++i)
    {
      places.push_back(cloud_.positions[random.bits() % cloud_.positions.size()]);
    }
    return places;
  }

private:
  winding::PointCloud cloud_;
  std::vector<double> areas_;
  winding::DipoleSum sum_;
  double shortest_ = 0; ///< shortest length over which points are spread; 0 for pure dipoles
};

class MeshSource final : public FarSource
{
public:
  explicit MeshSource(const Mesh& mesh)
    : mesh_(mesh)
    , surface_(clean(mesh))
    , sum_(surface_)
  {
  }

  const winding::Bounds& bounds() const override { return surface_.bounds; }

  using FarSource::sources;
  std::unique_ptr<winding::FarFieldSources> sources(
    const winding::Bounds& region, double spacing) const override
  {
    winding::SplitRule rule;
    if (spacing > 0)
    {
      rule.region = region;
      rule.longestSide = 8 * spacing;
    }
    return winding::farFieldSources(
      surface_.vertices, surface_.triangles, surface_.bounds, rule, serial);
  }

  std::vector<double> values(const std::vector<Point>& samples) const override
  {
    std::vector<double> values(samples.size());
    winding::SampleBlock block;
    block.count = 1;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      block.set(0, samples[i]);
      bool isOnSurface;
      if (sum_.evaluateWatching(block, &values[i], &isOnSurface))
      {
        values[i] = std::nan("");
      }
    }
    return values;
  }

  std::vector<Point> gradients(const std::vector<Point>& samples) const override
  {
    return gradientsOf(winding::BoundaryGradient(surface_, boundaryOf(surface_).edges), samples);
  }

  double distance(const Point& sample) const override
  {
    return distanceBetween(sample, surface_.vertices);
  }

  std::vector<double> strengths(const std::vector<Point>& samples) const override
  {
    // No triangle gives more than a half.
    return std::vector<double>(samples.size(), 1);
  }

  std::vector<Point> places(std::size_t count, unsigned seed) const override
  {
    return mesh_.triangles.empty() ? std::vector<Point>() : pointsNear(mesh_, count, 0, seed);
  }

private:
  Mesh mesh_;
  winding::Surface surface_;
  winding::TriangleSum sum_;
};

inline std::unique_ptr<FarSource> farSource(const Mesh& mesh)
{
  return std::make_unique<MeshSource>(mesh);
}

inline std::unique_ptr<FarSource> farSource(
  const Cloud& cloud, const std::vector<double>& areas, double regularization = 0)
{
  return std::make_unique<CloudSource>(cloud, areas, regularization);
}

/// A source of points with equal areas, whose sum is that of a sphere of the given radius.
inline std::unique_ptr<FarSource> farSource(const Cloud& cloud, double radius = 1)
{
  const auto count = static_cast<double>(cloud.positions.size());
  return farSource(
    cloud, std::vector<double>(cloud.positions.size(), 4 * winding::pi * radius * radius / count));
}

inline winding::FarField fieldOf(const FarSource& source, double tolerance = 1e-3)
{
  return {source.sources(), winding::FarFieldAccuracy::of(tolerance), serial};
}

inline Cloud mapped(Cloud cloud, const std::function<Point(const Point&)>& map)
{
  std::transform(cloud.positions.begin(), cloud.positions.end(), cloud.positions.begin(), map);
  return cloud;
}

inline Cloud with(Cloud cloud, const Cloud& other)
{
  cloud.positions.insert(cloud.positions.end(), other.positions.begin(), other.positions.end());
  cloud.normals.insert(cloud.normals.end(), other.normals.begin(), other.normals.end());
  return cloud;
}

/// A cloud with as many points in every shell as in the one around it of twice the radius; areas
/// shrink with the square of the radius.
inline std::unique_ptr<FarSource> gradedSource(
  std::size_t count, unsigned seed, double regularization = 0)
{
  Random random(seed);
  Cloud cloud;
  std::vector<double> areas;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double radius = std::exp2(random(-20, 0));
    cloud.normals.push_back(random.direction());
    cloud.positions.push_back(radius * random.direction());
    areas.push_back(60 * radius * radius / static_cast<double>(count));
  }
  return farSource(cloud, areas, regularization);
}

/// A sphere of 5000 points and a heap of equal points.
inline Cloud sphereWithHeap(std::size_t heap)
{
  Cloud cloud = sphereCloud(5000);
  cloud.positions.resize(5000 + heap, Point(0.123, 0.456, 0.789));
  cloud.normals.resize(5000 + heap, Point(0, 0, 1));
  return cloud;
}

/// A sphere of 5000 points, and `ball` points in a cube of 1/20000 of its size.
inline Cloud sphereWithBall(std::size_t ball, unsigned seed)
{
  const auto shrunk = [](const Point& p) -> Point
  {
    return Point(0.3, 0, 0) + 5e-5 * p;
  };
  return with(mapped(randomCloud(ball, seed), shrunk), sphereCloud(5000));
}

inline winding::Bounds boundsOf(const winding::Grid& grid)
{
  return {grid.firstSample,
    grid.sample(grid.dimensions[0] - 1, grid.dimensions[1] - 1, grid.dimensions[2] - 1)};
}

inline std::vector<float> valuesOn(const winding::FarField& field, const winding::Grid& grid,
  const winding::Extent& extent, winding::Executor& executor)
{
  std::vector<float> values(winding::sampleCount(extent), std::nanf(""));
  winding::FieldOutput output;
  output.values = values.data();
  field.evaluate(grid, extent, output, executor);
  return values;
}

inline std::vector<float> valuesOn(const winding::FarField& field, const winding::Grid& grid)
{
  return valuesOn(field, grid, grid.wholeExtent(), serial);
}

inline std::vector<float> valuesAt(
  const winding::FarField& field, const std::vector<Point>& samples, winding::Executor& executor)
{
  std::vector<float> values(samples.size(), -99);
  winding::FieldOutput output;
  output.values = values.data();
  const winding::VectorsView view(samples.empty() ? nullptr : samples[0].data(), samples.size());
  field.evaluate(view, output, executor);
  return values;
}

inline std::vector<float> valuesAt(
  const winding::FarField& field, const std::vector<Point>& samples)
{
  return valuesAt(field, samples, serial);
}

inline std::vector<Point> gradientsAt(
  const winding::FarField& field, const std::vector<Point>& samples, winding::Executor& executor)
{
  std::vector<Point> gradients(samples.size(), Point(-99, -99, -99));
  const winding::VectorsView view(samples.empty() ? nullptr : samples[0].data(), samples.size());
  field.gradient(view, gradients.empty() ? nullptr : gradients[0].data(), executor);
  return gradients;
}

inline std::vector<Point> gradientsAt(
  const winding::FarField& field, const std::vector<Point>& samples)
{
  return gradientsAt(field, samples, serial);
}

/// Samples of a grid: random ones, and those nearest to places on the source that are within the
/// grid.
inline std::vector<Eigen::Vector3i> comparedSamples(
  const FarSource& source, const winding::Grid& grid, std::size_t count, unsigned seed)
{
  Random random(seed);
  std::vector<Eigen::Vector3i> samples;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point at = random.point(0, 1).cwiseProduct(grid.dimensions.cast<double>());
    samples.push_back(at.cast<int>());
  }
  for (const Point& place : source.places(count, seed + 1))
  {
    const Point at = (place - grid.firstSample).cwiseQuotient(grid.spacing);
    const Point last = (grid.dimensions - Eigen::Vector3i::Ones()).cast<double>();
    if ((at.array() > -0.5).all() && (at.array() < last.array() + 0.5).all())
    {
      samples.emplace_back((at + Point::Constant(0.5)).cast<int>());
    }
  }
  return samples;
}

/**
 * The largest difference between values at samples and the direct sum of a source. Where the
 * absolute values of the summands (FarSource::strengths) add up to more than 1, eight roundings of
 * float of the excess are taken off: next to points of a cloud, where terms in the hundreds may
 * cancel, these alone are more than the finest tolerance.
 */
inline double largestError(
  const FarSource& source, const std::vector<Point>& samples, const std::vector<float>& values)
{
  const std::vector<double> expected = source.values(samples);
  const std::vector<double> strengths = source.strengths(samples);
  double largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!std::isfinite(values[i]))
    {
      return HUGE_VAL;
    }
    const double error =
      std::abs(values[i] - expected[i]) - 0x1p-21 * std::max(strengths[i] - 1, 0.0);
    largest = std::isnan(expected[i]) ? largest : std::max(largest, error);
  }
  return largest;
}

} // namespace shapes
