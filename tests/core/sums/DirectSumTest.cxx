// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/DirectSum.h"
#include "support/RealMeshes.h"

#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/QuadAngle.h"
#include "support/ReadObj.h"
#include "support/Samples.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{

using namespace shapes;
using winding::TriangleSum;

std::vector<double> windingOf(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  return valuesOf(TriangleSum(surface), samples);
}

std::vector<double> referenceOf(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  std::vector<double> values;
  for (const Point& q : samples)
  {
    values.push_back(static_cast<double>(winding::referenceSum<long double>(surface, q)));
  }
  return values;
}

std::map<std::string, Mesh> closedShapes()
{
  return {{"tetrahedron", tetrahedron()}, {"cube", cube()}, {"icosphere", icosphere(3)},
    {"torus", torus(48, 24)}, {"L", surfaceOf(lShape())},
    {"random cells", surfaceOf(randomCells(4, 7))}};
}

std::vector<Point> farAndNear(const Mesh& mesh, unsigned seed)
{
  std::vector<Point> samples = randomPoints(300, -2, 4, seed);
  for (const double distance : {1e-2, 1e-4, 1e-6, 1e-8})
  {
    const std::vector<Point> near = pointsNear(mesh, 100, distance, seed);
    samples.insert(samples.end(), near.begin(), near.end());
  }
  return samples;
}

} // namespace

TEST(TriangleSum, EqualsTheLongDoubleReference)
{
  SCOPED_TRACE("seeds 11, 12");
  std::map<std::string, Mesh> meshes = closedShapes();
  meshes["soup"] = triangleSoup(3000, 11);
  meshes["open cube"] = openCube();
  meshes["half a sphere"] = icosphere(3).part(0, 640);
  meshes["Moebius strip"] = moebiusStrip(40);
  double worst = 0;
  for (const auto& [name, mesh] : meshes)
  {
    const std::vector<Point> samples = farAndNear(mesh, 12);
    const double error = largestDifference(windingOf(mesh, samples), referenceOf(mesh, samples));
    EXPECT_LT(error, 1e-11) << name; // promised: 1e-8; measured: 7.7e-15
    worst = std::max(worst, error);
  }
  record("worst", worst);
}

TEST(TriangleSum, OfANeedleLosesNoMoreThanItsCoordinatesDo)
{
  SCOPED_TRACE("seed 16");
  Random random(16);
  double worst = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const Needle needle(random);
    const Mesh mesh{{needle.corners, needle.corners + 3}, {{0, 1, 2}}};
    const std::vector<Point> samples = randomPoints(8, -1, 1, static_cast<unsigned>(i));
    const std::vector<double> values = windingOf(mesh, samples);
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      const QuadVector q(samples[n]);
      const double exact = quadSolidAngle(QuadVector(needle.corners[0]) - q,
        QuadVector(needle.corners[1]) - q, QuadVector(needle.corners[2]) - q);
      const double error = std::remainder(values[n] - exact / (4 * std::acos(-1.0)), 1);
      worst = std::max(worst, std::abs(error) / (1 + needle.ratioAt(samples[n])));
    }
  }
  record("worst", worst);
  EXPECT_LT(worst, 2e-16); // measured: 7.1e-17
}

/// Returns a prism over a regular polygon of `corners` corners, `length` times as long as wide.
Mesh wire(int corners, double length)
{
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {length, 0, 0}};
  for (int i = 0; i < corners; ++i)
  {
    const double phi = 2 * std::acos(-1.0) * i / corners;
    mesh.points.emplace_back(0, 0.5 * std::cos(phi), 0.5 * std::sin(phi));
    mesh.points.emplace_back(length, 0.5 * std::cos(phi), 0.5 * std::sin(phi));
    const int a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % corners);
    for (const auto& triangle :
      {std::array{a, a + 1, b + 1}, {a, b + 1, b}, {0, a, b}, {1, b + 1, a + 1}})
    {
      mesh.triangles.push_back({triangle[0], triangle[2], triangle[1]});
    }
  }
  return mesh;
}

/// Returns a matrix that turns, any but along the axes.
Eigen::Matrix3d turn(Random& random)
{
  const Point x = random.direction(), y = x.unitOrthogonal();
  Eigen::Matrix3d matrix;
  matrix << x, y, x.cross(y);
  return matrix;
}

TEST(TriangleSum, OfLongBoxesAndWiresIsAnInteger)
{
  SCOPED_TRACE("seed 17");
  Random random(17);
  double worst = 0, worstTurned = 0;
  for (const double length : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8})
  {
    for (const bool isBox : {true, false})
    {
      const Mesh mesh = isBox ? cube({0, -0.5, -0.5}, {length, 0.5, 0.5}) : wire(64, length);
      std::vector<Point> samples = randomPoints(2000, -1, 1, 18);
      std::vector<double> expected;
      for (Point& q : samples)
      {
        const auto widthOf = [isBox](const Point& p)
        {
          return isBox ? std::max(std::abs(p.y()), std::abs(p.z())) : std::hypot(p.y(), p.z());
        };
        q *= widthOf(q) > 0.48 && widthOf(q) < 0.51 ? 0.9 : 1; // no sample lies at the skin
        expected.push_back(std::abs(q.x()) < 0.5 && widthOf(q) < 0.49 ? 1 : 0);
        q.x() = (q.x() + 0.5) * length;
      }
      worst = std::max(worst, largestDifference(windingOf(mesh, samples), expected));
      const Eigen::Matrix3d matrix = turn(random);
      for (Point& q : samples)
      {
        q = matrix * q;
      }
      const Mesh turned = mesh.mapped([&](const Point& p) -> Point { return matrix * p; });
      worstTurned =
        std::max(worstTurned, largestDifference(windingOf(turned, samples), expected) / length);
    }
  }
  record("worst", worst);
  record("worstTurned", worstTurned);
  EXPECT_LT(worst, 1e-14);       // measured: 2.2e-15
  EXPECT_LT(worstTurned, 1e-15); // measured: 2.2e-16
}

TEST(TriangleSum, OfALongTroughIsThatOfItsMissingRectangle)
{
  double worst = 0;
  for (const double length : {1e2, 1e4, 1e6, 1e8})
  {
    const std::vector<Point> samples = [length]
    {
      std::vector<Point> points = randomPoints(2000, -0.3, 1.3, 19);
      for (Point& q : points)
      {
        q.x() *= length;
      }
      return points;
    }();
    std::vector<double> expected;
    for (const Point& q : samples)
    {
      // The solid angle of a rectangle is a sum over its corners (x, y) at the height z.
      const double z = 1 - q.z();
      const auto corner = [z](double x, double y)
      {
        return std::atan(x * y / (z * std::sqrt(x * x + y * y + z * z)));
      };
      const double top = corner(length - q.x(), 1 - q.y()) - corner(-q.x(), 1 - q.y()) -
                         corner(length - q.x(), -q.y()) + corner(-q.x(), -q.y());
      const bool isInside =
        q.x() > 0 && q.x() < length && q.y() > 0 && q.y() < 1 && q.z() > 0 && q.z() < 1;
      expected.push_back(isInside - top / (4 * std::acos(-1.0)));
    }
    const Mesh trough =
      openCube().mapped([length](const Point& p) { return Point(length * p[0], p[1], p[2]); });
    worst = std::max(worst, largestDifference(windingOf(trough, samples), expected));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-14); // measured: 3.2e-15
}

TEST(TriangleSum, OfClosedShapesIsAnIntegerNearTheSurfaceToo)
{
  SCOPED_TRACE("seed 13");
  double worst = 0;
  for (const auto& [name, mesh] : closedShapes())
  {
    const std::vector<double> values = windingOf(mesh, farAndNear(mesh, 13));
    std::size_t inside = 0;
    for (const double w : values)
    {
      EXPECT_LT(std::abs(w - std::round(w)), 1e-12) << name; // measured: 6.7e-16
      EXPECT_TRUE(std::round(w) == 0 || std::round(w) == 1) << name << ' ' << w;
      worst = std::max(worst, std::abs(w - std::round(w)));
      inside += w > 0.5;
    }
    EXPECT_GT(inside, 100u) << name;
    EXPECT_GT(values.size() - inside, 100u) << name;
  }
  record("worst", worst);
}

TEST(TriangleSum, KnowsWhatIsInsideASphere)
{
  SCOPED_TRACE("seed 14");
  const std::vector<Point> samples = randomPoints(2000, -1.5, 1.5, 14);
  const std::vector<double> values = windingOf(icosphere(4), samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    // Samples between the inscribed and the circumscribed sphere may be on either side of the mesh.
    if (samples[i].norm() < 0.99 || samples[i].norm() > 1)
    {
      ASSERT_EQ(std::round(values[i]), samples[i].norm() < 1) << samples[i].transpose();
    }
  }
}

TEST(TriangleSum, IsTheMeanOfTheSidesOnFacesEdgesAndVertices)
{
  // The samples are exactly in the planes: quarters of the cube's size are free of rounding.
  const std::vector<Point> samples = {{0.25, 0.5, 0}, {0.25, 0.25, 1}, {0, 0.75, 0.5}, {0.5, 0, 0},
    {1, 1, 0.25}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}, {2, 0.5, 0}};
  const std::vector<double> expected = {0.5, 0.5, 0.5, 0.25, 0.25, 0.125, 0.125, 0.125, 0};
  const double error = largestDifference(windingOf(cube(), samples), expected);
  record("error", error);
  EXPECT_LT(error, 1e-15); // measured: 2.8e-17
}

TEST(TriangleSum, IsTheShareOfTheSolidOnGridPlanesOfLatticeSolids)
{
  double worst = 0;
  for (const Cells& cells : {lShape(), randomCells(4, 15)})
  {
    SCOPED_TRACE("seed 15");
    std::vector<Point> samples;
    std::vector<double> expected;
    for (int n = 0; n < 21 * 21 * 21; ++n)
    {
      samples.push_back(0.25 * Point(n % 21 - 2, n / 21 % 21 - 2, n / 441 - 2));
      expected.push_back(shapes::windingOf(cells, samples.back()));
    }
    worst = std::max(worst, largestDifference(windingOf(surfaceOf(cells), samples), expected));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 3.2e-16
}

TEST(TriangleSum, IsTheShareOfTheSolidAtVerticesOfTurnedSolids)
{
  SCOPED_TRACE("seed 15");
  // No sample lies in the plane of a triangle but up to rounding, except at its corners.
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(1, Point(3, -1, 2).normalized());
  const Cells cells = randomCells(4, 15);
  const Mesh mesh = surfaceOf(cells);
  const Mesh turned = mesh.mapped([&](const Point& p) -> Point { return turn * p; });
  std::vector<double> expected;
  for (const Point& vertex : mesh.points)
  {
    expected.push_back(shapes::windingOf(cells, vertex));
  }
  const double worst = largestDifference(windingOf(turned, turned.points), expected);
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 2.2e-16
}

TEST(TriangleSum, IsAdditiveOverSoups)
{
  SCOPED_TRACE("seeds 16, 17");
  const Mesh soup = triangleSoup(1000, 16);
  const std::vector<Point> samples = farAndNear(soup, 17);
  const std::vector<double> whole = windingOf(soup, samples);
  std::vector<double> sum = windingOf(soup.part(0, 137), samples);
  const std::vector<double> rest = windingOf(soup.part(137, 1000), samples);
  std::transform(sum.begin(), sum.end(), rest.begin(), sum.begin(), std::plus<>());
  const double error = largestDifference(whole, sum);
  record("error", error);
  EXPECT_LT(error, 1e-12); // measured: 7.8e-16
}

TEST(TriangleSum, CountsDuplicatesTwiceAndCancelsOpposites)
{
  SCOPED_TRACE("seeds 18, 19");
  const Mesh soup = triangleSoup(200, 18);
  const std::vector<Point> samples = farAndNear(soup, 19);
  std::vector<double> twice = windingOf(soup, samples);
  for (double& w : twice)
  {
    w *= 2;
  }
  const std::vector<double> zero(samples.size(), 0);
  const double doubled = largestDifference(windingOf(soup.with(soup), samples), twice);
  const double cancelled = largestDifference(windingOf(soup.with(soup.reversed()), samples), zero);
  record("doubled", doubled);
  record("cancelled", cancelled);
  EXPECT_LT(doubled, 1e-12);   // measured: 4.4e-16
  EXPECT_LT(cancelled, 1e-12); // measured: 1.0e-15
}

TEST(TriangleSum, IgnoresDegenerateTriangles)
{
  SCOPED_TRACE("seed 20");
  Mesh mesh = cube();
  mesh.points.push_back({0.5, 0, 0});
  const std::size_t before = mesh.triangles.size();
  mesh.triangles.push_back({0, 0, 1});
  for (const auto& t : cube().triangles)
  {
    // A needle with three different, collinear corners lies on an edge of each triangle.
    const auto middle = static_cast<std::int32_t>(mesh.points.size());
    mesh.points.push_back(0.5 * (mesh.points[t[0]] + mesh.points[t[1]]));
    mesh.triangles.push_back({t[0], t[1], middle});
  }
  const std::vector<Point> samples = farAndNear(cube(), 20);
  EXPECT_EQ(windingOf(mesh, samples), windingOf(mesh.part(0, before), samples));
}

TEST(TriangleSum, IsFiniteEverywhere)
{
  SCOPED_TRACE("seed 21");
  Mesh mesh = triangleSoup(100, 21).with(icosphere(1));
  std::vector<Point> samples = mesh.points;
  for (const auto& t : mesh.triangles)
  {
    samples.push_back(0.5 * (mesh.points[t[0]] + mesh.points[t[1]]));
    samples.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  }
  for (const double far : {0x1p-1074, 1e-300, 1e10, 1e100, 1e200, 1.7e308})
  {
    samples.push_back({far, 0, 0});
    samples.push_back({far, -far, far});
  }
  for (const double w : windingOf(mesh, samples))
  {
    ASSERT_TRUE(std::isfinite(w));
    ASSERT_LT(std::abs(w), 5);
  }
}

TEST(TriangleSum, IsFiniteAsCloseToVerticesAsNumbersGo)
{
  Mesh mesh = cube();
  const Point corner = mesh.points.front();
  std::vector<Point> samples;
  for (Point& point : mesh.points)
  {
    point -= corner; // only near 0 are there numbers as small as these
    for (const double beside : {0x1p-1074, 8e-317, 1e-308, 1e-300, 1e-200, 1e-160})
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const double sign : {1, -1})
        {
          samples.push_back(point);
          samples.back()[axis] += sign * beside;
        }
      }
    }
  }
  for (const Mesh& part : {mesh, mesh.part(0, mesh.triangles.size() - 1)})
  {
    for (const double w : windingOf(part, samples))
    {
      ASSERT_LE(std::abs(w), 1); // measured: -0.396 to 0.625
    }
  }
}

TEST(TriangleSum, VanishesFarAway)
{
  for (const double far : {1e6, 1e30, 1e100, 1e200, 1.7e308})
  {
    const std::vector<double> values =
      windingOf(openCube(), {{0.5, 0.5, far}, {far, far, far}, {-far, 0, far}});
    for (const double w : values)
    {
      // The missing lid, of area 1, is all that is seen.
      EXPECT_LT(std::abs(w), 1 / (4 * 3.14 * far) / far + 1e-30) << far;
    }
  }
}

TEST(TriangleSum, OfOneSampleDoesNotDependOnTheOthers)
{
  SCOPED_TRACE("seeds 22, 23");
  const winding::Surface surface = clean(triangleSoup(300, 22));
  const TriangleSum sum(surface);
  const std::vector<Point> samples = randomPoints(winding::SampleBlock::capacity, -2, 2, 23);
  const std::vector<double> whole = valuesOf(sum, samples);
  for (std::size_t first = 0; first < samples.size(); first += 17)
  {
    for (const std::size_t count : {1, 2, 3, 5, 9, 16})
    {
      const std::size_t last = std::min(first + count, samples.size());
      const std::vector<double> part =
        valuesOf(sum, {samples.begin() + first, samples.begin() + last});
      ASSERT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + first));
    }
  }
}

TEST(TriangleSum, EqualsTheReferenceValuesOfAnotherProgram)
{
  const std::string folder = WINDING_SHARED_DATA;
  std::ifstream file(folder + "/REFERENCE_W.tsv");
  ASSERT_TRUE(file) << folder;
  std::map<std::string, std::pair<std::vector<Point>, std::vector<double>>> references;
  std::string set, name, kind, line;
  std::getline(file, line);
  float x, y, z;
  for (double w; file >> set >> name >> kind >> x >> y >> z >> w;)
  {
    references[name].first.push_back({x, y, z});
    references[name].second.push_back(w);
  }
  for (const char* known : shapes::present({"bunny_1k.obj", "bunny_10k.obj", "teapot.obj",
         "truck_soup.obj", "self_intersectA.obj", "maxplanck_open_90k.obj"}))
  {
    const auto& [samples, expected] = references[known];
    ASSERT_EQ(samples.size(), 100u) << known;
    const Mesh mesh = readObj(folder + "/" + known);
    ASSERT_GT(mesh.triangles.size(), 0u) << known;
    const double error = largestDifference(windingOf(mesh, samples), expected);
    record(known, error);
    // 12 decimals are given; measured: 4.9e-13.
    EXPECT_LT(error, 1e-11) << known;
  }
}

TEST(TriangleSum, KeepsHalfATurnWhereTheSampleLiesInThePlaneOfAnotherTriangle)
{
  // Two quarters of a turn make −1 − 0i, at the branch cut; the third factor is 1 ± 0i.
  const std::vector<Point> points = {{0, 8, 8}, {0, 0, 0}, {4, 8, 0}, {0, 4, 4}};
  for (const Mesh& mesh : {Mesh{points, {{0, 1, 2}, {0, 1, 2}, {1, 0, 3}}},
         Mesh{points, {{0, 1, 2}, {0, 1, 2}, {0, 1, 3}}}})
  {
    EXPECT_EQ(valuesOf(winding::TriangleSum(clean(mesh)), {{2, 4, 4}})[0], -0.5);
    EXPECT_EQ(valuesOf(winding::TriangleSum(clean(mesh.reversed())), {{2, 4, 4}})[0], 0.5);
  }
}
