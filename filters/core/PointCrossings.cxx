#include "PointCrossings.h"

#include "BucketSort.h"
#include "RayColumns.h"
#include "RayCounter.h"
#include "UnitScale.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// Samples or triangles of a block: so few that small inputs occupy several cores, too.
constexpr std::size_t perBlock = 4096;

/// Lists of triangles are made for as many columns at a time as hold so many entries per triangle.
constexpr std::size_t mostEntries = 16;

/// Of what the executor shows as progress.
struct Share
{
  double first, last;

  double at(double part) const { return first + (last - first) * part; }
  Share part(double from, double to) const { return {this->at(from), this->at(to)}; }
};

/// Sets the executor's share, and what it was in the end.
class ShareOfExecutor
{
public:
  explicit ShareOfExecutor(Executor& executor)
    : executor_(executor)
    , whole_{executor.share().first, executor.share().second}
  {
  }
  ~ShareOfExecutor() { this->set({0, 1}); }
  ShareOfExecutor(const ShareOfExecutor&) = delete;
  ShareOfExecutor& operator=(const ShareOfExecutor&) = delete;

  void set(const Share& share)
  {
    executor_.setShare(whole_.at(share.first), whole_.at(share.last));
  }

private:
  Executor& executor_;
  Share whole_;
};

/// All triangles of a surface, or some of them.
class Candidates
{
public:
  explicit Candidates(std::size_t count)
    : count_(count)
  {
  }
  explicit Candidates(const TriangleIds& ids)
    : ids_(ids.data())
    , count_(ids.size())
  {
  }

  std::size_t size() const { return count_; }
  std::uint32_t operator[](std::size_t i) const
  {
    return ids_ ? ids_[i] : static_cast<std::uint32_t>(i);
  }

private:
  const std::uint32_t* ids_ = nullptr;
  std::size_t count_;
};

/// Which of some triangles reach which columns of rays.
class ReachOfTriangles
{
public:
  /// Keeps references. Throws Interrupted.
  ReachOfTriangles(const RayCounter& counter, const Candidates& triangles,
    const RaysInColumns& rays, Executor& executor)
    : counter_(counter)
    , triangles_(triangles)
    , columns_(rays.columns)
    , executor_(executor)
    , ranges_(new ColumnRange[triangles.size()])
  {
    constexpr std::size_t columnsPerBlock = 64;
    std::vector<RayBox> boxes(columns_.count());
    runBlocks(
      boxes.size(), columnsPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t column = first; column < last; ++column)
        {
          boxes[column] = RayBox(rays.starts[column], rays.starts[column + 1]);
        }
      },
      executor);
    RayBox all;
    for (const RayBox& box : boxes)
    {
      all.add(box);
    }
    std::atomic<std::size_t> inBoxes{0};
    runBlocks(
      triangles.size(), perBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        std::size_t ours = 0;
        for (std::size_t i = first; i < last; ++i)
        {
          ranges_[i] = this->rangeOf(triangles[i], all, boxes);
          ours += ranges_[i].isEmpty() ? 0 : ranges_[i].size();
        }
        inBoxes += ours;
      },
      executor);
    this->makeRounds(inBoxes);
  }

  /// Rounds are runs of columns of which there are lists at a time: starts, and the end.
  const std::vector<std::size_t>& rounds() const { return rounds_; }

  /// The triangles that reach the columns first … last − 1. Throws Interrupted.
  Buckets<std::uint32_t> inColumns(std::size_t first, std::size_t last) const
  {
    const Window window(first, last, columns_);
    return distribute<std::uint32_t>(
      triangles_.size(), last - first,
      [&](std::size_t from, std::size_t to, const auto& put)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          this->forEachColumn(
            i, window, [&](std::size_t column) { put(column - first, triangles_[i]); });
        }
      },
      executor_, perBlock);
  }

private:
  /// The columns first … last − 1, and the rows that they are in.
  struct Window
  {
    Window(std::size_t columnsBegin, std::size_t columnsEnd, const Columns& columns)
      : first(columnsBegin)
      , last(columnsEnd)
      , firstRow(static_cast<std::uint16_t>(columnsBegin / columns.perRow()))
      , lastRow(static_cast<std::uint16_t>((columnsEnd - 1) / columns.perRow()))
    {
    }

    std::size_t first, last;
    std::uint16_t firstRow, lastRow;
  };

  ColumnRange rangeOf(std::uint32_t id, const RayBox& all, const std::vector<RayBox>& boxes) const
  {
    const TriangleBox box = counter_.box(id);
    if (!all.isReachedBy(box))
    {
      return ColumnRange::none();
    }
    const ColumnRange range = columns_.of(box);
    const bool isReached =
      range.size() > 1 || boxes[columns_.number(range.firstY, range.firstZ)].isReachedBy(box);
    return isReached ? range : ColumnRange::none();
  }

  /// Calls visit for those of a window that triangle i reaches.
  template <class Visit>
  void forEachColumn(std::size_t i, const Window& window, const Visit& visit) const
  {
    ColumnRange range = ranges_[i];
    range.firstZ = std::max(range.firstZ, window.firstRow);
    range.lastZ = std::min(range.lastZ, window.lastRow);
    if (range.isEmpty())
    {
      return;
    }
    const auto visitOurs = [&](std::size_t column)
    {
      if (column >= window.first && column < window.last)
      {
        visit(column);
      }
    };
    if (!range.isNarrow())
    {
      counter_.footprint(triangles_[i], columns_, range).forEach(visitOurs);
      return;
    }
    for (int z = range.firstZ; z <= range.lastZ; ++z)
    {
      for (int y = range.firstY; y <= range.lastY; ++y)
      {
        visitOurs(columns_.number(y, z));
      }
    }
  }

  void makeRounds(std::size_t inBoxes)
  {
    const std::size_t most = mostEntries * triangles_.size();
    rounds_ = {0};
    if (inBoxes > most)
    {
      std::vector<std::size_t> entries(columns_.count(), 0);
      std::mutex mutex;
      runBlocks(
        triangles_.size(), perBlock,
        [&](std::size_t, std::size_t first, std::size_t last)
        {
          std::vector<std::size_t> ours(entries.size(), 0);
          const Window window(0, entries.size(), columns_);
          for (std::size_t i = first; i < last; ++i)
          {
            this->forEachColumn(i, window, [&ours](std::size_t column) { ++ours[column]; });
          }
          const std::lock_guard<std::mutex> lock(mutex);
          std::transform(ours.begin(), ours.end(), entries.begin(), entries.begin(), std::plus<>());
        },
        executor_);
      std::size_t sum = 0;
      for (std::size_t column = 0; column < entries.size(); ++column)
      {
        if (sum + entries[column] > most)
        {
          rounds_.push_back(column);
          sum = 0;
        }
        sum += entries[column];
      }
    }
    rounds_.push_back(columns_.count());
  }

  const RayCounter& counter_;
  const Candidates& triangles_;
  const Columns& columns_;
  Executor& executor_;
  std::unique_ptr<ColumnRange[]> ranges_;
  std::vector<std::size_t> rounds_;
};

/**
 * Counts and writes the crossings of rays in columns, a task to a column. A task that has too much to
 * do gives up, and its column is divided into columns of its own: so all tasks are short, of whatever
 * there is much in few columns.
 */
class ColumnTasks
{
public:
  ColumnTasks(const RayCounter& counter, const FieldOutput& output, Executor& executor)
    : counter_(counter)
    , output_(output)
    , executor_(executor)
    , share_(executor)
  {
  }

  /// False when interrupted; or throws Interrupted.
  bool run(const RaysInColumns& rays, const Candidates& triangles, const Share& share)
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
      if (!this->run(rays, reach, first, last, share.part(until(first), until(last))))
      {
        return false;
      }
    }
    return true;
  }

private:
  struct Full
  {
    std::size_t column;
    TriangleIds triangles;
  };

  /// The columns first … last − 1.
  bool run(const RaysInColumns& rays, const ReachOfTriangles& reach, std::size_t first,
    std::size_t last, const Share& share)
  {
    std::vector<Full> full;
    double tasksEnd;
    {
      const Buckets<std::uint32_t> triangles = reach.inColumns(first, last);
      bool mayGiveUp = false; // a guess: where it is wrong, what is left shows no progress
      for (std::size_t i = 0; i < triangles.count(); ++i)
      {
        mayGiveUp = mayGiveUp || static_cast<double>(rays.size(first + i)) *
                                     static_cast<double>(triangles.size(i)) >
                                   static_cast<double>(RayCounter::mostSteps);
      }
      std::mutex mutex;
      tasksEnd = mayGiveUp ? 0.5 : 1;
      share_.set(share.part(0, tasksEnd));
      const bool isComplete = executor_.run(last - first,
        [&](std::size_t i)
        {
          Ray* const begin = rays.starts[first + i];
          Ray* const end = rays.starts[first + i + 1];
          if (begin == end)
          {
            return;
          }
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
      if (!isComplete)
      {
        return false;
      }
    }
    const Share rest = share.part(tasksEnd, 1);
    for (std::size_t i = 0; i < full.size(); ++i)
    {
      const double count = static_cast<double>(full.size()), at = static_cast<double>(i);
      const std::size_t column = full[i].column;
      if (!this->divide(rays.starts[column], rays.starts[column + 1], full[i].triangles,
            rest.part(at / count, (at + 1) / count)))
      {
        return false;
      }
    }
    return true;
  }

  /// Into columns that are not too full even if all triangles reach all of them, if possible.
  bool divide(Ray* first, Ray* last, const TriangleIds& triangles, const Share& share)
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
      return this->run(inColumns, Candidates(triangles), share);
    }
    share_.set(share);
    return executor_.run(1,
      [&](std::size_t)
      {
        counter_.countAll(first, last, triangles);
        this->write(first, last);
      });
  }

  void write(const Ray* first, const Ray* last) const
  {
    for (; first != last; ++first)
    {
      output_.fill(first->crossings, first->sample, 1);
    }
  }

  const RayCounter& counter_;
  const FieldOutput& output_;
  Executor& executor_;
  ShareOfExecutor share_;
};

} // namespace

PointCrossings::PointCrossings(const Surface& surface)
  : surface_(surface)
{
}

EvaluationCost PointCrossings::expectedCost(std::size_t samples) const
{
  RaysThroughTriangles rays = {0, 0};
  const Eigen::Array2d sizes = surface_.bounds.sizes().tail<2>();
  if (!surface_.bounds.isEmpty() && sizes.minCoeff() > 0)
  {
    for (const Triangle& ids : surface_.triangles)
    {
      const Eigen::Array2d a = surface_.vertices[ids[0]].tail<2>();
      const Eigen::Array2d u = (surface_.vertices[ids[1]].tail<2>().array() - a) / sizes;
      const Eigen::Array2d v = (surface_.vertices[ids[2]].tail<2>().array() - a) / sizes;
      rays.layers += 0.5 * std::abs(u[0] * v[1] - u[1] * v[0]);
      rays.widths += (u.max(v).max(0.0) - u.min(v).min(0.0)).maxCoeff();
    }
  }
  return costOfCrossings(surface_.triangles.size(), samples, rays);
}

bool PointCrossings::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
try
{
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
    samples.size(), perBlock,
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

  if (box.isEmpty())
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
    executor, perBlock);
  RaysInColumns inColumns = {columns, std::vector<Ray*>(columns.count() + 1)};
  for (std::size_t column = 0; column < columns.count(); ++column)
  {
    inColumns.starts[column] = rays.begin(column);
  }
  inColumns.starts.back() = rays.end(columns.count() - 1);

  const RayCounter counter(surface_, scale);
  return ColumnTasks(counter, output, executor)
    .run(inColumns, Candidates(surface_.triangles.size()), {0, 1});
}
catch (const Interrupted&)
{
  return false;
}

} // namespace winding
