// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/Field.h"

#include "source/MeshVertices.h"
#include "support/Fields.h"
#include "support/HostileSoups.h"
#include "support/LatticeChain.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shuffled.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace
{

using namespace shapes;
using winding::FieldOptions;
using winding::Grid;
using winding::Method;

/// All numbers that a field gives on a grid and at scattered samples.
struct Numbers
{
  std::vector<double> values, distances, gradients;
  std::vector<unsigned char> inside;

  Numbers() = default;
  Numbers(const winding::Field& field, const Grid& grid, const std::vector<Point>& samples,
    winding::Executor& executor)
  {
    const std::size_t onGrid = winding::sampleCount(grid.wholeExtent()),
                      count = onGrid + samples.size();
    values.resize(count);
    distances.resize(count);
    inside.resize(count);
    gradients.resize(3 * samples.size());
    winding::FieldOutput output;
    output.doubleValues = values.data();
    output.doubleDistances = distances.data();
    output.inside = inside.data();
    field.evaluate(grid, grid.wholeExtent(), output, executor);
    output.doubleValues += onGrid;
    output.doubleDistances += onGrid;
    output.inside += onGrid;
    const winding::VectorsView view(samples[0].data(), samples.size());
    field.evaluate(view, output, executor);
    field.gradient(view, gradients.data(), executor);
  }
};

std::size_t differences(const std::vector<double>& a, const std::vector<double>& b)
{
  std::size_t count = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; count == 0 && i < a.size(); ++i)
  {
    // Zeros of both signs differ, and NaN is NaN. NOLINTNEXTLINE(bugprone-suspicious-memory-*)
    count += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
  }
  return count;
}

void expectSameBits(const Numbers& found, const Numbers& expected)
{
  EXPECT_EQ(differences(found.values, expected.values), 0u) << "values";
  EXPECT_EQ(found.inside, expected.inside);
  EXPECT_EQ(differences(found.distances, expected.distances), 0u) << "distances";
  EXPECT_EQ(differences(found.gradients, expected.gradients), 0u) << "gradients";
}

Grid gridOver(const winding::Bounds& bounds, int samples)
{
  const double longest = bounds.sizes().maxCoeff();
  const double spacing = (longest > 0 ? longest : 1) / (samples - 3);
  Grid grid;
  grid.spacing.setConstant(spacing);
  grid.firstSample = bounds.min() - Point::Constant(1.3 * spacing);
  grid.dimensions = Eigen::Vector3i::Constant(samples);
  return grid;
}

/// Compares the fields of a mesh by all methods with the fields of the same triangles written in
/// other ways.
void checkMesh(const Mesh& mesh, const Grid& grid, unsigned seed)
{
  Random random(seed);
  const auto below = [&random](std::size_t count)
  {
    return static_cast<std::size_t>(random.bits() % count);
  };
  const winding::Bounds bounds = boundsOf(mesh.points);
  std::vector<Point> samples;
  for (int i = 0; i < 40; ++i)
  {
    const Point t = random.point(-0.3, 1.3);
    samples.push_back(bounds.min() + t.cwiseProduct(bounds.sizes()));
  }
  for (const Method method :
    {Method::automatic, Method::rows, Method::hierarchical, Method::direct, Method::parity})
  {
    for (const double tolerance : {1e-3, 1e-6})
    {
      SCOPED_TRACE(std::string(nameOf(method)) + ", tolerance " + std::to_string(tolerance));
      FieldOptions options;
      options.method = method;
      options.tolerance = tolerance;
      const Numbers expected(*fieldOf(mesh, options), grid, samples, serial);
      ShuffledThreads threads(seed);
      const Mesh other = shuffled(mesh, below);
      expectSameBits(Numbers(*winding::Field::build(
                               std::vector<winding::TrianglesView>{other.view()}, options, threads),
                       grid, samples, threads),
        expected);
      // Two blocks, one of them without shared points, and unused points.
      const std::size_t cut = below(mesh.triangles.size() + 1);
      const Mesh first = other.part(0, cut);
      const Mesh second = withoutSharedPoints(other.part(cut, other.triangles.size()));
      expectSameBits(Numbers(*winding::Field::build(
                               std::vector<winding::TrianglesView>{second.view(), first.view()},
                               options, serial),
                       grid, samples, serial),
        expected);
    }
  }
}

Mesh meshOf(const LatticeChain& chain)
{
  Mesh mesh;
  mesh.points = chain.surface.vertices;
  mesh.triangles.assign(chain.surface.triangles.begin(), chain.surface.triangles.end());
  return mesh;
}

/// A sphere without a part, so that its rim has sides of many lengths.
Mesh openSphere(int levels)
{
  const Mesh whole = icosphere(levels);
  Mesh open = whole;
  open.triangles.clear();
  for (const auto& triangle : whole.triangles)
  {
    Point center = Point::Zero();
    for (const std::int32_t id : triangle)
    {
      center += whole.points[static_cast<std::size_t>(id)] / 3;
    }
    if (center[2] < 0.7 && center[0] + 0.3 * center[1] < 0.8)
    {
      open.triangles.push_back(triangle);
    }
  }
  return open;
}

} // namespace

TEST(ShuffledSources, ChainsOnALatticeHaveTheSameBits)
{
  for (unsigned seed = 2100; seed < 2180; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const LatticeChain chain = randomLatticeChain(seed, 30, 4);
    if (!chain.surface.triangles.empty())
    {
      checkMesh(meshOf(chain), chain.grid, seed);
    }
  }
}

TEST(ShuffledSources, MeshesHaveTheSameBits)
{
  SCOPED_TRACE("seeds 2181 … 2186");
  const Mesh sphere = openSphere(4), soup = triangleSoup(700, 2181);
  checkMesh(sphere, gridOver(boundsOf(sphere.points), 14), 2182);
  checkMesh(icosphere(3), gridOver(boundsOf(sphere.points), 14), 2183);
  checkMesh(soup, gridOver(boundsOf(soup.points), 12), 2184);
  const Mesh copies =
    copiesOf(latticeSoup(60, 3, 2185), 3).with(latticeSoup(100, 3, 2186).reversed());
  checkMesh(copies, gridOver(boundsOf(copies.points), 10), 2186);
}

TEST(ShuffledSources, MeshesWithOutliersHaveTheSameBits)
{
  Mesh mesh = openSphere(4);
  const auto first = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{90, 80, 70}, {91, 80, 70}, {90, 81, 70}});
  mesh.triangles.push_back({first, first + 1, first + 2});
  Grid grid = gridOver({Point(-1, -1, -1), Point(1, 1, 1)}, 12);
  checkMesh(mesh, grid, 2187);
}

TEST(ShuffledSources, CloudsHaveTheSameBits)
{
  for (unsigned seed = 2190; seed < 2230; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto below = [&random](std::size_t count)
    {
      return static_cast<std::size_t>(random.bits() % count);
    };
    Cloud cloud = seed % 2 ? sphereCloud(300 + below(1500)) : randomCloud(200 + below(400), seed);
    const std::size_t points = cloud.positions.size();
    for (std::size_t i = 0; i < points / 4 && seed % 3 == 0; ++i)
    {
      // Points at one place have equal, similar, and other normals.
      const std::size_t point = below(points);
      cloud.positions.push_back(cloud.positions[point]);
      const Point aside = 0.3 * static_cast<double>(below(4)) * random.direction();
      cloud.normals.push_back((cloud.normals[point] + aside).normalized());
    }
    std::vector<double> areas;
    for (std::size_t i = 0; i < cloud.positions.size() && seed % 5 == 0; ++i)
    {
      areas.push_back(random(0, 0.01));
    }
    const std::vector<std::size_t> order = shuffledNumbers(cloud.positions.size(), below);
    Cloud other;
    other.positions = inOrder(cloud.positions, order);
    other.normals = inOrder(cloud.normals, order);
    const std::vector<double> otherAreas = areas.empty() ? areas : inOrder(areas, order);

    FieldOptions options;
    const Method methods[] = {Method::automatic, Method::hierarchical, Method::direct};
    options.method = methods[seed % 3];
    options.tolerance = seed % 7 == 0 ? 1e-5 : 1e-3;
    options.regularization = seed % 4 == 1 ? 1.5 : 0;
    options.estimateNormals = seed % 6 == 3;
    options.pointAreaMethod =
      seed % 8 == 0 ? winding::PointAreaMethod::constant : winding::PointAreaMethod::voronoi;
    if (options.estimateNormals)
    {
      cloud.normals.clear();
      other.normals.clear();
    }
    const Grid grid = gridOver(boundsOf(cloud.positions), 12);
    const std::vector<Point> samples = randomPoints(40, -1.4, 1.4, seed);
    const auto viewOf = [](const Cloud& of, const std::vector<double>& withAreas)
    {
      winding::OrientedPointsView view = of.view();
      view.areas = {withAreas.data(), withAreas.size()};
      return view;
    };
    ShuffledThreads threads(seed);
    const Numbers expected(
      *winding::Field::build({viewOf(cloud, areas)}, options, serial), grid, samples, serial);
    expectSameBits(Numbers(*winding::Field::build({viewOf(other, otherAreas)}, options, threads),
                     grid, samples, threads),
      expected);
  }
}

TEST(ShuffledSources, VerticesOfMeshesHaveTheSameNormalsAndAreas)
{
  SCOPED_TRACE("seed 2240");
  Random random(2240);
  const auto below = [&random](std::size_t count)
  {
    return static_cast<std::size_t>(random.bits() % count);
  };
  const Mesh mesh = openSphere(4);
  Mesh other = mesh; // the points keep their numbers
  other.triangles = inOrder(mesh.triangles, shuffledNumbers(mesh.triangles.size(), below));
  for (auto& triangle : other.triangles)
  {
    std::rotate(
      triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(below(3)), triangle.end());
  }
  const winding::MeshVertices expected =
    winding::meshVertices({mesh.view()}, mesh.points.size(), serial);
  const winding::MeshVertices found =
    winding::meshVertices({other.view()}, mesh.points.size(), serial);
  ASSERT_EQ(found.areas().size(), mesh.points.size());
  for (std::size_t point = 0; point < mesh.points.size(); ++point)
  {
    EXPECT_EQ(found.normals()[point], expected.normals()[point]) << point;
    EXPECT_EQ(found.areas()[point], expected.areas()[point]) << point;
  }
}
