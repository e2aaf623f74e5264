// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/BoundaryGradient.h"
#include "base/Pi.h"

#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace
{

using namespace shapes;
using winding::BoundaryGradient;
using Long = Eigen::Matrix<long double, 3, 1>;

BoundaryGradient gradientOf(const winding::Surface& surface)
{
  return {surface, boundaryOf(surface).edges};
}

/// Every third triangle or so is missing.
Mesh damaged(const Mesh& whole, unsigned seed)
{
  Random random(seed);
  Mesh mesh{whole.points, {}};
  for (const auto& triangle : whole.triangles)
  {
    if (random(0, 1) > 0.3)
    {
      mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

/// One triangle of the sphere is repeated five times, another is turned round.
Mesh sphereWithMultiples()
{
  Mesh mesh = icosphere(1);
  mesh.triangles.insert(mesh.triangles.end(), 5, mesh.triangles[7]);
  std::swap(mesh.triangles[30][0], mesh.triangles[30][1]);
  return mesh;
}

std::vector<std::pair<std::string, Mesh>> openMeshes()
{
  return {{"triangle", Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}, {"cube", openCube()},
    {"sphere", icosphere(2).part(0, 250)}, {"torus", damaged(torus(24, 12), 611)},
    {"strip", moebiusStrip(12)}, {"multiples", sphereWithMultiples()},
    {"soup", triangleSoup(50, 612)}};
}

/// Points at which sums and steps of 2^−12 are exact, without any symmetry.
std::vector<Point> latticePoints(std::size_t count, unsigned seed)
{
  std::vector<Point> points = randomPoints(count, -1.5, 1.5, seed);
  for (Point& p : points)
  {
    p = ((p * 0x1p30).array().round() * 0x1p-30).matrix();
  }
  return points;
}

/// The gradient of the direct sum by central differences of fourth order. They may cross triangles,
/// where values jump by integers.
Point centralDifferences(const winding::Surface& surface, const Point& q)
{
  Point gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr long double h = 0x1p-12L;
    const auto difference = [&](int steps)
    {
      const Point step = steps * static_cast<double>(h) * Point::Unit(axis);
      const long double apart = winding::referenceSum<long double>(surface, q + step) -
                                winding::referenceSum<long double>(surface, q - step);
      return apart - std::round(apart);
    };
    gradient[axis] = static_cast<double>((8 * difference(1) - difference(2)) / (12 * h));
  }
  return gradient;
}

/// The formula of BoundaryGradient.h as it stands; edges on whose line q lies are left out.
Point byFormula(const winding::Surface& surface, const Point& q)
{
  Long sum = Long::Zero();
  for (const winding::BoundaryEdge& edge : boundaryOf(surface).edges)
  {
    const Long a = surface.vertices[edge.from].cast<long double>() - q.cast<long double>();
    const Long b = surface.vertices[edge.to].cast<long double>() - q.cast<long double>();
    const Long c = a.cross(b);
    if (c.norm() > 0)
    {
      const long double la = a.norm(), lb = b.norm();
      sum += edge.multiplicity * c * (la + lb) / (la * lb * (la * lb + a.dot(b)));
    }
  }
  return (sum / (4 * 3.14159265358979323846L)).cast<double>();
}

double distanceToBoundary(const winding::Surface& surface, const Point& q)
{
  double distance = HUGE_VAL;
  for (const winding::BoundaryEdge& edge : boundaryOf(surface).edges)
  {
    const Point u = surface.vertices[edge.from], along = surface.vertices[edge.to] - u;
    const double t = std::min(1.0, std::max(0.0, (q - u).dot(along) / along.squaredNorm()));
    distance = std::min(distance, (u + t * along - q).norm());
  }
  return distance;
}

} // namespace

TEST(BoundaryGradient, EqualsCentralDifferencesOfTheDirectSum)
{
  for (const auto& [name, mesh] : openMeshes())
  {
    SCOPED_TRACE(name + ", seeds 611 to 613");
    const winding::Surface surface = clean(mesh);
    const std::vector<Point> samples = latticePoints(100, 613);
    const std::vector<Point> gradients = gradientsOf(gradientOf(surface), samples);
    double worst = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      // The error of the differences is about (step / distance)⁴.
      if (distanceToBoundary(surface, samples[i]) > 0.05)
      {
        const Point expected = centralDifferences(surface, samples[i]);
        worst = std::max(worst, (gradients[i] - expected).norm());
      }
    }
    record(name, worst);
    EXPECT_LT(worst, 1e-8); // measured: 4e-10, the error of the differences
  }
}

TEST(BoundaryGradient, EqualsTheFormulaInLongDouble)
{
  for (const auto& [name, mesh] : openMeshes())
  {
    SCOPED_TRACE(name + ", seeds 611, 612, 614");
    const winding::Surface surface = clean(mesh);
    const std::vector<Point> samples = randomPoints(500, -2, 2, 614);
    const std::vector<Point> gradients = gradientsOf(gradientOf(surface), samples);
    double worst = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double unit = 1 / distanceToBoundary(surface, samples[i]);
      worst = std::max(worst, (gradients[i] - byFormula(surface, samples[i])).norm() / unit);
    }
    record(name, worst);
    EXPECT_LT(worst, 1e-13); // measured: 2.2e-16
  }
}

TEST(BoundaryGradient, OfClosedSurfacesIsExactlyZeroEverywhere)
{
  SCOPED_TRACE("seeds 615, 616");
  for (const Mesh& mesh : {Mesh(), cube(), icosphere(2), torus(24, 12),
         surfaceOf(randomCells(4, 615)), openCube().with(openCube().reversed())})
  {
    const winding::Surface surface = clean(mesh);
    std::vector<Point> samples = randomPoints(100, -2, 2, 616);
    samples.insert(samples.end(), mesh.points.begin(), mesh.points.end());
    samples.push_back({1e300, 0, 0});
    for (const Point& gradient : gradientsOf(gradientOf(surface), samples))
    {
      ASSERT_EQ(gradient, Point::Zero());
    }
  }
}

TEST(BoundaryGradient, OfAReversedSurfaceHasTheOtherSign)
{
  SCOPED_TRACE("seeds 611, 612, 617");
  for (const auto& [name, mesh] : openMeshes())
  {
    const winding::Surface surface = clean(mesh), reversed = clean(mesh.reversed());
    const std::vector<Point> samples = randomPoints(100, -2, 2, 617);
    const std::vector<Point> one = gradientsOf(gradientOf(surface), samples),
                             other = gradientsOf(gradientOf(reversed), samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      ASSERT_EQ(one[i], -other[i]) << name;
    }
  }
}

TEST(BoundaryGradient, DoesNotDependOnTheUnitOfLength)
{
  SCOPED_TRACE("seeds 611, 612, 618");
  for (const auto& [name, mesh] : openMeshes())
  {
    const winding::Surface surface = clean(mesh);
    const std::vector<Point> samples = randomPoints(200, -2, 2, 618);
    const std::vector<Point> expected = gradientsOf(gradientOf(surface), samples);
    for (const double scale : {0x1p-400, 0x1p-100, 0x1p100, 0x1p400, 1e-30, 1e30, 1e-100, 1e100})
    {
      const auto scaled = [scale](const Point& p) -> Point
      {
        return scale * p;
      };
      std::vector<Point> scaledSamples;
      std::transform(samples.begin(), samples.end(), std::back_inserter(scaledSamples), scaled);
      const winding::Surface other = cleanScaled(mesh, scale);
      const std::vector<Point> gradients = gradientsOf(gradientOf(other), scaledSamples);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const double error = (scale * gradients[i] - expected[i]).norm();
        // Powers of two change no bit; other scales were measured to change 8e-14.
        const bool isPowerOfTwo = scale == std::exp2(std::round(std::log2(scale)));
        ASSERT_LE(error, isPowerOfTwo ? 0 : 1e-11 * expected[i].norm() + 1e-13) << name << scale;
      }
    }
  }
}

TEST(BoundaryGradient, IsTheSameFarFromTheOrigin)
{
  SCOPED_TRACE("seeds 611, 612, 619");
  const auto toLattice = [](const Point& p) -> Point
  {
    return ((p * 0x1p28).array().round() * 0x1p-28).matrix();
  };
  const Point shift(4e6, -3e6, 5e6);
  for (const auto& [name, mesh] : openMeshes())
  {
    const winding::Surface still = clean(mesh.mapped(toLattice));
    const winding::Surface moved =
      clean(mesh.mapped([&](const Point& p) -> Point { return toLattice(p) + shift; }));
    std::vector<Point> samples, movedSamples;
    for (const Point& q : randomPoints(200, -2, 2, 619))
    {
      samples.push_back(toLattice(q));
      movedSamples.push_back(toLattice(q) + shift);
    }
    EXPECT_EQ(gradientsOf(gradientOf(moved), movedSamples), gradientsOf(gradientOf(still), samples))
      << name;
  }
}

TEST(BoundaryGradient, OnALineThroughAnEdgeLeavesOutThatEdge)
{
  // The samples are exactly on the line, though products of coordinates round: between the ends, at
  // them, beyond them.
  const Point end(1.1, 2.3, 3.7);
  const winding::Surface surface = clean(Mesh{{{0, 0, 0}, end, {0, 5, 1}}, {{0, 1, 2}}});
  for (const double t : {0.25, 0.5, 0.125, 0.0, 1.0, -0.5, -8.0, 2.0})
  {
    const Point q = t * end;
    const Point expected = byFormula(surface, q);
    EXPECT_GT(expected.norm(), 1e-6);
    EXPECT_LT((gradientsOf(gradientOf(surface), {q})[0] - expected).norm(), 1e-14) << t;
  }
}

TEST(BoundaryGradient, BesideAnEdgeIsThatOfAnEndlessLine)
{
  const winding::Surface surface = clean(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for (double d = 1e-2; d > 1e-80; d *= 1e-3)
  {
    // Around the edge w falls by 1 from below the triangle to above it, where the triangle's normal
    // points.
    const Point above = gradientsOf(gradientOf(surface), {{0.375, 0, d}})[0];
    EXPECT_NEAR(above[1] * 2 * winding::pi * d, -1, 4 * d + 1e-12);
    const Point beside = gradientsOf(gradientOf(surface), {{0.375, d, 0}})[0];
    EXPECT_NEAR(beside[2] * 2 * winding::pi * d, 1, 4 * d + 1e-12); // measured: 3.1 d
  }
}

TEST(BoundaryGradient, IsFiniteOnTheBoundaryAndAnywhereElse)
{
  for (const auto& [name, mesh] : openMeshes())
  {
    const winding::Surface surface = clean(mesh);
    std::vector<Point> samples = surface.vertices;
    for (const winding::BoundaryEdge& edge : boundaryOf(surface).edges)
    {
      const Point &u = surface.vertices[edge.from], &v = surface.vertices[edge.to];
      for (const double t : {0.5, 1.0 / 3, 1e-9, 1e-18, 1 - 1e-15})
      {
        samples.emplace_back((1 - t) * u + t * v);
      }
    }
    for (const double far : {0x1p-1074, 1e-300, 1e-150, 1e100, 1e200, 1.7e308})
    {
      samples.push_back(surface.vertices[0] + Point(far, 0, 0));
      samples.push_back({far, -far, far});
    }
    for (const Point& gradient : gradientsOf(gradientOf(surface), samples))
    {
      ASSERT_TRUE(gradient.allFinite()) << name;
    }
    // Far away the gradient is that of a dipole, whose strength is the vector area.
    const Point far = gradientsOf(gradientOf(surface), {{1e60, 0, 0}})[0];
    EXPECT_LT(far.norm(), 1e-60) << name;
  }
}
