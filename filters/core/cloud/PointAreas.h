// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Message.h"
#include "source/DistinctPoints.h"
#include "source/PointCloud.h"

#include <string>
#include <vector>

namespace winding
{

/// The source of the areas of a cloud's points, if the cloud has none of its own.
enum class PointAreaMethod
{
  voronoi, ///< area of each point's cell among its neighbours
  constant ///< one area for all points
};

/// The number of neighbours of a point that are looked at unless the user says otherwise.
constexpr int defaultNeighbors = 20;

/// The way in which points get areas; meaning and ranges are FieldOptions'.
struct PointAreaOptions
{
  PointAreaMethod method = PointAreaMethod::voronoi;
  double pointArea = 0;
  int neighbors = defaultNeighbors;
};

/**
 * Finds the area that each point of an oriented cloud stands for: the area of its Voronoi cell in
 * its tangent plane, among the cells of its k nearest neighbours whose normals are similar to its
 * own (Barill et al., Fast winding numbers for soups and clouds, 2018). Neighbours on the other
 * side of a thin part have opposite normals and do not count.
 *
 * A cell that neighbours do not close ends about half way to where the next point would be: at the
 * border of an open cloud it ends as far from the point as on its other sides. Points at equal
 * places share one cell if their normals are similar; points at equal places with opposite normals
 * have a cell each. A point far from all others gets no more than a few times the area of the
 * points that are nearest to it.
 *
 * A point with nearly no similar neighbours is taken to have a wrong normal, and all of its
 * neighbours count: else few flipped normals would have the areas of many. neighbors is k, at least
 * 3; where k neighbours leave a cell open, or few of them are similar, four times as many are
 * looked at, and thirty spots where most points lie in spots of more than k / 8, as several scans
 * of one surface make them. Areas are in squared units of the positions, finite, and 0 or more: 0
 * where rounding leaves nothing of a cell between its neighbours, and for all points of a cloud
 * that has one place only, for then nothing defines an area.
 *
 * The total area of spheres is within 0.3 %, also with ten times the density on one half; that of
 * the vertices of scans is 1 to 2 % too small, because neighbours that curve away from the tangent
 * plane are projected. Areas are rough where few points lie around sharp edges and thin parts: in
 * total, a teapot's vertices get 7 % too little, and an icosahedron's are far off.
 * Strays have large areas of their own.
 *
 * The work takes O(n log n) time, most of it on the executor's threads, and about 150 bytes per
 * point while it runs. The bits are the same for any executor and any order of the points. Throws
 * Interrupted.
 */
std::vector<double> voronoiAreas(
  const PointCloud& cloud, const DistinctPoints& places, int neighbors, Executor& executor);

/// The mean of voronoiAreas(): one area for every point, such that all together have the right
/// total. It suits evenly sampled surfaces without strays, whose areas would raise it.
double meanPointArea(
  const PointCloud& cloud, const DistinctPoints& places, int neighbors, Executor& executor);

/// Throws Refusal unless pointArea is an area for all points, or 0 for the mean.
void checkPointArea(double pointArea);

/// Returns what users can do where points lie at one place, with what comes of it.
Message missingPointArea(const std::string& consequence);

///@{
/// Finds the area of each point. An area that is given for all points needs no normals. Throws
/// Interrupted, and Refusal for an area that is larger than largestArea() (Sanitize.h). `places`
/// are the cloud's, where they are known already.
std::vector<double> pointAreas(
  const PointCloud& cloud, const PointAreaOptions& options, Executor& executor);
std::vector<double> pointAreas(const PointCloud& cloud, const DistinctPoints& places,
  const PointAreaOptions& options, Executor& executor);
///@}

} // namespace winding
