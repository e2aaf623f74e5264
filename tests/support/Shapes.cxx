// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/Shapes.h"
#include "base/Pi.h"
#include "support/Serial.h"

#include "source/Sanitize.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace shapes
{

namespace
{

/// Builds a mesh from coordinates; quadrilaterals share points with equal coordinates.
class Builder
{
public:
  std::int32_t id(const Point& point)
  {
    const auto found =
      ids_.emplace(std::array<double, 3>{point[0], point[1], point[2]}, mesh_.points.size());
    if (found.second)
    {
      mesh_.points.push_back(point);
    }
    return static_cast<std::int32_t>(found.first->second);
  }
  void quad(const Point& a, const Point& b, const Point& c, const Point& d)
  {
    mesh_.triangles.push_back({id(a), id(b), id(c)});
    mesh_.triangles.push_back({id(a), id(c), id(d)});
  }
  const Mesh& mesh() const { return mesh_; }

private:
  Mesh mesh_;
  std::map<std::array<double, 3>, std::size_t> ids_;
};

} // namespace

winding::TrianglesView Mesh::view() const
{
  return {{points.empty() ? nullptr : points[0].data(), points.size()},
    {triangles.empty() ? nullptr : triangles[0].data(), triangles.size()}};
}

Mesh Mesh::reversed() const
{
  Mesh result = *this;
  for (auto& triangle : result.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return result;
}

Mesh Mesh::mapped(const std::function<Point(const Point&)>& map) const
{
  Mesh result = *this;
  std::transform(points.begin(), points.end(), result.points.begin(), map);
  return result;
}

Mesh Mesh::moved(const Point& by) const
{
  return this->mapped([&by](const Point& p) -> Point { return p + by; });
}

Mesh Mesh::scaled(double factor) const
{
  return this->mapped([factor](const Point& p) -> Point { return factor * p; });
}

Mesh Mesh::with(const Mesh& other) const
{
  Mesh result = *this;
  const auto offset = static_cast<std::int32_t>(points.size());
  result.points.insert(result.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
  {
    result.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return result;
}

Mesh Mesh::part(std::size_t first, std::size_t last) const
{
  Mesh result;
  result.points = points;
  for (std::size_t i = first; i < last; ++i)
  {
    result.triangles.push_back(triangles[i]);
  }
  return result;
}

winding::Surface clean(const Mesh& mesh)
{
  return winding::sanitize(std::vector<winding::TrianglesView>{mesh.view()}, serial);
}

winding::Surface cleanScaled(const Mesh& mesh, double factor)
{
  winding::Surface surface = clean(mesh);
  surface.bounds.setEmpty();
  for (Point& vertex : surface.vertices)
  {
    vertex *= factor;
    surface.bounds.extend(vertex);
  }
  return surface;
}

winding::BoundaryChain boundaryOf(const winding::Surface& surface)
{
  return winding::boundaryChain(surface, serial);
}

Mesh tetrahedron()
{
  return {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Mesh cube(const Point& low, const Point& high)
{
  const Point size = high - low;
  // The faces at z = high come last, so that the open cube is a part of this one.
  return surfaceOf({{0, 0, 0}})
    .mapped([&](const Point& p) -> Point { return low + p.cwiseProduct(size); });
}

Mesh openCube()
{
  return cube().part(0, 10);
}

Mesh cubeWithSlit(double width)
{
  Mesh rest = cube();
  Mesh side{rest.points, {}};
  const auto isOfSide = [&rest](const std::array<std::int32_t, 3>& t)
  {
    return rest.points[t[0]][0] + rest.points[t[1]][0] + rest.points[t[2]][0] == 3;
  };
  std::copy_if(
    rest.triangles.begin(), rest.triangles.end(), std::back_inserter(side.triangles), isOfSide);
  rest.triangles.erase(
    std::remove_if(rest.triangles.begin(), rest.triangles.end(), isOfSide), rest.triangles.end());
  return rest.with(side.mapped([width](const Point& p) { return Point(p + Point(width, 0, 0)); }));
}

Mesh icosphere(int levels)
{
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh{{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g}, {0, -1, -g},
              {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}},
    {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2},
      {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5},
      {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b)
    {
      const auto found =
        middles.emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.points.size()));
      if (found.second)
      {
        mesh.points.push_back(0.5 * (mesh.points[a] + mesh.points[b]));
      }
      return found.first->second;
    };
    std::vector<std::array<std::int32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  return mesh.mapped([](const Point& p) -> Point { return p.normalized(); });
}

Mesh ball(const Point& center, double radius, int levels)
{
  return icosphere(levels).mapped([&](const Point& p) -> Point { return center + radius * p; });
}

Mesh torus(int along, int around)
{
  const auto at = [&](int i, int j) -> Point
  {
    const double u = 2 * winding::pi * (i % along) / along,
                 v = 2 * winding::pi * (j % around) / around;
    const double radius = 1 + 0.4 * std::cos(v);
    return {radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v)};
  };
  Builder builder;
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return builder.mesh();
}

Mesh doubleWalls(const Mesh& outer, double wall, const std::vector<std::size_t>& openings)
{
  Mesh mesh = outer.with(outer.reversed().mapped([wall](const Point& p) { return wall * p; }));
  const std::size_t faces = outer.triangles.size();
  const auto count = static_cast<std::int32_t>(outer.points.size());
  for (const std::size_t face : openings)
  {
    const std::array<std::int32_t, 3> t = outer.triangles[face];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t a = t[i], b = t[(i + 1) % 3];
      mesh.triangles.push_back({a, b, b + count});
      mesh.triangles.push_back({a, b + count, a + count});
    }
  }
  std::vector<std::array<std::int32_t, 3>> kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const bool isOpen =
      i < 2 * faces && std::find(openings.begin(), openings.end(), i % faces) != openings.end();
    if (!isOpen)
    {
      kept.push_back(mesh.triangles[i]);
    }
  }
  mesh.triangles = kept;
  return mesh;
}

Mesh lathe(const std::vector<std::array<double, 2>>& profile, int corners)
{
  Mesh mesh;
  for (const auto& [radius, height] : profile)
  {
    for (int i = 0; i < corners; ++i)
    {
      const double angle = 6.283185307179586 * i / corners;
      mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (int i = 0; i + corners < static_cast<int>(mesh.points.size()); ++i)
  {
    const int next = i % corners == corners - 1 ? i + 1 - corners : i + 1;
    mesh.triangles.push_back({i, next, next + corners});
    mesh.triangles.push_back({i, next + corners, i + corners});
  }
  return mesh;
}

Mesh moebiusStrip(int quads)
{
  Mesh mesh;
  for (int i = 0; i < quads; ++i)
  {
    const double turn = 2 * winding::pi * i / quads;
    const Point middle(std::cos(turn), std::sin(turn), 0);
    const Point side = 0.3 * (std::cos(turn / 2) * middle + std::sin(turn / 2) * Point::UnitZ());
    mesh.points.push_back(middle - side);
    mesh.points.push_back(middle + side);
  }
  for (std::int32_t i = 0; i < quads; ++i)
  {
    const bool last = i == quads - 1;
    const std::int32_t a = 2 * i, b = a + 1, c = last ? 0 : a + 3, d = last ? 1 : a + 2;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

Mesh book(std::int32_t pages, bool byTurns)
{
  Mesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (std::int32_t i = 0; i < pages; ++i)
  {
    mesh.points.push_back({std::cos(i), std::sin(i), 0.5});
    const bool back = byTurns && i % 2 == 1;
    mesh.triangles.push_back({back ? 1 : 0, back ? 0 : 1, i + 2});
  }
  return mesh;
}

Mesh triangleSoup(std::size_t count, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point center = random.point(-1, 1);
    const double size = std::exp2(random(-8, 0));
    const auto id = static_cast<std::int32_t>(mesh.points.size());
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.points.push_back(center + size * random.point(-1, 1));
    }
    mesh.triangles.push_back({id, id + 1, id + 2});
  }
  return mesh;
}

Cells lShape()
{
  return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}};
}

Cells randomCells(int n, unsigned seed)
{
  Random random(seed);
  Cells cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    if (random(0, 1) < 0.5)
    {
      cells.insert({i % n, i / n % n, i / n / n});
    }
  }
  return cells;
}

Mesh surfaceOf(const Cells& cells)
{
  Builder builder;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool high = face % 2 == 1;
    for (const Cell& cell : cells)
    {
      Cell beyond = cell;
      beyond[axis] += high ? 1 : -1;
      if (cells.count(beyond) == 0)
      {
        Point a(cell[0], cell[1], cell[2]);
        a[axis] += high;
        Point b = a, c = a, d = a;
        b[u] += 1;
        c[u] += 1;
        c[v] += 1;
        d[v] += 1;
        if (high)
        {
          builder.quad(a, b, c, d);
        }
        else
        {
          builder.quad(a, d, c, b);
        }
      }
    }
  }
  return builder.mesh();
}

double windingOf(const Cells& cells, const Point& point)
{
  // Each of the eight octants about the point lies in one cell near the point.
  int solid = 0;
  for (int octant = 0; octant < 8; ++octant)
  {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool upward = (octant >> axis) % 2 == 1;
      cell[axis] = static_cast<int>(upward ? std::floor(point[axis]) : std::ceil(point[axis]) - 1);
    }
    solid += static_cast<int>(cells.count(cell));
  }
  return solid / 8.0;
}

std::vector<Point> pointsNear(const Mesh& mesh, std::size_t count, double distance, unsigned seed)
{
  Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& t = mesh.triangles[random.bits() % mesh.triangles.size()];
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Point weights = random.point(0.2, 1);
    const Point place = (weights[0] * a + weights[1] * b + weights[2] * c) / weights.sum();
    const double side = random(0, 1) < 0.5 ? -1 : 1;
    points.push_back(place + side * distance * (b - a).cross(c - a).normalized());
  }
  return points;
}

} // namespace shapes
