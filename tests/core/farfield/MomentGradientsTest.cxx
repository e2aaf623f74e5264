// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/MomentGradients.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using shapes::Point;
using shapes::Random;
using winding::Expansion;
using winding::MomentDerivatives;

namespace
{

/// Moments of random dipoles in the unit ball, as floats hold them.
std::vector<float> someMoments(int order, Random& random)
{
  Expansion moments(static_cast<std::size_t>(winding::coefficientCount(order)));
  for (int i = 0; i < 20; ++i)
  {
    winding::addDipole(order, random.direction() * random(0, 1), random.direction(), moments);
  }
  return {moments.begin(), moments.end()};
}

Point gradientAt(const MomentDerivatives& derivatives, const Point& offset)
{
  Point gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float* along = axis == 0 ? derivatives.x : (axis == 1 ? derivatives.y : derivatives.z);
    gradient[axis] = winding::momentsAt(derivatives.order,
      Expansion(along, along + winding::coefficientCount(derivatives.order)), offset);
  }
  return gradient;
}

class GradientKernels : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(GradientKernels, DifferentiateMomentsLikeCentralDifferences)
{
  SCOPED_TRACE("seed 601");
  const int order = GetParam();
  Random random(601);
  for (int i = 0; i < 50; ++i)
  {
    const std::vector<float> moments = someMoments(order, random);
    const Expansion exact(moments.begin(), moments.end());
    const Point offset = random.direction() * random(1.5, 4);
    const Point gradient = gradientAt(MomentDerivatives(order, moments.data()), offset);
    for (int axis = 0; axis < 3; ++axis)
    {
      constexpr double h = 1e-3;
      const auto at = [&](double steps)
      {
        return winding::momentsAt(order, exact, offset + steps * h * Point::Unit(axis));
      };
      const double expected = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
      ASSERT_NEAR(gradient[axis], expected, 1e-6 * (1 + gradient.norm())); // measured: 3.2e-8
    }
  }
}

TEST_P(GradientKernels, OfMomentsEqualThePlainForm)
{
  SCOPED_TRACE("seed 602");
  const int order = GetParam();
  Random random(602);
  for (const std::size_t count : {1, 15, 16, 17, 256})
  {
    const std::vector<float> moments = someMoments(order, random);
    const MomentDerivatives derivatives(order, moments.data());
    alignas(64) float x[winding::SampleBlock::capacity] = {};
    alignas(64) float y[winding::SampleBlock::capacity] = {};
    alignas(64) float z[winding::SampleBlock::capacity] = {};
    std::vector<Point> offsets;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Point offset = random.direction() * random(1.5, 4);
      x[i] = static_cast<float>(offset[0]);
      y[i] = static_cast<float>(offset[1]);
      z[i] = static_cast<float>(offset[2]);
      offsets.emplace_back(x[i], y[i], z[i]);
    }
    winding::FloatGradientSums sums;
    std::fill_n(sums.y, count, 0.5f);
    winding::addMomentGradients(derivatives, 0.25f, x, y, z, count, sums);
    for (std::size_t i = 0; i < count; ++i)
    {
      // The kernel multiplies by 1/r², and adds to the number that was there before.
      const Point expected = gradientAt(derivatives, offsets[i]) / 16 + Point(0, 0.5, 0);
      const Point found(sums.x[i], sums.y[i], sums.z[i]);
      ASSERT_LT((found - expected).norm(), 1e-5 * (1 + expected.norm())); // measured: 1.0e-7
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, GradientKernels, testing::Values(3, 5, 7, 9));
