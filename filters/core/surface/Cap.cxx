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
  TriangleList fan;
  for (std::size_t number = 0; number < loops.size(); ++number)
  {
    const BoundaryLoop loop = loops[number];
    Bounds bounds;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (std::int32_t vertex : loop)
    {
      bounds.extend(vertices[vertex]);
      center += vertices[vertex] / static_cast<double>(loop.size());
    }
    // The new vertex lies off the loop's centre by π/18, e/12 and ln 2 · 3/8 of its size. These
    // are neither simple fractions nor, as sizes are, roots of such, which grids and CAD are full
    // of.
    const double size = bounds.diagonal().norm();
    const Eigen::Vector3d aside(0.17453292519943295, 0.22652348570492042, 0.25993019270997947);
    const std::int32_t apex = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(center + size * aside);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      fan.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
    }
  }
  return fan;
}

} // namespace winding
