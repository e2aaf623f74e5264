// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Surfaces and clouds that their owner completes: planes of symmetry, a flat base, the side of a
/// sheet, and points that are made one.

#include "base/Refusal.h"
#include "field/Field.h"
#include "source/Sanitize.h"
#include "source/SnappedPoints.h"
#include "support/Fields.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"
#include "surface/PlaneCap.h"
#include "surface/SheetSide.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>

namespace
{

using namespace shapes;
using winding::FieldOptions;
using winding::Surface;

/// The mesh with vertices, triangles and their first corners in a random order.
Mesh shuffled(const Mesh& mesh, Random& random)
{
  const auto orderOf = [&random](std::size_t count)
  {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)
    {
      std::swap(order[i - 1], order[random.bits() % i]);
    }
    return order;
  };
  Mesh result;
  result.points.resize(mesh.points.size());
  const std::vector<std::size_t> places = orderOf(mesh.points.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    result.points[places[i]] = mesh.points[i];
  }
  for (const std::size_t i : orderOf(mesh.triangles.size()))
  {
    const auto& t = mesh.triangles[i];
    auto& moved = result.triangles.emplace_back();
    const std::size_t first = random.bits() % 3;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      moved[corner] = static_cast<std::int32_t>(places[t[(first + corner) % 3]]);
    }
  }
  return result;
}

/// A rotation, a scale and a shift, and what they make of the texts of options.
struct Motion
{
  Eigen::Matrix3d rotation;
  double scale;
  Point shift;

  static Motion random(Random& random)
  {
    const double angle = random(0, 6);
    return {Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix(),
      std::pow(10, random(-3, 3)), random.point(-1, 1)};
  }

  Point operator()(const Point& p) const { return scale * (rotation * p) + shift; }

  std::string direction(const Point& along) const
  {
    std::ostringstream text;
    text.precision(17);
    text << "direction " << (rotation * along).transpose();
    return text.str();
  }

  std::string plane(const Point& normal, double offset) const
  {
    std::ostringstream text;
    text.precision(17);
    text << (rotation * normal).transpose() << " = "
         << scale * offset + (rotation * normal).dot(shift);
    return text.str();
  }
};

/// The triangles of a mesh whose corners are all where a function says.
template <class IsKept> Mesh kept(const Mesh& mesh, const IsKept& isKept)
{
  Mesh result;
  result.points = mesh.points;
  for (const auto& t : mesh.triangles)
  {
    if (isKept(mesh.points[t[0]]) && isKept(mesh.points[t[1]]) && isKept(mesh.points[t[2]]))
    {
      result.triangles.push_back(t);
    }
  }
  return result;
}

/// A box of `n` cells along each side, open at z = 1 and at x = 0.
Mesh quarterBox(int n)
{
  Cells cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    cells.insert({i % n, i / n % n, i / n / n});
  }
  Mesh box = surfaceOf(cells).mapped([n](const Point& p) -> Point { return p / n; });
  Mesh open;
  open.points = box.points;
  for (const auto& t : box.triangles)
  {
    const auto isAt = [&](int axis, double place)
    {
      return box.points[t[0]][axis] == place && box.points[t[1]][axis] == place &&
             box.points[t[2]][axis] == place;
    };
    if (!isAt(2, 1) && !isAt(0, 0))
    {
      open.triangles.push_back(t);
    }
  }
  return open;
}

double volumeOf(const Surface& surface)
{
  double volume = 0;
  for (const winding::Triangle& t : surface.triangles)
  {
    const Point &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                &c = surface.vertices[t[2]];
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

std::size_t netBoundary(const Surface& surface)
{
  return boundaryOf(surface).edges.size();
}

/// Whether every vertex belongs to a triangle, and no two are equal.
bool isClean(const Surface& surface)
{
  const auto isLess = [](const Point& a, const Point& b)
  {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::set<Point, decltype(isLess)> places(
    surface.vertices.begin(), surface.vertices.end(), isLess);
  std::set<std::int32_t> used;
  for (const winding::Triangle& t : surface.triangles)
  {
    used.insert(t.begin(), t.end());
  }
  return places.size() == surface.vertices.size() && used.size() == surface.vertices.size();
}

Surface mirrored(Surface surface, const std::string& planes)
{
  winding::PolygonParts parts;
  winding::Mirror(planes).addTo(surface, parts);
  return surface;
}

} // namespace

TEST(Plane, IsReadFromTexts)
{
  const auto planes = winding::planesIn("y = 0, x=-2.5; 3 4 0 = 10", winding::Parameter::mirror);
  ASSERT_EQ(planes.size(), 3u);
  EXPECT_EQ(planes[0].normal, Point(0, 1, 0));
  EXPECT_EQ(planes[1].offset, -2.5);
  EXPECT_NEAR(planes[2].height({0, 0, 7}), -2, 1e-15);
  EXPECT_EQ(planes[1].projected({0.3, 7, 1}), Point(-2.5, 7, 1));
  EXPECT_TRUE(winding::planesIn("  ", winding::Parameter::mirror).empty());
  for (const char* wrong : {"y", "y=", "=0", "w=1", "y=0 z", "0 0 0 = 1", "1 2 = 3", "y=nan",
         "y=inf", "1e-320 0 0 = 1e300", "y=0=1", "y==0", "1 2 3 4 = 5"})
  {
    EXPECT_THROW(winding::planesIn(wrong, winding::Parameter::mirror), winding::Refusal) << wrong;
  }
}

TEST(Mirror, MakesTheWholeOfAQuarter)
{
  const Surface half = mirrored(clean(quarterBox(3)), "x=0");
  EXPECT_NEAR(volumeOf(mirrored(half, "z=1")), 4, 1e-13);
  const Surface whole = mirrored(clean(quarterBox(3)), "x=0 z=1");
  EXPECT_EQ(netBoundary(whole), 0u);
  EXPECT_TRUE(isClean(whole));
  EXPECT_NEAR(volumeOf(whole), 4, 1e-13);
  EXPECT_EQ(whole.bounds.min(), Point(-1, 0, 0));
  EXPECT_EQ(whole.bounds.max(), Point(1, 1, 2));
  EXPECT_EQ(
    winding::Mirror("x=0 z=1").completed(clean(quarterBox(3)).bounds).max(), whole.bounds.max());
}

TEST(Mirror, LeavesOutLidsInThePlane)
{
  const Surface whole = mirrored(clean(cube()), "z=1");
  EXPECT_EQ(whole.triangles.size(), 20u);
  EXPECT_EQ(netBoundary(whole), 0u);
  EXPECT_TRUE(isClean(whole));
  EXPECT_NEAR(volumeOf(whole), 2, 1e-15);
}

TEST(Mirror, JoinsRimsThatMissThePlaneByRounding)
{
  Random random(31);
  const Mesh ragged = quarterBox(4).mapped(
    [&](const Point& p) -> Point {
      return p[0] == 0 ? Point{random(-4e-7, 4e-7), p[1], p[2]} : p;
    });
  const Surface whole = mirrored(clean(ragged), "x=0; z=1");
  EXPECT_EQ(netBoundary(whole), 0u);
  EXPECT_NEAR(volumeOf(whole), 4, 1e-5); // 2e-6
}

TEST(Mirror, TakesPlanesOfAnyDirection)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
  const Point shift(3, -2, 5), normal = turn * Point(1, 0, 0);
  const Mesh moved =
    quarterBox(3).mapped([&](const Point& p) -> Point { return turn * p + shift; });
  std::ostringstream plane;
  plane.precision(17);
  plane << normal.transpose() << " = " << normal.dot(shift);
  const Surface half = mirrored(clean(moved), plane.str());
  EXPECT_TRUE(isClean(half));
  const Surface expected = mirrored(clean(quarterBox(3)), "x=0");
  EXPECT_EQ(netBoundary(half), netBoundary(expected));
  EXPECT_EQ(half.vertices.size(), expected.vertices.size());
}

TEST(Mirror, IsRefusedForPlanesAtOtherAngles)
{
  EXPECT_NO_THROW(winding::Mirror("x=0 y=0 z=0"));
  EXPECT_NO_THROW(winding::Mirror("1 1 0 = 3; 1 -1 0 = 5; z=2"));
  for (const char* wrong : {"x=0 y=0 z=0 x=1", "y=0; 1 1 0 = 0", "1 1 0 = 0; y=0",
         "1 0 0 = 0; 1 1.7320508075688772 0 = 0", "y=0; 0.001 1 0 = 0", "x=0 y=0 z=0; 1 1 1 = 0"})
  {
    EXPECT_THROW(winding::Mirror{wrong}, winding::Refusal) << wrong;
  }
}

TEST(Mirror, CountsAPlaneThatIsThereTwiceOnce)
{
  const Surface once = mirrored(clean(quarterBox(3)), "x=0.3");
  for (const char* twice : {"x=0.3 x=0.3", "x=0.3; 3 0 0 = 0.9", "x=0.3; -7 0 0 = -2.1",
         "x=0.3 x=0.3000001", "x=0.3; 1 1e-7 0 = 0.3"})
  {
    const Surface whole = mirrored(clean(quarterBox(3)), twice);
    EXPECT_EQ(whole.vertices, once.vertices) << twice;
  }
  EXPECT_EQ(winding::Mirror("x=0.3; 3 0 0 = 0.9; y=0; z=0").copies(), 8u);
  // The size of the source decides how near is equal.
  EXPECT_NEAR(volumeOf(mirrored(clean(cube()), "x=0 x=1e-17")), 2, 1e-15);
}

TEST(Mirror, MakesARowAtParallelPlanes)
{
  const Surface row = mirrored(clean(quarterBox(3)), "x=0 x=1 z=1");
  EXPECT_TRUE(isClean(row));
  EXPECT_NEAR(volumeOf(row), 8, 1e-13);
  EXPECT_EQ(row.bounds.min(), Point(-1, 0, 0));
  EXPECT_EQ(row.bounds.max(), Point(3, 1, 2));
  EXPECT_EQ(
    winding::Mirror("x=0 x=1 z=1").completed(clean(quarterBox(3)).bounds).max(), row.bounds.max());
}

TEST(Mirror, TakesPlanesOfSixDigitsAtRightAngles)
{
  SCOPED_TRACE("seed 37");
  Random random(37);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Motion motion = Motion::random(random);
    const auto planeOf = [&](int axis, double offset)
    {
      const Point normal = motion.rotation.col(axis);
      std::ostringstream text;
      text.precision(6);
      text << normal.transpose() << " = ";
      text.precision(17);
      text << motion.scale * offset + normal.dot(motion.shift) << "; ";
      return text.str();
    };
    const winding::Mirror mirror(planeOf(0, 0) + planeOf(1, 0) + planeOf(2, 1));
    const auto planes = mirror.planesFor(clean(quarterBox(2).mapped(motion)).bounds);
    ASSERT_EQ(planes.size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(
        planes[std::size_t(i)].normal.dot(planes[std::size_t(i + 1) % 3].normal), 0, 1e-15)
        << "found 2e-16";
      EXPECT_NEAR(planes[std::size_t(i)].normal.dot(motion.rotation.col(i)), 1, 1e-9);
    }
  }
}

TEST(Mirror, GivesCloudsTheirOtherHalf)
{
  const Cloud all = sphereCloud(2000);
  Cloud half;
  for (std::size_t i = 0; i < all.positions.size(); ++i)
  {
    if (all.positions[i][1] >= 0)
    {
      half.positions.push_back(all.positions[i]);
      half.normals.push_back(all.normals[i]);
    }
  }
  const auto field = fieldOf(half, &FieldOptions::mirror, "y=0");
  EXPECT_EQ(field->info().primitives, 2 * half.positions.size() - 1) << "one is in the plane";
  const std::vector<double> values =
    valuesAt(*field, {{0, 0, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {0, -2, 0}, {0, 2, 0}});
  EXPECT_NEAR(values[0], 1, 0.01); // 0.9997
  EXPECT_NEAR(values[1], values[2], 1e-12);
  EXPECT_NEAR(values[3], 0, 0.01);
  EXPECT_NEAR(values[3], values[4], 1e-12);
}

TEST(PlaneCap, HasTheAreaOfItsPolygonsWhateverTheyAre)
{
  SCOPED_TRACE("seed 41");
  Random random(41);
  for (int trial = 0; trial < 1000; ++trial)
  {
    // Stars with holes that are stars, in a plane of any direction.
    const Point normal = random.direction(), u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Point> vertices;
    winding::Rims rims;
    double expected = 0;
    const auto addStar = [&](double x, double y, double size, int corners, bool isHole)
    {
      std::vector<std::int32_t> rim;
      std::vector<Eigen::Vector2d> flat;
      for (int i = 0; i < corners; ++i)
      {
        const double angle = 6.283185307179586 * i / corners, radius = random(0.3, 1) * size;
        flat.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
        rim.push_back(static_cast<std::int32_t>(vertices.size()));
        vertices.push_back(100 * normal + flat.back()[0] * u + flat.back()[1] * v);
      }
      double area = 0;
      for (int i = 0; i < corners; ++i)
      {
        const Eigen::Vector2d &a = flat[i], &b = flat[(i + 1) % corners];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
      expected += isHole ? -area : area;
      if (isHole)
      {
        std::reverse(rim.begin(), rim.end());
      }
      rims.push_back(rim);
    };
    addStar(0, 0, 10, 8 + static_cast<int>(random(0, 40)), false);
    const int holes = static_cast<int>(random(0, 5));
    for (int i = 0; i < holes; ++i)
    {
      const double angle = 6.283185307179586 * i / holes;
      addStar(1.2 * std::cos(angle), 1.2 * std::sin(angle), holes > 1 ? 0.6 : 1.2,
        3 + static_cast<int>(random(0, 9)), true);
    }
    addStar(25, 3, 4, 5, false); // with no hole
    if (trial % 2 == 1)
    {
      for (std::vector<std::int32_t>& rim : rims)
      {
        std::reverse(rim.begin(), rim.end());
      }
      expected = -expected;
    }
    const winding::TriangleList cap = winding::planeCapOf(rims, vertices, normal);
    double area = 0, unsignedArea = 0;
    Surface surface;
    surface.vertices = vertices;
    for (const winding::Triangle& t : cap)
    {
      const double twice =
        normal.dot((vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]));
      area += twice / 2;
      unsignedArea += std::abs(twice / 2);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        surface.triangles.push_back(t);
      }
    }
    ASSERT_NEAR(area, expected, 1e-9) << trial;
    // Triangles outside of the polygons would cancel others.
    ASSERT_NEAR(unsignedArea, std::abs(expected), 1e-9) << trial;
    std::size_t corners = 0;
    for (const std::vector<std::int32_t>& rim : rims)
    {
      corners += rim.size();
    }
    ASSERT_EQ(netBoundary(surface), corners) << trial;
  }
}

TEST(PlaneCap, ClosesRimsThatCrossThemselves)
{
  SCOPED_TRACE("seed 43");
  Random random(43);
  for (int trial = 0; trial < 1000; ++trial)
  {
    std::vector<Point> vertices;
    winding::Rims rims(1 + static_cast<std::size_t>(random(0, 3)));
    for (std::vector<std::int32_t>& rim : rims)
    {
      const int corners = 3 + static_cast<int>(random(0, 12));
      for (int i = 0; i < corners; ++i)
      {
        // On a lattice, so that corners coincide and lie on lines.
        rim.push_back(static_cast<std::int32_t>(vertices.size()));
        vertices.emplace_back(Point{std::floor(random(0, 5)), std::floor(random(0, 5)), 0});
      }
    }
    Surface surface;
    surface.vertices = vertices;
    for (const winding::Triangle& t : winding::planeCapOf(rims, vertices, {0, 0, 1}))
    {
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        surface.triangles.push_back(t);
      }
    }
    for (const std::vector<std::int32_t>& rim : rims)
    {
      for (std::size_t i = 0; i < rim.size(); ++i) // all edges are there, once
      {
        const auto& edges = boundaryOf(surface).edges;
        ASSERT_TRUE(std::any_of(edges.begin(), edges.end(),
          [&](const winding::BoundaryEdge& edge)
          { return edge.from == rim[i] && edge.to == rim[(i + 1) % rim.size()]; }))
          << trial;
      }
    }
  }
}

TEST(FlatBase, ClosesWhatIsOpenBelowAndLeavesOtherHoles)
{
  // A ball without its lower part, and without a triangle at the top and at the side.
  const Mesh dome = kept(icosphere(4), [](const Point& p) { return p[2] > -0.4; });
  Mesh holed;
  holed.points = dome.points;
  holed.triangles.assign(dome.triangles.begin() + 1, dome.triangles.end());
  for (const auto& [text, place] :
    {std::pair<std::string, double>{"down", -0.4}, {"z=-2", -2}, {"-z", -0.4}})
  {
    Surface surface = clean(holed);
    const Surface before = surface;
    const winding::BasedOpenings found = winding::FlatBase(text).addTo(surface, serial);
    EXPECT_EQ(found.closed, 1u) << text;
    EXPECT_EQ(found.left, 1u) << text;
    EXPECT_EQ(netBoundary(surface), 3u) << text;
    EXPECT_TRUE(isClean(surface)) << text;
    EXPECT_TRUE(
      std::equal(before.triangles.begin(), before.triangles.end(), surface.triangles.begin()));
    EXPECT_NEAR(surface.bounds.min()[2], place, 0.06) << text;
    EXPECT_EQ(winding::FlatBase(text).completed(before.bounds).min(), surface.bounds.min());
  }
}

TEST(FlatBase, ClosesTheLowerOpeningOfVessels)
{
  SCOPED_TRACE("seed 67");
  Random random(67);
  for (int trial = 0; trial < 400; ++trial)
  {
    // In half of the trials the upper opening is the larger one. The base is next to the lower one
    // or below it, in any direction.
    std::vector<std::array<double, 2>> profile(2 + random.bits() % 5);
    for (std::size_t i = 0; i < profile.size(); ++i)
    {
      const double last = static_cast<double>(profile.size()) - 1;
      profile[i] = {random(0.3, 1.2), 2 * static_cast<double>(i) / last};
    }
    const Mesh vessel = lathe(profile, 24);
    const Motion motion = Motion::random(random);
    const bool hasGap = trial % 3 == 0;
    const auto field = fieldOf(shuffled(vessel, random).mapped(motion), &FieldOptions::flatBase,
      hasGap ? motion.plane({0, 0, 1}, -0.25) : motion.direction({0, 0, -1}));
    EXPECT_EQ(field->info().netBoundaryEdges, 24u) << trial;
    EXPECT_EQ(field->info().warnings.size(), 1u) << trial;
    const double low = hasGap ? -0.2 : 0.05;
    EXPECT_GT(valuesAt(*field, {motion({0.01, 0.02, low})})[0], 0.5) << trial;
    EXPECT_LT(valuesAt(*field, {motion({0.01, 0.02, low - 0.1})})[0], 0.5) << trial;
    EXPECT_LT(valuesAt(*field, {motion({1.3, 0, 1})})[0], 0.5) << trial;
  }
}

TEST(FlatBase, TakesTheSenseOfFacesFromOpeningsNextToIt)
{
  // Vessels that look inward, and a crater with a lake at its bottom, where no points are: they
  // differ in their proportions only.
  for (const double above : {0.3, 0.8, 1.0, 1.3, 2.0})
  {
    const Mesh inward = lathe({{1, 0}, {above, 2}}, 24).reversed();
    const auto field = fieldOf(inward, &FieldOptions::flatBase, "z=-0.5");
    EXPECT_EQ(field->info().netBoundaryEdges, 24u) << above;
    EXPECT_LT(valuesAt(*field, {{0, 0, -0.25}})[0], -0.5) << above;
  }
  // A dome that looks inward and was cut at a slant, with a triangle missing low at its side.
  const Mesh dome = kept(icosphere(4), [](const Point& p) { return p[2] > 0.6 * p[0] - 0.4; });
  for (std::size_t low = 0; low < dome.triangles.size(); ++low)
  {
    const Point& p = dome.points[dome.triangles[low][0]];
    if (p[2] < 0.6 * p[0] - 0.3 || p[2] > -0.5)
    {
      continue;
    }
    Mesh holed = dome.reversed();
    holed.triangles.erase(holed.triangles.begin() + static_cast<std::ptrdiff_t>(low));
    EXPECT_LT(
      valuesAt(*fieldOf(holed, &FieldOptions::flatBase, "z=-1.2"), {{0.5, 0, -0.9}})[0], -0.5)
      << p.transpose();
  }
  const Mesh crater = lathe({{0.2, 0}, {1.5, 0.5}, {2, 1}, {4, 0.2}}, 24).reversed();
  FieldOptions options;
  options.flatBase = "z=-1";
  EXPECT_EQ(fieldOf(crater, options)->info().netBoundaryEdges, 24u) << "the lake is left";
  const std::vector<double> values =
    valuesAt(*fieldOf(crater, options), {{1.5, 0, 0}, {3.8, 0, -0.9}, {1, 0, 1}, {4.2, 0, 0}});
  EXPECT_GT(values[0], 0.9);
  EXPECT_GT(values[1], 0.9);
  EXPECT_LT(values[2], 0.1);
  EXPECT_LT(values[3], 0.1);
}

TEST(FlatBase, LeavesCupsAlone)
{
  // Closed below and looking outward, whatever the base and the rotation.
  SCOPED_TRACE("seed 71");
  Random random(71);
  for (const double height : {0.3, 1.0, 3.0})
  {
    const Motion motion = Motion::random(random);
    const Mesh cup = lathe({{0, 0}, {1, 0}, {1.1, height}}, 24);
    const auto field =
      fieldOf(cup.mapped(motion), &FieldOptions::flatBase, motion.plane({0, 0, 1}, -2));
    EXPECT_EQ(field->info().netBoundaryEdges, 24u) << height;
  }
}

TEST(FlatBase, MakesASolidOfATerrain)
{
  // A sheet over a square that looks up or down; z is known.
  const auto heightAt = [](double x, double y)
  {
    return 0.3 * std::sin(3 * x) + 0.2 * std::cos(5 * y);
  };
  Mesh terrain;
  const int n = 40;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double x = 2.0 * i / n, y = 2.0 * j / n;
      terrain.points.emplace_back(x, y, heightAt(x, y));
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int a = i * (n + 1) + j;
      terrain.triangles.push_back({a, a + n + 1, a + n + 2});
      terrain.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  SCOPED_TRACE("seed 47");
  Random random(47);
  std::vector<Point> samples;
  for (int i = 0; i < 2000; ++i)
  {
    samples.push_back(Point{random(-0.5, 2.5), random(-0.5, 2.5), random(-1.5, 1)});
  }
  for (const bool looksDown : {false, true})
  {
    FieldOptions options;
    options.flatBase = "z=-1";
    options.orientFaces = looksDown;
    const auto field = fieldOf(looksDown ? terrain.reversed() : terrain, options);
    EXPECT_EQ(field->info().netBoundaryEdges, 0u);
    EXPECT_EQ(field->info().bounds.min()[2], -1);
    const std::vector<double> values = valuesAt(*field, samples);

    options = FieldOptions();
    options.sheetSide = "down";
    const auto divider = fieldOf(looksDown ? terrain.reversed() : terrain, options);
    EXPECT_EQ(divider->info().added, 0.5);
    const std::vector<double> divided = valuesAt(*divider, samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const Point& p = samples[i];
      const bool isOver = p[0] > 0 && p[0] < 2 && p[1] > 0 && p[1] < 2;
      const double above = p[2] - heightAt(p[0], p[1]);
      if (std::abs(above) < 0.01)
      {
        continue; // the sheet is made of triangles
      }
      ASSERT_EQ(values[i], isOver && above < 0 && p[2] > -1 ? 1 : 0) << p.transpose();
      if (isOver)
      {
        ASSERT_EQ(divided[i] >= 0.5, above < 0) << p.transpose() << " " << divided[i];
      }
      ASSERT_NEAR(divided[i], divider->reference(p), 1e-3);
    }
  }
}

TEST(FlatBase, ClosesRingsInTheirPlane)
{
  // The upper half of a torus: its two rims lie in the base, and run in opposite directions.
  const Mesh half = kept(torus(48, 24), [](const Point& p) { return p[2] > -1e-9; });
  Surface surface = clean(half);
  const winding::BasedOpenings found = winding::FlatBase("z=0").addTo(surface, serial);
  EXPECT_EQ(found.closed, 2u);
  EXPECT_EQ(netBoundary(surface), 0u);
  EXPECT_TRUE(isClean(surface));
  const auto field = fieldOf(half, &FieldOptions::flatBase, "z=0");
  const std::vector<double> values = valuesAt(*field, {{0, 0, 0.1}, {1, 0, 0.1}, {0, 1, -0.1}});
  EXPECT_EQ(values, (std::vector<double>{0, 1, 0}));
  // No triangle of the base spans the hole: the nearest point of the ring is 0.6 away.
  const std::vector<Point> middle = {{0, 0, 0}};
  const std::vector<double> distances =
    field->distances(winding::VectorsView(middle[0].data(), 1), serial);
  EXPECT_NEAR(distances[0], 0.6, 0.01);
}

TEST(FlatBase, KeepsBoresOpen)
{
  SCOPED_TRACE("seed 73");
  Random random(73);
  for (int trial = 0; trial < 400; ++trial)
  {
    // An inner wall that may end above the base. In half of the trials a roof joins it to the outer
    // wall, and all may look inward.
    const double end = trial % 3 == 0 ? 0 : random(0, 0.3);
    std::vector<std::array<double, 2>> outer, inner;
    for (int i = 0; i <= 3; ++i)
    {
      outer.push_back({random(1.5, 2), i / 3.0});
      inner.push_back({random(0.85, 1), end + (1 - end) * i / 3});
    }
    Mesh ring = lathe(outer, 24).with(lathe(inner, 24).reversed());
    const bool hasRoof = trial % 2 == 0;
    if (hasRoof)
    {
      std::reverse(inner.begin(), inner.end());
      outer.insert(outer.end(), inner.begin(), inner.end());
      ring = lathe(outer, 24);
    }
    const bool isInward = random.bits() % 2 == 0;
    const Motion motion = Motion::random(random);
    FieldOptions options;
    options.flatBase =
      trial % 5 == 0 ? motion.plane({0, 0, 1}, -0.25) : motion.direction({0, 0, -1});
    const auto field =
      fieldOf(shuffled(isInward ? ring.reversed() : ring, random).mapped(motion), options);
    EXPECT_EQ(field->info().netBoundaryEdges, hasRoof ? 0u : 48u) << trial;
    EXPECT_EQ(field->info().warnings.size(), hasRoof ? 0u : 1u) << trial;
    const double sense = isInward ? -1 : 1;
    const std::vector<double> values =
      valuesAt(*field, {motion({1.25, 0, 0.1}), motion({0.01, 0.02, 0.1}), motion({0, 0.3, 0.05})});
    EXPECT_GT(sense * values[0], 0.6) << trial;
    EXPECT_LT(sense * values[1], 0.1) << trial;
    EXPECT_LT(sense * values[2], 0.1) << trial;
  }
}

TEST(FlatBase, TakesSoupsWhereEdgesCountTwice)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh soup;
    for (int i = 0; i < 7; ++i)
    {
      soup.points.push_back(random.point(-1, 1));
    }
    for (int i = 0; i < 12; ++i)
    {
      const auto first = static_cast<std::int32_t>(random.bits() % 7);
      const auto second = static_cast<std::int32_t>((first + 1 + random.bits() % 3) % 7);
      soup.triangles.push_back({first, second, (first + 4 + int(random.bits() % 3)) % 7});
    }
    Surface surface = clean(soup.with(soup.part(0, random.bits() % 12)));
    const std::size_t before = netBoundary(surface);
    winding::FlatBase("down").addTo(surface, serial);
    EXPECT_LE(netBoundary(surface), before);
  }
}

TEST(FlatBase, TakesTheSameRimsInAllDirections)
{
  // Holes of one triangle, of which each touches both rims of a wall.
  SCOPED_TRACE("seed 79");
  Random random(79);
  for (int trial = 0; trial < 300; ++trial)
  {
    const int corners = 4 + static_cast<int>(random.bits() % 6);
    Mesh wall =
      lathe({{1, 0}, {1.2, 1}}, corners)
        .mapped([&random](const Point& p) -> Point { return p + 0.05 * random.direction(); });
    for (int holes = trial % 2; holes < 3; ++holes)
    {
      wall.triangles.erase(wall.triangles.begin() +
                           static_cast<std::ptrdiff_t>(random.bits() % wall.triangles.size()));
    }
    const auto valuesIn = [&](const Motion& motion)
    {
      FieldOptions options;
      options.method = winding::Method::direct;
      options.flatBase = motion.direction({0, 0, -1});
      return valuesAt(*fieldOf(shuffled(wall, random).mapped(motion), options),
        {motion({0, 0, 0.06}), motion({0, 0, 0.5}), motion({0, 0, 0.9})});
    };
    const auto expected = valuesIn({Eigen::Matrix3d::Identity(), 1, Point(0, 0, 0)});
    const auto found = valuesIn(Motion::random(random));
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_NEAR(found[i], expected[i], 1e-9) << trial;
    }
  }
}

TEST(FlatBase, LiesBelowTheSurfaceByADistance)
{
  const Mesh square = {{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  for (const char* text : {"down 0.5", " -z\t0.5 ", "direction 0 0 -2 0.5"})
  {
    SCOPED_TRACE(text);
    const winding::FlatBase base(text);
    winding::Surface surface = clean(square);
    EXPECT_EQ(base.addTo(surface, serial).closed, 1u);
    EXPECT_EQ(surface.bounds.min(), Eigen::Vector3d(0, 0, 0.5));
    EXPECT_DOUBLE_EQ(volumeOf(surface), 2);
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()).matrix();
    winding::Surface again =
      clean(square.mapped([&](const Point& p) { return Point(turned * (p - Point(0, 0, 3))); }));
    winding::FlatBase(base.along(turned, {0, 0, 3})).addTo(again, serial);
    EXPECT_NEAR(volumeOf(again), 2, 1e-12);
  }
}

TEST(FlatBase, RefusesOtherTexts)
{
  for (const char* wrong :
    {"below", "z", "z=0 y=0", "direction 0 0 0", "down -1", "down nan", "down 1 2", "0.5"})
  {
    EXPECT_THROW(winding::FlatBase{wrong}, winding::Refusal) << wrong;
  }
  EXPECT_TRUE(winding::FlatBase("").isNone());
}

TEST(FlatBase, SaysWhereItClosesNothing)
{
  FieldOptions options;
  options.flatBase = "down";
  EXPECT_EQ(fieldOf(cube(), options)->info().warnings.size(), 1u);
  EXPECT_EQ(fieldOf(openCube(), options)->info().warnings.size(), 1u);
  options.flatBase = "up";
  const auto closed = fieldOf(openCube(), options);
  EXPECT_TRUE(closed->info().warnings.empty());
  EXPECT_EQ(closed->info().netBoundaryEdges, 0u);
}

TEST(SheetSide, LeavesClosedPartsAlone)
{
  FieldOptions options;
  options.sheetSide = "down";
  const auto field = fieldOf(cube(), options);
  EXPECT_EQ(field->info().added, 0);
  EXPECT_EQ(field->info().warnings.size(), 1u);
  options.sheetSide = "below";
  EXPECT_THROW(fieldOf(cube(), options), winding::Refusal);
}

TEST(SheetSide, DividesInAllMethodsAndForms)
{
  // A wide sheet: w is near 1 on one side and near 0 on the other.
  const Mesh sheet = kept(icosphere(5), [](const Point& p) { return p[2] > 0.9; })
                       .mapped(
                         [](const Point& p) -> Point {
                           return {p[0], p[1], p[2] - 0.95};
                         });
  SCOPED_TRACE("seed 53");
  const std::vector<Point> samples = randomPoints(500, -0.3, 0.3, 53);
  FieldOptions down;
  down.sheetSide = "down";
  const std::vector<double> below = valuesAt(*fieldOf(sheet, down), samples);
  for (const winding::Method method :
    {winding::Method::automatic, winding::Method::direct, winding::Method::hierarchical})
  {
    for (const char* side : {"down", "up", "direction 0.1 0 -1"})
    {
      FieldOptions options;
      options.sheetSide = side;
      options.method = method;
      const auto field = fieldOf(sheet, options);
      const std::vector<double> values = valuesAt(*field, samples);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        ASSERT_NEAR(values[i], field->reference(samples[i]), 1e-3);
        ASSERT_NEAR(values[i], side[0] == 'u' ? 1 - below[i] : below[i], 2e-3);
      }
      std::vector<float> distances(samples.size());
      std::vector<unsigned char> inside(samples.size());
      winding::FieldOutput output;
      output.distances = distances.data();
      output.inside = inside.data();
      field->evaluate(winding::VectorsView(samples.front().data(), samples.size()), output, serial);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        ASSERT_EQ(inside[i] != 0, values[i] >= 0.5);
        ASSERT_EQ(distances[i] < 0, inside[i] != 0);
      }
    }
  }
}

/// Hills, with normals of either sense or none: below them w is near 1, and above them near 0.
TEST(SheetSide, DividesByPoints)
{
  Cloud hills;
  for (int i = 0; i < 60 * 60; ++i)
  {
    const double x = i % 60 / 30. - 1, y = i / 60 / 30. - 1;
    hills.positions.emplace_back(x, y, 0.1 * std::sin(4 * x) * std::cos(4 * y));
    hills.normals.emplace_back(-0.4 * std::cos(4 * x) * std::cos(4 * y),
      0.4 * std::sin(4 * x) * std::sin(4 * y), i % 2 ? 1 : 1.01);
  }
  const std::vector<Point> samples = {{0, 0, -0.2}, {0.2, 0.1, 0.2}, {-0.2, 0.3, -0.15}};
  FieldOptions options;
  options.sheetSide = "down";
  const auto sheet = fieldOf(hills, options);
  EXPECT_EQ(sheet->info().added, 0.5);
  EXPECT_TRUE(sheet->info().warnings.empty());
  const std::vector<double> values = valuesAt(*sheet, samples);
  EXPECT_NEAR(values[0], 0.95, 0.06);
  EXPECT_NEAR(values[1], 0.05, 0.06);
  EXPECT_NEAR(values[2], 0.95, 0.06);
  EXPECT_NEAR(values[0], sheet->reference(samples[0]), 1e-3);
  Cloud down = hills;
  for (Point& normal : down.normals)
  {
    normal = -normal;
  }
  EXPECT_NEAR(valuesAt(*fieldOf(down, options), samples)[0], values[0], 1e-9);
  Cloud bare = hills;
  bare.normals.clear();
  options.estimateNormals = true;
  options.toward = "up";
  const auto seen = fieldOf(bare, options);
  EXPECT_TRUE(seen->info().warnings.empty());
  EXPECT_GT(seen->info().orientation.outward, 0.85); // not at the rim
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_NEAR(valuesAt(*seen, samples)[i], values[i], 0.02);
  }
  const auto closed = fieldOf(sphereCloud(2000), options);
  EXPECT_EQ(closed->info().added, 0);
  EXPECT_EQ(closed->info().warnings.size(), 2u) << "no part is open, and normals are as given";
  options.isOneOfSeveral = true;
  EXPECT_TRUE(fieldOf(sphereCloud(2000), options)->info().warnings.empty());
  EXPECT_EQ(fieldOf(sphereCloud(2000), options)->info().unused.size(), 2u);
}

TEST(SnappedPoints, MakeOneOfThoseThatAreNear)
{
  SCOPED_TRACE("seed 59");
  Random random(59);
  // Triangles of a ball with points of their own, each moved by up to 1e-4.
  const Mesh ball = icosphere(3);
  Mesh soup;
  for (const auto& t : ball.triangles)
  {
    for (const std::int32_t corner : t)
    {
      soup.points.emplace_back(ball.points[corner] + 1e-4 * random.direction());
    }
    const auto next = static_cast<std::int32_t>(soup.points.size());
    soup.triangles.push_back({next - 3, next - 2, next - 1});
  }
  EXPECT_GT(netBoundary(clean(soup)), 3000u);
  const winding::VectorsView view(soup.points.front().data(), soup.points.size());
  const auto snapped = winding::snappedPoints({view}, 2.1e-4, serial);
  Mesh closed = soup;
  double farthest = 0;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    closed.points[i] = Point(snapped[0].data() + 3 * i);
    farthest = std::max(farthest, (closed.points[i] - soup.points[i]).norm());
  }
  EXPECT_LE(farthest, 2.1e-4);
  EXPECT_EQ(clean(closed).vertices.size(), ball.points.size());
  EXPECT_EQ(netBoundary(clean(closed)), 0u);

  // The same places for any executor, any order, and any cut into views.
  ShuffledThreads threads(3);
  EXPECT_EQ(winding::snappedPoints({view}, 2.1e-4, threads), snapped);
  std::vector<Point> reversed(soup.points.rbegin(), soup.points.rend());
  const auto other = winding::snappedPoints(
    {{reversed.front().data(), 1000}, {reversed[1000].data(), reversed.size() - 1000}}, 2.1e-4,
    serial);
  for (std::size_t i = 0; i < reversed.size(); ++i)
  {
    const double* const moved = i < 1000 ? &other[0][3 * i] : &other[1][3 * (i - 1000)];
    ASSERT_EQ(Point(moved), closed.points[reversed.size() - 1 - i]);
  }
}

TEST(SnappedPoints, KeepWhatIsFarAndWhatIsNoPlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, nan, 0, 0, 1e90, 1, 1, -0.0, 0, 0};
  for (const double tolerance : {0.0, 1e-9, 0.999})
  {
    const auto found = winding::snappedPoints({{points.data(), 5}}, tolerance, serial)[0];
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_TRUE(found[i] == points[i] || std::isnan(points[i])) << i;
    }
  }
  const auto one = winding::snappedPoints({{points.data(), 2}}, 1, serial)[0];
  EXPECT_EQ(one[3], one[0]);
}

TEST(Mirror, NoticesSourcesThatReachAcrossIt)
{
  FieldOptions options;
  options.mirror = "x=0.5";
  EXPECT_EQ(fieldOf(cube(), options)->info().warnings.size(), 1u);
  options.mirror = "x=1";
  EXPECT_TRUE(fieldOf(cube(), options)->info().warnings.empty());
  // Points within the tolerance of the plane are in it.
  const Mesh ragged = quarterBox(4).mapped(
    [](const Point& p) -> Point {
      return p[0] == 0 ? Point{p[1] > 0.3 ? 1e-3 : -1e-3, p[1], p[2]} : p;
    });
  options = FieldOptions();
  options.mirror = "x=0 z=1";
  options.weldTolerance = 2e-3;
  const auto whole = fieldOf(ragged, options);
  EXPECT_EQ(whole->info().netBoundaryEdges, 0u);
  EXPECT_TRUE(whole->info().warnings.empty());
}

TEST(Mirror, LeavesViewpointsToTheHalfThatWasSeen)
{
  const Cloud all = sphereCloud(3000);
  std::vector<Point> half;
  for (const Point& p : all.positions)
  {
    if (p[1] >= 0)
    {
      half.push_back(p);
    }
  }
  FieldOptions options;
  options.mirror = "y=0";
  options.estimateNormals = true;
  options.toward = "0 50 0";
  const auto field = winding::Field::build(
    std::vector<winding::OrientedPointsView>{
      {winding::VectorsView(half.front().data(), half.size()), {}, {}}},
    options, serial);
  for (const double value : valuesAt(*field, {{0, 0.5, 0}, {0, -0.5, 0}, {0, 0, 0}}))
  {
    EXPECT_NEAR(value, 1, 0.1); // 0.98
  }
  EXPECT_TRUE(field->info().warnings.empty());
  EXPECT_TRUE(field->info().normalsAreEstimated);
  EXPECT_EQ(field->info().normalEstimation, winding::NormalEstimation::toward);
  EXPECT_GT(field->info().orientation.outward, 0.95);
}

TEST(FlatBase, SaysWhatItLeavesAndCuts)
{
  const auto warningsOf = [](const Mesh& mesh, const std::string& base)
  {
    std::string all;
    const auto field = fieldOf(mesh, &FieldOptions::flatBase, base);
    for (const winding::Message& message : field->info().warnings)
    {
      all += message.fault + "; " + message.facts + "; ";
    }
    return all;
  };
  const Mesh dome = kept(icosphere(4), [](const Point& p) { return p[2] > -0.4; });
  Mesh holed;
  holed.points = dome.points;
  holed.triangles.assign(dome.triangles.begin() + 1, dome.triangles.end());
  EXPECT_NE(
    warningsOf(holed, "down").find("leaves 1 opening as it is; it faces"), std::string::npos);
  EXPECT_NE(warningsOf(dome, "z=0").find("cuts the surface"), std::string::npos);
  EXPECT_NE(warningsOf(dome, "up").find("closes nothing: no opening faces it; 1 opening does not"),
    std::string::npos);
  EXPECT_EQ(warningsOf(dome, "down"), "");
}

TEST(FlatBase, TakesAnyCapForManyCorners)
{
  // A comb of 12 000 teeth, extruded: its base has more corners than are triangulated.
  Mesh walls;
  const int teeth = 12000;
  const auto at = [](int i) -> Point
  {
    return {static_cast<double>(i / 2), i % 4 < 2 ? 0.0 : 1.0, 0};
  };
  std::vector<Point> rim;
  for (int i = 0; i < 2 * teeth; ++i)
  {
    rim.push_back(at(i));
  }
  rim.emplace_back(teeth, 3, 0);
  rim.emplace_back(0, 3, 0);
  const auto count = static_cast<int>(rim.size());
  for (const Point& p : rim)
  {
    walls.points.push_back(p);
  }
  for (const Point& p : rim)
  {
    walls.points.push_back(p + Point(0, 0, 1));
  }
  for (int i = 0; i < count; ++i)
  {
    const int next = (i + 1) % count;
    walls.triangles.push_back({i, next, count + next});
    walls.triangles.push_back({i, count + next, count + i});
  }
  Surface surface = clean(walls);
  EXPECT_EQ(winding::FlatBase("down").addTo(surface, serial).closed, 1u);
  EXPECT_EQ(winding::FlatBase("up").addTo(surface, serial).closed, 1u);
  EXPECT_EQ(netBoundary(surface), 0u);
  EXPECT_NEAR(std::abs(volumeOf(surface)), 2.5 * teeth, 0.001 * teeth);
}

TEST(SheetSide, SaysWhereItDecidesNothing)
{
  Mesh sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  FieldOptions options;
  options.sheetSide = "+x";
  EXPECT_EQ(fieldOf(sheet, options)->info().warnings.size(), 1u) << "it lies along the sheet";
  options.sheetSide = "down";
  EXPECT_TRUE(fieldOf(sheet, options)->info().warnings.empty());
  const Mesh two = sheet.with(sheet.mapped(
    [](const Point& p) -> Point {
      return {p[0], p[1], p[2] + 0.5};
    }));
  EXPECT_EQ(fieldOf(two, options)->info().warnings.size(), 1u) << "sheets add up";
  const Mesh pieces = sheet.with(sheet.mapped(
    [](const Point& p) -> Point {
      return {p[0] + 1, p[1], p[2] + 0.1};
    }));
  EXPECT_TRUE(fieldOf(pieces, options)->info().warnings.empty()) << "they lie side by side";
  options.method = winding::Method::parity;
  EXPECT_THROW(fieldOf(sheet, options), winding::Refusal);
}

TEST(SnappedPoints, TakeTinyTolerancesAndSmallOnes)
{
  const std::vector<Point> points = randomPoints(20000, -1, 1, 61);
  const winding::VectorsView view(points.front().data(), points.size());
  for (const double tolerance : {1e-320, 1e-300, 1e-18})
  {
    const auto found = winding::snappedPoints({view}, tolerance, serial)[0];
    EXPECT_TRUE(std::equal(found.begin(), found.end(), points.front().data()));
  }
}

TEST(Completions, DependOnTheSetOfTrianglesAndFollowMotions)
{
  std::size_t completed = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<std::array<double, 2>> profile;
    for (std::uint64_t i = 0, count = 2 + random.bits() % 4; i < count; ++i)
    {
      profile.push_back({random(0.3, 1.2), 0.5 * static_cast<double>(i)});
    }
    // Walls with equal openings, vessels, a box with a sheet inside, soups, each with a hole.
    const Mesh sheet = openCube().part(0, 2).mapped(
      [](const Point& p) -> Point { return Point(0.3, 0.2, 0.4) + 0.5 * p; });
    const Mesh meshes[] = {lathe({{1, 0}, {1, 2}}, 4), lathe(profile, 12), cube().with(sheet),
      triangleSoup(20, seed), quarterBox(3)};
    const Mesh whole = meshes[seed % 5];
    const Mesh mesh = whole.part(0, whole.triangles.size() - random.bits() % 2);
    const Point side = random.bits() % 2 ? Point(0, 0, -1) : random.direction();
    const double reach = random(-3, -2.5);
    const int kind = static_cast<int>(random.bits() % 6);
    const auto optionsFor = [&](const Motion& motion)
    {
      FieldOptions options;
      options.method = winding::Method::direct;
      options.flatBase = kind == 0   ? motion.direction(side)
                         : kind == 1 ? motion.plane({0, 0, 1}, reach)
                                     : "";
      options.mirror = kind == 2 ? motion.plane(side, reach) : "";
      options.sheetSide = kind == 3 ? motion.direction(side) : "";
      options.ignoreOpenParts = kind == 4;
      options.weldTolerance = kind == 5 ? 1e-6 * motion.scale : 0;
      return options;
    };
    const Motion still = {Eigen::Matrix3d::Identity(), 1, Point(0, 0, 0)};
    const Motion moved = Motion::random(random);
    Motion larger = still;
    larger.scale = std::exp2(std::floor(random(-40, 40)));
    std::vector<Point> samples;
    for (int i = 0; i < 60; ++i)
    {
      samples.push_back(random.point(-1.5, 2.2));
    }
    const auto samplesOf = [&samples](const Motion& motion)
    {
      std::vector<Point> result;
      std::transform(samples.begin(), samples.end(), std::back_inserter(result), motion);
      return result;
    };
    const auto field = fieldOf(mesh, optionsFor(still));
    const std::vector<double> values = valuesAt(*field, samples);
    completed += values != valuesAt(*fieldOf(mesh, {}), samples);
    EXPECT_EQ(valuesAt(*fieldOf(shuffled(mesh, random), optionsFor(still)), samples), values);
    const auto scaled = fieldOf(shuffled(mesh, random).mapped(larger), optionsFor(larger));
    EXPECT_EQ(scaled->info().warnings.size(), field->info().warnings.size());
    const std::vector<double> ofScaled = valuesAt(*scaled, samplesOf(larger));
    const auto turned = fieldOf(shuffled(mesh, random).mapped(moved), optionsFor(moved));
    EXPECT_EQ(turned->info().netBoundaryEdges, field->info().netBoundaryEdges);
    const std::vector<double> ofTurned = valuesAt(*turned, samplesOf(moved));
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      EXPECT_NEAR(ofScaled[i], values[i], 1e-13) << samples[i].transpose();
      EXPECT_NEAR(ofTurned[i], values[i], 1e-9) << samples[i].transpose();
    }
  }
  EXPECT_GT(completed, 200u);
}
