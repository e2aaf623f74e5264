#include "PointCrossings.h"

#include "BucketSort.h"
#include "RayTriangle.h"
#include "UnitScale.h"

#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

namespace winding
{

namespace
{

/// A sample in units of the surface, and the crossings that were found so far.
struct Ray
{
  double x, y, z;
  std::size_t sample;
  int crossings;

  Eigen::Vector3d start() const { return {x, y, z}; }
};

using TriangleIds = std::vector<std::uint32_t>;

/// What of a triangle's box tells whether rays along +x may cross it.
struct TriangleBox
{
  TriangleBox(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double scale)
    : lowY(scale * std::min(std::min(a[1], b[1]), c[1]))
    , highY(scale * std::max(std::max(a[1], b[1]), c[1]))
    , lowZ(scale * std::min(std::min(a[2], b[2]), c[2]))
    , highZ(scale * std::max(std::max(a[2], b[2]), c[2]))
    , highX(scale * std::max(std::max(a[0], b[0]), c[0]))
  {
  }

  double lowY, highY, lowZ, highZ, highX;
};

/// The box of rays across them, in y and z, and the x from which on they are all ahead.
struct RayBox
{
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  double firstX = std::numeric_limits<double>::infinity();

  void add(const Eigen::Vector3d& start)
  {
    low = low.cwiseMin(start.tail<2>());
    high = high.cwiseMax(start.tail<2>());
    firstX = std::min(firstX, start[0]);
  }

  void add(const RayBox& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
    firstX = std::min(firstX, other.firstX);
  }

  bool isReachedBy(const TriangleBox& box) const
  {
    return (box.lowY <= high[0]) & (box.highY >= low[0]) & (box.lowZ <= high[1]) &
           (box.highZ >= low[1]) & (box.highX >= firstX);
  }
};

/// The columns that rays or a triangle are in: first to last in y, and in z.
struct ColumnRange
{
  int firstY, lastY, firstZ, lastZ;

  std::size_t size() const
  {
    return static_cast<std::size_t>(lastY - firstY + 1) *
           static_cast<std::size_t>(lastZ - firstZ + 1);
  }
};

/**
 * A grid over a box of rays. Places are rounded, but never fall as a coordinate rises: what a triangle
 * overlaps is in the columns between those of its corners.
 */
class Columns
{
public:
  /// About so many, at least 1, and at most as many as there are places.
  Columns(const RayBox& box, std::size_t wanted)
    : low_(box.low)
  {
    const int perAxis = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(wanted))));
    for (int axis = 0; axis < 2; ++axis)
    {
      const double scale = perAxis / (box.high[axis] - box.low[axis]);
      const bool isDivisible = perAxis > 1 && std::isfinite(scale) && scale > 0;
      count_[axis] = isDivisible ? perAxis : 1;
      scale_[axis] = isDivisible ? scale : 0;
    }
  }

  std::size_t count() const
  {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]);
  }

  std::size_t number(int y, int z) const
  {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(y);
  }
  std::size_t of(const Eigen::Vector3d& start) const
  {
    return this->number(place(0, start[1]), place(1, start[2]));
  }

  ColumnRange of(const TriangleBox& box) const
  {
    return {place(0, box.lowY), place(0, box.highY), place(1, box.lowZ), place(1, box.highZ)};
  }

private:
  int place(int axis, double coordinate) const
  {
    const double place = (coordinate - low_[axis]) * scale_[axis];
    return place >= count_[axis] ? count_[axis] - 1 : place > 0 ? static_cast<int>(place) : 0;
  }

  Eigen::Vector2d low_;
  double scale_[2];
  int count_[2];
};

/// Triangles in more columns than these are in the list of wide ones, which is of all columns.
constexpr std::size_t wideColumns = 16;

/// Finds the crossings of rays.
class RayCounter
{
public:
  RayCounter(const Surface& surface, double scale)
    : surface_(surface)
    , scale_(scale)
  {
  }

  TriangleBox box(std::uint32_t id) const
  {
    const Triangle& ids = surface_.triangles[id];
    return {
      surface_.vertices[ids[0]], surface_.vertices[ids[1]], surface_.vertices[ids[2]], scale_};
  }

  /// Of all rays with all triangles.
  void count(Ray* first, Ray* last, const TriangleIds& triangles) const
  {
    RayBox box;
    for (const Ray* ray = first; ray != last; ++ray)
    {
      box.add(ray->start());
    }
    const auto rays = static_cast<std::size_t>(last - first);
    const bool isDivided = rays * triangles.size() > fewPairs;
    const Columns columns(box, isDivided ? std::min(mostBuckets, rays / raysPerColumn) : 1);
    const std::vector<Ray*> starts = sortByColumn(first, last, columns);
    std::vector<TriangleIds> ofFull(columns.count()); // by column, full ones only
    for (const std::uint32_t id : triangles)
    {
      const TriangleBox ours = this->box(id);
      if (!box.isReachedBy(ours))
      {
        continue;
      }
      const RayTriangle triangle = this->triangle(id);
      const ColumnRange range = columns.of(ours);
      for (int z = range.firstZ; z <= range.lastZ; ++z)
      {
        for (int y = range.firstY; y <= range.lastY; ++y)
        {
          const std::size_t column = columns.number(y, z);
          if (columns.count() > 1 && starts[column + 1] - starts[column] > fullColumn)
          {
            ofFull[column].push_back(id);
            continue;
          }
          for (Ray* ray = starts[column]; ray != starts[column + 1]; ++ray)
          {
            ray->crossings += triangle.crossing(ray->start());
          }
        }
      }
    }
    for (std::size_t column = 0; column < columns.count(); ++column)
    {
      if (!ofFull[column].empty())
      {
        this->count(starts[column], starts[column + 1], ofFull[column]);
      }
    }
  }

private:
  RayTriangle triangle(std::uint32_t id) const
  {
    const Triangle& ids = surface_.triangles[id];
    return {surface_.vertices[ids[0]] * scale_, surface_.vertices[ids[1]] * scale_,
      surface_.vertices[ids[2]] * scale_};
  }

  static constexpr std::size_t fewPairs = 2048; ///< not worth dividing
  static constexpr std::size_t raysPerColumn = 4;
  static constexpr std::ptrdiff_t fullColumn = 64; ///< more rays are divided again

  /// Where each column begins then, and the end.
  static std::vector<Ray*> sortByColumn(Ray* first, Ray* last, const Columns& columns)
  {
    if (columns.count() == 1)
    {
      return {first, last};
    }
    const std::vector<Ray> rays(first, last);
    std::vector<std::size_t> counts(columns.count() + 1, 0);
    for (const Ray& ray : rays)
    {
      ++counts[columns.of(ray.start()) + 1];
    }
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    std::vector<Ray*> starts(counts.size());
    std::transform(counts.begin(), counts.end(), starts.begin(),
      [first](std::size_t count) { return first + count; });
    for (const Ray& ray : rays)
    {
      first[counts[columns.of(ray.start())]++] = ray;
    }
    return starts;
  }

  const Surface& surface_;
  double scale_;
};

/// The triangles that reach the rays of each column, and behind those the wide ones.
Buckets<std::uint32_t> trianglesByColumn(const RayCounter& counter, std::size_t triangles,
  const Buckets<Ray>& rays, const Columns& columns, Executor& executor)
{
  constexpr std::size_t columnsPerBlock = 64;
  std::vector<RayBox> boxes(columns.count());
  runBlocks(
    boxes.size(), columnsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t column = first; column < last; ++column)
      {
        for (const Ray* ray = rays.begin(column); ray != rays.end(column); ++ray)
        {
          boxes[column].add(ray->start());
        }
      }
    },
    executor);
  RayBox all;
  for (const RayBox& box : boxes)
  {
    all.add(box);
  }
  return distribute<std::uint32_t>(
    triangles, columns.count() + 1,
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto id = static_cast<std::uint32_t>(i);
        const TriangleBox ours = counter.box(id);
        if (!all.isReachedBy(ours))
        {
          continue;
        }
        const ColumnRange range = columns.of(ours);
        if (range.size() > wideColumns)
        {
          put(columns.count(), id);
          continue;
        }
        for (int z = range.firstZ; z <= range.lastZ; ++z)
        {
          for (int y = range.firstY; y <= range.lastY; ++y)
          {
            const std::size_t column = columns.number(y, z);
            if (boxes[column].isReachedBy(ours))
            {
              put(column, id);
            }
          }
        }
      }
    },
    executor);
}

} // namespace

PointCrossings::PointCrossings(const Surface& surface)
  : surface_(surface)
{
}

bool PointCrossings::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
try
{
  constexpr std::size_t samplesPerBlock = 16384;
  const Bounds& bounds = surface_.bounds;
  const double scale = unitScale(bounds);
  // Rays that start beside or behind the surface cross nothing.
  const auto mayCross = [&](const Eigen::Vector3d& q)
  {
    return q[1] >= bounds.min()[1] && q[1] <= bounds.max()[1] && q[2] >= bounds.min()[2] &&
           q[2] <= bounds.max()[2] && q[0] <= bounds.max()[0] && std::isfinite(q[0]);
  };
  RayBox box;
  std::mutex mutex;
  runBlocks(
    samples.size(), samplesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      RayBox ours;
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d q = samples[i];
        if (mayCross(q))
        {
          ours.add(q * scale);
          continue;
        }
        output.fill(q.allFinite() ? 0 : std::numeric_limits<double>::quiet_NaN(), i, 1);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      box.add(ours);
    },
    executor);

  if (!(box.low[0] <= box.high[0]))
  {
    return true; // nothing may cross
  }
  const Columns columns(box, std::min(mostBuckets, samples.size()));
  Buckets<Ray> rays = distribute<Ray>(
    samples.size(), columns.count(),
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d q = samples[i];
        if (mayCross(q))
        {
          const Ray ray = {q[0] * scale, q[1] * scale, q[2] * scale, i, 0};
          put(columns.of(ray.start()), ray);
        }
      }
    },
    executor);

  const RayCounter counter(surface_, scale);
  const std::size_t wide = columns.count();
  const Buckets<std::uint32_t> triangles =
    trianglesByColumn(counter, surface_.triangles.size(), rays, columns, executor);

  return executor.run(columns.count(),
    [&](std::size_t column)
    {
      TriangleIds ids(triangles.begin(wide), triangles.end(wide));
      ids.insert(ids.end(), triangles.begin(column), triangles.end(column));
      counter.count(rays.begin(column), rays.end(column), ids);
      for (const Ray* ray = rays.begin(column); ray != rays.end(column); ++ray)
      {
        output.fill(ray->crossings, ray->sample, 1);
      }
    });
}
catch (const Interrupted&)
{
  return false;
}

} // namespace winding
