// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/TouchedVoxels.h"

#include "base/CountingSort.h"
#include "source/CoordinateOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

/// A range of voxels along an axis: none if the first is the larger one.
struct Range
{
  int first, last;
};

/// The voxels i in [lowest, highest] whose interval [i, i + 1] meets [low, high].
Range voxelsMeeting(double low, double high, int lowest, int highest)
{
  const double first = std::max<double>(std::ceil(low - 1), lowest);
  const double last = std::min<double>(std::floor(high), highest);
  return first <= last ? Range{static_cast<int>(first), static_cast<int>(last)} : Range{0, -1};
}

/// The place on a segment from a to b at which a coordinate has a value between a's and b's.
Eigen::Vector3d placeAt(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int axis, double value)
{
  if (value == a[axis] || value == b[axis])
  {
    return value == a[axis] ? a : b;
  }
  // The coordinates are not rounded themselves, so the fraction has a rounding or two and no
  // cancellation.
  const double fraction = (value - a[axis]) / (b[axis] - a[axis]);
  Eigen::Vector3d place = a + fraction * (b - a);
  place[axis] = value;
  return place;
}

/// A triangle, or the part of it between two planes. A corner may be listed twice.
struct Polygon
{
  Eigen::Vector3d corners[6];
  int count = 0;

  void add(const Eigen::Vector3d& corner) { corners[count++] = corner; }

  /// Calls use(from, to) for the parts of the edges between two planes across an axis.
  template <class Use> void forEachPart(int axis, double low, double high, const Use& use) const
  {
    for (int i = 0; i < count; ++i)
    {
      const Eigen::Vector3d& a = corners[i];
      const Eigen::Vector3d& b = corners[i + 1 < count ? i + 1 : 0];
      if ((a[axis] >= low || b[axis] >= low) && (a[axis] <= high || b[axis] <= high))
      {
        use(placeAt(a, b, axis, std::clamp(a[axis], low, high)),
          placeAt(a, b, axis, std::clamp(b[axis], low, high)));
      }
    }
  }

  /// The part between two planes: a convex polygon with at most two corners more.
  Polygon between(int axis, double low, double high) const
  {
    Polygon rest;
    this->forEachPart(axis, low, high,
      [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
      {
        if (rest.count == 0 || rest.corners[rest.count - 1] != from)
        {
          rest.add(from);
        }
        if (rest.corners[0] != to)
        {
          rest.add(to);
        }
      });
    return rest;
  }
};

/// The primitives of a source by the layers of voxels that they reach. Points are polygons of one
/// corner.
class Layers
{
public:
  /// triangles is null for points.
  Layers(const std::vector<Eigen::Vector3d>& vertices, const TriangleList* triangles,
    const Grid& grid, const Extent& extent, Executor& executor)
    : extent_(extent)
    , triangles_(triangles)
    , vertices_(vertices.size())
  {
    forEachItem(
      vertices.size(),
      [&](std::size_t i) { vertices_[i] = grid.inGridUnits(vertices[i]).array() + 0.5; }, executor);
    // The grid's position is rounded, too, by any program that computes it from its voxels.
    gridMargin_ =
      rounding * (grid.firstSample.cwiseAbs().cwiseQuotient(grid.spacing).array() + 1).matrix();

    std::vector<Range> reaches(this->count());
    forEachItem(
      reaches.size(),
      [&](std::size_t i)
      { reaches[i] = this->layersOf(this->primitive(static_cast<std::uint32_t>(i))); },
      executor);
    const auto forEachPlace = [&](const auto& visit)
    {
      for (std::size_t i = 0; i < reaches.size(); ++i)
      {
        for (int k = reaches[i].first; k <= reaches[i].last; ++k)
        {
          visit(static_cast<std::size_t>(k - extent_[4]), static_cast<std::uint32_t>(i));
        }
      }
    };
    primitives_.sort(static_cast<std::size_t>(extent[5] - extent[4] + 1), forEachPlace);
  }

  /// Marks the voxels of layer k that the primitives touch.
  void mark(int k, unsigned char* marks) const
  {
    const auto layer = static_cast<std::size_t>(k - extent_[4]);
    for (const std::uint32_t* number = primitives_.begin(layer); number != primitives_.end(layer);
         ++number)
    {
      const Polygon primitive = this->primitive(*number);
      const Eigen::Vector3d margin = this->marginOf(primitive);
      this->markRows(primitive.between(2, k - margin[2], k + 1 + margin[2]), margin, k, marks);
    }
  }

private:
  /// The relative rounding of coordinates to which cutting an edge, twice, may add up, with room to
  /// spare.
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

  std::size_t count() const { return triangles_ ? triangles_->size() : vertices_.size(); }

  Polygon primitive(std::uint32_t number) const
  {
    Polygon polygon;
    if (triangles_)
    {
      // Rounding depends on the corner that the polygon begins with, which must not be an accident.
      const Triangle& ids = (*triangles_)[number];
      Eigen::Vector3d corners[3] = {vertices_[ids[0]], vertices_[ids[1]], vertices_[ids[2]]};
      turnToFirstOrder(corners);
      std::for_each(corners, corners + 3, [&](const Eigen::Vector3d& c) { polygon.add(c); });
    }
    else
    {
      polygon.add(vertices_[number]);
    }
    return polygon;
  }

  static std::pair<double, double> bounds(const Polygon& polygon, int axis)
  {
    double low = polygon.corners[0][axis], high = low;
    for (int i = 1; i < polygon.count; ++i)
    {
      low = std::min(low, polygon.corners[i][axis]);
      high = std::max(high, polygon.corners[i][axis]);
    }
    return {low, high};
  }

  Eigen::Vector3d marginOf(const Polygon& primitive) const
  {
    Eigen::Vector3d margin = gridMargin_;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] = bounds(primitive, axis);
      margin[axis] += rounding * std::max(std::abs(low), std::abs(high));
    }
    return margin;
  }

  Range reachOf(const Polygon& polygon, int axis, double margin) const
  {
    const auto [low, high] = bounds(polygon, axis);
    return voxelsMeeting(low - margin, high + margin, extent_[2 * axis], extent_[2 * axis + 1]);
  }

  /// The layers that a primitive reaches; none, too, if it reaches no row of the extent.
  Range layersOf(const Polygon& primitive) const
  {
    const Eigen::Vector3d margin = this->marginOf(primitive);
    const Range rows = this->reachOf(primitive, 1, margin[1]);
    return rows.first <= rows.last ? this->reachOf(primitive, 2, margin[2]) : rows;
  }

  /// Marks the voxels of layer k that a primitive touches; part is its part in that layer.
  void markRows(
    const Polygon& part, const Eigen::Vector3d& margin, int k, unsigned char* marks) const
  {
    if (part.count == 0)
    {
      return;
    }
    const Range rows = this->reachOf(part, 1, margin[1]);
    for (int j = rows.first; j <= rows.last; ++j)
    {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      part.forEachPart(1, j - margin[1], j + 1 + margin[1],
        [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
        {
          low = std::min({low, from[0], to[0]});
          high = std::max({high, from[0], to[0]});
        });
      const Range run = voxelsMeeting(low - margin[0], high + margin[0], extent_[0], extent_[1]);
      if (run.first <= run.last)
      {
        std::fill_n(marks + sampleNumber(extent_, run.first, j, k), run.last - run.first + 1,
          static_cast<unsigned char>(1));
      }
    }
  }

  Extent extent_;
  const TriangleList* triangles_;
  std::vector<Eigen::Vector3d> vertices_; ///< positions in voxels: voxel i is from i to i + 1
  Eigen::Vector3d gridMargin_;
  CountingSort<std::uint32_t> primitives_; ///< by layer
};

void mark(const std::vector<Eigen::Vector3d>& vertices, const TriangleList* triangles,
  const Grid& grid, const Extent& extent, unsigned char* marks, Executor& executor)
{
  if (sampleCount(extent) == 0)
  {
    return;
  }
  const Layers layers(vertices, triangles, grid, extent, executor);
  // Each layer is a block of its own, so that one thread writes it.
  runBlocks(
    static_cast<std::size_t>(extent[5] - extent[4] + 1), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    { layers.mark(extent[4] + static_cast<int>(layer), marks); },
    executor);
}

} // namespace

void markTouched(const Surface& surface, const Grid& grid, const Extent& extent,
  unsigned char* marks, Executor& executor)
{
  mark(surface.vertices, &surface.triangles, grid, extent, marks, executor);
}

void markTouched(const PointCloud& cloud, const Grid& grid, const Extent& extent,
  unsigned char* marks, Executor& executor)
{
  mark(cloud.positions, nullptr, grid, extent, marks, executor);
}

} // namespace winding
