// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CellFractions.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "field/Field.h"
#include "support/Fields.h"
#include "support/Interruption.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "support/ThreadSeconds.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>

/**
 * These tests compare fractions with volumes that are known: of axis-parallel boxes through each
 * other, all of them turned together, and of meshes. VTK's types of cells are 10 for tetrahedra, 12
 * for hexahedra and so on.
 */
namespace
{

using namespace shapes;
using winding::Field;
using winding::InsideRule;
using winding::InsideTest;

constexpr int tetra = 10, voxel = 11, hexahedron = 12, wedge = 13, pyramid = 14;

/// Cells in lists.
class CellList final : public winding::CellShapes
{
public:
  std::size_t size() const override { return shapes_.size(); }
  void get(std::size_t cell, winding::CellShape& shape) const override { shape = shapes_[cell]; }

  void add(int type, const std::vector<Point>& points)
  {
    winding::CellShape shape;
    shape.points = points;
    EXPECT_TRUE(shape.addFacesOf(type));
    shapes_.push_back(shape);
  }
  void add(const winding::CellShape& shape) { shapes_.push_back(shape); }

  CellList mapped(const std::function<Point(const Point&)>& map) const
  {
    CellList result = *this;
    for (winding::CellShape& shape : result.shapes_)
    {
      std::transform(shape.points.begin(), shape.points.end(), shape.points.begin(), map);
    }
    return result;
  }
  CellList reversed() const
  {
    CellList result = *this;
    std::reverse(result.shapes_.begin(), result.shapes_.end());
    return result;
  }
  const winding::CellShape& operator[](std::size_t i) const { return shapes_[i]; }

private:
  std::vector<winding::CellShape> shapes_;
};

/// A box's eight corners, in the order of hexahedra.
std::vector<Point> cornersOf(const Point& a, const Point& b)
{
  return {{a[0], a[1], a[2]}, {b[0], a[1], a[2]}, {b[0], b[1], a[2]}, {a[0], b[1], a[2]},
    {a[0], a[1], b[2]}, {b[0], a[1], b[2]}, {b[0], b[1], b[2]}, {a[0], b[1], b[2]}};
}

/// n³ boxes over a cube around the origin, moved by `move` at their inner corners.
CellList boxes(int n, double size, const std::function<Point(const Point&)>& move)
{
  CellList cells;
  const auto at = [&](int i)
  {
    return size * (2.0 * i / n - 1);
  };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        cells.add(hexahedron, cornersOf({at(i), at(j), at(k)}, {at(i + 1), at(j + 1), at(k + 1)}));
      }
    }
  }
  return cells.mapped(move);
}

Point still(const Point& p)
{
  return p;
}

/// The same boxes, each in six tetrahedra around a diagonal.
CellList tetrahedraOf(const CellList& hexahedra)
{
  CellList cells;
  for (std::size_t i = 0; i < hexahedra.size(); ++i)
  {
    const std::vector<Point>& p = hexahedra[i].points;
    for (const auto& [a, b] : {std::pair(1, 2), {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
    {
      cells.add(tetra, {p[0], p[std::size_t(a)], p[std::size_t(b)], p[6]});
    }
  }
  return cells;
}

std::vector<float> fractionsOf(const Field& field, const winding::CellShapes& cells,
  const InsideTest& isInside = {}, winding::CellsWithoutFraction* counts = nullptr)
{
  std::vector<float> fractions(cells.size(), -1.0F);
  const winding::CellsWithoutFraction found =
    winding::evaluateFractions(field, cells, isInside, fractions.data(), serial);
  if (counts)
  {
    *counts = found;
  }
  return fractions;
}

/// The volume of a cell with planar faces.
double volumeOf(const winding::CellShape& shape)
{
  double volume = 0;
  for (std::size_t face = 0; face < shape.faces(); ++face)
  {
    const int* const corners = shape.faceCorners.data() + shape.faceEnds[face];
    const auto at = [&](int i) -> Point
    {
      return shape.points[std::size_t(corners[i])] - shape.points[0];
    };
    for (int i = 2; i < shape.faceEnds[face + 1] - shape.faceEnds[face]; ++i)
    {
      volume += at(0).dot(at(i - 1).cross(at(i))) / 6;
    }
  }
  return volume;
}

double insideOf(const CellList& cells, const std::vector<float>& fractions)
{
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    sum += volumeOf(cells[i]) * static_cast<double>(fractions[i]);
  }
  return sum;
}

struct Box
{
  Point low, high;
  int sign; ///< −1 for a box whose faces look inward
};

/// The exact share of a box that is inside of others: volumes between all their planes.
double exactShare(
  const Point& low, const Point& high, const std::vector<Box>& solids, const InsideTest& isInside)
{
  std::array<std::vector<double>, 3> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& own = planes[std::size_t(axis)];
    own = {low[axis], high[axis]};
    for (const Box& box : solids)
    {
      own.push_back(std::clamp(box.low[axis], low[axis], high[axis]));
      own.push_back(std::clamp(box.high[axis], low[axis], high[axis]));
    }
    std::sort(own.begin(), own.end());
  }
  double inside = 0;
  for (std::size_t k = 1; k < planes[2].size(); ++k)
  {
    for (std::size_t j = 1; j < planes[1].size(); ++j)
    {
      for (std::size_t i = 1; i < planes[0].size(); ++i)
      {
        const Point a(planes[0][i - 1], planes[1][j - 1], planes[2][k - 1]);
        const Point b(planes[0][i], planes[1][j], planes[2][k]);
        const Point middle = 0.5 * (a + b);
        int w = 0;
        for (const Box& box : solids)
        {
          const bool isIn =
            (middle.array() > box.low.array()).all() && (middle.array() < box.high.array()).all();
          w += isIn ? box.sign : 0;
        }
        inside += isInside(w) ? (b - a).prod() : 0;
      }
    }
  }
  return inside / (high - low).prod();
}

TEST(CellFractions, AreTheSharesOfBoxesThroughEachOther)
{
  constexpr unsigned seed = 5;
  Random random(seed);
  double worst = 0;
  for (int trial = 0; trial < 40; ++trial)
  {
    std::vector<Box> solids;
    Mesh mesh;
    const int count = 1 + trial % 5;
    for (int i = 0; i < count; ++i)
    {
      // Every third trial has boxes on a lattice, so that faces lie on each other and on cells.
      Point a = random.point(-1, 1);
      Point b = random.point(-1, 1);
      if (trial % 3 == 0)
      {
        a = (4 * a).array().round() / 4;
        b = (4 * b).array().round() / 4;
      }
      const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
      if (((high - low).array() <= 0).any())
      {
        continue;
      }
      const int sign = trial % 4 == 3 && i % 2 == 1 ? -1 : 1;
      solids.push_back({low, high, sign});
      mesh = mesh.with(sign > 0 ? cube(low, high) : cube(low, high).reversed());
    }
    if (solids.empty())
    {
      continue;
    }
    const Eigen::Quaterniond turn =
      trial % 2 == 0 ? Eigen::Quaterniond::Identity()
                     : Eigen::Quaterniond(Eigen::AngleAxisd(1 + trial, random.direction()));
    const auto turned = [&turn](const Point& p) -> Point
    {
      return turn * p;
    };
    const CellList cells = boxes(4, 1.0, still);
    const std::shared_ptr<const Field> field = fieldOf(mesh.mapped(turned));
    const CellList turnedCells = cells.mapped(turned);
    for (const InsideTest& isInside : {InsideTest(), {InsideRule::signedThreshold, 1.5},
           {InsideRule::signedThreshold, -0.5}, {InsideRule::absoluteThreshold}, {InsideRule::odd}})
    {
      const std::vector<float> fractions = fractionsOf(*field, turnedCells, isInside);
      for (std::size_t i = 0; i < cells.size(); ++i)
      {
        const double exact = exactShare(cells[i].points[0], cells[i].points[6], solids, isInside);
        worst = std::max(worst, std::abs(exact - static_cast<double>(fractions[i])));
        ASSERT_NEAR(fractions[i], exact, 1e-6) << "trial " << trial << ", cell " << i << ", rule "
                                               << int(isInside.rule) << ", seed " << seed;
      }
    }
  }
  record("worst error", worst); // 3e-8, the rounding of fractions to float
}

/// A mesh as one cell.
CellList cellOf(const Mesh& mesh)
{
  winding::CellShape shape;
  shape.points = mesh.points;
  for (const std::array<std::int32_t, 3>& ids : mesh.triangles)
  {
    shape.addFace(ids.data(), 3);
  }
  CellList cells;
  cells.add(shape);
  return cells;
}

/// A cube in cells of all linear types, its corners from −s to s.
CellList cellsOfAllTypes(double s)
{
  const Point low(-s, -s, -s), middle(0, 0, 0), high(s, s, s);
  CellList cells;
  const auto part = [&](double x0, double y0, double z0, double x1, double y1, double z1)
  {
    return cornersOf({x0, y0, z0}, {x1, y1, z1});
  };
  const std::vector<Point> first = part(-s, -s, -s, 0, s, s), second = part(0, -s, -s, s, s, 0);
  // Six pyramids to the middle of the first half.
  Point top(-s / 2, 0, 0);
  winding::CellShape box;
  box.points = first;
  EXPECT_TRUE(box.addFacesOf(hexahedron));
  for (std::size_t face = 0; face < 6; ++face)
  {
    const int* const ids = box.faceCorners.data() + box.faceEnds[face];
    cells.add(pyramid, {first[std::size_t(ids[3])], first[std::size_t(ids[2])],
                         first[std::size_t(ids[1])], first[std::size_t(ids[0])], top});
  }
  // Two wedges.
  const std::vector<Point>& p = second;
  cells.add(wedge, {p[0], p[2], p[1], p[4], p[6], p[5]});
  cells.add(wedge, {p[0], p[3], p[2], p[4], p[7], p[6]});
  // A voxel, and prisms of five and six sides over a square with points on its sides.
  const std::vector<Point> third = part(0, -s, 0, s, 0, s);
  cells.add(
    voxel, {third[0], third[1], third[3], third[2], third[4], third[5], third[7], third[6]});
  const std::vector<Point> fourth = part(0, 0, 0, s / 2, s, s), fifth = part(s / 2, 0, 0, s, s, s);
  const auto between = [](const Point& a, const Point& b) -> Point
  {
    return 0.5 * (a + b);
  };
  cells.add(15, {fourth[0], fourth[1], fourth[2], fourth[3], between(fourth[3], fourth[0]),
                  fourth[4], fourth[5], fourth[6], fourth[7], between(fourth[7], fourth[4])});
  cells.add(16, {fifth[0], fifth[1], between(fifth[1], fifth[2]), fifth[2], fifth[3],
                  between(fifth[3], fifth[0]), fifth[4], fifth[5], between(fifth[5], fifth[6]),
                  fifth[6], fifth[7], between(fifth[7], fifth[4])});
  return cells;
}

/// Moves points so that the faces of boxes between them are not planar, and their border stays.
Point warped(const Point& p)
{
  const double inner = (1 - p[0] * p[0]) * (1 - p[1] * p[1]) * (1 - p[2] * p[2]);
  return p + 0.1 * inner * Point(std::sin(7 * p[1]), std::cos(5 * p[2]), std::sin(6 * p[0]));
}

TEST(CellFractions, AddUpToTheVolumeInCellsOfAllTypes)
{
  const Mesh sphere = icosphere(3).scaled(0.9);
  const double volume = volumeOf(cellOf(sphere)[0]);
  const auto field = fieldOf(sphere);
  const CellList hexahedra = boxes(9, 1.0, still);
  for (const CellList& cells : {hexahedra, tetrahedraOf(hexahedra),
         tetrahedraOf(boxes(7, 1, warped)), boxes(1, 1.3, still), cellsOfAllTypes(1)})
  {
    double all = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      EXPECT_NE(volumeOf(cells[i]), 0);
      all += std::abs(volumeOf(cells[i]));
    }
    EXPECT_GE(all, 8 * (1 - 1e-12));
    // 3e-9, by the rounding of fractions to float
    EXPECT_NEAR(insideOf(cells, fractionsOf(*field, cells)), volume, 1e-7 * volume);
  }
}

TEST(CellFractions, AddUpWhereSheetsMeetAtCornersAndEdges)
{
  constexpr unsigned seed = 11;
  Random random(seed);
  const auto latticePoint = [&random]() -> Point
  {
    const double x = std::floor(random(0, 4)), y = std::floor(random(0, 4));
    return {x, y, std::floor(random(0, 4))};
  };
  double worst = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    // Tetrahedra with corners on a lattice of 4³ points, which are turned either way or flat.
    Mesh mesh;
    for (int i = 0; i < 3; ++i)
    {
      Mesh one = tetrahedron();
      for (Point& point : one.points)
      {
        point = latticePoint();
      }
      mesh = mesh.with(one);
    }
    const auto field = fieldOf(mesh);
    const double low = trial % 3 == 0 ? 1 : random(0, 1);
    const Point corner(low, low, low), size = random.point(1, 3);
    CellList cells;
    cells.add(hexahedron, cornersOf(corner, corner + size));
    const CellList parts = tetrahedraOf(cells);
    for (const InsideRule rule :
      {InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd})
    {
      const std::vector<float> whole = fractionsOf(*field, cells, {rule});
      const std::vector<float> fractions = fractionsOf(*field, parts, {rule});
      const double sum = std::accumulate(fractions.begin(), fractions.end(), 0.0) / 6;
      worst = std::max(worst, std::abs(sum - static_cast<double>(whole[0])));
      ASSERT_NEAR(sum, whole[0], 1e-6) << "trial " << trial << ", seed " << seed;
    }
  }
  record("worst error", worst); // 3e-8
}

TEST(CellFractions, AreExactWhereAWallIsSeenEdgeOn)
{
  // The walls lie in planes through the apex of the cell, or next to it: a box through one of them
  // lacked what is beyond it, 17 % of the share.
  const Point apex(0.45845, 0.47975, 0.43715); // where it is tried first
  CellList cells;
  cells.add(hexahedron, cornersOf({0, 0, 0}, {1, 1, 1}));
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double distance : {0.0, 1e-13, 1e-10, 2e-9, 1e-7})
    {
      Box wall{{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 1}, through{{0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}, 1};
      wall.low[axis] = apex[axis] + distance;
      wall.low[(axis + 2) % 3] = 0.6;
      through.low[axis] = 0.1;
      through.low[(axis + 2) % 3] = 0.7;
      const std::vector<Box> solids = {wall, through};
      const auto field = fieldOf(cube(wall.low, wall.high).with(cube(through.low, through.high)));
      for (const InsideRule rule : {InsideRule::signedThreshold, InsideRule::odd})
      {
        const double share = exactShare({0, 0, 0}, {1, 1, 1}, solids, {rule});
        const double found = static_cast<double>(fractionsOf(*field, cells, {rule})[0]);
        worst = std::max(worst, std::abs(found - share));
      }
      EXPECT_LT(worst, 1e-7) << "axis " << axis << ", distance " << distance;
    }
  }
  record("worst error", worst); // 5e-9
}

TEST(CellFractions, AddUpWhereThinSolidsPassThroughEachOther)
{
  // Two tetrahedra and a triangle there twice, flattened to a billionth: 2.7e-4 of the block were
  // inside where their sides were lost, or layers on each other had no order.
  Mesh mesh;
  mesh.points = {{3, 0, 1}, {2, 3, 1}, {0, 2, 3}, {2, 1, 1}, {2, 2, 0}, {2, 2, 2}, {2, 1, 3},
    {3, 3, 1}, {1, 3, 0}, {2, 1, 2}, {3, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}, {4, 5, 6}, {6, 5, 4}, {7, 8, 9},
    {7, 9, 10}, {7, 10, 8}, {9, 8, 10}};
  const auto flattened = [](const Point& p) -> Point
  {
    return Point(1e-9 * p[0], p[1], p[2]).array() - 0.7;
  };
  const auto field = fieldOf(mesh.mapped(flattened));
  const Point corner = flattened({1, 1.5, 0.5});
  Eigen::Matrix3d sides;
  sides.col(0) = Point(-0.7606421698521838, 1.665886130289084, 3.381552620549962);
  sides.col(1) = Point(-2.979788624316246, 3.26752722991553, 3.369887671980474);
  sides.col(2) = Point(1.794097709620591, -0.1340558717790660, 3.255736073046562);
  const auto part = [&](double low, double high)
  {
    CellList cells;
    cells.add(hexahedron, cornersOf({low, 0, 0}, {high, 1, 1}));
    return cells.mapped([&](const Point& p) -> Point { return corner + sides * p; });
  };
  constexpr double length = 0.43163751848539533;
  double largest = 0;
  for (const InsideRule rule :
    {InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd})
  {
    for (const CellList& cells : {part(0, 1), part(0, length), part(length, 1),
           tetrahedraOf(part(0, 1)), tetrahedraOf(part(0, length))})
    {
      for (const float fraction : fractionsOf(*field, cells, {rule}))
      {
        largest = std::max(largest, static_cast<double>(fraction));
        EXPECT_LT(fraction, 1e-9) << "rule " << static_cast<int>(rule);
      }
    }
  }
  record("largest fraction", largest); // 2e-11
}

TEST(CellFractions, AddUpInHexahedraWithFacesThatAreNotPlanar)
{
  const Mesh sphere = icosphere(3).scaled(0.7);
  const double volume = volumeOf(cellOf(sphere)[0]);
  const CellList cells = boxes(7, 1, warped);
  const std::vector<float> fractions = fractionsOf(*fieldOf(sphere), cells);
  // The trilinear volume is the mean of those with faces cut along either diagonal.
  double inside = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    winding::CellShape turned = cells[i];
    for (std::size_t face = 0; face < 6; ++face)
    {
      int* const ids = turned.faceCorners.data() + turned.faceEnds[face];
      std::rotate(ids, ids + 1, ids + 4);
    }
    inside += 0.5 * (volumeOf(cells[i]) + volumeOf(turned)) * static_cast<double>(fractions[i]);
  }
  EXPECT_NEAR(inside, volume, 1e-7 * volume);
}

TEST(CellFractions, OfACellThatIsTheSolidAreOne)
{
  // All triangles lie in the faces of the cells.
  const Mesh sphere = icosphere(2), ring = torus(24, 12);
  for (const Mesh& mesh : {sphere, ring, sphere.moved({1e6, -3e6, 2e6})})
  {
    EXPECT_FLOAT_EQ(fractionsOf(*fieldOf(mesh), cellOf(mesh))[0], 1);
    EXPECT_FLOAT_EQ(fractionsOf(*fieldOf(mesh), cellOf(mesh.reversed()))[0], 1);
  }
  EXPECT_NEAR(fractionsOf(*fieldOf(ring), cellOf(icosphere(2).scaled(2)))[0],
    volumeOf(cellOf(ring)[0]) / (8 * volumeOf(cellOf(sphere)[0])), 1e-6);
}

TEST(CellFractions, AreNaNNowhereAndZeroOrOneWithoutVolume)
{
  const auto field = fieldOf(icosphere(2));
  CellList cells;
  std::vector<Point> points = cornersOf({0, 0, 0}, {1, 1, 1});
  points[3][1] = std::numeric_limits<double>::infinity();
  cells.add(hexahedron, points);
  winding::CellShape shape;
  cells.add(shape);
  cells.add(tetra, {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}});
  cells.add(tetra, {{3, 0, 0}, {3, 0, 0}, {3, 0, 0}, {3, 0, 0}});
  shape.points = {{0.1, 0.2, 0.3}, {0.2, 0.2, 0.1}};
  cells.add(shape);
  winding::CellsWithoutFraction counts;
  const std::vector<float> fractions = fractionsOf(*field, cells, {}, &counts);
  EXPECT_TRUE(std::isnan(fractions[0]));
  EXPECT_TRUE(std::isnan(fractions[1]));
  EXPECT_EQ(fractions[2], 1);
  EXPECT_EQ(fractions[3], 0);
  EXPECT_EQ(fractions[4], 1);
  EXPECT_EQ(counts.nowhere, 2U);
  EXPECT_EQ(counts.flat, 3U);
}

TEST(CellFractions, AreNaNWhereFacesDoNotClose)
{
  const auto field = fieldOf(cube(Point(-2, -2, -2), Point(0.5, 2, 2)));
  winding::CellShape box;
  box.points = cornersOf({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(box.addFacesOf(hexahedron));
  EXPECT_TRUE(box.isClosed());
  winding::CellShape lacking, turned, inverted, doubled;
  for (winding::CellShape* shape : {&lacking, &turned, &inverted})
  {
    shape->points = box.points;
  }
  for (std::size_t face = 0; face < box.faces(); ++face)
  {
    const std::vector<int> ids(box.faceCorners.begin() + box.faceEnds[face],
      box.faceCorners.begin() + box.faceEnds[face + 1]);
    const std::vector<int> back(ids.rbegin(), ids.rend());
    if (face != 2)
    {
      lacking.addFace(ids.data(), 4);
    }
    turned.addFace(face == 2 ? back.data() : ids.data(), 4);
    inverted.addFace(back.data(), 4);
    // Corners of its own for each face are corners of the others, too.
    std::vector<int> own;
    for (const int id : ids)
    {
      own.push_back(static_cast<int>(doubled.points.size()));
      doubled.points.push_back(box.points[std::size_t(id)]);
    }
    doubled.addFace(own.data(), 4);
  }
  // One face has a corner on an edge, and its neighbour has none there.
  winding::CellShape hanging = box;
  hanging.points.push_back(
    (box.points[std::size_t(box.faceCorners[0])] + box.points[std::size_t(box.faceCorners[1])]) /
    2);
  hanging.faceCorners.insert(
    hanging.faceCorners.begin() + 1, static_cast<int>(hanging.points.size()) - 1);
  std::for_each(
    hanging.faceEnds.begin() + 1, hanging.faceEnds.end(), [](int& faceEnd) { ++faceEnd; });
  hanging.areLinear = false;
  EXPECT_TRUE(hanging.isClosed());
  CellList cells;
  for (const winding::CellShape& shape : {box, lacking, turned, inverted, doubled, hanging})
  {
    cells.add(shape);
  }
  winding::CellsWithoutFraction counts;
  const std::vector<float> fractions = fractionsOf(*field, cells, {}, &counts);
  EXPECT_FLOAT_EQ(fractions[0], 0.5F);
  EXPECT_TRUE(std::isnan(fractions[1]));
  EXPECT_TRUE(std::isnan(fractions[2]));
  EXPECT_FLOAT_EQ(fractions[3], 0.5F);
  EXPECT_FLOAT_EQ(fractions[4], 0.5F);
  EXPECT_FLOAT_EQ(fractions[5], 0.5F);
  EXPECT_EQ(counts.open, 2U);
  EXPECT_EQ(counts.flat + counts.nowhere, 0U);
  EXPECT_EQ(winding::sentenceOf(winding::warningsOf(counts, 6).at(0)),
    "2 of 6 cells are not closed; a face of each is missing or turned: they have no fraction");
}

/// Cells that a solid only touches, or fills, have no share of 1e-17 of it, nor lack one.
TEST(CellFractions, AreZeroWhereASolidOnlyTouches)
{
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()));
  const auto turned = [&turn](const Point& p) -> Point
  {
    return turn * p;
  };
  const auto field = fieldOf(cube(Point(-0.4, -0.4, -0.4), Point(0.4, 0.4, 0.4)).mapped(turned));
  const CellList cells = boxes(10, 1, still);
  const std::vector<float> fractions = fractionsOf(*field, cells.mapped(turned));
  const auto between = std::count_if(
    fractions.begin(), fractions.end(), [](float share) { return share > 0 && share < 0.1F; });
  EXPECT_EQ(between, 0);
}

TEST(CellFractions, OfThinCellsAndFarFromTheOriginStay)
{
  // Layers at a wall, 1e-5 of their width high; a fifth of each is inside of a box.
  for (const double far : {0.0, 1e8})
  {
    CellList cells;
    const Point at(far, 0.5 * far, -far);
    cells.add(hexahedron, cornersOf(at, at + Point(1, 1, far > 0 ? 0.25 : 1e-5)));
    const Mesh solid = cube(at + Point(0.25, 0.1, -1), at + Point(0.5, 0.9, 1));
    EXPECT_NEAR(fractionsOf(*fieldOf(solid), cells)[0], 0.2, far > 0 ? 1e-6 : 1e-6);
  }
}

TEST(CellFractions, DependOnTheCellAlone)
{
  const Mesh mesh = icosphere(3).with(
    icosphere(2).mapped([](const Point& p) -> Point { return 0.8 * p + Point(0.7, 0.2, 0.1); }));
  const auto field = fieldOf(mesh);
  const CellList cells = boxes(8, 1.2, warped);
  const std::vector<float> fractions = fractionsOf(*field, cells);
  std::vector<float> reversed = fractionsOf(*field, cells.reversed());
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(reversed, fractions);
  for (unsigned seed = 1; seed < 4; ++seed)
  {
    ShuffledThreads threads(seed);
    std::vector<float> again(cells.size());
    winding::evaluateFractions(*field, cells, InsideTest(), again.data(), threads);
    EXPECT_EQ(again, fractions) << "seed " << seed;
  }
  Mesh turned = mesh;
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  for (std::array<std::int32_t, 3>& ids : turned.triangles)
  {
    std::rotate(ids.begin(), ids.begin() + 1, ids.end());
  }
  EXPECT_EQ(fractionsOf(*fieldOf(turned), cells), fractions);
}

/// Two blocks of squares of different sizes, whose faces are `gap` apart.
std::shared_ptr<const Field> layers(double gap)
{
  const auto block = [](int squares)
  {
    Cells cells;
    for (int i = 0; i < squares * squares; ++i)
    {
      cells.insert({i % squares, i / squares, 0});
    }
    return surfaceOf(cells).mapped(
      [&](const Point& p) -> Point { return Point(p[0], p[1], p[2] * squares) / squares; });
  };
  return fieldOf(block(20).with(block(23).moved({0, 0, 1 + gap})));
}

TEST(CellFractions, TakeNoLongerWhereLayersAreNearEachOther)
{
#ifndef NDEBUG
  GTEST_SKIP() << "sanitizers and checks of Eigen's slow some loops down more than others";
#endif
  const CellList cells =
    boxes(4, 1.1, [](const Point& p) -> Point { return p + Point(0.5, 0.5, 1); });
  const std::vector<double> gaps = {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  std::vector<std::shared_ptr<const Field>> fields;
  std::transform(gaps.begin(), gaps.end(), std::back_inserter(fields), layers);
  std::vector<double> least(gaps.size(), std::numeric_limits<double>::infinity());
  for (int run = 0; run < 9; ++run)
  {
    for (std::size_t i = 0; i < gaps.size(); ++i)
    {
      const double start = threadSeconds();
      fractionsOf(*fields[i], cells);
      least[i] = std::min(least[i], threadSeconds() - start);
    }
  }
  // Measured 0.93 to 1.04 times as long as the first. Where near faces are cut at each other's
  // sides, as touching ones are, 2.1 to 2.9 times from 1e-8 on.
  for (std::size_t i = 1; i < gaps.size(); ++i)
  {
    EXPECT_LT(least[i], 1.5 * least[0]) << "gap " << gaps[i];
  }
}

TEST(CellFractions, OfTanglesAreMeansOverRays)
{
  // Boxes turned at random, all through each other, in one cell: n³ pieces. Samples say how much of
  // it is inside, with a standard deviation of 0.001.
  for (const unsigned seed : {811U, 812U, 813U})
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh tangle;
    for (int i = 0; i < 60; ++i)
    {
      const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(random(0, 6), random.direction()).toRotationMatrix();
      const Point middle = random.point(-1, 1), size = random.point(0.2, 1.5);
      const Mesh box =
        cube(-size, size).mapped([&](const Point& p) -> Point { return middle + turn * p; });
      tangle = tangle.with(random.bits() % 3 == 0 ? box.reversed() : box);
    }
    const auto field = fieldOf(tangle);
    CellList cell;
    const std::vector<Point> corners = {{-4, -4, -4}, {8, -4, -4}, {-4, 8, -4}, {-4, -4, 8}};
    cell.add(tetra, corners);
    for (const double threshold : {0.5, 3.5})
    {
      std::vector<Point> samples;
      for (int i = 0; i < 60'000; ++i)
      {
        Point weights = random.point(0, 1);
        while (weights.sum() > 1)
        {
          weights = random.point(0, 1);
        }
        samples.push_back(Point::Constant(-4) + 12 * weights);
      }
      std::vector<unsigned char> inside(samples.size());
      winding::FieldOutput output;
      output.inside = inside.data();
      output.isInside.threshold = threshold;
      field->evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, serial);
      const double expected =
        static_cast<double>(std::count(inside.begin(), inside.end(), 1)) / 60'000;
      float found = 0;
      winding::evaluateFractions(*field, cell, output.isInside, &found, serial);
      EXPECT_NEAR(found, expected, 0.006) << threshold; // measured: 0.0014
    }
  }
}

TEST(CellFractions, CanBeInterruptedWithinAnOpenCell)
{
  class LargestRun final : public winding::Executor
  {
  public:
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      blocks = std::max(blocks, count);
      winding::SerialExecutor().run(count, work);
    }
    std::size_t blocks = 0;
  };
  CellList cell;
  cell.add(tetra, {{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}});
  float found = 0;
  LargestRun executor;
  winding::evaluateFractions(*fieldOf(triangleSoup(300, 5)), cell, InsideTest(), &found, executor);
  EXPECT_GE(executor.blocks, 200u); // an interrupt is seen between blocks
}

TEST(CellFractions, CanBeInterrupted)
{
  const auto field = fieldOf(icosphere(2));
  const auto open = fieldOf(icosphere(2).part(0, 300));
  const CellList cells = boxes(6, 1.2, still);
  for (const auto& source : {field, open})
  {
    int interruptions = 0;
    for (int runs = 0;; ++runs)
    {
      Interruption interruption(runs);
      std::vector<float> fractions(cells.size());
      if (isCompleted(
            [&] {
              winding::evaluateFractions(
                *source, cells, InsideTest(), fractions.data(), interruption);
            }))
      {
        break;
      }
      ++interruptions;
    }
    EXPECT_GE(interruptions, 3);
  }
}

/// The share of 20³ samples of a box.
double sampledShare(const Field& field, const winding::CellShape& box)
{
  constexpr int perAxis = 20;
  std::vector<Point> samples;
  const Point low = box.points[0], size = box.points[6] - low;
  for (int i = 0; i < perAxis * perAxis * perAxis; ++i)
  {
    const Point at(i % perAxis + 0.5, i / perAxis % perAxis + 0.5, i / perAxis / perAxis + 0.5);
    samples.push_back(low + (size.array() * at.array() / perAxis).matrix());
  }
  std::vector<unsigned char> inside(samples.size());
  winding::FieldOutput output;
  output.inside = inside.data();
  field.evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, serial);
  return static_cast<double>(std::count(inside.begin(), inside.end(), 1)) /
         static_cast<double>(inside.size());
}

/// A cell that meets no triangle has a share where w passes the threshold, too.
TEST(CellFractions, AreNearThoseOfSamplesInOpenings)
{
  const auto field = fieldOf(shapes::openCube());
  CellList cells;
  cells.add(hexahedron, cornersOf({0.8319, 0.1802, 0.8253}, {0.9716, 0.4952, 1.5866}));
  const double sampled = sampledShare(*field, cells[0]);
  EXPECT_GT(sampled, 0.1);
  EXPECT_NEAR(fractionsOf(*field, cells)[0], sampled, 0.05); // measured: 0.023, a layer of samples
}

TEST(CellFractions, AreNearThoseOfSamplesWhereSourcesAreOpen)
{
  const Cloud points = sphereCloud(400);
  const auto cloud = fieldOf(points);
  const auto open = fieldOf(icosphere(3).part(0, 1000));
  const auto soup = fieldOf(triangleSoup(100, 71));
  const CellList cells = boxes(6, 1.2, still);
  struct Case
  {
    const char* name;
    std::shared_ptr<const Field> field;
    double worst, mean; ///< limits of errors
  };
  // Measured: 0.006 and 0.0014, 0.022 and 0.006, 0.014 and 0.004; the samples miss 0.003.
  for (const Case& source :
    {Case{"open", open, 0.012, 0.003}, {"cloud", cloud, 0.04, 0.01}, {"soup", soup, 0.03, 0.01}})
  {
    const std::vector<float> fractions = fractionsOf(*source.field, cells);
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const bool isPartial = fractions[i] > 0 && fractions[i] < 1;
      if (!isPartial && i % 7 != 0)
      {
        continue;
      }
      const double error =
        std::abs(sampledShare(*source.field, cells[i]) - static_cast<double>(fractions[i]));
      EXPECT_LE(error, source.worst) << source.name << ", cell " << i;
      sum += isPartial ? error : 0;
      count += isPartial ? 1 : 0;
    }
    EXPECT_GT(count, 10) << source.name;
    EXPECT_LE(sum / count, source.mean) << source.name;
    record(std::string("mean error, ") + source.name, sum / count);
  }
}

} // namespace
