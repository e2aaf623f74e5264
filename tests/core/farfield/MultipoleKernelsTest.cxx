// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/MultipoleKernels.h"

#include "farfield/Expansions.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using shapes::Point;
using shapes::Random;
using winding::Expansion;

namespace
{

/// A batch of dipoles in the unit ball, and its moments in double.
struct Node
{
  winding::DipoleBatch batch;
  Expansion moments;

  Node(int order, std::size_t count, Random& random)
    : moments(static_cast<std::size_t>(winding::coefficientCount(order)))
  {
    batch.count = count;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point p = random.direction() * random(0, 1), n = random.direction() * 0.01;
      batch.x[i] = static_cast<float>(p[0]);
      batch.y[i] = static_cast<float>(p[1]);
      batch.z[i] = static_cast<float>(p[2]);
      batch.nx[i] = static_cast<float>(n[0]);
      batch.ny[i] = static_cast<float>(n[1]);
      batch.nz[i] = static_cast<float>(n[2]);
      winding::addDipole(order, p, n, moments);
    }
  }
};

/// Largest difference, relative to the largest coefficient of the same degree.
double difference(int order, const float* found, const Expansion& expected)
{
  double worst = 0;
  for (int n = 0; n <= order; ++n)
  {
    double largest = 0, apart = 0;
    for (int i = n * n; i < (n + 1) * (n + 1); ++i)
    {
      const std::size_t at = static_cast<std::size_t>(i);
      largest = std::max(largest, std::abs(expected[at]));
      apart = std::max(apart, std::abs(found[i] - expected[at]));
    }
    worst = std::max(worst, largest > 0 ? apart / largest : apart);
  }
  return worst;
}

class MultipoleKernels : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(MultipoleKernels, MakeMoments)
{
  SCOPED_TRACE("seed 211");
  Random random(211);
  const int order = GetParam();
  for (const std::size_t count : {1, 3, 16, 17, 64})
  {
    const Node node(order, count, random);
    alignas(64) float moments[winding::paddedCoefficients(winding::largestOrder)] = {};
    winding::addMoments(order, node.batch, moments);
    EXPECT_LT(difference(order, moments, node.moments), 3e-6); // measured: 7e-7
  }
}

TEST_P(MultipoleKernels, TranslateMomentsOfAnyNumberOfNodes)
{
  SCOPED_TRACE("seed 212");
  Random random(212);
  const int order = GetParam();
  const std::size_t stride = winding::paddedCoefficients(order);
  const std::size_t nodes = 40;
  std::vector<float> moments(nodes * stride);
  std::vector<Expansion> exact;
  for (std::size_t i = 0; i < nodes; ++i)
  {
    const Node node(order, 10, random);
    winding::addMoments(order, node.batch, &moments[i * stride]);
    exact.push_back(node.moments);
  }
  for (std::size_t count = 1; count <= winding::NodeBatch::capacity; ++count)
  {
    const float side = 0.75f;
    Expansion expected(static_cast<std::size_t>(winding::coefficientCount(order)));
    winding::NodeBatch batch;
    batch.count = count;
    for (std::size_t i = 0; i < count; ++i)
    {
      const float radius = static_cast<float>(random(0.01, 1));
      const Point d = random.direction() * random(2, 5);
      batch.node[i] = static_cast<std::int32_t>(random.bits() % nodes);
      batch.dx[i] = static_cast<float>(d[0]);
      batch.dy[i] = static_cast<float>(d[1]);
      batch.dz[i] = static_cast<float>(d[2]);
      batch.radius[i] = radius;
      // The reference takes unscaled moments of a node of that radius, and scales its result by the
      // cell's side.
      Expansion scaled = exact[static_cast<std::size_t>(batch.node[i])];
      for (int k = 0; k <= order; ++k)
      {
        for (int at = k * k; at < (k + 1) * (k + 1); ++at)
        {
          scaled[static_cast<std::size_t>(at)] *= std::pow(static_cast<double>(radius), k);
        }
      }
      const Expansion local = winding::momentsToLocal(order, scaled, d);
      for (int n = 0; n <= order; ++n)
      {
        for (int at = n * n; at < (n + 1) * (n + 1); ++at)
        {
          expected[static_cast<std::size_t>(at)] +=
            local[static_cast<std::size_t>(at)] * std::pow(static_cast<double>(side), n);
        }
      }
    }
    winding::LocalSums sums = {};
    winding::translateMoments(order, moments.data(), batch, side, sums);
    float local[winding::paddedCoefficients(winding::largestOrder)] = {};
    winding::addLanes(order, sums, local);
    EXPECT_LT(difference(order, local, expected), 2e-5) << count; // measured: 4e-6
  }
}

TEST_P(MultipoleKernels, EvaluateMoments)
{
  SCOPED_TRACE("seed 213");
  Random random(213);
  const int order = GetParam();
  const Node node(order, 30, random);
  alignas(64) float moments[winding::paddedCoefficients(winding::largestOrder)] = {};
  winding::addMoments(order, node.batch, moments);
  const double radius = 0.25, center[3] = {1e3, -2e3, 3e3};
  winding::SampleBlock samples;
  samples.count = 45;
  alignas(64) float values[48];
  std::vector<double> expected;
  for (std::size_t i = 0; i < samples.count; ++i)
  {
    const Point q = random.direction() * random(1.5, 20);
    samples.set(i, Point(center) + radius * q);
    values[i] = 0.25f;
    expected.push_back(0.25 + winding::momentsAt(order, node.moments, q) / radius);
  }
  winding::addMomentValues(order, moments, center, radius, samples, values);
  for (std::size_t i = 0; i < samples.count; ++i)
  {
    EXPECT_NEAR(values[i], expected[i], 1e-6); // measured: 2e-7
  }
}

TEST_P(MultipoleKernels, EvaluatePolynomials)
{
  SCOPED_TRACE("seed 214");
  Random random(214);
  const int order = GetParam();
  std::vector<float> coefficients;
  for (int i = 0; i < winding::monomialCount(order); ++i)
  {
    coefficients.push_back(static_cast<float>(random(-1, 1)));
  }
  constexpr std::size_t count = 32;
  alignas(64) float x[count], y[count], z[count], values[count], row[count];
  for (std::size_t s = 0; s < count; ++s)
  {
    x[s] = static_cast<float>(random(-0.5, 0.5));
    y[s] = static_cast<float>(random(-0.5, 0.5));
    z[s] = static_cast<float>(random(-0.5, 0.5));
  }
  winding::evaluatePolynomial(order, coefficients.data(), x, y, z, count, values);
  winding::evaluateRow(order, coefficients.data(), x, count, row);
  for (std::size_t s = 0; s < count; ++s)
  {
    double expected = 0, expectedInRow = 0;
    std::size_t next = 0;
    for (int i = order; i >= 0; --i)
    {
      expectedInRow +=
        coefficients[static_cast<std::size_t>(order - i)] * std::pow(static_cast<double>(x[s]), i);
      for (int j = order - i; j >= 0; --j)
      {
        for (int k = order - i - j; k >= 0; --k)
        {
          expected += coefficients[next++] * std::pow(static_cast<double>(x[s]), i) *
                      std::pow(static_cast<double>(y[s]), j) *
                      std::pow(static_cast<double>(z[s]), k);
        }
      }
    }
    EXPECT_NEAR(values[s], expected, 1e-6);
    EXPECT_NEAR(row[s], expectedInRow, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(OfOrder, MultipoleKernels, testing::Values(3, 5, 7, 9));
