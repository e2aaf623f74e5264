// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/Expansions.h"
#include "base/Pi.h"

#include "sums/SolidAngle.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>

using shapes::Point;
using shapes::Random;
using winding::Expansion;

namespace
{

struct Dipoles
{
  std::vector<Point> positions, moments; ///< area · normal / 4π

  double at(const Point& q) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      sum += winding::dipoleSolidAngle<double>(positions[i] - q, moments[i], 1.0);
    }
    return sum;
  }

  Expansion around(int order, const Point& center) const
  {
    Expansion result(static_cast<std::size_t>(winding::coefficientCount(order)));
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      winding::addDipole(order, positions[i] - center, moments[i], result);
    }
    return result;
  }
};

/// Dipoles within a distance of 1 around the origin, of about unit strength in all.
Dipoles someDipoles(unsigned seed)
{
  Random random(seed);
  Dipoles dipoles;
  for (int i = 0; i < 20; ++i)
  {
    dipoles.positions.push_back(random.direction() * random(0, 1));
    dipoles.moments.push_back(random.direction() / (4 * winding::pi));
  }
  return dipoles;
}

double largestDifference(const Expansion& a, const Expansion& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

class Expansions : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(Expansions, OfMomentsConvergeToTheDirectSum)
{
  SCOPED_TRACE("seed 201");
  const int order = GetParam();
  const Dipoles dipoles = someDipoles(201);
  const Expansion moments = dipoles.around(order, Point::Zero());
  Random random(202);
  for (int i = 0; i < 50; ++i)
  {
    const Point q = 4 * random.direction();
    // The first missing degree falls off as (1/4)^(order + 3).
    EXPECT_NEAR(winding::momentsAt(order, moments, q), dipoles.at(q),
      2 * (order + 2) * std::pow(0.25, order + 3)); // measured: half of it
  }
}

TEST_P(Expansions, OfMomentsMoveExactly)
{
  SCOPED_TRACE("seed 203");
  const int order = GetParam();
  const Dipoles dipoles = someDipoles(203);
  const Point to(0.3, -0.7, 0.5);
  const Expansion moved =
    winding::shiftMoments(order, dipoles.around(order, Point::Zero()), Point::Zero() - to);
  EXPECT_LT(largestDifference(moved, dipoles.around(order, to)), 1e-13); // measured: 2e-15
}

TEST_P(Expansions, OfLocalFieldsConvergeToTheDirectSum)
{
  SCOPED_TRACE("seed 204");
  const int order = GetParam();
  const Dipoles dipoles = someDipoles(204);
  const Point center(4, -3, 5);
  const Expansion local =
    winding::momentsToLocal(order, dipoles.around(order, Point::Zero()), center);
  Random random(205);
  for (int i = 0; i < 50; ++i)
  {
    const Point s = random.direction();
    const double ratio = 1 / (center.norm() - 1);
    EXPECT_NEAR(winding::localAt(order, local, s), dipoles.at(center + s),
      2 * (order + 2) * std::pow(ratio, order + 3)); // measured: a twentieth of it
  }
}

TEST_P(Expansions, OfLocalFieldsMoveExactly)
{
  SCOPED_TRACE("seed 206");
  const int order = GetParam();
  const Expansion local =
    winding::momentsToLocal(order, someDipoles(206).around(order, Point::Zero()), Point(2, 3, -1));
  const Point shift(0.25, -0.25, 0.5);
  const Expansion moved = winding::shiftLocal(order, local, shift);
  Random random(207);
  for (int i = 0; i < 50; ++i)
  {
    const Point s = random.direction();
    // A finite harmonic polynomial is the same polynomial about any centre.
    EXPECT_NEAR(
      winding::localAt(order, moved, s), winding::localAt(order, local, shift + s), 1e-12);
  }
}

TEST_P(Expansions, OfLocalFieldsArePolynomials)
{
  SCOPED_TRACE("seed 208");
  const int order = GetParam();
  const Expansion local =
    winding::momentsToLocal(order, someDipoles(208).around(order, Point::Zero()), Point(2, 3, -1));
  const Eigen::VectorXd coefficients =
    winding::polynomialMatrix(order) *
    Eigen::Map<const Eigen::VectorXd>(local.data(), static_cast<Eigen::Index>(local.size()));
  Random random(209);
  for (int i = 0; i < 50; ++i)
  {
    const Point s = random.direction();
    double value = 0;
    int row = 0;
    for (int a = order; a >= 0; --a)
    {
      for (int b = order - a; b >= 0; --b)
      {
        for (int c = order - a - b; c >= 0; --c)
        {
          value += coefficients[row++] * std::pow(s[0], a) * std::pow(s[1], b) * std::pow(s[2], c);
        }
      }
    }
    EXPECT_NEAR(value, winding::localAt(order, local, s), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(OfOrder, Expansions, testing::Values(1, 2, 3, 4, 5, 7, 9));
