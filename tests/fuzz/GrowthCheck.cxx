// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "report/SurfaceReport.h"
#include "support/Serial.h"
#include "support/ThreadSeconds.h"
#include "surface/Orientation.h"
#include "voxels/CellFractions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

/**
 * @file
 * Sources that crowd at a place: four times as many triangles, in the same place, may take no more
 * than about four times as long. Samples in the plane of a hole take about as long as others.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

constexpr double turn = 6.283185307179586;
constexpr int attempts = 2;

/// The least seconds that work takes in several attempts, on this thread.
template <class Work> double secondsOf(const Work& work)
{
  double least = HUGE_VAL;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    const double start = shapes::threadSeconds();
    work();
    least = std::min(least, shapes::threadSeconds() - start);
  }
  return least;
}

void addTriangle(Mesh& mesh, std::int32_t a, std::int32_t b, std::int32_t c)
{
  mesh.triangles.push_back({a, b, c});
}

/// Triangles that share a vertex and nothing else.
Mesh star(Choices& choices, int count)
{
  Mesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  for (int i = 0; i < count; ++i)
  {
    const Point tip = choices.point(-1, 1);
    mesh.points.push_back(tip);
    mesh.points.emplace_back(tip + 0.01 * choices.point(-1, 1));
    addTriangle(mesh, 0, 2 * i + 1, 2 * i + 2);
  }
  return mesh;
}

/// Triangles that share an edge, all in the same sense there.
Mesh pages(Choices& choices, int count)
{
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}};
  const double width = choices.between(0.7, 1.4);
  for (int i = 0; i < count; ++i)
  {
    const double angle = turn * i / count;
    mesh.points.emplace_back(width * std::cos(angle), width * std::sin(angle), 0.5);
    addTriangle(mesh, 0, 1, i + 2);
  }
  return mesh;
}

/// Triangles about as large as the box of all of them.
Mesh largeTriangles(Choices& choices, int count)
{
  Mesh mesh;
  for (int i = 0; i < count; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.points.push_back(choices.point(-1, 1));
    }
    addTriangle(mesh, 3 * i, 3 * i + 1, 3 * i + 2);
  }
  return mesh;
}

/// Boxes in boxes, turned together.
Mesh nestedBoxes(Choices& choices, int triangles)
{
  const Eigen::Matrix3d rotation =
    choices.oneIn(2) ? Eigen::Matrix3d::Identity()
                     : Eigen::AngleAxisd(choices.between(0, 3), choices.point(-1, 1).normalized())
                         .toRotationMatrix();
  Mesh mesh;
  for (int i = 0; i < triangles / 12; ++i)
  {
    const double size = 1 + i;
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    const Mesh box = shapes::cube(Point::Constant(-size), Point::Constant(size));
    for (const Point& point : box.points)
    {
      mesh.points.emplace_back(rotation * point);
    }
    for (const auto& t : box.triangles)
    {
      addTriangle(mesh, first + t[0], first + t[1], first + t[2]);
    }
  }
  return mesh;
}

void report(const Mesh& mesh)
{
  const Surface surface = shapes::clean(mesh);
  reportOn(surface, edgesOf(surface, serial), serial);
}

void orientFaces(const Mesh& mesh)
{
  const Surface surface = shapes::clean(mesh);
  orient(surface, {}, serial);
}

/// A tetrahedron around all of a mesh, or a smaller one that is like it.
class OneCell final : public CellShapes
{
public:
  explicit OneCell(double size)
    : size_(size)
  {
  }
  std::size_t size() const override { return 1; }
  void get(std::size_t, CellShape& shape) const override
  {
    constexpr int tetrahedron = 10;
    shape.points = {{-4, -4, -4}, {8, -4, -4}, {-4, 8, -4}, {-4, -4, 8}};
    for (Point& point : shape.points)
    {
      point *= size_;
    }
    shape.addFacesOf(tetrahedron);
  }

private:
  double size_;
};

void fractionsIn(const Mesh& mesh, double size)
{
  const auto field = Field::build(viewsOf(mesh), FieldOptions(), serial);
  float fraction = 0;
  evaluateFractions(*field, OneCell(size), winding::InsideTest(), &fraction, serial);
}

void fractions(const Mesh& mesh)
{
  fractionsIn(mesh, 1);
}

void fractionsInside(const Mesh& mesh)
{
  fractionsIn(mesh, 0.2);
}

struct Growing
{
  const char* name;
  Mesh (*make)(Choices& choices, int triangles);
  void (*work)(const Mesh& mesh);
  int triangles;
};

constexpr Growing growing[] = {{"report on a star", star, report, 3000},
  {"report on pages", pages, report, 3000},
  {"report on large triangles", largeTriangles, report, 2000},
  {"report on boxes in boxes", nestedBoxes, report, 6000},
  {"orientation of boxes in boxes", nestedBoxes, orientFaces, 6000},
  {"orientation of pages", pages, orientFaces, 15'000},
  {"fractions of large triangles", largeTriangles, fractions, 600},
  {"fractions among large triangles", largeTriangles, fractionsInside, 600}};

/// A bowl with a rim of so many edges in z = 0.
Mesh bowl(int edges)
{
  constexpr int rings = 60;
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= rings; ++i)
  {
    const double angle = turn / 4 * i / rings;
    profile.push_back({i == 0 ? 0 : std::sin(angle), i == rings ? 0 : -std::cos(angle)});
  }
  return shapes::lathe(profile, edges);
}

std::string checkSlice(Choices& choices)
{
  const Mesh mesh = bowl(500 + choices.below(4000));
  FieldOptions options;
  const auto field = Field::build(viewsOf(mesh), options, serial);
  const bool isGrid = choices.oneIn(2);
  std::vector<Point> points;
  for (int i = 0; i < 20'000; ++i)
  {
    points.push_back(choices.point(-1, 1));
  }
  const auto secondsAt = [&](bool inPlane)
  {
    Grid grid;
    grid.dimensions = {100, 100, 3};
    grid.spacing = {0.02, 0.02, 0.1};
    grid.firstSample = {-1, -1, inPlane ? -0.1 : -0.137};
    std::vector<Point> samples = points;
    for (Point& sample : samples)
    {
      sample[2] = inPlane ? 0 : sample[2];
    }
    return secondsOf(
      [&]
      {
        isGrid ? valuesOf(*field, grid, grid.wholeExtent(), false, serial)
               : valuesOf(*field, samples, false, serial);
      });
  };
  constexpr double most = 3;
  const double expected = secondsAt(false), found = secondsAt(true);
  if (found <= most * expected + 0.01)
  {
    return {};
  }
  std::ostringstream text;
  text << "samples in the plane of a hole take " << found << " s, others " << expected << " s";
  return text.str();
}

} // namespace

std::string checkGrowth(Choices& choices)
{
  const auto kinds = static_cast<int>(std::size(growing));
  const int kind = choices.below(kinds + 1);
  if (kind == kinds)
  {
    return checkSlice(choices);
  }
  // n log n takes 5 times as long for 4 times as many, and n² 16 times.
  constexpr int factor = 4;
  constexpr double most = 8, allowance = 0.01;
  const Growing& growth = growing[kind];
  const Mesh few = growth.make(choices, growth.triangles);
  const Mesh many = growth.make(choices, factor * growth.triangles);
  const double ofFew = secondsOf([&] { growth.work(few); });
  const double ofMany = secondsOf([&] { growth.work(many); });
  if (ofMany <= most * ofFew + allowance)
  {
    return {};
  }
  std::ostringstream text;
  text << growth.name << " takes " << ofFew << " s for " << few.triangles.size()
       << " triangles, and " << ofMany << " s for " << many.triangles.size();
  return text.str();
}

} // namespace fuzz
