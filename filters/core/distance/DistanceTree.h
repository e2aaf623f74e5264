#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "distance/NearestKernels.h"
#include "source/PointCloud.h"
#include "source/SourceTree.h"
#include "source/Surface.h"

#include <vector>

namespace winding
{

/**
 * The triangles of a surface or the points of a cloud in a hierarchy of boxes: what is nearest to a
 * sample. Immutable once built; all queries may run on several threads at once.
 *
 * Coordinates are those of the source times scale(), which changes nothing but exponents. Memory: that
 * of bytesFor().
 */
class DistanceTree
{
public:
  /// Copies what it needs. Throws Interrupted.
  DistanceTree(const Surface& surface, Executor& executor);
  DistanceTree(const PointCloud& cloud, Executor& executor);

  /// About what it takes for so many primitives.
  static std::size_t bytesFor(bool areTriangles, std::size_t primitives);

  double scale() const { return scale_; }
  bool empty() const { return boxes_.empty(); }

  /// Node 0 is the root; none without items.
  const SourceNode& node(std::uint32_t number) const { return tree_.nodes()[number]; }

  /// Tight boxes of the items of a node.
  const Bounds& box(std::uint32_t node) const { return boxes_[node]; }

  /// Looks for what is nearer to a sample than `nearest` among the items of a node. nearest.squared may
  /// be infinite; where nothing is nearer, `nearest` stays. Returns how many items it looked at.
  std::size_t findNearest(
    const Eigen::Vector3d& sample, std::uint32_t node, Nearest& nearest) const;

  /// Of the items of leaves: those that are no farther than limits from any of 8 samples; see
  /// NearestKernels.h.
  void keepNearer(const std::vector<NearItems>& runs, const SampleBlock& samples,
    const double* squaredLimits, std::vector<NearItems>& kept) const;

  /// Of the items of leaves, for samples in scaled coordinates; see NearestKernels.h.
  void lowerSquaredDistances(
    const std::vector<NearItems>& runs, const SampleBlock& samples, double* squared) const;

private:
  template <class BoxOf> void makeBoxes(const BoxOf& boxOf, Executor& executor);

  double scale_;
  SourceTree tree_;
  std::vector<Bounds> boxes_;
  std::vector<NearTriangle> triangles_; ///< in the tree's order; or these:
  std::vector<NearPoint> points_;
};

/// The square of the distance of a point from a box.
inline double squaredDistance(const Bounds& box, const Eigen::Vector3d& point)
{
  return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0).squaredNorm();
}

} // namespace winding
