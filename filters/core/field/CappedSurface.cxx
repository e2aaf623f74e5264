// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/CappedSurface.h"

#include "farfield/FarFieldChoice.h"
#include "farfield/GridCells.h"
#include "farfield/TriangleFarField.h"
#include "source/SourceArea.h"
#include "source/UnitScale.h"
#include "surface/Cap.h"
#include "surface/RepeatedLoops.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace winding
{

CappedSurface::CappedSurface(const Surface& surface, const BoundaryChain& chain, double tolerance,
  Executor& executor, CapSum capSum)
  : surface_(surface)
  , rows_(surface.vertices, surface, {cap_, capMultiplicities_})
  , points_(surface.vertices, surface, {cap_, capMultiplicities_}, surface.bounds)
  , capSum_(surface.vertices, {cap_, capMultiplicities_}, surface.bounds)
  , bounds_(surface.bounds)
  , choice_(capSum)
{
  if (!chain.edges.empty())
  {
    const BoundaryEdges ordered = sortedByCoordinates(chain.edges, surface.vertices, executor);
    loops_ = std::make_unique<const RepeatedLoops>(
      boundaryLoops(ordered, surface.vertices.size(), executor));
    cap_ = capOf(loops_->loops);
    capMultiplicities_ = loops_->multiplicities(trianglesOfCap);
    capArea_ = approximateAreaOf(surface.vertices, cap_);
  }
  if (tolerance < FarFieldAccuracy::finest || cap_.empty())
  {
    return;
  }
  const FarFieldAccuracy accuracy = FarFieldAccuracy::of(tolerance);
  order_ = accuracy.order;
  if (capSum == CapSum::farField || !isCheaperDirectly(Primitive::triangle, cap_.size(), order_))
  {
    accuracy_ = accuracy;
    capFarField_ = std::make_unique<const TriangleFarField>(
      surface.vertices, ChainView(cap_, capMultiplicities_), surface.bounds, accuracy);
  }
}

CappedSurface::~CappedSurface() = default;

namespace
{

/// w of the fan at all samples of a cell, by its far field.
class FanOfCell final : public RowSink
{
public:
  FanOfCell(const FarField& farField, GridCells cells, const FarFieldTask& task)
    : box_(cells.samplesOf(task.cell))
    , values_(sampleCount(box_))
    , areOnFan_(values_.size())
  {
    cells.setSink(*this);
    farField.evaluate(cells, task, true);
  }

  void row(int i, int j, int k, std::size_t count, const float* values,
    const bool* isSuspect) const override
  {
    const std::size_t first = sampleNumber(box_, i, j, k);
    std::copy(values, values + count, &values_[first]);
    if (isSuspect)
    {
      std::copy(isSuspect, isSuspect + count, &areOnFan_[first]);
    }
  }

  void addTo(FanValues& fan, const SampleOnCap& sample) const
  {
    const std::size_t number = sampleNumber(box_, sample.i, sample.j, sample.k);
    fan.values.push_back(-values_[number]);
    fan.areOnFan.push_back(areOnFan_[number]);
  }

private:
  Extent box_;
  mutable std::vector<float> values_;
  mutable std::vector<char> areOnFan_;
};

} // namespace

/**
 * All rows through cells that lie behind each other along x. A bar holds the runs of equal χ in
 * them; the far field hands it the cap's values in pieces of rows, and it writes the differences.
 */
class CappedSurface::Bar final : public RowSink
{
public:
  /// `rows` is an extent whose ranges of j and k count: a band's.
  Bar(const CappedSurface& surface, const RowCrossings::OnGrid& onGrid, const Grid& grid,
    const Extent& extent, const Extent& rows, std::size_t band, const FieldOutput& output)
    : surface_(surface)
    , grid_(grid)
    , extent_(extent)
    , rows_(rows)
    , output_(output)
  {
    for (int k = rows[4]; k <= rows[5]; ++k)
    {
      onGrid.evaluate(k, band,
        [this](int, int, const std::vector<RowRun>& runs)
        {
          starts_.push_back(runs_.size());
          runs_.insert(runs_.end(), runs.begin(), runs.end());
        });
    }
  }

  void row(int i, int j, int k, std::size_t count, const float* capValues,
    const bool* isSuspect) const override
  {
    const RowRun* run = &runs_[starts_[sampleNumber(rows_, rows_[0], j, k)]];
    while (run->end <= i)
    {
      ++run;
    }
    float values[SampleBlock::capacity];
    for (std::size_t n = 0; n < count;)
    {
      const auto last = std::min(count, static_cast<std::size_t>(run->end - i));
      const auto inside = static_cast<float>(run->value);
      for (std::size_t m = n; m < last; ++m)
      {
        values[m] = inside - capValues[m];
      }
      for (std::size_t m = n; isSuspect && m < last; ++m)
      {
        if (isSuspect[m])
        {
          onCap_.push_back({i + static_cast<int>(m), j, k, run->value});
        }
      }
      n = last;
      ++run;
    }
    output_.write(values, sampleNumber(extent_, i, j, k), count);
  }

  std::size_t samplesOnCap() const { return onCap_.size(); }

  /// Takes −w of the fan at the samples on the cap that have come since the last call.
  void addFan(const FarField& farField, const GridCells& cells, const FarFieldTask& task) const
  {
    const FanOfCell fan(farField, cells, task);
    for (std::size_t n = fan_.values.size(); n < onCap_.size(); ++n)
    {
      fan.addTo(fan_, onCap_[n]);
    }
  }

  /// Writes the values of samples on the cap, after the values of all rows.
  void finish() const { surface_.resolveOnCap(grid_, extent_, onCap_, &fan_, output_); }

private:
  const CappedSurface& surface_;
  const Grid& grid_;
  Extent extent_, rows_;
  const FieldOutput& output_;
  std::vector<std::size_t> starts_; ///< each row's first run in runs_
  std::vector<RowRun> runs_;
  mutable std::vector<SampleOnCap> onCap_;
  mutable FanValues fan_; ///< at these
};

void CappedSurface::evaluateByFarField(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  const std::shared_ptr<const FarField> farField = capFarField_->suiting(grid, executor);
  GridCells cells(grid, extent, farField->scale(), farField->order());
  std::vector<FarFieldTask> tasks = farField->tasks(cells, cells.taskLevel());
  struct Fan
  {
    std::shared_ptr<const FarField> farField;
    std::map<std::array<int, 3>, FarFieldTask> tasks; // by cell
  };
  const Lazy<Fan> fanOnCap;
  const auto indexOf = [](const FarFieldTask& task)
  {
    return std::array<int, 3>{task.cell.index[0], task.cell.index[1], task.cell.index[2]};
  };
  const auto makeFan = [&]
  {
    SerialExecutor serial;
    Fan fan = {this->otherCap().fanFarField()->suiting(grid, serial), {}};
    for (FarFieldTask& task : fan.farField->tasks(cells, cells.taskLevel()))
    {
      fan.tasks.emplace(indexOf(task), std::move(task));
    }
    return fan;
  };
  // Cells with the same rows are put together, so that the rows' crossings are found once.
  const auto rowsOf = [](const FarFieldTask& task)
  {
    return std::pair(task.cell.index[2], task.cell.index[1]);
  };
  std::stable_sort(tasks.begin(), tasks.end(),
    [&](const FarFieldTask& a, const FarFieldTask& b) { return rowsOf(a) < rowsOf(b); });
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    if (i == 0 || rowsOf(tasks[i]) != rowsOf(tasks[i - 1]))
    {
      starts.push_back(i);
    }
  }
  starts.push_back(tasks.size());

  if (tasks.empty())
  {
    return;
  }
  // The rows of a bar make one band.
  const int height = static_cast<int>(cells.sizeOf(cells.taskLevel(), 1));
  const RowBands bands = {extent[2] / height * height, height};
  const std::unique_ptr<const RowCrossings::OnGrid> onGrid =
    rows_.on(grid, extent, bands, executor);
  executor.run(starts.size() - 1,
    [&](std::size_t number)
    {
      Extent rows = cells.samplesOf(tasks[starts[number]].cell);
      rows[0] = rows[1] = 0;
      const Bar bar(*this, *onGrid, grid, extent, rows, bands.bandOf(rows[2]), output);
      GridCells barCells = cells;
      barCells.setSink(bar);
      for (std::size_t task = starts[number]; task < starts[number + 1]; ++task)
      {
        const std::size_t before = bar.samplesOnCap();
        farField->evaluate(barCells, tasks[task], true);
        if (bar.samplesOnCap() > before)
        {
          const Fan& fan = fanOnCap.get(makeFan);
          bar.addFan(*fan.farField, cells, fan.tasks.at(indexOf(tasks[task])));
        }
      }
      bar.finish();
    });
}

bool CappedSurface::usesFarField(std::size_t samples) const
{
  return capFarField_ && (choice_ == CapSum::farField ||
                           !isCheaperDirectly(Primitive::triangle, cap_.size(), samples, order_));
}

bool CappedSurface::usesFarField(const Grid& grid) const
{
  return this->usesFarField(sampleCount(grid.wholeExtent())) &&
         isInReachOfSingles(grid, bounds_, unitScale(bounds_));
}

void CappedSurface::prepare(const Grid& grid, Executor& executor) const
{
  if (this->usesFarField(grid))
  {
    capFarField_->suiting(grid, executor);
  }
}

void CappedSurface::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  if (this->usesFarField(grid) && sampleCount(extent) > 0)
  {
    this->evaluateByFarField(grid, extent, output, executor);
    return;
  }
  // A block has enough work to be worth it, and little enough to answer an interrupt within a
  // moment.
  const std::size_t samplesPerBlock = std::min<std::size_t>(65536, 50'000'000 / (cap_.size() + 1));
  rows_.evaluateBlocks(
    grid, extent, samplesPerBlock,
    [&](const RowCrossings::OnGrid& onGrid, int layer, std::size_t band)
    {
      std::vector<SampleOnCap> onCap;
      onGrid.evaluate(layer, band,
        [&](int j, int k, const std::vector<RowRun>& runs)
        { this->evaluateRow(grid, extent, j, k, runs, output, onCap); });
      this->resolveOnCap(grid, extent, onCap, nullptr, output);
    },
    executor);
}

void CappedSurface::evaluateRow(const Grid& grid, const Extent& extent, int j, int k,
  const std::vector<RowRun>& runs, const FieldOutput& output, std::vector<SampleOnCap>& onCap) const
{
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t row =
    (static_cast<std::size_t>(k - extent[4]) * height + static_cast<std::size_t>(j - extent[2])) *
    width;
  if (cap_.empty())
  {
    for (const RowRun& run : runs)
    {
      output.fill(run.value, row + static_cast<std::size_t>(run.begin - extent[0]),
        static_cast<std::size_t>(run.end - run.begin));
    }
    return;
  }
  // Blocks of samples reach over the ends of runs, which may be short.
  auto run = runs.begin();
  for (std::size_t done = 0; done < width; done += SampleBlock::capacity)
  {
    const int begin = extent[0] + static_cast<int>(done);
    SampleBlock block;
    block.count = std::min(SampleBlock::capacity, width - done);
    int rowValues[SampleBlock::capacity];
    for (std::size_t n = 0; n < block.count; ++n)
    {
      const int i = begin + static_cast<int>(n);
      run += i >= run->end;
      rowValues[n] = run->value;
      block.set(n, grid.sample(i, j, k));
    }
    double values[SampleBlock::capacity];
    bool isSuspect[SampleBlock::capacity];
    const bool any = capSum_.evaluateWatching(block, values, isSuspect);
    for (std::size_t n = 0; n < block.count; ++n)
    {
      values[n] = rowValues[n] - values[n];
      if (any && isSuspect[n])
      {
        onCap.push_back({begin + static_cast<int>(n), j, k, rowValues[n]});
      }
    }
    output.write(values, row + done, block.count);
  }
}

const OtherCap& CappedSurface::otherCap() const
{
  return *otherCap_.get(
    [this] { return std::make_unique<const OtherCap>(surface_, *loops_, cap_, accuracy_); });
}

void CappedSurface::resolveOnCap(const Grid& grid, const Extent& extent,
  const std::vector<SampleOnCap>& samples, const FanValues* fan, const FieldOutput& output) const
{
  if (samples.empty())
  {
    return;
  }
  std::vector<double> values;
  this->otherCap().resolve(grid, samples, fan, values);
  FieldOutput again = output;
  again.sides = nullptr; // they were counted when they were written first
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const SampleOnCap& sample = samples[n];
    again.write(&values[n], sampleNumber(extent, sample.i, sample.j, sample.k), 1);
  }
}

} // namespace winding
