// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelSurface.h"

#include "level/GridContour.h"
#include "level/SharpContour.h"

#include <cstdint>
#include <vector>

namespace winding
{

Surface surfaceOf(const Grid& grid, const LevelEdges& edges, const EdgeRoots& roots, bool isSharp,
  Executor& executor)
{
  Surface surface;
  std::vector<std::int64_t> ids;
  const auto place = [&](const auto& write, std::size_t vertices)
  {
    std::vector<double> coordinates(3 * vertices);
    write(coordinates.data());
    surface.vertices.resize(vertices);
    for (std::size_t n = 0; n < vertices; ++n)
    {
      surface.vertices[n] = Eigen::Map<const Eigen::Vector3d>(&coordinates[3 * n]);
      surface.bounds.extend(surface.vertices[n]);
    }
  };
  if (isSharp)
  {
    const SharpContour contour(grid, edges, &roots, true, executor);
    std::vector<std::int64_t> offsets(contour.polygons() + 1);
    ids.resize(contour.corners());
    contour.writePolygons(offsets.data(), ids.data(), executor);
    place([&](double* to) { contour.place(to, executor); }, contour.vertices());
  }
  else
  {
    GridContour contour(grid, edges, executor);
    ids.resize(3 * contour.triangles());
    contour.takeTriangles(ids.data(), executor);
    place([&](double* to) { contour.place(roots, to, executor); }, contour.vertices());
  }
  surface.triangles.resize(ids.size() / 3);
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    surface.triangles[n / 3][n % 3] = static_cast<std::int32_t>(ids[n]);
  }
  surface.inputTriangles = surface.triangles.size();
  return surface;
}

} // namespace winding
