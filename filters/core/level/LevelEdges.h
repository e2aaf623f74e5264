// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BooleanOperation.h"
#include "base/Executor.h"
#include "base/SideCounts.h"
#include "field/Field.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace winding
{

/// An edge of a grid between a sample that is inside and one that is not. It runs from `sample` to
/// the next one along the axis.
struct GridEdge
{
  std::array<int, 3> sample;
  std::uint8_t axis;
  bool firstIsInside; ///< true if the first sample is inside, false if the second is
  /// w at the two samples, cut off to ±127, where whole rows are integers; 0 elsewhere.
  std::array<std::int8_t, 2> windings;
};

/**
 * All edges of a grid at which the inside rule changes its answer: the edges that the boundary of
 * the inside crosses. They come in the order of the rows that they begin in, along x, y and z for
 * each, and from low to high x.
 *
 * Where whole rows of the field are integers the edges follow from runs of these, and no sample is
 * looked at. Other fields are evaluated a slab of layers after the other, so that memory is that of
 * a slab, and the values of the edges' samples are kept.
 *
 * Guaranteed: the edges are the same for every executor, and those that the field of the whole
 * grid, as floats, would give.
 *
 * Time: as the field's, but linear in the rows and edges where rows are integers. Memory: 13
 * bytes per row, 16 or 24 per edge, and that of a slab.
 */
class LevelEdges
{
public:
  /// The memory that a slab may take if it has more than 16 layers.
  static constexpr double usualSlabBytes = 96.0 * 1024 * 1024;

  /// withBorder adds a border of samples around the grid, all of them outside. Keeps references to
  /// field and grid.
  LevelEdges(const Field& field, const Grid& grid, const InsideTest& isInside, bool withBorder,
    double slabBytes = usualSlabBytes);

  /// Finds the runs of row (j, k) of a grid, without its border: they cover it, with value 1 inside
  /// and 0 outside.
  using RowRuns = std::function<void(int j, int k, std::vector<RowRun>& runs)>;

  /// Finds the runs of the layers from `first` to `end` - 1, on any thread. The answer holds what
  /// it needs.
  using LayerRuns = std::function<RowRuns(int first, int end)>;

  /// Takes the edges of a solid from the runs of its rows, `layersAtOnce` layers for a task. They
  /// are done, and have no windings, values or sides. Throws Interrupted.
  LevelEdges(const Grid& grid, bool withBorder, int layersAtOnce, const LayerRuns& layerRuns,
    Executor& executor);

  /**
   * Takes the edges at which the result of an operation on solids changes: each operand has its own
   * edges of this grid, which are done, all with a border or all without. The result is done, too,
   * and has no windings, values or sides. Time: linear in the edges and rows of all. Throws
   * Interrupted.
   */
  LevelEdges(const std::vector<const LevelEdges*>& operands, BooleanOperation operation,
    const Grid& grid, Executor& executor);
  ~LevelEdges();

  /// The memory of the tables of rows that a grid needs, in bytes.
  static double bytesOfRows(const Grid& grid);

  /// The memory of a usual slab, in bytes. None is needed where whole rows are integers.
  static double bytesOfSlab(const Grid& grid);

  bool isDone() const { return nextLayer_ == grid_.dimensions[2]; }

  ///@{
  /// The share of the grid that is done, now and after the next advance().
  double progress() const { return this->shareOf(nextLayer_); }
  double nextProgress() const { return this->shareOf(this->endOfNext()); }
  ///@}

  /// Goes on with the next slab. Throws Interrupted.
  void advance(Executor& executor);

  ///@{
  /// The edges, and all that is asked about them below, are known once isDone().
  std::size_t size() const { return edges_.size(); }
  const GridEdge& operator[](std::size_t n) const { return edges_[n]; }
  ///@}

  /// The numbers of the edges along an axis that begin in row (j, k): the first, and one behind the
  /// last.
  std::pair<std::size_t, std::size_t> inRow(int axis, int j, int k) const
  {
    const std::size_t line = this->lineOf(axis, j, k);
    return {starts_[line], starts_[line + 1]};
  }

  /// Whether the first sample of a row is inside; with a border, the first sample is one of the
  /// border.
  bool beginsInside(int j, int k) const { return beginsInside_[this->lineOf(0, j, k) / 3] != 0; }

  ///@{
  /// Whether no edge is crossed since all samples, of the border too, are inside or outside.
  bool areAllInside() const { return edges_.empty() && this->beginsInside(0, 0); }
  bool areAllOutside() const { return edges_.empty() && !this->beginsInside(0, 0); }
  ///@}

  /// Whether a sample, of the border too if there is one, is inside.
  bool isSampleInside(const std::array<int, 3>& sample) const;

  /// Whether any sample next to the end of the grid is inside.
  bool reachesBorder() const;

  /// Describes a row of the grid, without its border, as runs with value 1 inside and 0 outside.
  void findRuns(int j, int k, std::vector<RowRun>& runs) const;

  /// Writes 1 for each sample of the grid that is inside and 0 for others, without a border, in the
  /// order of samples. Throws Interrupted.
  void writeInside(unsigned char* inside, Executor& executor) const;

  /// The number of the edge from a sample along an axis; size() if the inside rule does not change
  /// there.
  std::size_t find(const std::array<int, 3>& sample, int axis) const;

  /// Whether one of an edge's samples is in the border around the grid.
  bool isAtBorder(const GridEdge& edge) const
  {
    const int sample = edge.sample[edge.axis];
    return sample < 0 || sample == grid_.dimensions[edge.axis] - 1;
  }

  /// The values of w at the two samples of an edge that is not at the border, as floats; null where
  /// whole rows are integers.
  const std::array<float, 2>* values(std::size_t n) const
  {
    return values_.empty() ? nullptr : &values_[n];
  }

  /// The sides of the grid's samples, by the signed rule; they are counted for that rule only.
  const SideCounts& sides() const { return sides_; }

  int border() const { return border_; }

private:
  class Layer;
  class Slab;

  std::size_t lineOf(int axis, int j, int k) const
  {
    const auto rows = static_cast<std::size_t>(grid_.dimensions[1] + 2 * border_);
    return 3 * (static_cast<std::size_t>(k + border_) * rows +
                 static_cast<std::size_t>(j + border_)) +
           static_cast<std::size_t>(axis);
  }

  double shareOf(int layers) const { return static_cast<double>(layers) / grid_.dimensions[2]; }
  int endOfNext() const;

  void endAfterLastLayer();
  void addSides(const std::vector<SideCounts>& layers);
  void advanceByRuns(Executor& executor);
  void advanceBySamples(Executor& executor);
  void addEdges(const std::vector<Layer>& layers, const Slab* slab, Executor& executor);

  const Field* field_; ///< null unless the edges are a field's
  const Grid& grid_;
  InsideTest isInside_;
  int border_; ///< layers of samples around the grid: 1 or 0
  int layersPerSlab_ = 0;
  const RowCrossings* rows_ = nullptr; ///< null unless whole rows are integers
  int nextLayer_ = 0;
  std::unique_ptr<Layer> lastLayer_; ///< layer before nextLayer_
  std::unique_ptr<Slab> slab_;       ///< values of the last layers before nextLayer_
  SideCounts sides_;
  std::vector<GridEdge> edges_;
  std::vector<std::array<float, 2>> values_;
  std::vector<std::uint32_t> starts_; ///< first edge of each line, by lineOf(): a row has three
  std::vector<std::uint8_t> beginsInside_;
};

} // namespace winding
