// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Cap.h"

#include "base/Bounds.h"

namespace winding
{

namespace
{

/// Appends the cap of a loop, whose vertices are in rim, which is empty then.
void appendCap(std::vector<std::int32_t>& rim, TriangleList& cap)
{
  while (rim.size() > 2)
  {
    const std::size_t n = rim.size();
    for (std::size_t i = 0; i < n; i += 2)
    {
      if (i + 1 < n)
      {
        // An ear runs against the sense of the rim, whose two edges it cancels.
        cap.push_back({rim[i], rim[(i + 2) % n], rim[i + 1]});
      }
      rim[i / 2] = rim[i];
    }
    // A rim of three vertices is one ear, so nothing is left.
    rim.resize(n == 3 ? 0 : (n + 1) / 2);
  }
}

/// The most vertices that are joined to the apex of a fan: needles are near to all that is near
/// the fan, which costs a far field its gain.
constexpr std::size_t mostInFan = 64;

/// Adds the triangles between a ring and every other vertex of it, twice the length of an edge
/// `aside`. Returns these.
std::vector<std::int32_t> addNarrowing(const std::vector<std::int32_t>& ring,
  const Eigen::Vector3d& aside, std::vector<Eigen::Vector3d>& vertices, TriangleList& fan)
{
  const std::size_t n = ring.size();
  double length = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    length += (vertices[ring[(i + 1) % n]] - vertices[ring[i]]).norm() / static_cast<double>(n);
  }
  std::vector<std::int32_t> next;
  for (std::size_t i = 0; i < n; i += 2)
  {
    next.push_back(static_cast<std::int32_t>(vertices.size()));
    vertices.emplace_back(vertices[ring[i]] + 2 * length * aside);
  }
  for (std::size_t i = 0; i < n; i += 2)
  {
    const std::int32_t from = next[i / 2], to = next[(i / 2 + 1) % next.size()];
    const std::int32_t middle = ring[(i + 1) % n];
    fan.push_back({middle, ring[i], from});
    fan.push_back({middle, from, to});
    if (i + 1 < n)
    {
      fan.push_back({ring[(i + 2) % n], middle, to});
    }
  }
  return next;
}

} // namespace

TriangleList capOf(const BoundaryLoops& loops)
{
  TriangleList cap;
  cap.reserve(loops.vertices() - 2 * loops.size());
  std::vector<std::int32_t> rim;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    rim.assign(loops[i].begin(), loops[i].end());
    appendCap(rim, cap);
  }
  return cap;
}

TriangleList capOf(const BoundaryLoop& loop)
{
  TriangleList cap;
  std::vector<std::int32_t> rim(loop.begin(), loop.end());
  appendCap(rim, cap);
  return cap;
}

TriangleList fanOf(const BoundaryLoops& loops, std::vector<Eigen::Vector3d>& vertices)
{
  // New vertices lie off by π/18, e/12 and ln 2 · 3/8 of a length. These are neither simple
  // fractions nor, as lengths are, roots of such, which grids and CAD are full of.
  const Eigen::Vector3d aside(0.17453292519943295, 0.22652348570492042, 0.25993019270997947);
  TriangleList fan;
  std::vector<std::int32_t> ring;
  for (std::size_t number = 0; number < loops.size(); ++number)
  {
    ring.assign(loops[number].begin(), loops[number].end());
    Bounds bounds;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (std::int32_t vertex : ring)
    {
      bounds.extend(vertices[vertex]);
      center += vertices[vertex] / static_cast<double>(ring.size());
    }
    while (ring.size() > mostInFan)
    {
      ring = addNarrowing(ring, aside, vertices, fan);
    }
    const std::int32_t apex = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(center + bounds.diagonal().norm() * aside);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      fan.push_back({ring[(i + 1) % ring.size()], ring[i], apex});
    }
  }
  return fan;
}

std::size_t trianglesOfFan(const BoundaryLoop& loop)
{
  std::size_t triangles = 0, left = loop.size();
  for (; left > mostInFan; left = (left + 1) / 2)
  {
    triangles += left + (left + 1) / 2;
  }
  return triangles + left;
}

} // namespace winding
