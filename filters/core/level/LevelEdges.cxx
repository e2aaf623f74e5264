// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelEdges.h"

#include "base/Refusal.h"
#include "level/SideRuns.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace winding
{

namespace
{

constexpr double bytesPerSample = sizeof(float) + 1;

/// Finds the runs of the result of an operation on rows of several operands. Each has one run or
/// more.
void mergeRuns(const std::vector<std::vector<RowRun>>& rows, BooleanOperation operation,
  std::vector<RowRun>& merged)
{
  std::vector<const RowRun*> runs;
  for (const std::vector<RowRun>& row : rows)
  {
    runs.push_back(row.data());
  }
  const int width = rows.front().back().end;
  merged.clear();
  for (int begin = 0, end = width; begin < width; begin = end, end = width)
  {
    std::size_t inside = 0;
    for (const RowRun* run : runs)
    {
      inside += run->value != 0;
      end = std::min(end, run->end);
    }
    merged.push_back(
      {begin, end, isInResult(operation, runs.size(), inside, runs.front()->value != 0)});
    for (const RowRun*& run : runs)
    {
      run += run->end == end && end < width;
    }
  }
}

int layersOfSlab(const Grid& grid, double bytes)
{
  // The layer that slabs share counts little among 16 or more, and multiples of 16 suit far fields.
  constexpr int few = 16;
  const double layers = bytes / (bytesPerSample * grid.dimensions[0] * grid.dimensions[1]);
  return layers < grid.dimensions[2] ? std::max(few, static_cast<int>(layers) / few * few)
                                     : grid.dimensions[2];
}

} // namespace

/// The samples of a layer as the changes of their state, row by row: the inside rule's answer or w
/// changes there, walking along x.
class LevelEdges::Layer
{
public:
  struct State
  {
    bool isInside = false;
    std::int8_t winding = 0; ///< 0 unless whole rows are integers
  };

  /// The state changes between the samples i and i + 1.
  struct Change
  {
    int i;
    State after;
  };

  /// The changes along one row.
  struct Row
  {
    State begin;
    const Change *first = nullptr, *last = nullptr;
  };

  /// Returns the state of a run with value 1 inside and 0 outside.
  static State sideOf(const RowRun& run) { return {run.value != 0, 0}; }

  explicit Layer(int border)
    : border_(border)
  {
  }

  /// Adds the next row; `runs` cover it.
  template <class Runs, class StateOf> void addRow(const Runs& runs, const StateOf& stateOf)
  {
    // The border's samples are outside.
    State before = border_ > 0 ? State() : stateOf(runs.front());
    begins_.push_back(before);
    starts_.push_back(changes_.size());
    for (const RowRun& run : runs)
    {
      this->change(before, stateOf(run), run.begin - 1);
    }
    if (border_ > 0)
    {
      this->change(before, State(), runs.back().end - 1);
    }
  }

  Row row(int j) const
  {
    const auto n = static_cast<std::size_t>(j);
    if (j < 0 || n >= starts_.size())
    {
      return {};
    }
    const std::size_t last = n + 1 < starts_.size() ? starts_[n + 1] : changes_.size();
    return {begins_[n], changes_.data() + starts_[n], changes_.data() + last};
  }

private:
  void change(State& before, State after, int at)
  {
    if (before.isInside != after.isInside || before.winding != after.winding)
    {
      changes_.push_back({at, after});
      before = after;
    }
  }

  int border_;
  std::vector<std::size_t> starts_;
  std::vector<State> begins_;
  std::vector<Change> changes_;
};

/// The values of the samples of some layers, among them the last layer of the slab before.
class LevelEdges::Slab
{
public:
  Slab(const Grid& grid, int layers)
    : extent_(grid.wholeExtent())
    , layerSize_(
        static_cast<std::size_t>(grid.dimensions[0]) * static_cast<std::size_t>(grid.dimensions[1]))
    , values_(layerSize_ * static_cast<std::size_t>(layers + 1))
    , inside_(layerSize_ * static_cast<std::size_t>(layers))
  {
    extent_[4] = extent_[5] = -1;
  }

  /// Evaluates layers firstLayer to lastLayer.
  void evaluate(const Field& field, const Grid& grid, int firstLayer, int lastLayer,
    const InsideTest& isInside, Executor& executor)
  {
    const auto lastBefore = static_cast<std::ptrdiff_t>(layerSize_) * (extent_[5] - extent_[4]);
    if (lastBefore > 0)
    {
      std::copy_n(values_.begin() + lastBefore, layerSize_, values_.begin());
    }
    extent_[4] = firstLayer - 1;
    extent_[5] = lastLayer;
    Extent evaluated = extent_;
    evaluated[4] = firstLayer;
    FieldOutput output;
    output.values = values_.data() + layerSize_;
    output.inside = inside_.data();
    output.isInside = isInside;
    field.evaluate(grid, evaluated, output, executor);
  }

  float value(const std::array<int, 3>& sample) const
  {
    return values_[sampleNumber(extent_, sample[0], sample[1], sample[2])];
  }

  /// Describes a row as runs, with value 1 inside and 0 outside.
  void findRuns(int j, int k, std::vector<RowRun>& runs) const
  {
    const std::uint8_t* row = inside_.data() + sampleNumber(extent_, 0, j, k) - layerSize_;
    describeSides(row, extent_[1] + 1, runs);
  }

  SideCounts countSides(int k, const InsideTest& isInside) const
  {
    const float* values = values_.data() + sampleNumber(extent_, 0, 0, k);
    SideCounts counts;
    for (std::size_t i = 0; i < layerSize_; ++i)
    {
      counts.add(values[i], isInside);
    }
    return counts;
  }

private:
  Extent extent_;
  std::size_t layerSize_;
  std::vector<float> values_;
  std::vector<std::uint8_t> inside_;
};

LevelEdges::LevelEdges(const Field& field, const Grid& grid, const InsideTest& isInside,
  bool withBorder, double slabBytes)
  : field_(&field)
  , grid_(grid)
  , isInside_(isInside)
  , border_(withBorder ? 1 : 0)
  , layersPerSlab_(layersOfSlab(grid, slabBytes))
  , rows_(field.integerRows())
  , lastLayer_(std::make_unique<Layer>(border_))
  , starts_(this->lineOf(0, -border_, grid.dimensions[2] + border_) + 1, 0)
  , beginsInside_(starts_.size() / 3, 0)
{
}

LevelEdges::LevelEdges(const Grid& grid, bool withBorder, int layersAtOnce,
  const LayerRuns& layerRuns, Executor& executor)
  : field_(nullptr)
  , grid_(grid)
  , border_(withBorder ? 1 : 0)
  , starts_(this->lineOf(0, -border_, grid.dimensions[2] + border_) + 1, 0)
  , beginsInside_(starts_.size() / 3, 0)
{
  const auto depth = static_cast<std::size_t>(grid.dimensions[2]);
  std::vector<Layer> layers(depth + 2, Layer(border_));
  const auto atOnce = static_cast<std::size_t>(layersAtOnce);
  executor.run((depth + atOnce - 1) / atOnce,
    [&](std::size_t task)
    {
      const auto first = task * atOnce, end = std::min(depth, first + atOnce);
      const RowRuns rowRuns = layerRuns(static_cast<int>(first), static_cast<int>(end));
      std::vector<RowRun> runs;
      for (std::size_t k = first; k < end; ++k)
      {
        for (int j = 0; j < grid.dimensions[1]; ++j)
        {
          rowRuns(j, static_cast<int>(k), runs);
          layers[k + 1].addRow(runs, Layer::sideOf);
        }
      }
    });
  this->addEdges(layers, nullptr, executor);
  nextLayer_ = grid.dimensions[2];
  this->endAfterLastLayer();
}

LevelEdges::LevelEdges(const std::vector<const LevelEdges*>& operands, BooleanOperation operation,
  const Grid& grid, Executor& executor)
  : LevelEdges(
      grid, operands.front()->border_ > 0, 1,
      [&operands, operation](int, int) -> RowRuns
      {
        return [&operands, operation, rows = std::vector<std::vector<RowRun>>(operands.size())](
                 int j, int k, std::vector<RowRun>& merged) mutable
        {
          for (std::size_t n = 0; n < operands.size(); ++n)
          {
            operands[n]->findRuns(j, k, rows[n]);
          }
          mergeRuns(rows, operation, merged);
        };
      },
      executor)
{
}

LevelEdges::~LevelEdges() = default;

double LevelEdges::bytesOfRows(const Grid& grid)
{
  return (3.0 * sizeof(std::uint32_t) + 1) * grid.dimensions[1] * grid.dimensions[2];
}

double LevelEdges::bytesOfSlab(const Grid& grid)
{
  return bytesPerSample * (layersOfSlab(grid, usualSlabBytes) + 1) * grid.dimensions[0] *
         grid.dimensions[1];
}

int LevelEdges::endOfNext() const
{
  const int layers = rows_ ? grid_.dimensions[2] : layersPerSlab_;
  return std::min(nextLayer_ + layers, grid_.dimensions[2]);
}

void LevelEdges::advance(Executor& executor)
{
  if (rows_)
  {
    this->advanceByRuns(executor);
  }
  else
  {
    this->advanceBySamples(executor);
  }
  if (this->isDone())
  {
    this->endAfterLastLayer();
  }
}

/// Ends the table of rows: no edge begins in the border behind the last layer.
void LevelEdges::endAfterLastLayer()
{
  std::fill(starts_.begin() + static_cast<std::ptrdiff_t>(this->lineOf(0, -border_, nextLayer_)),
    starts_.end(), static_cast<std::uint32_t>(edges_.size()));
}

void LevelEdges::findRuns(int j, int k, std::vector<RowRun>& runs) const
{
  const auto [first, last] = this->inRow(0, j, k);
  RowRun run = {0, 0, this->beginsInside(j, k)};
  runs.clear();
  for (std::size_t edge = first; edge < last; ++edge)
  {
    run.end = edges_[edge].sample[0] + 1;
    if (run.end > run.begin)
    {
      runs.push_back(run);
    }
    run = {run.end, 0, !edges_[edge].firstIsInside};
  }
  run.end = grid_.dimensions[0];
  if (run.end > run.begin)
  {
    runs.push_back(run);
  }
}

bool LevelEdges::reachesBorder() const
{
  const int width = grid_.dimensions[0], depth = grid_.dimensions[1], height = grid_.dimensions[2];
  std::vector<RowRun> runs;
  for (int k = 0; k < height; ++k)
  {
    for (int j = 0; j < depth; ++j)
    {
      this->findRuns(j, k, runs);
      const bool isOuter = j == 0 || j == depth - 1 || k == 0 || k == height - 1;
      for (const RowRun& run : runs)
      {
        if (run.value != 0 && (isOuter || run.begin == 0 || run.end == width))
        {
          return true;
        }
      }
    }
  }
  return false;
}

void LevelEdges::writeInside(unsigned char* inside, Executor& executor) const
{
  const Extent extent = grid_.wholeExtent();
  runBlocks(
    static_cast<std::size_t>(grid_.dimensions[2]), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = static_cast<int>(layer);
      std::vector<RowRun> runs;
      for (int j = 0; j < grid_.dimensions[1]; ++j)
      {
        this->findRuns(j, k, runs);
        unsigned char* const row = inside + sampleNumber(extent, 0, j, k);
        for (const RowRun& run : runs)
        {
          std::fill(row + run.begin, row + run.end, static_cast<unsigned char>(run.value));
        }
      }
    },
    executor);
}

void LevelEdges::addSides(const std::vector<SideCounts>& layers)
{
  for (const SideCounts& layer : layers)
  {
    sides_ += layer;
  }
}

void LevelEdges::advanceByRuns(Executor& executor)
{
  const auto depth = static_cast<std::size_t>(grid_.dimensions[2]);
  std::vector<Layer> layers(depth + 2, Layer(border_));
  const auto stateOf = [this](const RowRun& run)
  {
    return Layer::State{
      isInside_(run.value), static_cast<std::int8_t>(std::clamp<int>(run.value, -127, 127))};
  };
  std::vector<SideCounts> sides(depth);
  // All rows of a layer make one band.
  const std::unique_ptr<const RowCrossings::OnGrid> onGrid =
    rows_->on(grid_, grid_.wholeExtent(), {0, grid_.dimensions[1]}, executor);
  const auto findLayer = [&](std::size_t k)
  {
    onGrid->evaluate(static_cast<int>(k), 0,
      [&](int, int, const std::vector<RowRun>& runs)
      {
        layers[k + 1].addRow(runs, stateOf);
        for (const RowRun& run : runs)
        {
          sides[k].add(run.value, isInside_, static_cast<std::size_t>(run.end - run.begin));
        }
      });
  };
  executor.run(depth, findLayer);
  this->addSides(sides);
  this->addEdges(layers, nullptr, executor);
  nextLayer_ = grid_.dimensions[2];
}

void LevelEdges::advanceBySamples(Executor& executor)
{
  const int end = this->endOfNext();
  if (!slab_)
  {
    slab_ = std::make_unique<Slab>(grid_, end);
  }
  slab_->evaluate(*field_, grid_, nextLayer_, end - 1, isInside_, executor);
  const auto count = static_cast<std::size_t>(end - nextLayer_);
  std::vector<Layer> layers(count + 1, Layer(border_));
  layers[0] = std::move(*lastLayer_);
  std::vector<SideCounts> sides(count);
  runBlocks(
    count, 1,
    [&](std::size_t n, std::size_t, std::size_t)
    {
      const int k = nextLayer_ + static_cast<int>(n);
      std::vector<RowRun> runs;
      for (int j = 0; j < grid_.dimensions[1]; ++j)
      {
        slab_->findRuns(j, k, runs);
        layers[n + 1].addRow(runs, Layer::sideOf);
      }
      if (isInside_.rule == InsideRule::signedThreshold)
      {
        sides[n] = slab_->countSides(k, isInside_);
      }
    },
    executor);
  this->addSides(sides);
  if (end == grid_.dimensions[2])
  {
    layers.emplace_back(border_);
  }
  this->addEdges(layers, slab_.get(), executor);
  *lastLayer_ = std::move(layers.back());
  nextLayer_ = end;
  if (this->isDone())
  {
    slab_ = nullptr;
  }
}

namespace
{

/// Finds the samples from `begin` to `last` at which one of two rows is inside and the other is
/// not. Calls visit(first, end, state of a, state of b) for samples first … end − 1 with the same
/// states, ascending.
template <class Row, class Visit>
void forEachDifference(Row a, Row b, int begin, int last, const Visit& visit)
{
  while (begin <= last)
  {
    int end = last + 1;
    for (const Row* row : {&a, &b})
    {
      end = row->first != row->last ? std::min(end, row->first->i + 1) : end;
    }
    if (a.begin.isInside != b.begin.isInside && begin < end)
    {
      visit(begin, end, a.begin, b.begin);
    }
    for (Row* row : {&a, &b})
    {
      if (row->first != row->last && row->first->i + 1 == end)
      {
        row->begin = row->first->after;
        ++row->first;
      }
    }
    begin = end;
  }
}

} // namespace

/// Adds the edges that begin in all of these layers but the last; the first layer is the one before
/// nextLayer_.
void LevelEdges::addEdges(const std::vector<Layer>& layers, const Slab* slab, Executor& executor)
{
  const int firstRow = -border_, lastRow = grid_.dimensions[1] - 1 + border_;
  const int firstSample = -border_, lastSample = grid_.dimensions[0] - 1 + border_;
  // Calls visit(axis, j, first i, end of i, states of both samples) for all edges of a layer.
  const auto forEachEdge = [&](std::size_t layer, int k, const auto& visit)
  {
    for (int j = firstRow; j <= lastRow; ++j)
    {
      const Layer::Row row = layers[layer].row(j);
      Layer::State before = row.begin;
      for (const Layer::Change* change = row.first; change != row.last; ++change)
      {
        if (before.isInside != change->after.isInside)
        {
          visit(0, j, change->i, change->i + 1, before, change->after);
        }
        before = change->after;
      }
      const auto forOthers = [&](int axis, const Layer::Row& other)
      {
        forEachDifference(row, other, firstSample, lastSample,
          [&](int begin, int end, Layer::State a, Layer::State b)
          { visit(axis, j, begin, end, a, b); });
      };
      if (j < lastRow)
      {
        forOthers(1, layers[layer].row(j + 1));
      }
      if (k < grid_.dimensions[2] - 1 + border_)
      {
        forOthers(2, layers[layer + 1].row(j));
      }
    }
  };
  // Without a border no edge begins before the first layer.
  const std::size_t first = nextLayer_ == 0 && border_ == 0 ? 1 : 0;
  const std::size_t count = layers.size() - 1 - first;
  const auto layerOf = [&](std::size_t n)
  {
    return nextLayer_ - 1 + static_cast<int>(n + first);
  };

  runBlocks(
    count, 1,
    [&](std::size_t n, std::size_t, std::size_t)
    {
      const int k = layerOf(n);
      for (int j = firstRow; j <= lastRow; ++j)
      {
        beginsInside_[this->lineOf(0, j, k) / 3] = layers[n + first].row(j).begin.isInside;
      }
      forEachEdge(n + first, k,
        [&](int axis, int j, int begin, int end, Layer::State, Layer::State)
        { starts_[this->lineOf(axis, j, k) + 1] += static_cast<std::uint32_t>(end - begin); });
    },
    executor);
  const auto sumsBegin =
    starts_.begin() + static_cast<std::ptrdiff_t>(this->lineOf(0, firstRow, layerOf(0)));
  const auto sumsEnd =
    starts_.begin() + static_cast<std::ptrdiff_t>(this->lineOf(0, firstRow, layerOf(count)));
  if (std::accumulate(sumsBegin, sumsEnd + 1, std::uint64_t{0}) >
      std::numeric_limits<std::uint32_t>::max())
  {
    throw Refusal(Message("not enough memory", {largerVoxels()},
      "the surface crosses more than 4294967295 edges of the grid"));
  }
  std::partial_sum(sumsBegin, sumsEnd + 1, sumsBegin);
  edges_.resize(*sumsEnd);
  values_.resize(slab ? edges_.size() : 0);

  runBlocks(
    count, 1,
    [&](std::size_t n, std::size_t, std::size_t)
    {
      const int k = layerOf(n);
      std::size_t next = starts_[this->lineOf(0, firstRow, k)];
      forEachEdge(n + first, k,
        [&](int axis, int j, int begin, int end, Layer::State a, Layer::State b)
        {
          for (int i = begin; i < end; ++i)
          {
            const GridEdge edge = {
              {i, j, k}, static_cast<std::uint8_t>(axis), a.isInside, {a.winding, b.winding}};
            if (slab && !this->isAtBorder(edge))
            {
              std::array<int, 3> second = edge.sample;
              ++second[axis];
              values_[next] = {slab->value(edge.sample), slab->value(second)};
            }
            edges_[next++] = edge;
          }
        });
    },
    executor);
}

/// Every edge of its row before a sample changes the side.
bool LevelEdges::isSampleInside(const std::array<int, 3>& sample) const
{
  const auto [first, last] = this->inRow(0, sample[1], sample[2]);
  const auto begin = edges_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto found = std::lower_bound(begin, edges_.begin() + static_cast<std::ptrdiff_t>(last),
    sample[0], [](const GridEdge& edge, int i) { return edge.sample[0] < i; });
  return this->beginsInside(sample[1], sample[2]) != ((found - begin) % 2 != 0);
}

std::size_t LevelEdges::find(const std::array<int, 3>& sample, int axis) const
{
  const auto [first, last] = this->inRow(axis, sample[1], sample[2]);
  const auto found = std::lower_bound(edges_.begin() + static_cast<std::ptrdiff_t>(first),
    edges_.begin() + static_cast<std::ptrdiff_t>(last), sample[0],
    [](const GridEdge& edge, int i) { return edge.sample[0] < i; });
  const auto number = static_cast<std::size_t>(found - edges_.begin());
  return number != last && found->sample[0] == sample[0] ? number : edges_.size();
}

} // namespace winding
