// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/PointCrossings.h"

#include "base/Bounds.h"
#include "base/BucketSort.h"
#include "base/Progress.h"
#include "base/SampledSource.h"
#include "rays/ClearCells.h"
#include "rays/RayCounter.h"
#include "rays/ReachOfTriangles.h"
#include "rays/TriangleColumns.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// The number of samples in a block: small inputs shall occupy several cores.
constexpr std::size_t samplesPerBlock = 4096;

/// A part of what the executor shows as progress, from `first` to `last` of 0 to 1.
struct Share
{
  double first, last;

  double at(double part) const { return first + (last - first) * part; }
  Share part(double from, double to) const { return {this->at(from), this->at(to)}; }
};

/**
 * Counts and writes the crossings of rays in columns, a task to a column. A task that has too much
 * to do gives up, and its column is divided into columns of its own: so all tasks are short, even
 * if most rays or triangles are in a few columns.
 */
class ColumnTasks
{
public:
  ColumnTasks(const RayCounter& counter, const FieldOutput& output, Executor& executor)
    : counter_(counter)
    , output_(output)
    , executor_(executor)
    , progress_(executor)
  {
  }

  /// Runs the tasks of all columns. Throws Interrupted.
  void run(const RaysInColumns& rays, const CandidateTriangles& triangles, const Share& share)
  {
    const ReachOfTriangles reach(counter_, triangles, rays, executor_);
    const double all = static_cast<double>(rays.starts.back() - rays.starts.front());
    const auto until = [&](std::size_t column)
    {
      return static_cast<double>(rays.starts[column] - rays.starts.front()) / all;
    };
    for (std::size_t round = 0; round + 1 < reach.rounds().size(); ++round)
    {
      const std::size_t first = reach.rounds()[round], last = reach.rounds()[round + 1];
      const Share ours = share.part(until(first), until(last));
      std::vector<Full> full;
      const double tasksEnd = this->run(rays, reach.inColumns(first, last), first, ours, full);
      this->divide(rays, full, ours.part(tasksEnd, 1)); // the lists of all columns are given back
    }
  }

  /// Runs the tasks of all columns, whose `triangles` are known. Throws Interrupted.
  void run(const RaysInColumns& rays, const Buckets<std::uint32_t>& triangles, const Share& share)
  {
    std::vector<Full> full;
    const double tasksEnd = this->run(rays, triangles, 0, share, full);
    this->divide(rays, full, share.part(tasksEnd, 1));
  }

private:
  /// A column whose task gave up.
  struct Full
  {
    std::size_t column;
    TriangleIds triangles;
  };

  /// Runs the tasks of the columns from `first` on that `triangles` are for, and puts into `full`
  /// what gave up. Returns the part of `share` after which that is divided.
  double run(const RaysInColumns& rays, const Buckets<std::uint32_t>& triangles, std::size_t first,
    const Share& share, std::vector<Full>& full)
  {
    std::vector<std::size_t> occupied;
    bool mayGiveUp = false; // a guess: where it is wrong, columns divided later show no progress
    for (std::size_t i = 0; i < triangles.count(); ++i)
    {
      const double pairs =
        static_cast<double>(rays.size(first + i)) * static_cast<double>(triangles.size(i));
      mayGiveUp = mayGiveUp || pairs > static_cast<double>(RayCounter::mostSteps);
      if (rays.size(first + i) > 0)
      {
        occupied.push_back(i);
      }
    }
    std::mutex mutex;
    const double tasksEnd = mayGiveUp ? 0.5 : 1;
    this->show(share.part(0, tasksEnd));
    executor_.run(occupied.size(),
      [&](std::size_t task)
      {
        const std::size_t i = occupied[task];
        Ray* const begin = rays.starts[first + i];
        Ray* const end = rays.starts[first + i + 1];
        TriangleIds ids(triangles.begin(i), triangles.end(i));
        if (counter_.count(begin, end, ids))
        {
          this->write(begin, end);
          return;
        }
        std::for_each(begin, end, [](Ray& ray) { ray.crossings = 0; });
        const std::lock_guard<std::mutex> lock(mutex);
        full.push_back({first + i, std::move(ids)});
      });
    return tasksEnd;
  }

  void divide(const RaysInColumns& rays, const std::vector<Full>& full, const Share& share)
  {
    for (std::size_t i = 0; i < full.size(); ++i)
    {
      const double count = static_cast<double>(full.size()), at = static_cast<double>(i);
      const std::size_t column = full[i].column;
      this->divide(rays.starts[column], rays.starts[column + 1], full[i].triangles,
        share.part(at / count, (at + 1) / count));
    }
  }

  /// Divides a column into columns that, if possible, are not too full even if all triangles reach
  /// all of them.
  void divide(Ray* first, Ray* last, const TriangleIds& triangles, const Share& share)
  {
    constexpr double pairsPerColumn = RayCounter::mostSteps / 4.0;
    const double rays = static_cast<double>(last - first);
    const double wanted = rays * static_cast<double>(triangles.size()) / pairsPerColumn;
    const double most = std::min(rays, static_cast<double>(mostBuckets));
    const Columns columns(
      RayBox(first, last), static_cast<std::size_t>(std::clamp(wanted, std::min(4.0, most), most)));
    if (columns.count() > 1)
    {
      const RaysInColumns inColumns = RayCounter::sort(first, last, columns);
      this->run(inColumns, CandidateTriangles(triangles), share);
      return;
    }
    this->show(share);
    executor_.run(1,
      [&](std::size_t)
      {
        counter_.countAll(first, last, triangles);
        this->write(first, last);
      });
  }

  void show(const Share& share) { progress_.set(share.first, share.last); }

  void write(const Ray* first, const Ray* last) const
  {
    constexpr std::ptrdiff_t ahead = 32;
    for (; first != last; ++first)
    {
      if (last - first > ahead)
      {
        output_.askFor(first[ahead].sample);
      }
      output_.fill(first->crossings, first->sample, 1);
    }
  }

  const RayCounter& counter_;
  const FieldOutput& output_;
  Executor& executor_;
  Progress progress_;
};

/// No cap.
const TriangleList& noTriangles()
{
  static const TriangleList none;
  return none;
}

RaysThroughTriangles raysThrough(const CrossedChain& chain, const Bounds& bounds)
{
  RaysThroughTriangles rays;
  const Eigen::Array2d sizes = bounds.sizes().tail<2>();
  if (bounds.isEmpty() || !(sizes.minCoeff() > 0))
  {
    return rays;
  }
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Triangle& ids = chain[i];
    const Eigen::Array2d a = chain.vertex(ids[0]).tail<2>();
    const Eigen::Array2d u = (chain.vertex(ids[1]).tail<2>().array() - a) / sizes;
    const Eigen::Array2d v = (chain.vertex(ids[2]).tail<2>().array() - a) / sizes;
    rays.layers += 0.5 * std::abs(u[0] * v[1] - u[1] * v[0]);
    const Eigen::Array2d sides = u.max(v).max(0.0) - u.min(v).min(0.0);
    rays.lengths += sides.maxCoeff();
    rays.widths += sides.minCoeff();
  }
  return rays;
}

} // namespace

PointCrossings::PointCrossings(const Surface& surface)
  : PointCrossings(surface.vertices, surface, noTriangles(), surface.bounds)
{
}

PointCrossings::PointCrossings(const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const ChainView& cap, const Bounds& bounds)
  : chain_(vertices, triangles, cap)
  , bounds_(bounds)
{
}

PointCrossings::~PointCrossings() = default;

double PointCrossings::weight(std::size_t samples) const
{
  const RaysThroughTriangles& rays = rays_.get([this] { return raysThrough(chain_, bounds_); });
  // A triangle is tested by the samples within it, and by those in the columns along it: as many as
  // are on a line across all of them, by its sides. Long and narrow triangles are passed over by a
  // binary search on most lines, others are tested on most: measured for walls of thin sheet metal
  // and for scans.
  const auto count = static_cast<double>(samples);
  const auto triangles = static_cast<double>(chain_.size());
  // Many triangles do not fit into the caches: 1.7 at 1.4 million, 2.3 at 22 million.
  const double slowdown = 1 + 0.5 * std::max(0.0, std::log10(triangles / 5e4));
  const double perSample = 35e-9 + 12.5e-9 * rays.layers;
  return 40e-9 * slowdown * triangles + perSample * count +
         slowdown * (12e-9 * rays.lengths + 90e-9 * rays.widths) * std::sqrt(count);
}

std::size_t PointCrossings::bytes(std::size_t samples) const
{
  return (bytesPerPrimitive + 140) * chain_.size() + 42 * samples;
}

/// Returns whether finding clear cells, which takes about as long for a triangle as a ray does for
/// a sample, saves more than that.
bool PointCrossings::isWorthClearing(std::size_t samples) const
{
  constexpr std::size_t fewSamples = 4096;
  return samples >= std::max(fewSamples, chain_.size() / 2) && !bounds_.isEmpty() &&
         bounds_.sizes().maxCoeff() > 0;
}

void PointCrossings::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  if (!this->isWorthClearing(samples.size()))
  {
    this->cast(samples, output, nullptr, executor);
    return;
  }
  Progress progress(executor);
  progress.set(0, 0.2);
  constexpr std::size_t samplesPerCell = 12;
  ClearCells clear(chain_, bounds_, samples.size() / samplesPerCell, executor);
  const std::vector<Eigen::Vector3d>& places = clear.places();
  if (!places.empty())
  {
    std::vector<double> windings(places.size());
    FieldOutput toWindings;
    toWindings.doubleValues = windings.data();
    this->cast(VectorsView(places[0].data(), places.size()), toWindings, nullptr, executor);
    clear.setWindings(std::move(windings));
  }
  progress.set(0.2, 1);
  this->cast(samples, output, &clear, executor);
}

/// Returns the triangles in columns, or null where walking over all of them takes no longer, as for
/// many rays. Null is also for the first few rays, which sorting would not pay for.
const TriangleColumns* PointCrossings::columnsForFew(
  const RayCounter& counter, double scale, std::size_t rays, Executor& executor) const
{
  constexpr std::size_t fewTriangles = 4096, trianglesPerRay = 4;
  if (chain_.size() < fewTriangles || rays > chain_.size() / trianglesPerRay ||
      !wereFewAsked_.exchange(true))
  {
    return nullptr;
  }
  const TriangleColumns& columns = *columns_.get(
    [&]
    {
      return std::make_unique<const TriangleColumns>(
        counter, chain_.size(), bounds_, scale, executor);
    });
  return columns.isUsable() ? &columns : nullptr;
}

/// Writes the values of samples: those that `clear` has, unless it is null, and of all others by
/// rays.
void PointCrossings::cast(const VectorsView& samples, const FieldOutput& output,
  const ClearCells* clear, Executor& executor) const
{
  const Bounds& bounds = bounds_;
  const double scale = unitScale(bounds);
  // Rays that start off or behind the surface cross nothing.
  const auto mayCross = [&bounds](const Eigen::Vector3d& q)
  {
    return q[1] >= bounds.min()[1] && q[1] <= bounds.max()[1] && q[2] >= bounds.min()[2] &&
           q[2] <= bounds.max()[2] && q[0] <= bounds.max()[0] && std::isfinite(q[0]);
  };
  const auto known = [&](const Eigen::Vector3d& q) -> std::optional<double>
  {
    if (!mayCross(q))
    {
      return q.allFinite() ? 0 : std::numeric_limits<double>::quiet_NaN();
    }
    return clear ? clear->windingAt(q) : std::nullopt;
  };
  // The samples of each block that need a ray, counted from its first one.
  static_assert(samplesPerBlock <= 1 << 16);
  std::vector<std::vector<std::uint16_t>> unknown(
    (samples.size() + samplesPerBlock - 1) / samplesPerBlock);
  RayBox box;
  std::mutex mutex;
  runBlocks(
    samples.size(), samplesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      RayBox ours;
      std::uint16_t numbers[samplesPerBlock];
      std::uint16_t* end = numbers;
      for (std::size_t i = first; i < last; ++i)
      {
        const Eigen::Vector3d q = samples[i];
        const std::optional<double> winding = known(q);
        if (winding)
        {
          output.fill(*winding, i, 1);
        }
        else
        {
          ours.add(q * scale);
          *end++ = static_cast<std::uint16_t>(i - first);
        }
      }
      unknown[block].assign(numbers, end);
      const std::lock_guard<std::mutex> lock(mutex);
      box.add(ours);
    },
    executor);

  if (box.isEmpty())
  {
    return; // all is known
  }
  const RayCounter counter(chain_, scale);
  const std::size_t count = std::accumulate(unknown.begin(), unknown.end(), std::size_t(0),
    [](std::size_t sum, const std::vector<std::uint16_t>& block) { return sum + block.size(); });
  const TriangleColumns* const kept = this->columnsForFew(counter, scale, count, executor);
  const Columns columns =
    kept ? kept->columns() : Columns(box, std::min(mostBuckets, samples.size()));
  Buckets<Ray> rays = distribute<Ray>(
    unknown.size(), columns.count(),
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t block = first; block < last; ++block)
      {
        for (const std::uint16_t number : unknown[block])
        {
          const std::size_t i = block * samplesPerBlock + number;
          const Eigen::Vector3d q = samples[i];
          const Ray ray = {q[0] * scale, q[1] * scale, q[2] * scale, i, 0};
          put(columns.of(ray.start()), ray);
        }
      }
    },
    executor, 1);
  unknown.clear(); // 2 bytes per ray, which tasks need no more

  RaysInColumns inColumns = {columns, std::vector<Ray*>(columns.count() + 1)};
  for (std::size_t column = 0; column < columns.count(); ++column)
  {
    inColumns.starts[column] = rays.begin(column);
  }
  inColumns.starts.back() = rays.end(columns.count() - 1);

  ColumnTasks tasks(counter, output, executor);
  if (kept)
  {
    tasks.run(inColumns, kept->triangles(), {0, 1});
    return;
  }
  tasks.run(inColumns, CandidateTriangles(chain_.size()), {0, 1});
}

} // namespace winding
