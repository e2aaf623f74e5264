#include "report/ThinParts.h"

#include "source/SourceArea.h"
#include "surface/Components.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace winding
{

namespace
{

/// The least share that is worth a warning. Solids that are thick enough lose less at sharp edges
/// (ThinPartsTest.cxx).
constexpr double leastShare = 0.05;

/// The answer of the samples around a point.
enum class Around
{
  unknown, ///< the point is not between samples
  lost,
  shown
};

/// Returns whether any sample from `first` to `last`, which counts, is inside.
bool isAnyInside(
  const Eigen::Array3i& first, const Eigen::Array3i& last, const IsSampleInside& isInside)
{
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (isInside(i, j, k))
        {
          return true;
        }
      }
    }
  }
  return false;
}

Around lookAround(const Grid& grid, const Eigen::Vector3d& point, const IsSampleInside& isInside)
{
  // A point in a plane of samples lies in the cells on both sides of it. Coordinates are rounded.
  constexpr double nearPlane = 1e-6;
  const Eigen::Array3d place = grid.inGridUnits(point).array();
  const Eigen::Array3d low = (place - nearPlane).ceil() - 1, high = (place + nearPlane).floor() + 1;
  if (!(low >= 0 && high < grid.dimensions.array().cast<double>()).all())
  {
    return Around::unknown;
  }
  return isAnyInside(low.cast<int>(), high.cast<int>(), isInside) ? Around::shown : Around::lost;
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

/// Returns whether a sample in a box, or next to it, is inside; true for boxes that reach beyond
/// the grid.
bool isShown(const Grid& grid, const Bounds& box, const IsSampleInside& isInside)
{
  const Eigen::Array3d low = grid.inGridUnits(box.min()).array().floor();
  const Eigen::Array3d high = grid.inGridUnits(box.max()).array().ceil();
  const bool liesInGrid = (low >= 0 && high < grid.dimensions.array().cast<double>()).all();
  return !liesInGrid || isAnyInside(low.cast<int>(), high.cast<int>(), isInside);
}

/// Counts the components of a surface, and those that are lost.
void countComponents(
  const Surface& surface, const Grid& grid, const IsSampleInside& isInside, ThinParts& parts)
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
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const Bounds& box = boxes[i];
    const bool isSmall = (box.sizes().array() < mostVoxels * grid.spacing.array()).any();
    const bool isSolid = triangles[i] >= fewest;
    parts.components += isSolid;
    parts.lostComponents += isSolid && isSmall && !isShown(grid, box, isInside);
  }
}

} // namespace

std::optional<ThinParts> thinPartsOf(const Field& field, const Grid& grid,
  const IsSampleInside& isInside, InsideRule rule, double threshold, Executor& executor)
{
  const Surface* surface = field.distinctSurface();
  if (!surface)
  {
    return std::nullopt;
  }
  std::vector<PointOfTriangle> lost;
  std::size_t known = 0;
  constexpr std::size_t points = 2048;
  for (const PointOfTriangle& point : evenPoints(*surface, points))
  {
    const Around around = lookAround(grid, point.position, isInside);
    known += around != Around::unknown;
    if (around == Around::lost)
    {
      lost.push_back(point);
    }
  }
  ThinParts parts;
  parts.share = known > 0 ? static_cast<double>(lost.size()) / static_cast<double>(known) : 0;
  if (!parts.areWorthTelling())
  {
    if (field.info().netBoundaryEdges == 0)
    {
      countComponents(*surface, grid, isInside, parts);
    }
    return parts;
  }
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
      const Eigen::Vector3d across = acrossFrom(*surface, point);
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
  return parts;
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
