// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/CappedSurface.h"

#include "base/Bounds.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "sums/ReferenceSum.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/RowValues.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include "field/Field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace shapes;
using winding::CappedSurface;
using winding::Extent;
using winding::FieldOutput;
using winding::Grid;

std::vector<double> valuesOn(const CappedSurface& capped, const Grid& grid, const Extent& extent)
{
  std::vector<double> values(winding::sampleCount(extent), std::nan(""));
  FieldOutput output;
  output.doubleValues = values.data();
  capped.evaluate(grid, extent, output, serial);
  return values;
}

std::vector<double> valuesOn(const Mesh& mesh, const Grid& grid)
{
  const winding::Surface surface = clean(mesh);
  return valuesOn({surface, boundaryOf(surface), 0, serial}, grid, grid.wholeExtent());
}

std::vector<double> valuesAt(const CappedSurface& capped, const std::vector<Point>& samples)
{
  std::vector<double> values(samples.size(), std::nan(""));
  FieldOutput output;
  output.doubleValues = values.data();
  capped.evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, serial);
  return values;
}

/// The largest difference to the direct sum among the samples that are not on the surface, on the
/// grid and at its samples as scattered ones.
double largestError(const Mesh& mesh, const Grid& grid)
{
  const winding::Surface surface = clean(mesh);
  const std::vector<double> values = valuesOn(mesh, grid);
  const std::vector<double> scattered =
    valuesAt({surface, boundaryOf(surface), 0, serial}, samplesOf(grid));
  const winding::TriangleSum sum(surface);
  double largest = 0;
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const Point q = grid.sample(n);
    winding::SampleBlock block;
    block.count = 1;
    block.x[0] = q[0];
    block.y[0] = q[1];
    block.z[0] = q[2];
    double expected;
    bool isOnSurface;
    if (!sum.evaluateWatching(block, &expected, &isOnSurface))
    {
      largest = std::max(largest, std::abs(values[n] - expected));
      largest = std::max(largest, std::abs(scattered[n] - expected));
    }
    EXPECT_TRUE(std::isfinite(scattered[n]));
    EXPECT_TRUE(std::isfinite(values[n]));
  }
  return largest;
}

/// The mesh with every triangle deleted, repeated or flipped with the same probability.
Mesh damaged(const Mesh& mesh, double probability, unsigned seed)
{
  Random random(seed);
  Mesh result{mesh.points, {}};
  for (const auto& t : mesh.triangles)
  {
    const double fate = random(0, 1) / probability;
    if (fate >= 1)
    {
      result.triangles.push_back(fate < 2 ? std::array{t[0], t[2], t[1]} : t);
    }
    if (fate >= 2 && fate < 3)
    {
      result.triangles.push_back(t);
    }
  }
  return result;
}

Grid gridAround(const Mesh& mesh, int resolution)
{
  const winding::Bounds bounds = clean(mesh).bounds;
  const Point spacing = bounds.sizes() / resolution;
  return gridOf(bounds.min() - 1.5 * spacing, spacing, Eigen::Vector3i::Constant(resolution + 4));
}

} // namespace

TEST(CappedSurface, EqualsTheDirectSumOnRandomLatticeChains)
{
  SCOPED_TRACE("seeds 1 … 2000");
  ChainComparison total;
  for (unsigned seed = 1; seed <= 2000; ++seed)
  {
    const ChainComparison found = compareWithDirectSum(randomLatticeChain(seed, 12, 4));
    EXPECT_EQ(found.failure, "") << "seed " << seed;
    total.offSurface += found.offSurface;
    total.onSurface += found.onSurface;
    total.onRim += found.onRim;
    total.means += found.means;
    total.largestError = std::max(total.largestError, found.largestError);
  }
  record("largestError", total.largestError);
  EXPECT_LT(total.largestError, 1e-13); // measured: 3e-15
  EXPECT_GT(total.offSurface, 500000u); // measured: 772626
  EXPECT_GT(total.onSurface, 20000u);   // measured: 31762
  EXPECT_GT(total.onRim, 3000u);        // measured: 5862
  EXPECT_EQ(total.means, 0u);           // measured: 0; 1 of 16.5 million in a million chains
}

TEST(CappedSurface, KeepsToleranceOnRandomLatticeChainsAndTheirCaps)
{
  SCOPED_TRACE("seeds 1 … 150");
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
  {
    ChainComparison total;
    for (unsigned seed = 1; seed <= 150; ++seed)
    {
      const ChainComparison found =
        compareWithDirectSum(randomLatticeChain(seed, 40, 4), tolerance);
      EXPECT_EQ(found.failure, "") << "seed " << seed;
      total.onSurface += found.onSurface;
      total.largestError = std::max(total.largestError, found.largestError);
    }
    record("largestError", total.largestError / tolerance);
    EXPECT_LT(total.largestError, tolerance); // measured: 1.7e-7 at 1e-6 and at 1e-3
    EXPECT_GT(total.onSurface, 5000u);        // measured: 5490
  }
}

TEST(CappedSurface, EqualsTheDirectSumWhereAMillionRandomChainsFailed)
{
  // In some of these chains two equal triangles of the cap make half a turn, and the sample lies in
  // the plane of a third. In others a sample on the surface and on the cap lies in a plane of the
  // other cap by accident.
  for (const unsigned seed : {296587u, 322077u, 398403u, 872884u, 989924u})
  {
    const ChainComparison found = compareWithDirectSum(randomLatticeChain(seed, 12, 4));
    EXPECT_EQ(found.failure, "") << "seed " << seed;
  }
}

TEST(CappedSurface, EqualsTheDirectSumOnDamagedShapes)
{
  SCOPED_TRACE("seed 141");
  double largest = 0;
  for (const Mesh& mesh : {icosphere(2), torus(24, 12), surfaceOf(randomCells(4, 141))})
  {
    for (const double probability : {0.01, 0.1, 0.3})
    {
      const Mesh broken = damaged(mesh, probability, 141);
      largest = std::max(largest, largestError(broken, gridAround(broken, 12)));
    }
  }
  for (const Mesh& mesh : {moebiusStrip(40), triangleSoup(60, 142), icosphere(3).part(0, 700)})
  {
    largest = std::max(largest, largestError(mesh, gridAround(mesh, 14)));
  }
  record("largestError", largest);
  EXPECT_LT(largest, 1e-12); // measured: 1.2e-14
}

TEST(CappedSurface, EqualsTheDirectSumAtSamplesOnTheCap)
{
  // The cap is the missing face at z = 1, in a plane of the grid or a tiny distance from one.
  const winding::Surface surface = clean(openCube());
  double largest = 0;
  for (const double beside :
    {0.0, 1e-17, -1e-16, 1e-15, -1e-14, 1e-12, -1e-10, 1e-8, -1e-7, 1e-6, -1e-5, 1e-4, -1e-3})
  {
    const Grid grid = gridOf({-0.25, -0.25, beside}, {0.125, 0.125, 0.125}, {13, 13, 13});
    const std::vector<double> values = valuesOn(openCube(), grid);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const Eigen::Vector3i index = winding::sampleIndex(grid.wholeExtent(), n);
      const bool isAcross = index[0] > 2 && index[0] < 10 && index[1] > 2 && index[1] < 10;
      if (index[2] == 8 && isAcross)
      {
        const Point q = grid.sample(index);
        const auto expected = static_cast<double>(winding::referenceSum<long double>(surface, q));
        largest = std::max(largest, std::abs(values[n] - expected));
      }
      ASSERT_TRUE(std::isfinite(values[n]) && std::abs(values[n]) <= 1.000001);
    }
  }
  record("largestError", largest);
  EXPECT_LT(largest, 1e-10); // measured: 3.9e-11
}

TEST(CappedSurface, EqualsTheDirectSumOnTheRim)
{
  // Samples on the rim lie on every cap. The surface has more triangles than both of its caps.
  const winding::Surface surface = clean(openCube());
  const winding::TriangleSum sum(surface);
  const Grid grid = gridOf({-0.25, -0.25, -0.25}, {0.125, 0.125, 0.125}, {13, 13, 13});
  const std::vector<double> values = valuesOn(openCube(), grid);
  std::size_t samples = 0;
  for (int i = 2; i <= 10; ++i)
  {
    for (int j = 2; j <= 10; ++j)
    {
      if (i == 2 || i == 10 || j == 2 || j == 10)
      {
        const Eigen::Vector3i index(i, j, 10);
        const std::vector<double> expected = valuesOf(sum, {grid.sample(index)});
        EXPECT_GT(expected[0], 0.1) << index.transpose(); // 0.25, and 0.125 at corners
        EXPECT_NEAR(values[winding::sampleNumber(grid.wholeExtent(), index)], expected[0], 1e-15)
          << index.transpose();
        ++samples;
      }
    }
  }
  EXPECT_EQ(samples, 32u);
}

TEST(CappedSurface, EqualsTheDirectSumBesideCapsOfAnyDirection)
{
  // The cube is turned and moved, so that samples lie on its cap up to rounding, on either side of
  // it.
  SCOPED_TRACE("seed 143");
  Random random(143);
  double largest = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(random(0, 6), random.direction()).toRotationMatrix();
    const Point away = random.point(-1, 1) * (i % 3 == 0 ? 1e3 : 1);
    const Mesh mesh = openCube().mapped([&](const Point& p) -> Point { return turn * p + away; });
    const winding::Surface surface = clean(mesh);
    const CappedSurface capped(surface, boundaryOf(surface), 0, serial);
    // The middle sample of the grid is a point of the missing face.
    const Point on = turn * Point{random(0.1, 0.9), random(0.1, 0.9), 1} + away;
    const Grid grid = gridOf(on - Point::Constant(0.0625), Point::Constant(0.0625), {3, 3, 3});
    const std::vector<double> values = valuesOn(capped, grid, grid.wholeExtent());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const Point q = grid.sample(n);
      const auto expected = static_cast<double>(winding::referenceSum<long double>(surface, q));
      largest = std::max(largest, std::abs(values[n] - expected));
    }
  }
  record("largestError", largest);
  EXPECT_LT(largest, 1e-9); // measured: 8e-15
}

TEST(CappedSurface, KeepsToleranceAtScatteredSamplesByAFarFieldOfTheCap)
{
  Mesh mesh = damaged(icosphere(4), 0.1, 11);
  const winding::Surface surface = clean(mesh);
  const winding::BoundaryChain chain = boundaryOf(surface);
  std::vector<Point> samples = randomPoints(3000, -1.5, 1.5, 12);
  samples.emplace_back(1e5, 0, 1);
  samples.emplace_back(std::nan(""), 0, 0);
  samples.emplace_back(0, std::numeric_limits<double>::infinity(), 0);
  const std::vector<double> exact = valuesAt({surface, chain, 0, serial}, samples);
  for (const double tolerance : {1e-2, 1e-3, 1e-5})
  {
    const CappedSurface capped(surface, chain, tolerance, serial, CappedSurface::CapSum::farField);
    ASSERT_TRUE(capped.usesFarFieldAtPoints(samples.size()));
    const std::vector<double> values = valuesAt(capped, samples);
    for (std::size_t n = 0; n + 2 < samples.size(); ++n)
    {
      ASSERT_NEAR(values[n], exact[n], tolerance) << n;
    }
    EXPECT_TRUE(std::isnan(values[samples.size() - 1]));
    EXPECT_TRUE(std::isnan(values[samples.size() - 2]));
  }
  EXPECT_TRUE(std::isnan(exact[samples.size() - 1]));
  EXPECT_TRUE(std::isnan(exact[samples.size() - 2]));
}

TEST(CappedSurface, KeepsToleranceInThePlaneOfALargeHole)
{
  // A slice through the plane in which a bowl was cut lies on its cap, and another cap has a far
  // field, too.
  constexpr double tolerance = 1e-3;
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= 20; ++i)
  {
    const double angle = 1.5707963267948966 * i / 20;
    profile.push_back({i == 0 ? 0 : std::sin(angle), i == 20 ? 0 : -std::cos(angle)});
  }
  const winding::Surface surface = clean(lathe(profile, 500));
  ShuffledThreads threads(7);
  const CappedSurface capped(
    surface, boundaryOf(surface), tolerance, serial, CappedSurface::CapSum::farField);
  const Grid grid = gridOf({-1.21, -1.17, -0.5}, {0.05, 0.05, 0.125}, {47, 50, 9});
  ASSERT_EQ(grid.sample(0, 0, 4)[2], 0);
  ASSERT_TRUE(capped.usesFarField(grid));
  const std::vector<double> values = valuesOn(capped, grid, grid.wholeExtent());
  const Extent layer = {0, 46, 0, 49, 4, 4}, piece = {9, 40, 17, 33, 3, 5};
  const std::vector<double> ofLayer = valuesOn(capped, grid, layer);
  const std::vector<double> ofPiece = valuesOn(capped, grid, piece);
  std::vector<Point> samples;
  for (std::size_t n = 0; n < ofLayer.size(); ++n)
  {
    const Point q = grid.sample(layer, n);
    const std::size_t inGrid = 4 * ofLayer.size() + n;
    EXPECT_EQ(ofLayer[n], values[inGrid]);
    EXPECT_NEAR(values[inGrid], winding::referenceSum<double>(surface, q), tolerance)
      << q.transpose();
    samples.push_back(q);
  }
  for (std::size_t n = 0; n < ofPiece.size(); ++n)
  {
    const int i = static_cast<int>(n % 32), j = static_cast<int>(n / 32 % 17),
              k = static_cast<int>(n / 32 / 17);
    EXPECT_EQ(ofPiece[n], values[winding::sampleNumber(grid.wholeExtent(), i + 9, j + 17, k + 3)]);
  }
  ASSERT_TRUE(capped.usesFarFieldAtPoints(samples.size()));
  const std::vector<double> scattered = valuesAt(capped, samples);
  std::vector<double> again(samples.size());
  FieldOutput output;
  output.doubleValues = again.data();
  capped.evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, threads);
  EXPECT_EQ(again, scattered);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    EXPECT_NEAR(scattered[n], winding::referenceSum<double>(surface, samples[n]), tolerance)
      << samples[n].transpose();
  }
}

TEST(CappedSurface, AtASampleAloneHasTheBitsThatItHasAmongOthers)
{
  const Mesh mesh = damaged(icosphere(2), 0.2, 13);
  const winding::Surface surface = clean(mesh);
  const CappedSurface capped(surface, boundaryOf(surface), 0, serial);
  std::vector<Point> samples = randomPoints(300, -1.2, 1.2, 14);
  samples.insert(samples.end(), surface.vertices.begin(), surface.vertices.end());
  const std::vector<double> together = valuesAt(capped, samples);
  for (std::size_t n = 0; n < samples.size(); n += 7)
  {
    ASSERT_EQ(valuesAt(capped, {samples[n]})[0], together[n]) << n;
  }
}

TEST(CappedSurface, IsAnIntegerEverywhereIfClosed)
{
  for (const Mesh& mesh : {cube(), icosphere(2), torus(12, 8), icosphere(1).with(icosphere(1))})
  {
    const winding::Surface surface = clean(mesh);
    const CappedSurface capped(surface, boundaryOf(surface), 0, serial);
    EXPECT_EQ(capped.capTriangles(), 0u);
    const Grid grid = gridAround(mesh, 16);
    for (const double value : valuesOn(capped, grid, grid.wholeExtent()))
    {
      ASSERT_EQ(value, std::round(value));
    }
  }
}

TEST(CappedSurface, KeepsToleranceOnGridsHoweverFarTheyReach)
{
  SCOPED_TRACE("seed 146");
  const winding::Surface surface = clean(damaged(icosphere(3), 0.3, 146));
  const CappedSurface capped(
    surface, boundaryOf(surface), 1e-3, serial, CappedSurface::CapSum::farField);
  for (const double far : {1e2, 1e6, 1e10, 1e14, 1e20, 1e40, 1e80})
  {
    for (const Grid& grid :
      {gridOf(Point::Constant(-far), Point::Constant(0.2 * far), {11, 11, 11}),
        gridOf({-1, -1, -1}, {0.3, 0.5, 0.3 * far}, {7, 6, 4}),
        gridOf({far, 0, 0}, {1, 1, 1}, {5, 5, 5})})
    {
      const std::vector<double> values = valuesOn(capped, grid, grid.wholeExtent());
      for (std::size_t n = 0; n < values.size(); ++n)
      {
        const double expected = winding::referenceSum<double>(surface, grid.sample(n));
        EXPECT_NEAR(values[n], expected, 1e-3) << far << " " << n;
      }
    }
  }
}

TEST(CappedSurface, IsZeroIfEmpty)
{
  const Grid grid = gridOf({-1, -1, -1}, {1, 1, 1}, {3, 4, 5});
  EXPECT_EQ(valuesOn(Mesh(), grid), std::vector<double>(60, 0.0));
}

TEST(CappedSurface, ClassifiesWithoutTheValuesAsWithThem)
{
  SCOPED_TRACE("seed 144");
  for (const Mesh& mesh : {icosphere(2), damaged(icosphere(2), 0.1, 144), openCube().reversed()})
  {
    const winding::Surface surface = clean(mesh);
    const CappedSurface capped(surface, boundaryOf(surface), 0, serial);
    const Grid grid = gridAround(mesh, 12);
    const std::size_t count = winding::sampleCount(grid.wholeExtent());
    std::vector<float> values(count);
    std::vector<unsigned char> only(count, 99);
    for (const auto rule : {winding::InsideRule::signedThreshold,
           winding::InsideRule::absoluteThreshold, winding::InsideRule::odd})
    {
      FieldOutput output;
      output.values = values.data();
      capped.evaluate(grid, grid.wholeExtent(), output, serial);
      output.values = nullptr;
      output.inside = only.data();
      output.isInside.rule = rule;
      capped.evaluate(grid, grid.wholeExtent(), output, serial);
      for (std::size_t n = 0; n < count; ++n)
      {
        ASSERT_EQ(only[n], output.isInside(values[n]));
      }
    }
  }
}

TEST(CappedSurface, HasTheSameBitsInAnyPiecesAndOnAnyThreads)
{
  SCOPED_TRACE("seed 145");
  const Mesh mesh = damaged(torus(24, 12), 0.1, 145).with(openCube());
  const winding::Surface surface = clean(mesh);
  const CappedSurface capped(surface, boundaryOf(surface), 0, serial);
  const Grid grid = gridOf({-1.5, -1.5, -0.5}, {0.125, 0.125, 0.125}, {26, 25, 14});
  const Extent whole = grid.wholeExtent();
  const std::vector<double> expected = valuesOn(capped, grid, whole);

  std::vector<double> threaded(expected.size());
  FieldOutput output;
  output.doubleValues = threaded.data();
  ShuffledThreads threads(145);
  capped.evaluate(grid, whole, output, threads);
  EXPECT_EQ(threaded, expected);

  for (const Extent& part : {Extent{0, 25, 0, 24, 3, 3}, {5, 5, 0, 24, 0, 13}, {1, 19, 7, 21, 2, 9},
         {25, 25, 24, 24, 13, 13}, {0, 25, 12, 12, 0, 13}})
  {
    const std::vector<double> values = valuesOn(capped, grid, part);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      ASSERT_EQ(values[n], expected[winding::sampleNumber(whole, winding::sampleIndex(part, n))]);
    }
  }
}

TEST(CappedSurface, DoesNotDependOnTheUnitOfLengthOrTheDistanceFromTheOrigin)
{
  SCOPED_TRACE("seed 146");
  const Mesh mesh = damaged(icosphere(2), 0.1, 146);
  for (const double scale : {1e-30, 1e-6, 1e6, 1e30})
  {
    const Mesh scaled = mesh.scaled(scale);
    EXPECT_LT(largestError(scaled, gridAround(scaled, 12)), 1e-12) << scale;
  }
  // The meshes lie about a million diagonals away, and the last grid has samples on the open cube's
  // cap.
  const Point away(3e6, -2e6, 1e6);
  for (const Mesh& source : {mesh, openCube()})
  {
    const Mesh moved = source.moved(away);
    EXPECT_LT(largestError(moved, gridAround(moved, 12)), 1e-9);
    const Grid grid = gridOf(away - Point::Constant(0.25), Point::Constant(0.125), {13, 13, 13});
    EXPECT_LT(largestError(moved, grid), 1e-9);
  }
}

/// A fan leaves the bounds of a wafer, and so do samples next to its hole.
TEST(CappedSurface, EqualsTheDirectSumNextToTheHolesOfAWafer)
{
  for (std::size_t missing = 0; missing < 12; ++missing)
  {
    shapes::Mesh wafer = shapes::cube().mapped(
      [](const shapes::Point& p) { return shapes::Point(p[0], 1e-9 * p[1], p[2]); });
    wafer.triangles.erase(wafer.triangles.begin() + static_cast<std::ptrdiff_t>(missing));
    std::vector<shapes::Point> samples = shapes::randomPoints(60, 0.05, 0.95, 871);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      samples[i][1] = i % 3 == 0 ? 4e-9 : i % 3 == 1 ? -3e-9 : 1e-7;
    }
    const auto field = fieldOf(wafer, winding::Method::rows);
    std::vector<double> found(samples.size());
    winding::FieldOutput output;
    output.doubleValues = found.data();
    field->evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, serial);
    const winding::Surface surface = shapes::clean(wafer);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      EXPECT_NEAR(found[i], winding::referenceSum<double>(surface, samples[i]), 1e-6)
        << missing << ' ' << samples[i].transpose();
    }
  }
}
