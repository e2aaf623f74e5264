// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/ThinParts.h"

#include "base/Digits.h"
#include "base/Evenly.h"
#include "surface/Components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace winding
{

namespace
{

/// The least shares that are worth a warning. Solids that are thick enough lose less at sharp edges
/// (ThinPartsTest.cxx).
constexpr double leastLostShare = 0.05, leastThinShare = 0.08;

/// The triangles of a piece that may bound something.
constexpr std::size_t fewestTriangles = 4;

/// The samples from `first` to `last`, which counts.
struct SampleBox
{
  Eigen::Array3i first, last;

  /// Returns whether test(i, j, k) is true for all of the samples.
  template <class Test> bool hasAll(const Test& test) const
  {
    return !this->hasAny([&](int i, int j, int k) { return !test(i, j, k); });
  }

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
  SolidBoxes solids;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const Bounds& box = boxes[i];
    if (triangles[i] < fewestTriangles)
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

/// Returns the thickness of a box with these edges along a direction of unit length.
double thicknessOf(const Eigen::Vector3d& edges, const Eigen::Vector3d& direction)
{
  return direction.cwiseAbs().dot(edges);
}

} // namespace

void WallSamples::add(const WallSamples& from, std::size_t i)
{
  points.push_back(from.points[i]);
  lines.push_back(from.lines[i]);
  shares.push_back(from.shares[i]);
}

void WallSamples::leave(std::size_t count)
{
  points = evenly(points, count);
  lines = evenly(lines, count);
  shares = evenly(shares, count);
}

void WallSamples::move(double distance)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i].position += distance * points[i].normal;
    double& wall = lines[i].wall;
    wall += 2 * distance;
    points[i].weight = wall > 0 ? points[i].weight : 0;
    wall = wall > 0 ? wall : std::numeric_limits<double>::infinity();
  }
}

bool isInsideNear(const Grid& grid, const Eigen::Vector3d& point, const IsSampleInside& isInside)
{
  const auto samples = samplesAround(grid, point);
  return !samples || samples->hasAny(isInside);
}

bool isInsideWithinReach(
  const Grid& grid, const Eigen::Vector3d& point, const IsSampleInside& isInside)
{
  constexpr double reach = 3;
  const Eigen::Array3d place = grid.inGridUnits(point).array();
  const Eigen::Array3d last = grid.dimensions.array().cast<double>() - 1;
  if (!(place >= 0 && place <= last).all())
  {
    return true;
  }
  const auto samples = samplesBetween(grid, (place - reach).max(0.0), (place + reach).min(last));
  return !samples || samples->hasAny(isInside);
}

std::vector<std::int32_t> trianglesOutOfReach(const Surface& surface,
  const std::vector<std::int32_t>& triangles, const Grid& grid, const IsSampleInside& isInside)
{
  constexpr std::size_t most = 16;
  std::vector<std::int32_t> found;
  for (const std::int32_t triangle : triangles)
  {
    const Triangle& t = surface.triangles[triangle];
    const bool isOut = std::any_of(t.begin(), t.end(),
      [&](std::int32_t vertex)
      {
        const Eigen::Vector3d& point = surface.vertices[vertex];
        return !isInsideNear(grid, point, isInside) && !isInsideWithinReach(grid, point, isInside);
      });
    if (isOut)
    {
      found.push_back(triangle);
    }
    if (found.size() == most)
    {
      break;
    }
  }
  return found;
}

ThinParts thinPartsOf(const WallSamples& walls, const Grid& grid, const IsSampleInside& isInside)
{
  double all = 0, lost = 0, thin = 0;
  ThinParts parts;
  for (std::size_t i = 0; i < walls.points.size(); ++i)
  {
    const SurfaceSample& point = walls.points[i];
    const auto samples = samplesAround(grid, point.position);
    if (!samples)
    {
      continue;
    }
    const bool isLost = isInside && !samples->hasAny(isInside);
    if (isInside && samples->hasAll(isInside))
    {
      continue; // others fill what lies before it
    }
    all += point.weight;
    parts.hasLostPoints |= isLost;
    if (walls.lines[i].wall < thicknessOf(grid.spacing, point.normal))
    {
      const double weight = point.weight / walls.shares[i];
      thin += weight;
      parts.thinVolume += weight * walls.lines[i].wall / 2; // a wall has two sides
      lost += isLost ? weight : 0;
      parts.voxels.push_back(
        walls.lines[i].wall / thicknessOf(Eigen::Vector3d::Ones(), point.normal));
    }
  }
  std::sort(parts.voxels.begin(), parts.voxels.end());
  constexpr std::size_t fewest = 4; // walls, as chance may find some
  if (parts.voxels.size() >= fewest)
  {
    parts.lostShare = std::min(1.0, lost / all);
    parts.thinShare = std::min(1.0, thin / all);
  }
  return parts;
}

double ThinParts::largestVoxel() const
{
  if (voxels.empty())
  {
    return 0;
  }
  // A fiftieth of the surface is thinner than this voxel.
  const double left = std::clamp(0.02 / std::max(lostShare, thinShare), 0.0, 0.9);
  return voxels[static_cast<std::size_t>(left * static_cast<double>(voxels.size() - 1))];
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

std::size_t piecesOf(const Surface& surface)
{
  VertexPieces pieces(surface);
  std::vector<std::size_t> triangles(surface.vertices.size(), 0); // of each piece, by first vertex
  for (const Triangle& t : surface.triangles)
  {
    ++triangles[static_cast<std::size_t>(pieces.sets.find(t[0]))];
  }
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
    [](std::size_t count) { return count >= fewestTriangles; }));
}

int resolutionFor(double voxel, const Grid& grid)
{
  const double longest = grid.dimensions.cast<double>().cwiseProduct(grid.spacing).maxCoeff();
  constexpr double most = 4096;
  const double needed = longest / voxel;
  // Two digits are enough for an estimate.
  const double digits = needed > 1000 ? 100 : 10;
  return needed < most ? static_cast<int>(digits * std::ceil(needed / digits)) : 0;
}

std::string resolutionFact(double voxel, const Grid& grid)
{
  const int needed = resolutionFor(voxel, grid);
  return needed > 0 ? "a resolution of " + std::to_string(needed) + " would keep it" : "";
}

bool ThinParts::areMany() const
{
  return lostShare >= leastLostShare || thinShare >= leastThinShare;
}

bool ThinParts::areWorthTelling() const
{
  // Tips and sharp edges come out in pieces, too, which are next to nothing.
  constexpr double least = 0.005;
  const bool isBroken = pieces > sourcePieces &&
                        (thinVolume > least * sourceVolume || std::abs(volumeRatio - 1) > least);
  return this->areMany() || this->isVolumeOff() || isBroken;
}

bool ThinParts::isVolumeOff() const
{
  constexpr double most = 0.02;
  return std::abs(volumeRatio - 1) > most;
}

Message thinPartsAdvice(
  const ThinParts& parts, const Grid& grid, bool mayTouch, const std::string& what)
{
  const std::vector<Remedy> touching =
    mayTouch ? std::vector<Remedy>{touchedVoxels()} : std::vector<Remedy>();
  std::vector<Remedy> remedies = {smallerVoxels()};
  std::string facts;
  const auto add = [&facts](const std::string& fact)
  {
    facts += (facts.empty() || fact.empty() ? "" : "; ") + fact;
  };
  if (!parts.areWorthTelling())
  {
    remedies.insert(remedies.end(), touching.begin(), touching.end());
    if (parts.lostPlace)
    {
      const Eigen::Vector3d& p = *parts.lostPlace;
      add(joined("at ", inDigits(p[0], 3), " ", inDigits(p[1], 3), " ", inDigits(p[2], 3)));
      add(resolutionFact(parts.largestVoxel(), grid));
      return Message("a part is thinner than a voxel, and missing", remedies, facts);
    }
    return Message("parts are smaller than a voxel", remedies,
      std::to_string(parts.lostComponents) + " of " + std::to_string(parts.components) +
        " closed parts have no sample inside");
  }
  const bool isOfSource = what == "parts";
  double voxel = parts.largestVoxel();
  if (parts.sourceVolume > 0 && parts.thinVolume > 1.5 * parts.sourceVolume)
  {
    // The volume of walls counts twice in rods. Voxels as thick as these cut an eighth of it off,
    // and voxels of this length a fiftieth.
    voxel /= 2.7;
  }
  if (parts.areMany())
  {
    add(parts.lostShare >= leastLostShare
          ? "about " + percentOf(parts.lostShare) + " of the surface is lost"
          : "about " + percentOf(parts.thinShare) + " of the surface may be lost");
  }
  if (parts.isVolumeOff())
  {
    const double off = parts.volumeRatio - 1;
    add(isOfSource ? "the volume is " + percentOf(std::abs(off)) + (off < 0 ? " less" : " more") +
                       " than the source's"
                   : "the volume is about " + percentOf(std::abs(off)) +
                       (off < 0 ? " too small" : " too large"));
    if (!parts.areMany())
    {
      // Edges that are cut off take a share that falls with the square of the voxel.
      constexpr double wanted = 0.015;
      const double ofEdges = grid.spacing.minCoeff() * std::sqrt(wanted / std::abs(off));
      voxel = voxel > 0 ? std::min(voxel, ofEdges) : ofEdges;
    }
  }
  if (parts.pieces > parts.sourcePieces)
  {
    add("it is in " + std::to_string(parts.pieces) + " pieces instead of " +
        std::to_string(parts.sourcePieces));
  }
  const std::string needed = resolutionFact(voxel, grid);
  add(needed);
  if (needed.empty() && parts.areMany())
  {
    remedies.clear();
  }
  if (parts.mayBeTwoWalls)
  {
    remedies.insert(remedies.begin(), {"see whether it has two walls", {Parameter::surfaceReport}});
  }
  remedies.insert(remedies.end(), touching.begin(), touching.end());
  return Message(parts.areMany() ? what + " are thinner than a voxel"
                                 : std::string("the grid is too coarse for the ") +
                                     (isOfSource ? "source" : "result"),
    remedies, facts);
}

} // namespace winding
