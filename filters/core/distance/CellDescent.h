// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "distance/NearestItems.h"
#include "distance/NearestLists.h"
#include "distance/NearestNumbers.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace winding
{

/**
 * The way from many samples down to cells of a few, whose distances are found from a list that they
 * share: of what may be nearest to any of them. Large cells have lists of a tree's nodes
 * (NearestLists.h), small ones of its items (NearestItems.h). Each task has a descent of its own,
 * which holds its lists.
 *
 * Samples is a set of samples in scaled coordinates with
 *   Part, some of the samples, which are next to each other;
 *   std::size_t count(part), and Bounds boxOf(part), the box of its samples;
 *   bool isAskedFor(part), whether any sample's distance is to be written;
 *   std::pair<Part, Part> halves(part), for a part of at least two samples;
 *   void forEach(part, f), which calls f(position, sample) for each sample that is asked for, where
 *     the sample's name is of a type Samples::Name;
 *   void write(squared, number, sample), where `squared` is the square of its distance, and
 *     `number` the nearest item's, if numbers are wanted (NearestNumbers.h);
 *   bool isSettled(part, distance, rounding), which may be left out: whether the distance of the
 *     middle of a part's box, as it is rounded, says all that is asked of its samples.
 * Samples that move within the box of their part have, in place of the last two,
 *   double settle(part, items, count), which evaluates them wherever they go. The items hold what
 *     is nearest to any place of the box; without items, it has to search the tree. It returns the
 *     samples times items that it has looked at;
 *   std::monostate Name.
 */
template <class Samples> class CellDescent
{
public:
  using Part = typename Samples::Part;

  /// Whether samples move.
  static constexpr bool areMoving = std::is_same_v<typename Samples::Name, std::monostate>;

  /// limit: distances beyond it, in scaled coordinates, are not asked for. Keeps references.
  /// `numbers`, if it is not null, gives samples the numbers of what is nearest, and there is no
  /// limit.
  CellDescent(const DistanceTree& tree, double limit, const Samples& samples,
    const NearestNumbers* numbers = nullptr)
    : tree_(tree)
    , limit_(limit)
    , samples_(samples)
    , numbers_(numbers)
    , lists_(tree, limit)
    , items_(tree)
  {
  }

  /// Writes the distances of a part's samples, and returns the parts that it left undone, since
  /// lists stayed long: they are for further tasks.
  std::vector<Part> run(const Part& part)
  {
    this->descend(part, 0, nullptr);
    return std::move(left_);
  }

private:
  /// Cells with at least this number of samples have lists of items.
  static constexpr std::size_t samplesPerList = 512;

  /// Lists with more items than this are too long: the cell is cut further, down to so few samples
  /// that they are searched for one by one. With 4096 items, grids of 128 samples along their side
  /// take a fifth longer for 5.5 million triangles and a tenth less for 250 000; with 16 384 it is
  /// the other way round (measured).
  static constexpr std::size_t mostItems = 6144, fewSamples = samplesAtOnce;

  /// Assumed number of items tested per item kept, where nodes are opened down to leaves. Where
  /// nodes wait until their items are few, 100 000 random samples of 250 000 triangles take 0.13 s
  /// by cells alone instead of 0.22 (measured).
  static constexpr std::size_t itemsForEachLeft = 2;

  /// Lists up to this length are not worth making shorter.
  static constexpr std::size_t fewItems = 16;

  /// A task leaves its rest to other tasks after this number of samples times items. Where all of a
  /// source is equally near, as at the centre of a sphere, tasks take some tenths of a second.
  static constexpr double mostWorkPerTask = 1 << 28;

  /// firstNode: where the list of the cell begins that the part lies in; nearby: a point of the
  /// source, or null.
  void descend(const Part& part, std::size_t firstNode, const SourcePoint* nearby)
  {
    if (!samples_.isAskedFor(part))
    {
      return;
    }
    if (lists_.work() + items_.work() + work_ > mostWorkPerTask && hasEvaluated_)
    {
      left_.push_back(part);
      return;
    }
    NearestCell cell = cellOf(samples_.boxOf(part));
    const std::size_t count = samples_.count(part);
    const std::size_t lastNode = lists_.size();
    lists_.append(cell, firstNode, nearby);
    if (lists_.size() == lastNode)
    {
      this->evaluate(part, nullptr, 0); // all of the source is beyond the limit
      return;
    }
    if (this->isSettled(part, cell))
    {
      hasEvaluated_ = true;
    }
    else if (cell.isOnePlace())
    {
      this->searchOnce(part, cell.low, cell.nearest);
    }
    else if (count <= samplesPerList && this->openIfShort(cell, lastNode))
    {
      items_.keep(cell, lists_.items(lastNode), this->candidatesAt(0));
      this->refine(part, 0);
    }
    else if (count <= fewSamples)
    {
      this->searchEach(part, cell.nearest);
    }
    else
    {
      const Parts parts = this->partsOf(part);
      for (std::size_t i = 0; i < parts.count; ++i)
      {
        this->descend(parts.part[i], lastNode, &cell.nearest);
      }
    }
    lists_.removeFrom(lastNode);
  }

  /// Opens the nodes of a cell's list down to leaves, if it has few items. Returns whether few
  /// enough are left.
  bool openIfShort(const NearestCell& cell, std::size_t firstNode)
  {
    if (lists_.itemsFrom(firstNode) > itemsForEachLeft * mostItems)
    {
      return false;
    }
    lists_.open(cell, firstNode);
    return lists_.itemsFrom(firstNode) <= mostItems;
  }

  bool isSettled(const Part& part, const NearestCell& cell) const
  {
    if constexpr (canSettle<Samples>(0))
    {
      const double distance = (cell.center() - cell.nearest.position).norm();
      return samples_.isSettled(part, distance, cell.nearest.rounding);
    }
    return false;
  }

  template <class Some>
  static constexpr auto canSettle(int)
    -> decltype(std::declval<const Some&>().isSettled(std::declval<const Part&>(), 0.0, 0.0))
  {
    return true;
  }
  template <class> static constexpr bool canSettle(long) { return false; }

  struct Parts
  {
    Part part[samplesAtOnce];
    std::size_t count = 0;
  };

  /// Halves a part three times over, except for parts whose samples are searched for.
  Parts partsOf(const Part& part) const
  {
    static_assert(samplesAtOnce == 1 << 3);
    Parts parts;
    this->cut(part, 3, parts);
    return parts;
  }

  void cut(const Part& part, int times, Parts& parts) const
  {
    if (times == 0 || samples_.count(part) <= fewSamples)
    {
      parts.part[parts.count++] = part;
      return;
    }
    const std::pair<Part, Part> halves = samples_.halves(part);
    this->cut(halves.first, times - 1, parts);
    this->cut(halves.second, times - 1, parts);
  }

  Candidates& candidatesAt(std::size_t depth)
  {
    while (candidates_.size() <= depth)
    {
      candidates_.push_back(tree_.noCandidates());
    }
    return candidates_[depth];
  }

  /// Writes the distances of a part's samples from the candidates at a depth.
  void refine(const Part& part, std::size_t depth)
  {
    const Candidates& candidates = candidates_[depth];
    if (samples_.count(part) <= fewSamples || candidates.size() <= fewItems)
    {
      this->evaluate(part, candidates.numbers(), candidates.size());
      return;
    }
    const Parts parts = this->partsOf(part);
    NearestCell cells[samplesAtOnce];
    std::transform(parts.part, parts.part + parts.count, cells,
      [this](const Part& some) { return cellOf(samples_.boxOf(some)); });
    items_.findNearest(cells, parts.count, candidates);
    for (std::size_t i = 0; i < parts.count; ++i)
    {
      const Part& some = parts.part[i];
      if (!samples_.isAskedFor(some) || this->isSettled(some, cells[i]))
      {
        continue;
      }
      if (samples_.count(some) <= fewSamples)
      {
        const std::vector<std::uint32_t>& numbers = items_.numbers(cells[i], candidates);
        this->evaluate(some, numbers.data(), numbers.size());
        continue;
      }
      items_.keep(cells[i], candidates, this->candidatesAt(depth + 1));
      this->refine(some, depth + 1);
    }
  }

  /// The number of what is nearest to a sample, found by a search from a point that is near; none
  /// where none is wanted.
  std::uint32_t numberOf(const Eigen::Vector3d& position, const SourcePoint& nearby) const
  {
    return numbers_ ? numbers_->find(&position, 1, nearby.item).number : NearestNumbers::none;
  }

  /// The square of a sample's distance, found by a search from a point that is near.
  double searched(const Eigen::Vector3d& position, const SourcePoint& nearby)
  {
    hasEvaluated_ = true;
    Nearest nearest = {limit_ * limit_, {0, 0, 0}};
    tree_.compare(position, nearby.item, nearest);
    // One sample is compared with an item in the time of several.
    work_ += static_cast<double>(samplesAtOnce * (tree_.findNearest(position, 0, nearest) + 1));
    return nearest.squared;
  }

  void searchEach(const Part& part, const SourcePoint& nearby)
  {
    if constexpr (areMoving)
    {
      this->evaluate(part, nullptr, 0);
    }
    else
    {
      samples_.forEach(part,
        [&](const Eigen::Vector3d& position, const typename Samples::Name& sample) {
          samples_.write(
            this->searched(position, nearby), this->numberOf(position, nearby), sample);
        });
    }
  }

  /// Writes the distance of any number of samples at one place.
  void searchOnce(const Part& part, const Eigen::Vector3d& place, const SourcePoint& nearby)
  {
    if constexpr (areMoving)
    {
      this->evaluate(part, nullptr, 0);
    }
    else
    {
      const double squared = this->searched(place, nearby);
      const std::uint32_t number = this->numberOf(place, nearby);
      samples_.forEach(part, [&](const Eigen::Vector3d&, const typename Samples::Name& sample)
        { samples_.write(squared, number, sample); });
    }
  }

  /// Writes the distances of samples from items; there are none where all of the source is
  /// beyond the limit.
  void evaluate(const Part& part, const std::uint32_t* items, std::size_t itemCount)
  {
    hasEvaluated_ = true;
    if constexpr (areMoving)
    {
      work_ += samples_.settle(part, items, itemCount);
    }
    else
    {
      samples_.forEach(part,
        [&](const Eigen::Vector3d& position, const typename Samples::Name& sample)
        {
          names_[block_.count] = sample;
          block_.set(block_.count++, position);
          if (block_.count == SampleBlock::capacity)
          {
            this->writeBlock(items, itemCount);
          }
        });
      this->writeBlock(items, itemCount);
    }
  }

  void writeBlock(const std::uint32_t* items, std::size_t itemCount)
  {
    const std::size_t padded = (block_.count + samplesAtOnce - 1) / samplesAtOnce * samplesAtOnce;
    alignas(64) double squared[SampleBlock::capacity];
    std::fill_n(squared, padded, std::numeric_limits<double>::infinity());
    tree_.lowerSquaredDistances(items, itemCount, block_, squared);
    work_ += static_cast<double>(padded * itemCount);
    if (numbers_)
    {
      numbers_->findAmong(items, itemCount, block_, squared, found_);
    }
    for (std::size_t n = 0; n < block_.count; ++n)
    {
      samples_.write(squared[n], numbers_ ? found_[n] : NearestNumbers::none, names_[n]);
    }
    block_.count = 0;
  }

  const DistanceTree& tree_;
  const double limit_;
  const Samples& samples_;
  const NearestNumbers* numbers_;
  NearestLists lists_;
  NearestItems items_;
  std::deque<Candidates> candidates_; ///< of the cells that lie in each other, from the largest on
  SampleBlock block_;
  typename Samples::Name names_[SampleBlock::capacity]; ///< of the samples of the block
  std::uint32_t found_[SampleBlock::capacity];          ///< numbers of what is nearest to them
  double work_ = 0;           ///< samples times items of the cells that are done
  bool hasEvaluated_ = false; ///< true after the first cell, so that every task gets on
  std::vector<Part> left_;
};

/// All parts that tasks have left undone.
template <class Part> std::vector<Part> joined(const std::vector<std::vector<Part>>& left)
{
  std::vector<Part> parts;
  for (const std::vector<Part>& some : left)
  {
    parts.insert(parts.end(), some.begin(), some.end());
  }
  return parts;
}

/// Whether tasks show progress. It would begin again with tasks that do what others have left.
enum class TaskProgress
{
  shown,
  hidden
};

/// Writes the distances of the samples of some parts, each in a task or in more. Throws
/// Interrupted.
template <class Samples>
void evaluateByCells(const DistanceTree& tree, double limit, const Samples& samples,
  std::vector<typename Samples::Part> parts, Executor& executor,
  TaskProgress progress = TaskProgress::shown, const NearestNumbers* numbers = nullptr)
{
  for (; !parts.empty(); progress = TaskProgress::hidden)
  {
    std::vector<std::vector<typename Samples::Part>> left(parts.size());
    const auto work = [&](std::size_t n)
    {
      left[n] = CellDescent<Samples>(tree, limit, samples, numbers).run(parts[n]);
    };
    if (progress == TaskProgress::shown)
    {
      executor.run(parts.size(), work);
    }
    else
    {
      executor.runBriefly(parts.size(), work);
    }
    parts = joined(left);
  }
}

} // namespace winding
