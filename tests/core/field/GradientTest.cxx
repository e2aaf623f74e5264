// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Executor.h"
#include "base/Pi.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "sums/ReferenceSum.h"
#include "support/Fields.h"
#include "support/Interruption.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "surface/BoundaryGradient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

/**
 * These tests look at Field::gradient() and at the direct sum over clouds; BoundaryGradientTest.cxx
 * and FarFieldGradientTest.cxx look at surfaces and at far fields.
 */

namespace
{

using namespace shapes;
using winding::Field;
using winding::Method;
using Long = Eigen::Matrix<long double, 3, 1>;

std::vector<std::shared_ptr<const Field>> someFields()
{
  const Mesh open = icosphere(3).part(0, 900);
  const Cloud cloud = sphereCloud(2000);
  return {fieldOf(open, Method::automatic), fieldOf(open, Method::direct),
    fieldOf(open, Method::hierarchical), fieldOf(cloud, Method::direct),
    fieldOf(cloud, Method::hierarchical)};
}

/// A cloud with the areas of its points.
struct Dipoles
{
  winding::PointCloud cloud;
  std::vector<double> areas;

  std::vector<Point> gradients(const std::vector<Point>& samples) const
  {
    return gradientsOf(winding::DipoleSum(cloud, areas), samples);
  }
};

std::vector<Dipoles> someDipoles(unsigned seed)
{
  Random random(seed);
  std::vector<Dipoles> all;
  for (const Cloud& cloud :
    {sphereCloud(1000), randomCloud(1000, seed + 1), Cloud{{{0.1, 0.2, 0.3}}, {{0, 0.6, 0.8}}},
      Cloud{std::vector<Point>(300, Point(0.5, 0, 0)), std::vector<Point>(300, Point(0, 0, 1))}})
  {
    Dipoles dipoles{clean(cloud), {}};
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
      dipoles.areas.push_back(random(0, 0.01));
    }
    all.push_back(dipoles);
  }
  return all;
}

/// The sum of the gradients of SolidAngle.h's dipoles; `strength` becomes the sum of their sizes.
Point byFormula(const Dipoles& dipoles, const Point& q, double& strength)
{
  Long sum = Long::Zero();
  strength = 0;
  for (std::size_t i = 0; i < dipoles.areas.size(); ++i)
  {
    const Long d = dipoles.cloud.positions[i].cast<long double>() - q.cast<long double>();
    const long double r = d.norm();
    if (r > 0)
    {
      const Long n = dipoles.cloud.normals[i].cast<long double>();
      const Long share =
        static_cast<long double>(dipoles.areas[i]) * (3 * n.dot(d) / (r * r) * d - n) / (r * r * r);
      sum += share;
      strength += static_cast<double>(share.norm());
    }
  }
  strength /= (4 * winding::pi);
  return sum.cast<double>() / (4 * winding::pi);
}

} // namespace

TEST(DipoleSumGradient, EqualsTheFormulaInLongDouble)
{
  SCOPED_TRACE("seeds 621 to 624");
  double worst = 0;
  for (const Dipoles& dipoles : someDipoles(621))
  {
    std::vector<Point> samples = randomPoints(100, -2, 2, 623);
    Random random(624);
    for (const double distance : {1e-2, 1e-4, 1e-8})
    {
      for (int i = 0; i < 20; ++i)
      {
        samples.push_back(dipoles.cloud.positions[random.bits() % dipoles.areas.size()] +
                          distance * random.direction());
      }
    }
    // A sample on points leaves these out.
    samples.insert(
      samples.end(), dipoles.cloud.positions.begin(), dipoles.cloud.positions.begin() + 1);
    const std::vector<Point> gradients = dipoles.gradients(samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      double strength;
      const Point expected = byFormula(dipoles, samples[i], strength);
      ASSERT_LE((gradients[i] - expected).norm(), 1e-13 * strength);
      worst = std::max(worst, strength > 0 ? (gradients[i] - expected).norm() / strength : 0);
    }
  }
  record("worst", worst); // measured: 2.3e-15
}

TEST(DipoleSumGradient, EqualsCentralDifferencesOfTheDirectSum)
{
  SCOPED_TRACE("seeds 625 to 627");
  for (const Dipoles& dipoles : someDipoles(625))
  {
    for (Point q : randomPoints(50, -2, 2, 627))
    {
      // Samples are rounded so that steps from them are exact.
      q = ((q * 0x1p30).array().round() * 0x1p-30).matrix();
      double strength;
      byFormula(dipoles, q, strength);
      const Point gradient = dipoles.gradients({q})[0];
      for (int axis = 0; axis < 3; ++axis)
      {
        constexpr long double h = 0x1p-12L;
        const auto at = [&](int steps)
        {
          return winding::referenceSum<long double>(
            dipoles.cloud, dipoles.areas, q + steps * static_cast<double>(h) * Point::Unit(axis));
        };
        const long double expected = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
        ASSERT_NEAR(
          gradient[axis], static_cast<double>(expected), 1e-8 * strength); // measured: 7e-10
      }
    }
  }
}

TEST(Gradient, OfASurfaceIsTheSameForEveryMethod)
{
  SCOPED_TRACE("seed 628");
  const Mesh mesh = icosphere(3).part(0, 900);
  const std::vector<Point> samples = randomPoints(1000, -2, 2, 628);
  const std::vector<Point> expected = gradientsAt(*fieldOf(mesh, Method::direct), samples);
  for (const Method method :
    {Method::automatic, Method::rows, Method::hierarchical, Method::parity})
  {
    EXPECT_EQ(gradientsAt(*fieldOf(mesh, method), samples), expected) << nameOf(method);
  }
  const winding::Surface surface = clean(mesh);
  EXPECT_EQ(
    gradientsOf(winding::BoundaryGradient(surface, boundaryOf(surface).edges), samples), expected);
}

TEST(Gradient, OfACloudIsWithinTheToleranceThatOfTheDirectSum)
{
  SCOPED_TRACE("seed 629");
  const Cloud cloud = sphereCloud(3000);
  const std::vector<Point> samples = randomPoints(1000, -2, 2, 629);
  const std::vector<Point> expected = gradientsAt(*fieldOf(cloud, Method::direct), samples),
                           found = gradientsAt(*fieldOf(cloud, Method::hierarchical), samples);
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double distance = std::max(std::abs(samples[i].norm() - 1), 0.01);
    worst = std::max(worst, (found[i] - expected[i]).norm() * distance);
  }
  record("worst", worst);
  EXPECT_LT(worst, 4e-3); // measured: 8.8e-4
  EXPECT_GT(worst, 0);    // a far field was used indeed
}

TEST(Gradient, HasTheSameBitsOnAnyThreadsInAnyOrder)
{
  SCOPED_TRACE("seeds 630 to 632");
  const std::vector<Point> samples = randomPoints(5000, -2, 2, 630);
  ShuffledThreads one(631), other(632);
  for (const auto& field : someFields())
  {
    const std::vector<Point> expected = gradientsAt(*field, samples);
    EXPECT_EQ(gradientsAt(*field, samples, one), expected);
    EXPECT_EQ(gradientsAt(*field, samples, other), expected);
  }
}

TEST(Gradient, TakesSamplesOfAnyTypeAndStride)
{
  for (const auto& field : someFields())
  {
    std::vector<float> strided;
    std::vector<Point> samples;
    for (int i = 0; i < 100; ++i)
    {
      // A float holds these numbers exactly.
      const float x = i / 64.0f - 0.75f, y = i % 7 / 8.0f, z = -i % 11 / 16.0f;
      strided.insert(strided.end(), {x, y, z, 77, 78});
      samples.push_back({x, y, z});
    }
    std::vector<Point> gradients(100);
    field->gradient(winding::VectorsView(strided.data(), 100, 5), gradients[0].data(), serial);
    EXPECT_EQ(gradients, gradientsAt(*field, samples));
  }
}

TEST(Gradient, IsFiniteButWhereThereIsNoPlace)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const std::vector<Point> nowhere = {{nan, 0, 0}, {0, infinity, 0}, {0, 0, -infinity}};
  for (const auto& field : someFields())
  {
    for (const Point& gradient : gradientsAt(*field, nowhere))
    {
      EXPECT_TRUE(std::isnan(gradient[0]) && std::isnan(gradient[1]) && std::isnan(gradient[2]));
    }
    std::vector<Point> samples = {{0, 0, 0}, {1e200, 0, 0}, {0, -1e308, 1e-3}, {1e6, 1e6, -1e6},
      {1e30, -1e30, 1e30}, {180, 0, 0}, {-1e12, 0, 0}, {1e-300, 0, 0}};
    for (const Point& on : icosphere(3).points)
    {
      samples.push_back(on);
    }
    for (const Point& on : sphereCloud(2000).positions)
    {
      samples.push_back(on);
    }
    for (const Point& gradient : gradientsAt(*field, samples))
    {
      ASSERT_TRUE(gradient.allFinite());
    }
  }
}

TEST(Gradient, IsOneOverTheUnitOfLength)
{
  SCOPED_TRACE("seed 633");
  const std::vector<Point> samples = randomPoints(500, -2, 2, 633);
  const Mesh mesh = icosphere(2).part(0, 250);
  for (const double scale : {1e-100, 1e-30, 1e30, 1e100})
  {
    const auto scaled = [scale](const Point& p) -> Point
    {
      return scale * p;
    };
    std::vector<Point> scaledSamples;
    std::transform(samples.begin(), samples.end(), std::back_inserter(scaledSamples), scaled);
    Cloud cloud = sphereCloud(2000);
    const auto compare = [&](const Field& field, const Field& expectedField, double tolerance)
    {
      const std::vector<Point> expected = gradientsAt(expectedField, samples),
                               found = gradientsAt(field, scaledSamples);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        ASSERT_LT((scale * found[i] - expected[i]).norm(), tolerance * (1 + expected[i].norm()))
          << scale;
      }
    };
    compare(*fieldOf(mesh.mapped(scaled), Method::direct), *fieldOf(mesh, Method::direct), 1e-11);
    Cloud scaledCloud = cloud;
    std::transform(
      cloud.positions.begin(), cloud.positions.end(), scaledCloud.positions.begin(), scaled);
    // Areas are estimated, and so are in the unit squared.
    compare(*fieldOf(scaledCloud, Method::direct), *fieldOf(cloud, Method::direct), 1e-11);
    compare(*fieldOf(scaledCloud, Method::hierarchical), *fieldOf(cloud, Method::hierarchical),
      1e-2); // measured: 3.3e-4
  }
}

TEST(Gradient, OfATinySourceIsCutOffAtTheLargestNumber)
{
  // Samples lie next to the boundary, as near as 1e-320, where doubles are close to the smallest
  // that there are. Fields refuse sources as small as this one.
  const winding::Surface surface = cleanScaled(icosphere(1).part(0, 50), 1e-300);
  const winding::BoundaryEdges edges = boundaryOf(surface).edges;
  const winding::BoundaryEdge edge = edges[0];
  std::vector<Point> samples;
  for (const double beside : {1e-301, 1e-310, 1e-320})
  {
    samples.emplace_back(
      (surface.vertices[edge.from] + surface.vertices[edge.to]) / 2 + Point(beside, beside, 0));
  }
  for (const Point& gradient : gradientsOf(winding::BoundaryGradient(surface, edges), samples))
  {
    EXPECT_TRUE(gradient.allFinite());
    EXPECT_GT(gradient.norm(), 1e298);
  }
}

TEST(Gradient, OfNothingIsZero)
{
  for (const auto& field :
    {fieldOf(Mesh(), Method::automatic), fieldOf(icosphere(2), Method::direct),
      fieldOf(Cloud(), Method::direct), fieldOf(Cloud(), Method::hierarchical)})
  {
    for (const Point& gradient : gradientsAt(*field, {{0, 0, 0}, {1, 2, 3}, {1e200, 0, 0}}))
    {
      EXPECT_EQ(gradient, Point::Zero());
    }
  }
}

TEST(Gradient, SaysWhenItWasInterrupted)
{
  Interruption interruption(0);
  const std::vector<Point> samples(1000, Point(0.5, 0.5, 0.5));
  std::vector<Point> gradients(1000);
  for (const auto& field : someFields())
  {
    EXPECT_THROW(field->gradient(winding::VectorsView(samples[0].data(), samples.size()),
                   gradients[0].data(), interruption),
      winding::Interrupted);
  }
}
