// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Evaluator.h"
#include "base/Views.h"
#include "source/PointCloud.h"

#include <random>
#include <string>
#include <vector>

/**
 * @file
 * Random points, clouds, and values at points. Random numbers come from a seed and are the same
 * with every standard library. Several in one list of arguments are in braces, which fix their
 * order for every compiler.
 */
namespace shapes
{

using Point = Eigen::Vector3d;

class Random
{
public:
  explicit Random(unsigned seed)
    : engine_(seed)
  {
  }
  /// A number in [low, high).
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// A number of about the normal distribution: the sum of twelve, less their mean.
  double normal();
  Point point(double low, double high);
  Point direction();
  std::uint64_t bits() { return engine_(); }

private:
  std::mt19937_64 engine_;
};

std::vector<Point> randomPoints(std::size_t count, double low, double high, unsigned seed);

/// Random points around bounds, from `low` to `high` of their sides: 0 to 1 is within.
std::vector<Point> randomPointsAround(
  const winding::Bounds& bounds, std::size_t count, double low, double high, unsigned seed);

/// Points with normals, on the unit sphere or anywhere.
struct Cloud
{
  std::vector<Point> positions;
  std::vector<Point> normals;

  winding::OrientedPointsView view() const;
};

/// Points evenly spread over the unit sphere (a Fibonacci lattice), with outward normals.
Cloud sphereCloud(std::size_t count);
Cloud randomCloud(std::size_t count, unsigned seed);
winding::PointCloud clean(const Cloud& cloud);

/// The values at all samples, evaluated block by block.
std::vector<double> valuesOf(
  const winding::Evaluator& evaluator, const std::vector<Point>& samples);

std::vector<Point> gradientsOf(
  const winding::GradientEvaluator& evaluator, const std::vector<Point>& samples);

winding::Bounds boundsOf(const std::vector<Point>& points);

/// Returns the largest difference of two numbers at one place; NaN counts as a difference.
double largestDifference(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the share of unit normals whose cosines to `expected` are more than `cosine`.
double rightShare(
  const std::vector<Point>& normals, const std::vector<Point>& expected, double cosine = 0);

/// Puts a measured number into the running test's report (--gtest_output=xml shows it).
void record(const std::string& name, double value);

} // namespace shapes
