// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/ThinParts.h"

#include "source/SourceArea.h"
#include "surface/Components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace winding
{

namespace
{

/// The least share that is worth a warning. Solids that are thick enough lose less at sharp edges
/// (ThinPartsTest.cxx).
constexpr double leastShare = 0.05;

/// The samples from `first` to `last`, which counts.
struct SampleBox
{
  Eigen::Array3i first, last;

  std::size_t size() const
  {
    return static_cast<std::size_t>((last - first + 1).cast<std::int64_t>().prod());
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

/// A point of the surface, and the samples that show it.
struct PlacedPoint
{
  PointOfTriangle point;
  SampleBox samples;
};

/// Returns about 2000 points of a surface, without the ones that are not between samples.
std::vector<PlacedPoint> pointsOf(const Surface& surface, const Grid& grid)
{
  std::vector<PlacedPoint> points;
  constexpr std::size_t count = 2048;
  for (const PointOfTriangle& point : evenPoints(surface, count))
  {
    if (const auto samples = samplesAround(grid, point.position))
    {
      points.push_back({point, *samples});
    }
  }
  return points;
}

/// Returns the distance along a ray to a triangle in units of `direction`; infinity for a miss
/// (Möller and Trumbore 1997).
double distanceTo(const Surface& surface, const Triangle& t, const Eigen::Vector3d& origin,
  const Eigen::Vector3d& direction)
{
  constexpr double miss = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d& a = surface.vertices[t[0]];
  const Eigen::Vector3d u = surface.vertices[t[1]] - a, v = surface.vertices[t[2]] - a;
  const Eigen::Vector3d p = direction.cross(v);
  const double determinant = u.dot(p);
  if (determinant == 0)
  {
    return miss;
  }
  const Eigen::Vector3d offset = origin - a;
  const double s = offset.dot(p) / determinant;
  const Eigen::Vector3d q = offset.cross(u);
  const double r = direction.dot(q) / determinant;
  const double distance = v.dot(q) / determinant;
  return s >= 0 && r >= 0 && s + r <= 1 && distance > 0 ? distance : miss;
}

/// Returns the vector from a point against its normal to the next triangle, or along it if that one
/// is nearer; not finite where there is none.
Eigen::Vector3d acrossFrom(const Surface& surface, const PointOfTriangle& point)
{
  const Eigen::Vector3d inward = -point.normal;
  double behind = std::numeric_limits<double>::infinity(), before = behind;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (i != point.triangle)
    {
      const Triangle& t = surface.triangles[i];
      behind = std::min(behind, distanceTo(surface, t, point.position, inward));
      before = std::min(before, distanceTo(surface, t, point.position, -inward));
    }
  }
  return behind <= before ? Eigen::Vector3d(behind * inward) : Eigen::Vector3d(-before * inward);
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

/// The places of a surface that may be lost.
struct Candidates
{
  std::vector<PlacedPoint> points;
  SolidBoxes solids; ///< of a closed surface
};

Candidates candidatesOf(const Field& field, const Grid& grid)
{
  const Surface& surface = *field.distinctSurface();
  Candidates result;
  result.points = pointsOf(surface, grid);
  if (field.info().netBoundaryEdges == 0)
  {
    result.solids = solidBoxesOf(surface, grid);
  }
  return result;
}

/// Sets the share that is lost, and returns these points.
std::vector<PointOfTriangle> findLostPoints(
  const std::vector<PlacedPoint>& points, const IsSampleInside& isInside, ThinParts& parts)
{
  std::vector<PointOfTriangle> lost;
  for (const PlacedPoint& placed : points)
  {
    if (!placed.samples.hasAny(isInside))
    {
      lost.push_back(placed.point);
    }
  }
  if (!lost.empty())
  {
    parts.share = static_cast<double>(lost.size()) / static_cast<double>(points.size());
  }
  return lost;
}

/// Finds how thick parts are at points that are lost, and counts no others.
void measureThickness(const Field& field, const Grid& grid,
  const std::vector<PointOfTriangle>& lost, InsideRule rule, double threshold, Executor& executor,
  ThinParts& parts)
{
  // A closed surface has one side inside for sure.
  const bool isSure =
    field.info().netBoundaryEdges == 0 && rule != InsideRule::odd && threshold <= 1;
  const std::size_t rays = std::min<std::size_t>(lost.size(), isSure ? 64 : 16);
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> thicknesses(rays);
  runBlocks(
    rays, 1,
    [&](std::size_t ray, std::size_t, std::size_t)
    {
      const PointOfTriangle& point = lost[ray * lost.size() / rays];
      const Eigen::Vector3d across = acrossFrom(*field.distinctSurface(), point);
      const bool isWall = across.stableNorm() < grid.spacing.norm() &&
                          (isSure || winding::isInside(field.reference(point.position + across / 2),
                                       rule, threshold));
      thicknesses[ray] = isWall ? across.norm() : none;
    },
    executor);
  std::sort(thicknesses.begin(), thicknesses.end());
  const auto walls = static_cast<std::size_t>(
    std::lower_bound(thicknesses.begin(), thicknesses.end(), none) - thicknesses.begin());
  parts.share *= static_cast<double>(walls) / static_cast<double>(rays);
  parts.thickness = walls > 0 ? thicknesses[walls / 10] : 0;
}

ThinParts thinPartsOf(const Field& field, const Grid& grid, const Candidates& candidates,
  const IsSampleInside& isInside, InsideRule rule, double threshold, Executor& executor)
{
  ThinParts parts;
  const std::vector<PointOfTriangle> lost = findLostPoints(candidates.points, isInside, parts);
  if (parts.areWorthTelling())
  {
    measureThickness(field, grid, lost, rule, threshold, executor, parts);
    return parts;
  }
  const SolidBoxes& solids = candidates.solids;
  parts.lostComponents = static_cast<std::size_t>(std::count_if(solids.small.begin(),
    solids.small.end(), [&isInside](const SampleBox& box) { return !box.hasAny(isInside); }));
  parts.components = parts.lostComponents > 0 ? solids.count : 0;
  return parts;
}

} // namespace

std::optional<ThinParts> thinPartsOf(const Field& field, const Grid& grid,
  const IsSampleInside& isInside, InsideRule rule, double threshold, Executor& executor)
{
  if (!field.distinctSurface())
  {
    return std::nullopt;
  }
  return thinPartsOf(field, grid, candidatesOf(field, grid), isInside, rule, threshold, executor);
}

std::optional<ThinParts> thinPartsOf(
  const Field& field, const Grid& grid, InsideRule rule, double threshold, Executor& executor)
{
  if (!field.distinctSurface())
  {
    return std::nullopt;
  }
  Candidates candidates = candidatesOf(field, grid);
  std::unordered_map<std::size_t, std::size_t> numbers;
  std::vector<double> positions;
  const auto numberOf = [&](int i, int j, int k)
  {
    return sampleNumber(grid.wholeExtent(), i, j, k);
  };
  const auto take = [&](int i, int j, int k)
  {
    if (numbers.emplace(numberOf(i, j, k), numbers.size()).second)
    {
      const Eigen::Vector3d sample = grid.sample(i, j, k);
      positions.insert(positions.end(), sample.begin(), sample.end());
    }
    return false;
  };
  for (const PlacedPoint& placed : candidates.points)
  {
    placed.samples.hasAny(take);
  }
  // Boxes that would take too long are skipped.
  constexpr std::size_t mostSamples = 1000000;
  std::size_t samples = 0;
  std::vector<SampleBox>& boxes = candidates.solids.small;
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(),
                [&](const SampleBox& box)
                {
                  const bool isTooLarge = samples + box.size() > mostSamples;
                  samples += isTooLarge ? 0 : box.size();
                  return isTooLarge || box.hasAny(take);
                }),
    boxes.end());
  std::vector<unsigned char> inside(numbers.size());
  FieldOutput output;
  output.inside = inside.data();
  output.rule = rule;
  output.threshold = threshold;
  field.evaluate(VectorsView(positions.data(), inside.size()), output, executor);
  return thinPartsOf(
    field, grid, candidates,
    [&](int i, int j, int k) { return inside[numbers.at(numberOf(i, j, k))] != 0; }, rule,
    threshold, executor);
}

bool ThinParts::areWorthTelling() const
{
  return share >= leastShare;
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
  std::string facts = "about " + percentOf(parts.share) + " of the surface is lost";
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
