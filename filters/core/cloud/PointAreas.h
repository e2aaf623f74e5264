#pragma once

#include "base/Executor.h"
#include "source/PointCloud.h"

#include <vector>

namespace winding
{

/// Where the areas of a cloud's points come from, if the cloud has none of its own.
enum class PointAreaMethod
{
  voronoi, ///< each point's cell among its neighbours
  constant ///< one for all points
};

/// How many neighbours of a point are looked at unless the user says otherwise.
constexpr int defaultNeighbors = 20;

/**
 * The area that each point of an oriented cloud stands for: that of its Voronoi cell in its tangent
 * plane, among those of its k nearest neighbours whose normals are similar to its own (Barill et al.,
 * Fast winding numbers for soups and clouds, 2018). Neighbours on the other side of a thin part have
 * opposite normals and do not count.
 *
 * A cell that neighbours do not close ends about half way to where the next point would be: at the
 * border of an open cloud as far from the points as on the other sides. Points at equal places share
 * one cell, those of them whose normals are similar; points at equal places with opposite normals
 * have a cell each. A point far from all others gets no more than a few times the area of those that
 * are nearest to it.
 *
 * Of a point with nearly no similar neighbours the normal is taken to be wrong, and all of them count:
 * else few flipped normals would have the areas of many. neighbors is k, at least 3; where they leave a
 * cell open, or few of them are similar, four times as many are looked at. Areas are in squared units of
 * the positions, more than 0 and finite; all are 0 where the cloud has one place only, for then nothing
 * tells an area.
 *
 * In total, of spheres within 0.3 %, with ten times the density on one half, too, and of the vertices of
 * scans 1 to 2 % too small, for what curves away from the tangent plane is projected. Of few points
 * around sharp edges and thin parts, areas are rough: those of a teapot's vertices are 7 % too small in
 * total, of an icosahedron's far off. Strays have large areas of their own.
 * O(n log n) time, most of it on the executor's threads; about 150 bytes per point while it runs; the
 * same bits for any executor. Throws Interrupted.
 */
std::vector<double> voronoiAreas(const PointCloud& cloud, Executor& executor, int neighbors);

/// The mean of those: one area for every point, such that all together have the right one. It suits
/// evenly sampled surfaces without strays, whose areas would raise it.
double meanPointArea(const PointCloud& cloud, Executor& executor, int neighbors);

/// Throws Refusal unless it is an area for all points, or 0 for the mean.
void checkPointArea(double pointArea);

/// One area for each point, by a method; pointArea and neighbors as in FieldOptions. An area that is
/// given for all points needs no normals. Throws Interrupted.
std::vector<double> pointAreas(const PointCloud& cloud, PointAreaMethod method, double pointArea,
  int neighbors, Executor& executor);

} // namespace winding
