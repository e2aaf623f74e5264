// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/LooseParts.h"

#include "cloud/OutwardNormals.h"
#include "rays/SurfaceSamples.h"
#include "surface/Components.h"
#include "surface/Edges.h"

#include <utility>
#include <vector>

namespace winding
{

bool turnLooseParts(Surface& surface, const PolygonParts& parts, Executor& executor)
{
  constexpr std::size_t most = 4096;
  const SurfaceSamples samples = sampleSurface(surface, most, executor);
  PointCloud cloud;
  for (const SurfaceSample& sample : samples.points)
  {
    cloud.positions.push_back(sample.position);
    cloud.bounds.extend(sample.position);
  }
  const OutwardNormals found = giveOutwardNormals(
    cloud, NormalEstimation::automatic, Viewpoints(""), PointAreaOptions(), executor);
  if (cloud.positions.empty() || found.isUnsure())
  {
    return false;
  }
  const Components components = componentsOf(surface, edgesOf(surface, executor), parts);
  std::vector<double> agreement(components.size(), 0);
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    const SurfaceSample& sample = samples.points[i];
    const auto component = static_cast<std::size_t>(components.ofTriangle[sample.triangle]);
    agreement[component] += sample.weight * (sample.normal.dot(cloud.normals[i]) < 0 ? -1 : 1);
  }
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (agreement[static_cast<std::size_t>(components.ofTriangle[i])] < 0)
    {
      std::swap(surface.triangles[i][1], surface.triangles[i][2]);
    }
  }
  return true;
}

} // namespace winding
