// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SurfaceReport.h"

#include "base/Bounds.h"
#include "base/DisjointSets.h"
#include "source/DistinctPoints.h"
#include "source/UnitScale.h"
#include "surface/NearlyClosed.h"
#include "surface/OpenParts.h"
#include "surface/Orientation.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>

namespace winding
{

namespace
{

OrientationCounts countOrientations(
  const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  OrientationCounts counts;
  std::vector<char> isCapped;
  for (const JudgedComponent& judged :
    judgedComponents(surface, edges, componentsOf(surface, edges), isCapped, executor))
  {
    ++(judged.isNearlyClosed ? counts.nearlyClosed : counts.closed);
    counts.inverted += judged.lies.isInverted() && !judged.isUnclear;
    counts.nestedSolids += judged.lies.isNestedSolid() && !judged.isUnclear;
  }
  const Contradictions contradictions = contradictionsOf(surface, edges);
  counts.contradictions = contradictions.edges;
  counts.oneSided = contradictions.oneSided;
  return counts;
}

/// Lengths below this share of the median edge are of slits, not of holes. Rounding of coordinates
/// leaves 1e-7 in single precision, and 1e-5 in files with six digits.
constexpr double shareOfSlits = 1e-3;

} // namespace

bool SurfaceReport::isClosedExceptForSlits() const
{
  return widestSlit && *widestSlit < shareOfSlits * medianEdgeLength && edges.inconsistent == 0 &&
         edges.netBoundary == edges.boundary;
}

bool SurfaceReport::canBeWelded() const
{
  return std::all_of(slits.endDistances.begin(), slits.endDistances.end(),
    [this](double distance) { return distance < shareOfSlits * medianEdgeLength; });
}

EdgeCounts countEdges(const Surface& surface, const SurfaceEdges& edges)
{
  EdgeCounts counts;
  counts.edges = edges.size();
  counts.boundary = counts.netBoundary = edges.rims.size();
  counts.nonManifold = edges.crowds.size();
  counts.components = surface.triangles.size();
  DisjointSets pieces(surface.triangles.size());
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    counts.components -= pieces.unite(pair.triangles[0], pair.triangles[1]);
    counts.inconsistent += !pair.agrees;
  }
  counts.netBoundary += counts.inconsistent;
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    std::ptrdiff_t net = 0;
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      net += use->sense;
      counts.components -= pieces.unite(edges.begin(crowd)->triangle, use->triangle);
    }
    counts.netBoundary += net != 0;
  }
  DisjointSets rims(surface.vertices.size());
  std::vector<std::int32_t> rimVertices;
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    rims.unite(rim.low, rim.high);
    rimVertices.push_back(rim.low);
  }
  for (std::int32_t& vertex : rimVertices)
  {
    vertex = rims.find(vertex);
  }
  std::sort(rimVertices.begin(), rimVertices.end());
  counts.boundaryLoops = static_cast<std::size_t>(
    std::unique(rimVertices.begin(), rimVertices.end()) - rimVertices.begin());
  return counts;
}

SurfaceReport reportOn(
  const Surface& surface, const SurfaceEdges& edges, Executor& executor, const PolygonParts& parts)
{
  SurfaceReport report;
  report.edges = countEdges(surface, edges);
  report.orientation = countOrientations(surface, edges, executor);
  report.vertexComponents = VertexPieces(surface).count;
  const RepeatedFaces faces = repeatedFaces(surface, parts);
  report.isTwoSided = faces.cancelAll();
  for (const FaceKind kind : faces.kinds)
  {
    report.duplicateTriangles += kind == FaceKind::repeated || kind == FaceKind::opposite;
  }
  if (faces.areAny())
  {
    const std::vector<char> isLeftOut = facesToLeaveOut(surface, edges, faces, parts, executor);
    report.mendableTriangles =
      static_cast<std::size_t>(std::count(isLeftOut.begin(), isLeftOut.end(), char(1)));
    OrientationCounts& counts = report.orientation;
    if (counts.nestedSolids + counts.inverted > 0)
    {
      // Walls cancel: what fills a cavity exactly is not nested.
      const Surface skins = SurfacePart(surface, withWalls(isLeftOut, faces), false).chain;
      const OrientationCounts ofSkins =
        countOrientations(skins, edgesOf(skins, executor), executor);
      counts.nestedSolids = ofSkins.nestedSolids;
      counts.inverted = ofSkins.inverted;
    }
  }
  if (!edges.rims.empty())
  {
    report.slits = slitsOf(surface, edges, executor);
    report.widestSlit = report.slits.widest();
    report.medianEdgeLength = medianEdgeLength(surface, edges, executor);
  }
  report.openPartsInside = openPartsInside(surface, edges, executor).count;
  const Eigen::Vector3d center =
    surface.bounds.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(surface.bounds.center());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const Triangle& triangle = surface.triangles[i];
    // Only the volume uses offsets from the centre: their rounding would give area to triangles
    // whose vertices lie on a line.
    const Eigen::Vector3d& a = surface.vertices[triangle[0]];
    const Eigen::Vector3d& b = surface.vertices[triangle[1]];
    const Eigen::Vector3d& c = surface.vertices[triangle[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    report.volume += (a - center).dot(normal) / 6;
    if (faces.kinds[i] != FaceKind::repeated)
    {
      report.zeroAreaTriangles += normal == Eigen::Vector3d::Zero();
      report.area += 0.5 * normal.norm();
    }
  }
  report.eulerCharacteristic = static_cast<long long>(surface.vertices.size()) -
                               static_cast<long long>(report.edges.edges) +
                               static_cast<long long>(surface.triangles.size());
  return report;
}

VertexCounts countVertices(
  const std::vector<VectorsView>& points, const Surface& surface, Executor& executor)
{
  VertexCounts counts;
  std::vector<Eigen::Vector3d> finite;
  Bounds bounds;
  for (const VectorsView& view : points)
  {
    counts.points += view.size();
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      const Eigen::Vector3d point = view[i];
      if (point.allFinite())
      {
        finite.push_back(point);
        bounds.extend(point);
      }
    }
  }
  counts.different = DistinctPoints(finite, unitScale(bounds), executor).size();
  counts.unreferenced = counts.different - std::min(counts.different, surface.vertices.size());
  return counts;
}

} // namespace winding
