// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "source/Surface.h"

#include <functional>
#include <limits>

namespace winding
{

/**
 * The rule for how large a triangle of a far field may be. A large triangle is near to many samples
 * though most of it is far from each of them, so it is cut in pieces that are not.
 */
struct SplitRule
{
  Bounds region;                                                ///< box of the samples
  double longestSide = std::numeric_limits<double>::infinity(); ///< limit among the samples
  /// The rule is relaxed where there would be more pieces than this, but triangles stay whole at
  /// worst.
  std::size_t mostPieces = std::numeric_limits<std::size_t>::max();

  bool operator==(const SplitRule& other) const
  {
    return longestSide == other.longestSide && mostPieces == other.mostPieces &&
           region.min() == other.region.min() && region.max() == other.region.max();
  }

  /// The longest side that a triangle may have: `longestSide` or, if that is more, half its
  /// distance from the samples.
  double allowedFor(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const;
};

/**
 * Returns the number of pieces that `triangles` may be cut in for `samples` and expansions of an
 * order. Twice the triangles and 100 000 are enough for a surface across a grid of 512³, and cost a
 * small source no more memory than a far field of 100 000 triangles. Pieces are to take no more
 * than a quarter of the direct sum's time. The tree takes as long for a piece as the direct sum for
 * 190 (order 3), 320, 540 and 1060 (order 9) pairs of a sample and a triangle, measured with AVX2;
 * 450, 1010, 1790 and 2800 are assumed, for processors on which pairs take less time.
 */
std::size_t mostPieces(std::size_t triangles, std::size_t samples, int order);

/// Whether the rule leaves all triangles whole. Throws Interrupted.
bool leavesWhole(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const TriangleList& triangles, Executor& executor);

/// A piece of a triangle, or a whole one that was not cut.
struct TrianglePiece
{
  const Eigen::Vector3d &a, &b, &c;
  std::size_t triangle; ///< number of the triangle that it is a piece of
  bool isCut;           ///< whether it is less than that triangle
};

/**
 * Cuts triangles in pieces whose sides are no longer than the rule allows, and visits each piece.
 * Triangles that count 0 times are left out.
 *
 * A triangle is cut in two across its longest side, and its pieces again. Sides are cut in the
 * middle by their length alone, so that pieces of neighbours meet vertex to vertex where both are
 * cut.
 */
void forEachPiece(const SplitRule& rule, const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const std::function<void(const TrianglePiece& piece)>& visit);

} // namespace winding
