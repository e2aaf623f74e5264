// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/**
 * @file
 * The inner loops of distances, compiled once per instruction set and chosen at run time (Highway).
 *
 * The nearest point of a triangle abc to q is that on one of its sides, or where q projects to, if
 * that is inside of it. All four are computed as points of the triangle, and the nearest is taken,
 * so that no case is decided on a small number: a needle costs few digits, a triangle without area
 * none, and a projection that is mistaken for one inside leads to a point off the triangle by
 * rounding at most.
 *
 * Squares must stay finite: coordinates are scaled to about unit size (UnitScale.h).
 */
namespace winding
{

/// A triangle as the loops need it.
struct NearTriangle
{
  double a[3];
  double ab[3], ac[3]; ///< from a to the other corners
  double v[3], w[3]; ///< (q − a)·v and (q − a)·w are the weights of b and c where q projects to
  double inverseAB, inverseAC, inverseBC; ///< 1/|ab|² and so on; 0 for a side of no length
};

NearTriangle nearTriangle(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

struct NearPoint
{
  double position[3];
};

inline NearPoint nearPoint(const Eigen::Vector3d& position)
{
  return {{position[0], position[1], position[2]}};
}

/// Items first … last − 1 of an array.
struct NearItems
{
  std::uint32_t first, last;
};

/// Samples per kernel call; fewer take just as long.
constexpr std::size_t samplesAtOnce = 8;

///@{
/// Lowers squared[i] to the square of the distance of sample i from the nearest of the items of
/// some numbers, for all samples of a block and for the entries that pad them to whole vectors.
/// squared: aligned as the block is.
void lowerSquaredDistances(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, double* squared);
void lowerSquaredDistances(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, double* squared);
///@}

/// Whether a triangle's distance from at least one of the first samplesAtOnce samples of a block,
/// as the loops compute it, is no more than the sample's limit. The caller adds the rounding of
/// distances (roundingOfOffset) to the limits. squaredLimits: one for each, aligned as the block.
bool isNearer(
  const NearTriangle& triangle, const SampleBlock& samples, const double* squaredLimits);

///@{
/// Lowers least[i] to the least name of the items of some numbers whose distance from sample i, as
/// the loops compute it, is below the sample's limit. An item has the name names[item], a whole
/// number. The arrays have an entry for each sample and those that pad a block, and are aligned as
/// it is.
void lowerNames(const NearTriangle* triangles, const std::uint32_t* numbers, std::size_t count,
  const std::uint32_t* names, const SampleBlock& samples, const double* squaredLimits,
  double* least);
void lowerNames(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const std::uint32_t* names, const SampleBlock& samples, const double* squaredLimits,
  double* least);
///@}

/// The nearest point that was found.
struct Nearest
{
  double squared;         ///< square of its distance
  double offset[3];       ///< offset from it to the sample
  std::uint32_t item = 0; ///< number, in the array, of the item that it lies on
};

/**
 * A bound of the error of a computed offset from a point of a source, and so of a computed
 * distance. Let r be the distance and s the size of the source: the offset from a triangle's
 * beginning has a length of at most r + s, the sides of at most s, and all that is taken from that
 * offset to get to the nearest point of at most 2s; each of these 3 sides, 3 products and 5
 * differences is rounded by half an epsilon of its length. The bound does not hold for triangles so
 * thin that their normal is inexact: there, points lie off the triangle by as much as the normal
 * has lost.
 */
inline double roundingOfOffset(double distance, double size)
{
  return 8 * std::numeric_limits<double>::epsilon() * (distance + size);
}

///@{
/// Replaces the nearest point by that on an item, if it is nearer.
void findNearest(
  const NearTriangle* triangles, const NearItems& run, const double* sample, Nearest& nearest);
void findNearest(
  const NearPoint* points, const NearItems& run, const double* sample, Nearest& nearest);
///@}

///@{
/// Sets nearest[i] to the nearest point of the items with some indices, at least
/// one, for each sample of a block of samplesAtOnce samples at most.
void findNearestOfEach(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, Nearest* nearest);
void findNearestOfEach(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, Nearest* nearest);
///@}

} // namespace winding
