// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Fidelity.h"

#include "base/Digits.h"
#include "base/UnitRandom.h"
#include "distance/DistanceTree.h"
#include "distance/SampleDistances.h"
#include "report/SelfIntersections.h"
#include "source/PointCloud.h"
#include "source/SourceArea.h"
#include "surface/Components.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

std::vector<Eigen::Vector3d> draw(
  const Field::PointOnSource& pointOn, std::size_t samples, UnitRandom& random)
{
  std::vector<Eigen::Vector3d> points(samples);
  for (Eigen::Vector3d& point : points)
  {
    const double u = random(), v = random(), t = random();
    point = pointOn(u, v, t);
  }
  return points;
}

VectorsView viewOf(const std::vector<Eigen::Vector3d>& points)
{
  return points.empty() ? VectorsView() : VectorsView(points[0].data(), points.size());
}

void setStatistics(const std::vector<double>& distances, double& largest, double& mean)
{
  for (const double distance : distances)
  {
    largest = std::max(largest, distance);
    mean += distance / static_cast<double>(distances.size());
  }
}

/// The volume that closed triangles enclose. It is taken about their middle, so that a place far
/// from the origin costs no digits.
double volumeOf(const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
{
  Bounds bounds;
  for (const Triangle& triangle : triangles)
  {
    bounds.extend(vertices[triangle[0]]);
  }
  const Eigen::Vector3d middle = bounds.isEmpty() ? Eigen::Vector3d(0, 0, 0) : bounds.center();
  double sixfold = 0;
  for (const Triangle& t : triangles)
  {
    const Eigen::Vector3d a = vertices[t[0]] - middle, b = vertices[t[1]] - middle;
    sixfold += a.dot(b.cross(vertices[t[2]] - middle));
  }
  return sixfold / 6;
}

/// Counts the components of a surface, and those that have nothing within a distance of a tree.
void countComponents(const Surface& source, const DistanceTree& tree, double near, Fidelity& result,
  Executor& executor)
{
  const Components components = componentsOf(source, edgesOf(source, executor));
  std::vector<Eigen::Vector3d> middles;
  for (const Triangle& t : source.triangles)
  {
    middles.push_back((source.vertices[t[0]] + source.vertices[t[1]] + source.vertices[t[2]]) / 3);
  }
  const std::vector<double> ofMiddles = distancesFrom(tree, viewOf(middles), executor);
  const std::vector<double> ofCorners = distancesFrom(tree, viewOf(source.vertices), executor);
  std::vector<char> isFound(components.size());
  for (std::size_t n = 0; n < source.triangles.size(); ++n)
  {
    double nearest = ofMiddles[n];
    for (const std::int32_t corner : source.triangles[n])
    {
      nearest = std::min(nearest, ofCorners[static_cast<std::size_t>(corner)]);
    }
    if (nearest <= near)
    {
      isFound[static_cast<std::size_t>(components.ofTriangle[n])] = 1;
    }
  }
  result.components = components.size();
  result.lostComponents =
    static_cast<std::size_t>(std::count(isFound.begin(), isFound.end(), char(0)));
}

} // namespace

std::string inWords(const Fidelity& fidelity)
{
  const auto inThree = [](double number)
  {
    return inDigits(number, 3);
  };
  std::string text = joined("distance from the input max ", inThree(fidelity.largestFromSource),
    ", mean ", inThree(fidelity.meanFromSource), "; to the input max ",
    inThree(fidelity.largestToSource), ", mean ", inThree(fidelity.meanToSource), "\nvolume ",
    inThree(fidelity.volume), ", of the input ",
    std::isnan(fidelity.sourceVolume) ? "unknown" : inThree(fidelity.sourceVolume), "; ",
    fidelity.lostComponents, " of ", fidelity.components, " parts lost; ",
    fidelity.selfIntersections, " self-intersections");
  if (!std::isnan(fidelity.largestShapeError))
  {
    text += joined("\noff the distance that is asked for max ", inThree(fidelity.largestShapeError),
      ", mean ", inThree(fidelity.meanShapeError));
  }
  return text;
}

double bytesForComparison(const Field& field, double triangles, double samples)
{
  // The surface is there twice, each time with a vertex for two triangles. A sample has its place
  // and its distance, and the search for it its place in an order (SampleDistances.h).
  constexpr double perTriangle = 2 * (sizeof(Triangle) + 0.5 * sizeof(Eigen::Vector3d));
  constexpr double perPair = 100; // SelfIntersections.h
  constexpr double perSample = sizeof(Eigen::Vector3d) + sizeof(double) + 1 + 32;
  const Surface* const source = field.surface();
  const double primitives = static_cast<double>(field.info().primitives);
  const double corners = source != nullptr ? static_cast<double>(source->vertices.size()) : 0;
  const double ofTrees =
    static_cast<double>(DistanceTree::bytesFor(true, 1)) * triangles +
    static_cast<double>(DistanceTree::bytesFor(source != nullptr, 1)) * primitives;
  const double most = std::max(samples, source != nullptr ? primitives + corners : 0);
  return perTriangle * triangles + std::max(perPair * triangles, ofTrees + perSample * most);
}

Fidelity compareWithSource(const Field& field, const std::vector<Eigen::Vector3d>& vertices,
  const TriangleList& triangles, double voxel, std::size_t samples, unsigned seed,
  Executor& executor, const WantedDistances* wanted)
{
  Fidelity result;
  const Surface* const source = field.surface();
  const bool isClosed = source != nullptr && field.info().netBoundaryEdges == 0;
  result.sourceVolume = isClosed ? volumeOf(source->vertices, source->triangles)
                                 : std::numeric_limits<double>::quiet_NaN();
  result.volume = volumeOf(vertices, triangles);
  result.selfIntersections = countSelfIntersections(vertices, triangles, executor);
  Surface surface;
  surface.vertices = vertices;
  surface.triangles = triangles;
  for (const Eigen::Vector3d& vertex : vertices)
  {
    surface.bounds.extend(vertex);
  }
  const DistanceTree tree(surface, executor);
  if (source != nullptr && !source->triangles.empty())
  {
    const double moved = wanted ? wanted->band.farthest() : 0;
    countComponents(*source, tree, moved + 0.5 * voxel, result, executor);
  }
  if (triangles.empty() || field.info().primitives == 0)
  {
    return result;
  }
  result.samples = samples;
  UnitRandom random(seed);
  const auto ofSource = draw(field.pointOnSource(), samples, random);
  const auto ofSurface = draw(pointOnTriangles(vertices, triangles), samples, random);
  setStatistics(distancesFrom(tree, viewOf(ofSource), executor), result.largestFromSource,
    result.meanFromSource);
  setStatistics(
    field.distances(viewOf(ofSurface), executor), result.largestToSource, result.meanToSource);
  if (wanted)
  {
    std::vector<double> errors = distancesFrom(*wanted->from, viewOf(ofSurface), executor);
    for (double& error : errors)
    {
      error = std::min(std::abs(error - std::abs(wanted->band.low)),
        std::abs(error - std::abs(wanted->band.high)));
    }
    result.largestShapeError = result.meanShapeError = 0;
    setStatistics(errors, result.largestShapeError, result.meanShapeError);
  }
  return result;
}

} // namespace winding
