// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/ThinParts.h"

#include "surface/Components.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

namespace
{

/// The least shares that are worth a warning. Solids that are thick enough lose less at sharp edges
/// (ThinPartsTest.cxx).
constexpr double leastLostShare = 0.05, leastThinShare = 0.08;

/// The samples from `first` to `last`, which counts.
struct SampleBox
{
  Eigen::Array3i first, last;

  /// Returns whether test(i, j, k) is true for any of the samples.
  template <class Test> bool hasAny(const Test& test) const
  {
    for (int k = first[2]; k <= last[2]; ++k)
    {
      for (int j = first[1]; j <= last[1]; ++j)
      {
        for (int i = first[0]; i <= last[0]; ++i)
        {
          if (test(i, j, k))
          {
            return true;
          }
        }
      }
    }
    return false;
  }
};

/// Returns the samples between two positions in units of sample indices; nothing where the grid
/// does not have all of them.
std::optional<SampleBox> samplesBetween(
  const Grid& grid, const Eigen::Array3d& low, const Eigen::Array3d& high)
{
  if (!(low >= 0 && high < grid.dimensions.array().cast<double>()).all())
  {
    return std::nullopt;
  }
  return SampleBox{low.cast<int>(), high.cast<int>()};
}

std::optional<SampleBox> samplesAround(const Grid& grid, const Eigen::Vector3d& point)
{
  // A point in a plane of samples lies in the cells on both sides of it. Coordinates are rounded.
  constexpr double nearPlane = 1e-6;
  const Eigen::Array3d place = grid.inGridUnits(point).array();
  return samplesBetween(grid, (place - nearPlane).ceil() - 1, (place + nearPlane).floor() + 1);
}

/// The components of a surface: how many there are, and the samples of small ones.
struct SolidBoxes
{
  std::size_t count = 0;
  std::vector<SampleBox> small; ///< of each that lies in the grid, what is in its bounds or next to
};

SolidBoxes solidBoxesOf(const Surface& surface, const Grid& grid)
{
  VertexPieces pieces(surface);
  std::vector<std::int32_t> numbers(surface.vertices.size());
  std::vector<Bounds> boxes;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto vertex = static_cast<std::int32_t>(i);
    const std::int32_t first = pieces.sets.find(vertex);
    if (first == vertex)
    {
      numbers[i] = static_cast<std::int32_t>(boxes.size());
      boxes.emplace_back();
    }
    else
    {
      numbers[i] = numbers[first]; // `first` is less than `vertex`
    }
    boxes[numbers[i]].extend(surface.vertices[i]);
  }
  std::vector<std::size_t> triangles(boxes.size(), 0); // of each box
  for (const Triangle& t : surface.triangles)
  {
    ++triangles[numbers[t[0]]];
  }
  constexpr double mostVoxels = 2;
  constexpr std::size_t fewest = 4; // triangles that bound something
  SolidBoxes solids;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const Bounds& box = boxes[i];
    if (triangles[i] < fewest)
    {
      continue;
    }
    ++solids.count;
    if ((box.sizes().array() < mostVoxels * grid.spacing.array()).any())
    {
      const auto samples = samplesBetween(grid, grid.inGridUnits(box.min()).array().floor(),
        grid.inGridUnits(box.max()).array().ceil());
      if (samples)
      {
        solids.small.push_back(*samples);
      }
    }
  }
  return solids;
}

double voxelOf(const Grid& grid)
{
  return grid.spacing.norm() / std::sqrt(3.0);
}

} // namespace

ThinParts thinPartsOf(const WallSamples& walls, const Grid& grid, const IsSampleInside& isInside)
{
  const double diagonal = grid.spacing.norm(), voxel = voxelOf(grid);
  double all = 0, lost = 0, thin = 0;
  std::size_t found = 0;
  ThinParts parts;
  for (std::size_t i = 0; i < walls.points.size(); ++i)
  {
    const auto samples = samplesAround(grid, walls.points[i].position);
    if (!samples)
    {
      continue;
    }
    const double weight = walls.points[i].weight, thickness = walls.thicknesses[i];
    const bool isLost = isInside && !samples->hasAny(isInside);
    all += weight;
    lost += isLost && thickness < diagonal ? weight / walls.shares[i] : 0;
    thin += thickness < voxel ? weight / walls.shares[i] : 0;
    found += thickness < (isLost ? diagonal : voxel);
    parts.hasLostPoints |= isLost;
  }
  constexpr std::size_t fewest = 4; // walls, as chance may find some
  if (found >= fewest)
  {
    parts.lostShare = std::min(1.0, lost / all);
    parts.thinShare = std::min(1.0, thin / all);
  }
  return parts;
}

std::vector<std::size_t> WallSamples::inOrder() const
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::isfinite(thicknesses[i]))
    {
      found.push_back(i);
    }
  }
  std::sort(found.begin(), found.end(),
    [this](std::size_t a, std::size_t b) { return thicknesses[a] < thicknesses[b]; });
  return found;
}

void ThinParts::keep(double share, const std::vector<double>& walls, const Grid& grid)
{
  lostShare *= share;
  thinShare *= share;
  const double limit = thinShare > lostShare ? voxelOf(grid) : grid.spacing.norm();
  const auto thin = std::lower_bound(walls.begin(), walls.end(), limit) - walls.begin();
  if (thin > 0)
  {
    // At the thickness that is kept a fiftieth of the surface is lost, or a tenth of its thin part.
    const double left = std::clamp(0.02 / std::max(lostShare, thinShare), 0.1, 0.9);
    thickness = walls[static_cast<std::size_t>(left * static_cast<double>(thin - 1))];
  }
}

void countLostComponents(
  const Surface& surface, const Grid& grid, const IsSampleInside& isInside, ThinParts& parts)
{
  const SolidBoxes solids = solidBoxesOf(surface, grid);
  constexpr std::size_t most = 1 << 16;
  std::size_t looks = 0;
  const auto isInsideInTime = [&](int i, int j, int k)
  {
    return ++looks > most || isInside(i, j, k);
  };
  parts.lostComponents = static_cast<std::size_t>(std::count_if(solids.small.begin(),
    solids.small.end(), [&](const SampleBox& box) { return !box.hasAny(isInsideInTime); }));
  parts.components = parts.lostComponents > 0 ? solids.count : 0;
}

bool ThinParts::areWorthTelling() const
{
  return lostShare >= leastLostShare || thinShare >= leastThinShare;
}

Message thinPartsAdvice(const ThinParts& parts, const Grid& grid, bool mayTouch)
{
  if (!parts.areWorthTelling())
  {
    return Message("parts are smaller than a voxel",
      mayTouch ? std::vector<Remedy>{smallerVoxels(), touchedVoxels()}
               : std::vector<Remedy>{smallerVoxels()},
      std::to_string(parts.lostComponents) + " of " + std::to_string(parts.components) +
        " closed parts have no sample inside");
  }
  std::string facts = parts.lostShare >= leastLostShare
                        ? "about " + percentOf(parts.lostShare) + " of the surface is lost"
                        : "about " + percentOf(parts.thinShare) + " of the surface may be lost";
  const double longest = grid.dimensions.cast<double>().cwiseProduct(grid.spacing).maxCoeff();
  constexpr double mostVoxels = 4096; // along the longest side
  const double needed = parts.thickness > 0 ? longest / parts.thickness : mostVoxels;
  std::vector<Remedy> remedies;
  if (needed < mostVoxels)
  {
    remedies.push_back(smallerVoxels());
    // Two digits are enough for an estimate.
    const double digits = needed > 1000 ? 100 : 10;
    facts += "; a resolution of " +
             std::to_string(std::lround(digits * std::ceil(needed / digits))) + " would keep it";
  }
  if (mayTouch)
  {
    remedies.push_back(touchedVoxels());
  }
  return Message("parts are thinner than a voxel", remedies, facts);
}

} // namespace winding
