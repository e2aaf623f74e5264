// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Bounds.h"
#include "base/Pi.h"
#include "support/FarFields.h"
#include "support/Serial.h"

#include <sstream>

/**
 * @file
 * Errors of far fields against the direct sum, in units of the tolerance: the largest of all
 * samples that are compared here under a name. "sphere" is a mesh and a cloud, "soup" triangles
 * whole and in pieces; numbers after "mesh" and "cloud" are the spacing of voxels. Measured with
 * AVX-512.
 *
 *                          1e-2   1e-3   1e-4   1e-5   1e-6
 *   sphere                 0.20   0.30   0.21   0.19   0.24
 *   part                   0.13   0.15   0.07   0.10   0.12
 *   torus                  0.24   0.11   0.17   0.08   0.04
 *   cells                  0.33   0.11   0.08   0.07   0.02
 *   cube                   0.52   0.09   0.05   0.04   0.03
 *   soup                   0.10   0.02   0.06   0.02   0.05
 *   random                 0.14   0.09   0.10   0.15   0.08
 *   graded                 0.12   0.12   0.19   0.11   0.10
 *   heap                   0.11   0.52   0.12   0.05   0.23
 *   ball                   0.07   0.07   0.12   0.04   0.02
 *   sphere scattered       0.36   0.25   0.42   0.68   0.44
 *   part scattered         0.20   0.11   0.12   0.21   0.07
 *   torus scattered        0.23   0.12   0.14   0.15   0.08
 *   soup scattered         0.08   0.04   0.05   0.03   0.05
 *   random scattered       0.20   0.15   0.16   0.20   0.09
 *   graded scattered       0.17   0.14   0.09   0.06   0.06
 *   heap scattered         0.12   0.05   0.07   0.13   0.13
 *   ball scattered         0.09   0.06   0.05   0.04   0.04
 *   cloud 1 1 4            0.15   0.12   0.16   0.08   0.05
 *   cloud 1 4 16           0.10   0.18   0.04   0.08   0.02
 *   cloud 1 100 1          0.21   0.23   0.30   0.17   0.07
 *   cloud 64 1 1           0.27   0.25   0.26   0.10   0.04
 *   cloud 1000 1 0.01      0.11   0.27   0.67   0.60   0.18
 *   slice                  0.21   0.14   0.25   0.23   0.09
 *   row                    0.12   0.07   0.05   0.06   0.00
 *   sample                 0.13   0.25   0.23   0.30   0.06
 *   mesh 0.001             0.06   0.08   0.03   0.05   0.12
 *   cloud 0.001            0.48   0.05   0.07   0.06   0.00
 *   far mesh               0.11   0.07   0.07   0.04   0.05
 *   far cloud              0.21   0.25   0.22   0.09   0.07
 *   far cloud scattered    0.27   0.60   0.65   0.41   0.28
 *   cap                    0.18   0.47   0.78   0.62   0.35
 */

namespace
{

using namespace shapes;
using winding::FarField;
using winding::FarFieldAccuracy;
using winding::Grid;

struct Case
{
  std::string name;
  std::unique_ptr<FarSource> source;
  Grid grid;
  bool isInPieces = false; ///< triangles larger than eight voxels are cut

  Case(std::string title, std::unique_ptr<FarSource> from, const Eigen::Vector3i& dimensions)
    : name(std::move(title))
    , source(std::move(from))
    , grid(shapes::gridAround(source->bounds(), dimensions, 0.1))
  {
  }

  Case(std::string title, std::unique_ptr<FarSource> from, const Grid& samples)
    : name(std::move(title))
    , source(std::move(from))
    , grid(samples)
  {
  }

  FarField field(double tolerance) const
  {
    return {source->sources(shapes::boundsOf(grid), isInPieces ? grid.spacing.maxCoeff() : 0),
      FarFieldAccuracy::of(tolerance), serial};
  }
};

constexpr double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

void recordError(const Case& one, const std::string& where, double tolerance, double error)
{
  std::ostringstream name;
  name << one.name << where << " " << tolerance;
  record(name.str(), error);
  EXPECT_LT(error, 1) << tolerance;
}

/// Expects errors of less than the tolerance at random samples and at samples next to sources.
void compareOnGrids(const std::vector<Case>& cases, unsigned seed, std::size_t samples = 200)
{
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name + ", seed " + std::to_string(seed));
    const std::vector<Eigen::Vector3i> at = comparedSamples(*one.source, one.grid, samples, seed);
    std::vector<Point> positions;
    for (const Eigen::Vector3i& index : at)
    {
      positions.push_back(one.grid.sample(index));
    }
    for (const double tolerance : tolerances)
    {
      const std::vector<float> all = valuesOn(one.field(tolerance), one.grid);
      std::vector<float> values;
      for (const Eigen::Vector3i& index : at)
      {
        values.push_back(all[winding::sampleNumber(one.grid.wholeExtent(), index)]);
      }
      recordError(one, "", tolerance, largestError(*one.source, positions, values) / tolerance);
    }
  }
}

/// Expects errors of less than the tolerance at scattered samples: anywhere, and at several
/// distances from places on the sources.
void compareScattered(const std::vector<Case>& cases, unsigned seed)
{
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name + ", seed " + std::to_string(seed));
    Random random(seed);
    const winding::Bounds& bounds = one.source->bounds();
    const double size = bounds.sizes().maxCoeff();
    std::vector<Point> samples;
    for (int i = 0; i < 500; ++i)
    {
      samples.emplace_back(bounds.center() + 0.7 * size * random.point(-1, 1));
    }
    for (const Point& place : one.source->places(200, seed))
    {
      samples.emplace_back(place + size * std::exp2(random(-10, -3)) * random.direction());
    }
    for (const double tolerance : tolerances)
    {
      recordError(one, " scattered", tolerance,
        largestError(*one.source, samples, valuesAt(one.field(tolerance), samples)) / tolerance);
    }
  }
}

const Eigen::Vector3i usual(44, 29, 36);

std::vector<Case> meshes()
{
  std::vector<Case> cases;
  cases.emplace_back("sphere", farSource(icosphere(4)), usual);
  cases.emplace_back("part", farSource(icosphere(3).part(0, 800)), usual);
  cases.emplace_back("torus", farSource(torus(40, 20)), usual);
  cases.emplace_back("soup", farSource(triangleSoup(250, 301)), Eigen::Vector3i(30, 31, 32));
  return cases;
}

std::vector<Case> clouds()
{
  std::vector<Case> cases;
  cases.emplace_back("sphere", farSource(sphereCloud(5000)), usual);
  cases.emplace_back("random", farSource(randomCloud(5000, 305)), usual);
  cases.emplace_back("graded", gradedSource(5000, 306), usual);
  cases.emplace_back("heap", farSource(sphereWithHeap(25000)), usual);
  cases.emplace_back("ball", farSource(sphereWithBall(25000, 307)), usual);
  return cases;
}

} // namespace

TEST(FarField, EqualsTheDirectSumOfMeshes)
{
  compareOnGrids(meshes(), 301);
}

TEST(FarField, EqualsTheDirectSumOfMeshesAtScatteredSamples)
{
  compareScattered(meshes(), 302);
}

TEST(FarField, EqualsTheDirectSumOfLargeTrianglesInPieces)
{
  std::vector<Case> cases;
  cases.emplace_back("cells", farSource(surfaceOf(randomCells(3, 303))), usual);
  cases.emplace_back("soup", farSource(triangleSoup(100, 304)), usual);
  cases.emplace_back("cube", farSource(openCube()), usual);
  for (Case& one : cases)
  {
    one.isInPieces = true;
  }
  compareOnGrids(cases, 303);
}

TEST(FarField, EqualsTheDirectSumOfClouds)
{
  compareOnGrids(clouds(), 305);
}

TEST(FarField, EqualsTheDirectSumOfCloudsAtScatteredSamples)
{
  compareScattered(clouds(), 308);
}

TEST(FarField, EqualsTheDirectSumOnVoxelsOfAnyShape)
{
  std::vector<Case> cases;
  for (const Point& shape :
    {Point(1, 1, 4), Point(1, 4, 16), Point(1, 100, 1), Point(64, 1, 1), Point(1000, 1, 0.01)})
  {
    std::ostringstream name;
    name << "mesh " << shape.transpose();
    const Point spacing = 0.05 * shape;
    const Grid grid = gridOf(-12 * spacing + Point(0.01, 0.02, 0.03), spacing, {25, 25, 25});
    cases.emplace_back(name.str(), farSource(icosphere(3)), grid);
    cases.emplace_back("cloud" + name.str().substr(4), farSource(sphereCloud(2000)), grid);
  }
  // There may be one sample along one, two or three axes, whatever the spacing there.
  for (const double spacing : {1e-6, 0.05, 1e6})
  {
    cases.emplace_back("slice", farSource(sphereCloud(2000)),
      gridOf({-1.2, -1.2, 0.2}, {0.05, 0.05, spacing}, {48, 48, 1}));
    cases.emplace_back("row", farSource(icosphere(3)),
      gridOf({-1.2, 0.1, 0.2}, {0.01, spacing, spacing}, {240, 1, 1}));
    cases.emplace_back("sample", farSource(icosphere(3)),
      gridOf({0.1, 0.1, 0.2}, Point::Constant(spacing), {1, 1, 1}));
  }
  compareOnGrids(cases, 309, 100);
}

TEST(FarField, EqualsTheDirectSumOnGridsMuchFinerThanTheSource)
{
  // The grids lie across the surface: of about the size of its triangles, of a tenth of that, and
  // much smaller.
  std::vector<Case> cases;
  for (const double spacing : {1e-2, 1e-3, 1e-6})
  {
    std::ostringstream name;
    name << "mesh " << spacing;
    const Grid grid = gridOf(
      Point(0.6, 0, 0.8) - 10 * Point::Constant(spacing), Point::Constant(spacing), {21, 20, 19});
    cases.emplace_back(name.str(), farSource(icosphere(4)), grid);
    cases.emplace_back("cloud" + name.str().substr(4), farSource(sphereCloud(5000)), grid);
  }
  compareOnGrids(cases, 316, 100);
}

TEST(FarField, EqualsTheDirectSumOfSourcesFarApart)
{
  // Two sources, a million diagonals apart, are seen from close to one, and from so far that both
  // are specks.
  const auto away = [](const Point& p) -> Point
  {
    return p + Point(3e6, -2e6, 1e6);
  };
  const Mesh mesh = icosphere(2).part(0, 300), twoMeshes = mesh.with(mesh.mapped(away));
  const Cloud cloud = sphereCloud(500), twoClouds = with(cloud, mapped(cloud, away));
  const Grid beside = gridOf(away({-1.2, -1.2, -1.2}), Point::Constant(0.1), {25, 25, 25});
  std::vector<Case> cases;
  cases.emplace_back("mesh beside", farSource(twoMeshes), beside);
  cases.emplace_back("cloud beside", farSource(twoClouds, 1), beside);
  cases.emplace_back("mesh", farSource(twoMeshes), Eigen::Vector3i(20, 21, 22));
  cases.emplace_back("cloud", farSource(twoClouds, 1), Eigen::Vector3i(20, 21, 22));
  compareOnGrids(cases, 310);
}

TEST(FarField, DoesNotDependOnTheUnitOfLengthOrTheDistanceFromTheOrigin)
{
  std::vector<Case> cases;
  for (const double scale : {1e-30, 1e30})
  {
    const auto scaled = [scale](const Point& p) -> Point
    {
      return scale * p;
    };
    const std::string name = scale < 1 ? "tiny " : "huge ";
    cases.emplace_back(
      name + "mesh", farSource(icosphere(3).part(0, 900).mapped(scaled)), usual / 2);
    cases.emplace_back(
      name + "cloud", farSource(mapped(sphereCloud(2000), scaled), scale), usual / 2);
  }
  const auto away = [](const Point& p) -> Point
  {
    return p + Point(3e6, -2e6, 1e6);
  };
  cases.emplace_back("far mesh", farSource(icosphere(3).part(0, 900).mapped(away)), usual / 2);
  cases.emplace_back("far cloud", farSource(mapped(sphereCloud(2000), away)), usual / 2);
  compareOnGrids(cases, 311);
  compareScattered(cases, 312);
}

TEST(FarField, EqualsTheDirectSumOfASingleSource)
{
  std::vector<Case> cases;
  const Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}};
  cases.emplace_back("triangle", farSource(triangle), usual / 2);
  // A point has no size of its own; its area may be anything.
  for (const double size : {1e-30, 1e-10, 1.0, 1e10, 1e30})
  {
    const Cloud point{{{3 * size, 4 * size, 5 * size}}, {{0, 0.6, 0.8}}};
    std::ostringstream name;
    name << "point of " << size;
    cases.emplace_back(name.str(), farSource(point, size),
      gridOf(size * Point(-1, 0, 1), Point::Constant(0.25 * size), {30, 31, 32}));
  }
  compareOnGrids(cases, 313);
}

TEST(FarField, EqualsTheDirectSumOfAreasMuchLargerThanTheCloud)
{
  // Two points are almost at the same place, and their areas are those of a sphere of radius 1.
  const Cloud two{{{1, 1, 1}, {1 + 0x1p-50, 1, 1}}, {{0, 0.6, 0.8}, {1, 0, 0}}};
  std::vector<Case> cases;
  cases.emplace_back("two", farSource(two), gridOf({0, 0, 0}, {0.1, 0.1, 0.1}, {19, 20, 21}));
  // The moments of many points with such areas, in units of the cloud, are too large for a float.
  const auto shrunk = [](const Point& p) -> Point
  {
    return 1e-30 * p;
  };
  cases.emplace_back("many", farSource(mapped(randomCloud(3000, 315), shrunk)),
    gridOf({-0.9, -0.95, -1}, {0.1, 0.1, 0.1}, {19, 20, 21}));
  compareOnGrids(cases, 314);
}

TEST(FarField, EqualsTheDirectSumBesideASmallSourceAndALargeCell)
{
  // An open cap has a hundred thousandth of the size of the cloud. One of two samples in line with
  // it is next to it, so that their cell is large, and the cap, just outside of it, is small.
  SCOPED_TRACE("seed 315");
  const Point center(0.3, 0.1, 0.2);
  Cloud cap = sphereCloud(4000);
  cap.positions.resize(2000);
  cap.normals.resize(2000);
  constexpr double radius = 1e-5;
  cap = mapped(cap, [&](const Point& p) -> Point { return center + radius * p; });
  const Cloud sphere = sphereCloud(1000);
  std::vector<double> areas(3000, 4 * winding::pi / 1000);
  std::fill_n(areas.begin(), 2000, 4 * winding::pi * radius * radius / 4000);
  const auto source = farSource(with(cap, sphere), areas);
  Random random(315);
  for (const double tolerance : tolerances)
  {
    const FarField field(source->sources(), FarFieldAccuracy::of(tolerance), serial);
    double largest = 0;
    for (int i = 0; i < 100; ++i)
    {
      const Point direction = random.direction();
      const std::vector<Point> samples = {
        center + random(3, 10) * radius * direction, center + 0.5 * direction};
      largest = std::max(largest, largestError(*source, samples, valuesAt(field, samples)));
    }
    std::ostringstream name;
    name << "cap " << tolerance;
    record(name.str(), largest / tolerance);
    EXPECT_LT(largest / tolerance, 1) << tolerance;
  }
}

TEST(FarField, IsZeroWithoutSources)
{
  const Grid grid = gridOf({-1, -1, -1}, {0.1, 0.1, 0.1}, {19, 20, 21});
  const std::vector<Point> samples = {{0, 0, 0}, {1e200, 0, 0}, {5, 6, 7}};
  for (const auto& source : {farSource(Mesh()), farSource(Cloud())})
  {
    const FarField field(source->sources(), FarFieldAccuracy::of(1e-3), serial);
    EXPECT_EQ(valuesOn(field, grid), std::vector<float>(19 * 20 * 21, 0.0f));
    EXPECT_EQ(valuesAt(field, samples), std::vector<float>(3, 0.0f));
  }
}
