// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Grid.h"
#include "support/Grids.h"
#include "support/Shapes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * Triangles that overlap each other so much that most of them are near to every sample: the worst
 * that a far field can meet.
 */
namespace shapes
{

/// Random triangles with vertices on a lattice of n³ points in [0, n − 1]³; many share edges.
inline Mesh latticeSoup(std::size_t count, int n, unsigned seed)
{
  Random random(seed);
  const auto cells = static_cast<std::uint64_t>(n);
  Mesh mesh;
  for (std::uint64_t i = 0; i < cells * cells * cells; ++i)
  {
    mesh.points.emplace_back(i % cells, i / cells % cells, i / cells / cells);
  }
  while (mesh.triangles.size() < count)
  {
    std::array<std::int32_t, 3> ids;
    for (std::int32_t& id : ids)
    {
      id = static_cast<std::int32_t>(random.bits() % mesh.points.size());
    }
    mesh.triangles.push_back(ids);
  }
  return mesh;
}

/// All triangles of a mesh, `copies` times over the same points.
inline Mesh copiesOf(Mesh mesh, std::size_t copies)
{
  const std::size_t once = mesh.triangles.size();
  mesh.triangles.reserve(once * copies);
  for (std::size_t i = once; i < once * copies; ++i)
  {
    mesh.triangles.push_back(mesh.triangles[i - once]);
  }
  return mesh;
}

/// Large triangles round one common edge, like the pages of a book.
inline Mesh pagesOf(std::size_t count, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  mesh.points = {{0, 0, -1}, {0, 0, 1}};
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.triangles.push_back({0, 1, static_cast<std::int32_t>(mesh.points.size())});
    mesh.points.push_back(random.direction());
  }
  return mesh;
}

/// Large triangles round one common vertex.
inline Mesh petalsOf(std::size_t count, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  mesh.points = {{0, 0, 0}};
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto next = static_cast<std::int32_t>(mesh.points.size());
    mesh.triangles.push_back({0, next, next + 1});
    mesh.points.push_back(random.direction());
    mesh.points.push_back(random.direction());
  }
  return mesh;
}

/// Long thin triangles that all pass within a thousandth of the origin.
inline Mesh needlesOf(std::size_t count, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = static_cast<std::int32_t>(mesh.points.size());
    const Point end = random.direction(), beside = 1e-3 * random.direction();
    mesh.points.insert(mesh.points.end(), {end, beside - end, 1.002 * (beside - end)});
    mesh.triangles.push_back({id, id + 1, id + 2});
  }
  return mesh;
}

/// Squares across the unit square, at random heights up to `height`.
inline Mesh sheetsOf(std::size_t count, double height, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  while (mesh.triangles.size() + 1 < count)
  {
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    const double z = height * random.point(0, 1)[2];
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
    {
      const Point shift = random.point(-0.1, 0.1);
      mesh.points.emplace_back(x + shift[0], y + shift[1], z);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

inline std::vector<std::pair<std::string, Mesh>> hostileSoups(std::size_t count)
{
  return {
    {"lattice", latticeSoup(count, 17, 1501)},
    {"small lattice", latticeSoup(count, 3, 1502)},
    {"one triangle", copiesOf(latticeSoup(1, 17, 1503), count)},
    {"pages", pagesOf(count, 1504)},
    {"petals", petalsOf(count, 1505)},
    {"needles", needlesOf(count, 1506)},
  };
}

} // namespace shapes
