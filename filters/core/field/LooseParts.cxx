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

namespace
{

/// Adds a point of each component that has none.
void addMissing(
  const Surface& surface, const Components& components, std::vector<SurfaceSample>& samples)
{
  std::vector<char> hasPoint(components.size(), 0);
  for (const SurfaceSample& sample : samples)
  {
    hasPoint[static_cast<std::size_t>(components.ofTriangle[sample.triangle])] = 1;
  }
  const auto isMissing = [&](std::int32_t triangle)
  {
    return !hasPoint[static_cast<std::size_t>(components.ofTriangle[triangle])];
  };
  std::vector<std::int32_t> triangles, first;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(surface.triangles.size()); ++i)
  {
    if (isMissing(i))
    {
      triangles.push_back(i);
    }
  }
  // In an order that their corners decide the first one of each component is taken.
  for (const std::int32_t triangle : chooseTriangles(surface, triangles, triangles.size()))
  {
    if (isMissing(triangle))
    {
      first.push_back(triangle);
      hasPoint[static_cast<std::size_t>(components.ofTriangle[triangle])] = 1;
    }
  }
  const std::vector<SurfaceSample> added = sampleTriangles(surface, first);
  samples.insert(samples.end(), added.begin(), added.end());
}

} // namespace

bool turnLooseParts(Surface& surface, const PolygonParts& parts, Executor& executor)
{
  const Components components = componentsOf(surface, edgesOf(surface, executor), parts);
  constexpr std::size_t most = 4096, mostComponents = 1 << 15;
  if (components.size() < 2 || components.size() > mostComponents)
  {
    return false;
  }
  std::vector<SurfaceSample> samples = sampleSurface(surface, most, executor).points;
  addMissing(surface, components, samples);
  PointCloud cloud;
  for (const SurfaceSample& sample : samples)
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
  std::vector<double> agreement(components.size(), 0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const SurfaceSample& sample = samples[i];
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
