// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/WallGrid.h"

#include "base/Digits.h"
#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "tasks/MendedSource.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

Grid plainGrid(GridRequest request)
{
  request.resolution = WallGrid::plain;
  return setUpGrid(request);
}

} // namespace

WallGrid::WallGrid(const GridRequest& request)
  : plain_(plainGrid(request))
  , voxel_(plain_.spacing[0])
{
}

void WallGrid::add(
  const Field& field, const InsideTest& isInside, bool mendsSource, Executor& executor)
{
  Run silent = {executor, [](const Message&) {}, {}};
  MendedSource source(field, plain_, {mendsSource, false, isInside}, silent);
  source.decideByLayers();
  const WallSamples walls = source.field().diagnosis().boundingWalls(isInside, executor);
  constexpr double perWall = 1.5, few = 0.05;
  double all = 0, thin = 0;
  std::vector<std::pair<double, double>> wanted; // edge of voxels and area
  for (std::size_t i = 0; i < walls.points.size(); ++i)
  {
    const SurfaceSample& point = walls.points[i];
    all += point.weight;
    const double voxel = walls.lines[i].wall / (perWall * point.normal.lpNorm<1>());
    if (voxel < plain_.spacing[0])
    {
      wanted.emplace_back(voxel, point.weight / walls.shares[i]);
      thin += wanted.back().second;
    }
  }
  std::sort(wanted.begin(), wanted.end());
  double sum = 0;
  for (const auto& [voxel, area] : wanted)
  {
    sum += area;
    if (sum > few * all)
    {
      voxel_ = std::min(voxel_, voxel);
      thinShare_ = std::max(thinShare_, std::min(1.0, thin / all));
      return;
    }
  }
}

int WallGrid::resolution() const
{
  const double wanted = 10 * std::ceil(plain * plain_.spacing[0] / voxel_ / 10);
  return thinShare_ > 0 ? static_cast<int>(std::min<double>(wanted, most)) : plain;
}

std::string WallGrid::reason() const
{
  return thinShare_ > 0
           ? "resolution " + std::to_string(this->resolution()) + ", since about " +
               percentOf(thinShare_) + " of the surface has walls thinner than 1.5 of " +
               std::to_string(plain) + " voxels"
           : "";
}

} // namespace winding
