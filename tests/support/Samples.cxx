// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/Samples.h"
#include "base/Pi.h"
#include "support/Serial.h"

#include "source/Sanitize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shapes
{

double Random::normal()
{
  double sum = -6;
  for (int i = 0; i < 12; ++i)
  {
    sum += (*this)(0, 1);
  }
  return sum;
}

Point Random::point(double low, double high)
{
  const double x = (*this)(low, high), y = (*this)(low, high), z = (*this)(low, high);
  return {x, y, z};
}

Point Random::direction()
{
  Point p = point(-1, 1);
  while (p.norm() > 1 || p.norm() < 0.1)
  {
    p = point(-1, 1);
  }
  return p.normalized();
}

std::vector<Point> randomPoints(std::size_t count, double low, double high, unsigned seed)
{
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& p : points)
  {
    p = random.point(low, high);
  }
  return points;
}

std::vector<Point> randomPointsAround(
  const winding::Bounds& bounds, std::size_t count, double low, double high, unsigned seed)
{
  std::vector<Point> points = randomPoints(count, low, high, seed);
  for (Point& p : points)
  {
    p = bounds.min() + p.cwiseProduct(bounds.sizes());
  }
  return points;
}

winding::OrientedPointsView Cloud::view() const
{
  return {{positions.empty() ? nullptr : positions[0].data(), positions.size()},
    {normals.empty() ? nullptr : normals[0].data(), normals.size()}, {}};
}

Cloud sphereCloud(std::size_t count)
{
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double turn = static_cast<double>(i) * winding::pi * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - z * z);
    cloud.positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
  }
  cloud.normals = cloud.positions;
  return cloud;
}

Cloud randomCloud(std::size_t count, unsigned seed)
{
  Random random(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    cloud.positions.push_back(random.point(-1, 1));
    cloud.normals.push_back(random.direction());
  }
  return cloud;
}

winding::PointCloud clean(const Cloud& cloud)
{
  return winding::sanitize(std::vector<winding::OrientedPointsView>{cloud.view()}, serial);
}

namespace
{

/// Calls evaluate(block, number of its first sample) for all samples in blocks.
template <class Evaluate>
void forEachBlock(const std::vector<Point>& samples, const Evaluate& evaluate)
{
  for (std::size_t first = 0; first < samples.size(); first += winding::SampleBlock::capacity)
  {
    winding::SampleBlock block;
    block.count = std::min(winding::SampleBlock::capacity, samples.size() - first);
    for (std::size_t i = 0; i < block.count; ++i)
    {
      block.set(i, samples[first + i]);
    }
    evaluate(block, first);
  }
}

} // namespace

std::vector<double> valuesOf(const winding::Evaluator& evaluator, const std::vector<Point>& samples)
{
  std::vector<double> values(samples.size());
  const auto evaluate = [&](const winding::SampleBlock& block, std::size_t first)
  {
    evaluator.evaluate(block, values.data() + first);
  };
  forEachBlock(samples, evaluate);
  return values;
}

std::vector<Point> gradientsOf(
  const winding::GradientEvaluator& evaluator, const std::vector<Point>& samples)
{
  std::vector<Point> gradients(samples.size());
  const auto evaluate = [&](const winding::SampleBlock& block, std::size_t first)
  {
    evaluator.evaluateGradients(block, gradients[first].data());
  };
  forEachBlock(samples, evaluate);
  return gradients;
}

winding::Bounds boundsOf(const std::vector<Point>& points)
{
  winding::Bounds bounds;
  for (const Point& point : points)
  {
    bounds.extend(point);
  }
  return bounds;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    // The comparison is written so that NaN counts.
    largest = std::abs(a[i] - b[i]) <= largest ? largest : std::abs(a[i] - b[i]);
  }
  return largest;
}

double rightShare(
  const std::vector<Point>& normals, const std::vector<Point>& expected, double cosine)
{
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    right += normals[i].dot(expected[i]) > cosine;
  }
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

void record(const std::string& name, double value)
{
  std::ostringstream text;
  text << value;
  testing::Test::RecordProperty(name, text.str());
}

} // namespace shapes
