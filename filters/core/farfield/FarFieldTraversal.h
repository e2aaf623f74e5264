// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "farfield/FarFieldTask.h"
#include "farfield/FarFieldTree.h"
#include "farfield/FarFieldWork.h"

namespace winding
{

/// A cell that is cut no further, with all that acts on its samples.
struct FarFieldLeaf
{
  const TargetCell& cell;
  /// Sum of all that acts through expansions (Expansions.h); null where nothing does.
  const float* polynomial;
  const std::vector<std::int32_t>& byMoments; ///< nodes that act through their moments
  const std::vector<ItemRange>& exactly;      ///< items that are summed one by one
};

/// Receives the leaves of a task, to compute something else than values from them.
class FarFieldLeafVisitor
{
public:
  virtual ~FarFieldLeafVisitor() = default;
  virtual void visit(const FarFieldLeaf& leaf) = 0;
};

/// The way from a cell down to its samples; see FarField.h. Each task has its own, which holds the
/// task's lists.
class FarFieldTraversal
{
public:
  FarFieldTraversal(const FarFieldTree& tree, const TargetCells& cells);

  /// Evaluates the samples of a task's cell, and returns the work done. Irregular cells whose
  /// samples get the sum of the whole sources are appended to `toWhole` instead, if that is given.
  FarFieldWork evaluate(
    const FarFieldTask& task, bool watching, std::vector<TargetCell>* toWhole = nullptr);

  /// Gives the samples of some cells the sum of the whole sources, and returns the work done. Cells
  /// that have few samples each take less time together.
  FarFieldWork evaluateWhole(const TargetCell* first, const TargetCell* last, bool watching);

  /// Shows the visitor all leaves of a task's cell, and evaluates nothing itself.
  void visit(const FarFieldTask& task, FarFieldLeafVisitor& visitor);

  /// Goes down to a level only, appends the tasks that remain from there, and returns the work
  /// done.
  FarFieldWork collect(int level, std::vector<FarFieldTask>& tasks);

private:
  /// A local expansion, padded as the kernels need it.
  struct Local
  {
    alignas(64) float values[paddedCoefficients(largestOrder)];
  };

  void start(const FarFieldTask& task);
  void descend(const TargetCell& cell, Local& local, std::size_t firstNode, double spent);
  void evaluateLeaf(const TargetCell& cell, Local& local, std::size_t firstKept, bool isGivenUp);
  bool isTooMuch(double seconds) const;
  double secondsOfLooks(std::uint64_t looks, const TargetCell& cell) const;
  double secondsOfAccepted(const TargetCell& cell) const;
  std::size_t itemsKept(std::size_t firstKept) const;
  bool isHopeless(const TargetCell& cell, std::size_t firstKept, double spent) const;
  void classify(const TargetCell& cell, std::size_t firstNode);
  void addAccepted(const TargetCell& cell, Local& local);
  bool isWorthCutting(const TargetCell& cell, std::size_t firstKept, double spent) const;
  void descendToChildren(
    const TargetCell& cell, const Local& local, std::size_t firstKept, double spent);
  bool collectNear(const TargetCell& cell, std::size_t firstKept);
  bool isCheaperWhole(std::size_t samples) const;
  void countNear(const TargetCell& cell);
  void evaluateNear(const TargetCell& cell, const float* polynomial);

  const FarFieldTree& tree_;
  const TargetCells& cells_;
  double secondsPerLook_;        ///< at one node
  double secondsPerTranslation_; ///< of one node to a cell
  double secondsOfWhole_;        ///< for the sum of the whole sources at one sample
  bool watching_ = false;
  FarFieldLeafVisitor* visitor_ = nullptr;
  std::vector<TargetCell>* toWhole_ = nullptr;
  int lastLevel_ = 0; ///< level whose cells are collected rather than evaluated
  std::vector<FarFieldTask>* tasks_ = nullptr;
  FarFieldWork work_;

  /// The nodes left to the cell at work; before them stand those left to the cells that it lies in.
  std::vector<std::int32_t> nodes_;
  std::vector<std::int32_t> candidates_, accepted_, split_; ///< lists of classify()
  std::vector<std::int32_t> byMoments_, stack_;             ///< lists of collectNear()
  std::vector<ItemRange> exactly_;
};

} // namespace winding
