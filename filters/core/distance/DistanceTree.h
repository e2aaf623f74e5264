// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/UninitializedVector.h"
#include "distance/Candidates.h"
#include "distance/NearestKernels.h"
#include "source/PointCloud.h"
#include "source/SourceTree.h"
#include "source/Surface.h"

#include <vector>

namespace winding
{

/**
 * The triangles of a surface or the points of a cloud in a hierarchy of boxes, to find the one that
 * is nearest to a sample. Immutable once built; all queries may run on several threads at once.
 *
 * Coordinates are the source's times scale(), which changes nothing but exponents. Nothing
 * depends on the order of the triangles or points, and on which corner a triangle begins with. The
 * tree takes about bytesFor() of memory.
 */
class DistanceTree
{
public:
  /// Copies all it needs. Throws Interrupted when the executor was interrupted.
  DistanceTree(const Surface& surface, Executor& executor);
  DistanceTree(const PointCloud& cloud, Executor& executor);

  /// Returns the approximate memory of a tree over `primitives` primitives, in bytes.
  static std::size_t bytesFor(bool areTriangles, std::size_t primitives);

  double scale() const { return scale_; }
  bool empty() const { return boxes_.empty(); }

  /// The node of a number. Node 0 is the root; a tree without items has no nodes.
  const SourceNode& node(std::uint32_t number) const { return tree_.nodes()[number]; }

  /// The number of nodes, whose children stand behind their parents.
  std::size_t nodes() const { return boxes_.size(); }

  /// The number in the source of an item.
  std::uint32_t numberOf(std::uint32_t item) const { return tree_.order()[item]; }

  /// The tight box of the items of a node.
  const Bounds& box(std::uint32_t node) const { return boxes_[node]; }

  /// Looks among the items of a node for one that is nearer to a sample than `nearest`, and sets
  /// `nearest` to it; where none is nearer, `nearest` stays. nearest.squared may be infinite.
  /// Returns how many items it looked at. It finds the least squared distance of all items as it is
  /// computed, whatever the order in which it looks at them.
  std::size_t findNearest(
    const Eigen::Vector3d& sample, std::uint32_t node, Nearest& nearest) const;

  /// Sets `nearest` to a point of an item, if that is nearer to the sample.
  void compare(const Eigen::Vector3d& sample, std::uint32_t item, Nearest& nearest) const;

  /// Returns whether an item in a box at this squared distance may be computed to be nearer than
  /// `nearest`.
  bool mayHoldNearer(double squared, const Nearest& nearest) const;

  /// Returns the largest distance between two points of the source, in scaled coordinates.
  double size() const { return size_; }

  /// Lists of items that may be nearest to samples, which are empty as yet.
  Candidates noCandidates() const { return Candidates(points_.empty() ? 3 : 1); }

  /// Replaces all candidates by the items of some runs.
  void assign(const std::vector<NearItems>& runs, Candidates& to) const;

  ///@{
  /// The loops of NearestKernels.h, for samples in scaled coordinates.
  void lowerSquaredDistances(const std::uint32_t* items, std::size_t count,
    const SampleBlock& samples, double* squared) const;
  void findNearestOfEach(const std::uint32_t* items, std::size_t count, const SampleBlock& samples,
    Nearest* nearest) const;
  /// Names are the numbers that items have in the source.
  void lowerNumbers(const std::uint32_t* items, std::size_t count, const SampleBlock& samples,
    const double* squaredLimits, double* least) const;
  bool isNearer(std::uint32_t triangle, const SampleBlock& samples, const double* limits) const;
  ///@}

private:
  template <class Make> void makeItemsAndBoxes(const Make& make, Executor& executor);

  void findAmong(const Eigen::Vector3d& sample, const NearItems& items, Nearest& nearest) const;

  double scale_;
  double size_ = 0; ///< no distance of two points of the source is larger
  SourceTree tree_;
  std::vector<Bounds> boxes_;
  UninitializedVector<NearTriangle> triangles_; ///< in the tree's order; none in a tree of points
  UninitializedVector<NearPoint> points_;       ///< in the tree's order; none in one of triangles
};

/// The square of the distance of a point from a box.
inline double squaredDistance(const Bounds& box, const Eigen::Vector3d& point)
{
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0).squaredNorm();
}

} // namespace winding
