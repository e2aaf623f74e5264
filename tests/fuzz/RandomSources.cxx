// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomSources.h"

#include "base/Refusal.h"
#include "support/Serial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fuzz
{

namespace
{

using shapes::Mesh;
using shapes::Point;
using shapes::serial;

using Ids = std::array<std::int32_t, 3>;

void addTriangle(Mesh& mesh, const Point& a, const Point& b, const Point& c)
{
  const auto first = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Point latticePoint(Choices& choices, int size)
{
  const int x = choices.below(size + 1), y = choices.below(size + 1);
  return Point(x, y, choices.below(size + 1));
}

/// Triangles without relation, on a lattice of a few points or anywhere.
Mesh soup(Choices& choices, int triangles)
{
  Mesh mesh;
  const int size = choices.oneIn(3) ? 0 : 1 + choices.below(choices.oneIn(4) ? 17 : 4);
  const auto corner = [&]() -> Point
  {
    return size == 0 ? choices.point(-1, 1) : latticePoint(choices, size);
  };
  for (int i = 0; i < triangles; ++i)
  {
    const Point a = corner(), b = corner();
    addTriangle(mesh, a, b, corner());
  }
  return mesh;
}

/// Tetrahedra with corners on a lattice.
Mesh tetrahedra(Choices& choices, int triangles)
{
  Mesh mesh;
  const int size = 1 + choices.below(4);
  for (int i = 0; i < triangles; i += 4)
  {
    const Point v[4] = {latticePoint(choices, size), latticePoint(choices, size),
      latticePoint(choices, size), latticePoint(choices, size)};
    for (const auto& [a, b, c] : {Ids{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    {
      addTriangle(mesh, v[a], v[b], v[c]);
    }
  }
  return mesh;
}

/// Triangles that share an edge or a vertex, copies of one triangle, or needles.
Mesh fan(Choices& choices, int triangles)
{
  Mesh mesh;
  const int kind = choices.below(4);
  const Point a = choices.point(-1, 1), b = choices.point(-1, 1), c = choices.point(-1, 1);
  for (int i = 0; i < triangles; ++i)
  {
    const Point d = choices.point(-1, 1);
    switch (kind)
    {
    case 0:
      addTriangle(mesh, a, b, d);
      break;
    case 1:
      addTriangle(mesh, a, choices.point(-1, 1), d);
      break;
    case 2:
      choices.oneIn(2) ? addTriangle(mesh, a, b, c) : addTriangle(mesh, a, c, b);
      break;
    default:
      addTriangle(mesh, a + 1e-3 * d, a + 1e-3 * choices.point(-1, 1), b + 1e-3 * d);
    }
  }
  return mesh;
}

/// Removes, repeats and turns triangles, and has some triangles collapse.
void damage(Choices& choices, Mesh& mesh)
{
  std::vector<Ids> kept;
  const int rarity = 4 + choices.below(40);
  for (const Ids& triangle : mesh.triangles)
  {
    const Ids turned = {triangle[0], triangle[2], triangle[1]};
    switch (choices.below(rarity))
    {
    case 0:
      break;
    case 1:
      kept.insert(kept.end(), {triangle, triangle});
      break;
    case 2:
      kept.push_back(turned);
      break;
    case 3:
      kept.insert(kept.end(), {triangle, turned, {triangle[0], triangle[0], triangle[1]}});
      break;
    default:
      kept.push_back(triangle);
    }
  }
  mesh.triangles = kept;
}

/// Makes vertices unusable, and ids.
void spoil(Choices& choices, Mesh& mesh)
{
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const std::int32_t badIds[] = {-1, static_cast<std::int32_t>(mesh.points.size()),
    std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};
  if (!mesh.points.empty() && choices.oneIn(2))
  {
    mesh.points[choices.below(mesh.points.size())][choices.below(3)] = choices.oneOf(bad);
  }
  else if (!mesh.triangles.empty())
  {
    mesh
      .triangles[choices.below(mesh.triangles.size())][static_cast<std::size_t>(choices.below(3))] =
      choices.oneOf(badIds);
  }
}

/// The largest and smallest sizes stay away from where areas and volumes leave the range of double.
double randomScale(Choices& choices)
{
  const double scales[] = {0.1, 1.0 / 3, 1e-3, 1e3, 0x1p-20, 1e-30, 1e30, 1e-80, 1e80};
  return choices.oneIn(3) ? choices.oneOf(scales) : 1;
}

/// Moves, scales, turns, flattens or rounds all points, each now and then.
void transform(Choices& choices, std::vector<Point>& points)
{
  const double scale = randomScale(choices);
  const double shifts[] = {0, 0, 0, -0.7, 1e5, 1.0 / 3};
  const double shift = choices.oneOf(shifts) * scale;
  const bool turns = choices.oneIn(4), flattens = choices.oneIn(12);
  // Beyond that, float has no finite numbers.
  const bool rounds = choices.oneIn(4) && scale < 1e31;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  for (int i = 0; turns && i < 9; ++i)
  {
    matrix(i) = choices.between(-1, 1);
  }
  const int flatAxis = choices.below(3);
  for (Point& p : points)
  {
    p = ((scale * (matrix * p)).array() + shift).matrix();
    if (flattens)
    {
      p[flatAxis] = shift + 1e-9 * (p[flatAxis] - shift);
    }
    if (rounds)
    {
      p = p.cast<float>().cast<double>();
    }
  }
}

/// Gives every triangle corners of its own.
Mesh unwelded(const Mesh& mesh)
{
  Mesh loose;
  for (const Ids& t : mesh.triangles)
  {
    addTriangle(loose, mesh.points[static_cast<std::size_t>(t[0])],
      mesh.points[static_cast<std::size_t>(t[1])], mesh.points[static_cast<std::size_t>(t[2])]);
  }
  return loose;
}

Mesh knownShape(Choices& choices, int mostTriangles)
{
  const auto seed = static_cast<unsigned>(choices.below(1000));
  switch (choices.below(7))
  {
  case 0:
    return shapes::tetrahedron();
  case 1:
    return shapes::cube();
  case 2:
    return shapes::openCube();
  case 3:
    return shapes::icosphere(mostTriangles >= 80 ? 1 : 0);
  case 4:
    return shapes::torus(3 + choices.below(4), 3 + choices.below(3));
  case 5:
    return shapes::moebiusStrip(3 + choices.below(9));
  default:
    return shapes::surfaceOf(shapes::randomCells(mostTriangles >= 80 ? 2 : 1, seed));
  }
}

} // namespace

Mesh randomMesh(Choices& choices, int mostTriangles)
{
  const int triangles = 1 + choices.below(mostTriangles);
  Mesh mesh;
  switch (choices.below(4))
  {
  case 0:
    mesh = soup(choices, triangles);
    break;
  case 1:
    mesh = tetrahedra(choices, triangles);
    break;
  case 2:
    mesh = fan(choices, triangles);
    break;
  default:
    mesh = knownShape(choices, mostTriangles);
  }
  if (choices.oneIn(2))
  {
    damage(choices, mesh);
  }
  if (choices.oneIn(8))
  {
    mesh = mesh.with(mesh.scaled(0.5));
  }
  transform(choices, mesh.points);
  if (choices.oneIn(3))
  {
    mesh = unwelded(mesh);
  }
  if (choices.oneIn(10))
  {
    spoil(choices, mesh);
  }
  return mesh;
}

Mesh randomSolid(Choices& choices)
{
  const auto seed = static_cast<unsigned>(choices.below(1000));
  Mesh mesh = choices.oneIn(2) ? shapes::icosphere(choices.below(2))
              : choices.oneIn(2)
                ? shapes::torus(3 + choices.below(5), 3 + choices.below(4))
                : shapes::surfaceOf(shapes::randomCells(1 + choices.below(3), seed));
  if (choices.oneIn(3))
  {
    mesh = mesh.with(mesh.moved({5, 6, 7}));
  }
  const double scale = randomScale(choices);
  return mesh.scaled(scale);
}

winding::OrientedPointsView RandomCloud::view() const
{
  winding::OrientedPointsView view = cloud.view();
  if (!areas.empty())
  {
    view.areas = winding::ScalarsView(areas.data(), areas.size());
  }
  return view;
}

RandomCloud randomCloud(Choices& choices, int mostPoints)
{
  RandomCloud random;
  const int points = 1 + choices.below(mostPoints);
  const int kind = choices.below(4), size = 1 + choices.below(6);
  const bool hasAreas = choices.oneIn(2), hasUnevenAreas = choices.oneIn(4);
  for (int i = 0; i < points; ++i)
  {
    Point position = kind == 0 ? latticePoint(choices, size) : choices.point(-1, 1);
    Point normal = choices.point(-1, 1);
    if (kind >= 2)
    {
      position = position.norm() > 0 ? position.normalized() : Point(1, 0, 0);
      normal = position;
    }
    random.cloud.positions.push_back(position);
    random.cloud.normals.push_back(normal);
    if (hasAreas)
    {
      const double area = choices.between(0, 0.3);
      random.areas.push_back(hasUnevenAreas ? area * std::exp2(choices.between(-20, 3)) : area);
    }
  }
  std::vector<Point>& positions = random.cloud.positions;
  const bool isHeap = choices.oneIn(8);
  for (std::size_t i = 1; isHeap && i < positions.size(); i += 2)
  {
    positions[i] = positions[0];
  }
  if (!hasAreas)
  {
    transform(choices, positions);
  }
  if (choices.oneIn(10))
  {
    random.cloud.normals[choices.below(positions.size())].setZero();
  }
  return random;
}

winding::Grid randomGrid(Choices& choices, const winding::Bounds& bounds)
{
  winding::Grid grid;
  const Point sizes = bounds.sizes();
  const double longest = sizes.maxCoeff() > 0      ? sizes.maxCoeff()
                         : bounds.min().norm() > 0 ? bounds.min().norm()
                                                   : 1.0;
  const bool isAligned = choices.oneIn(2), isCubic = choices.oneIn(2);
  const int steps = 1 + choices.below(3);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = isCubic || !(sizes[axis] > 0) ? longest : sizes[axis];
    grid.spacing[axis] = extent / steps * (isAligned ? 1 : choices.between(0.5, 1.5));
    grid.firstSample[axis] =
      bounds.min()[axis] - (isAligned ? 1 : choices.between(-0.5, 1.5)) * grid.spacing[axis];
    grid.dimensions[axis] = choices.oneIn(8) ? 1 : 1 + steps + choices.below(3);
  }
  return grid;
}

winding::Extent randomExtent(Choices& choices, const winding::Grid& grid)
{
  winding::Extent extent = grid.wholeExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = choices.below(extent[2 * axis + 1] + 1);
    extent[2 * axis] = first;
    extent[2 * axis + 1] = first + choices.below(extent[2 * axis + 1] - first + 1);
  }
  return extent;
}

std::vector<Point> randomSamples(Choices& choices, const std::vector<Point>& vertices, int count)
{
  winding::Bounds bounds;
  for (const Point& p : vertices)
  {
    bounds.extend(p);
  }
  const double size = std::max(bounds.sizes().maxCoeff(), 1e-3 * bounds.min().norm());
  std::vector<Point> samples;
  for (int i = 0; i < count; ++i)
  {
    const Point a = vertices[choices.below(vertices.size())];
    const Point b = vertices[choices.below(vertices.size())];
    switch (choices.below(8))
    {
    case 0:
      samples.push_back(a);
      break;
    case 1:
      samples.push_back(0.5 * (a + b));
      break;
    case 2:
      samples.push_back(a + size * std::exp2(choices.between(-40, 0)) * choices.point(-1, 1));
      break;
    case 3:
      samples.push_back(bounds.center() + 1e3 * size * choices.point(-1, 1));
      break;
    default:
      samples.push_back(bounds.center() + size * choices.point(-0.7, 0.7));
    }
  }
  return samples;
}

double randomTolerance(Choices& choices)
{
  const double tolerances[] = {1e-2, 1e-2, 1e-2, 1e-3, 1e-3, 1e-3, 1e-3, 1e-4, 1e-4, 1e-5, 1e-6};
  return choices.oneOf(tolerances);
}

std::vector<winding::TrianglesView> viewsOf(const Mesh& mesh)
{
  return {mesh.view()};
}

std::vector<winding::OrientedPointsView> viewsOf(const RandomCloud& cloud)
{
  return {cloud.view()};
}

winding::InsideRule randomRule(Choices& choices)
{
  using winding::InsideRule;
  const InsideRule rules[] = {
    InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd};
  return choices.oneOf(rules);
}

double randomThreshold(Choices& choices)
{
  return choices.oneIn(3) ? choices.between(0.05, 1.5) : 0.5;
}

std::shared_ptr<const winding::Field> randomField(Choices& choices)
{
  using namespace winding;
  FieldOptions options;
  const Method methods[] = {
    Method::automatic, Method::rows, Method::direct, Method::hierarchical, Method::parity};
  options.method = choices.oneOf(methods);
  options.tolerance = randomTolerance(choices);
  try
  {
    if (choices.oneIn(4))
    {
      const RandomCloud cloud = randomCloud(choices, 20);
      options.method = choices.oneIn(2) ? Method::automatic : Method::hierarchical;
      return Field::build(viewsOf(cloud), options, serial);
    }
    const shapes::Mesh mesh = randomMesh(choices, 16);
    return Field::build(viewsOf(mesh), options, serial);
  }
  catch (const Refusal&)
  {
    return nullptr;
  }
}

} // namespace fuzz
