#pragma once

#include "farfield/FarFieldTask.h"
#include "farfield/FarFieldTree.h"
#include "farfield/FarFieldWork.h"

namespace winding
{

/// What acts on the samples of a cell that is cut no further.
struct FarFieldLeaf
{
  const TargetCell& cell;
  const float* polynomial; ///< of all that acts through expansions; see Expansions.h
  const std::vector<std::int32_t>& byMoments; ///< nodes
  const std::vector<ItemRange>& exactly;
};

/// Makes something else of leaves than values.
class FarFieldLeafVisitor
{
public:
  virtual ~FarFieldLeafVisitor() = default;
  virtual void visit(const FarFieldLeaf& leaf) = 0;
};

/// The way from a cell down to its samples; see FarField.h. One for each task: it keeps its lists.
class FarFieldTraversal
{
public:
  FarFieldTraversal(const FarFieldTree& tree, const TargetCells& cells);

  /// Evaluates the samples of a cell, and tells what was done.
  FarFieldWork evaluate(const FarFieldTask& task, bool watching);

  /// Shows the visitor all leaves of a cell instead.
  void visit(const FarFieldTask& task, FarFieldLeafVisitor& visitor);

  /// Goes down to a level only, appends what is to be done from there, and tells what was done.
  FarFieldWork collect(int level, std::vector<FarFieldTask>& tasks);

private:
  /// A local expansion, with what padding the kernels want.
  struct Local
  {
    alignas(64) float values[paddedCoefficients(largestOrder)];
  };

  void start(const FarFieldTask& task);
  void descend(const TargetCell& cell, Local& local, std::size_t firstNode);
  void classify(const TargetCell& cell, Local& local, std::size_t firstNode);
  void addAccepted(const TargetCell& cell, Local& local);
  bool isWorthCutting(const TargetCell& cell, std::size_t firstKept) const;
  void descendToChildren(const TargetCell& cell, const Local& local, std::size_t firstKept);
  void collectNear(const TargetCell& cell, std::size_t firstKept);
  void countNear(const TargetCell& cell);
  void evaluateNear(const TargetCell& cell, const float* polynomial);

  const FarFieldTree& tree_;
  const TargetCells& cells_;
  bool watching_ = false;
  FarFieldLeafVisitor* visitor_ = nullptr;
  int lastLevel_ = 0; ///< cells are collected here rather than evaluated
  std::vector<FarFieldTask>* tasks_ = nullptr;
  FarFieldWork work_;

  /// Nodes of the cell at work and, before them, of those that it lies in.
  std::vector<std::int32_t> nodes_;
  std::vector<std::int32_t> candidates_, accepted_, split_; ///< of classify()
  std::vector<std::int32_t> byMoments_, stack_;             ///< of collectNear()
  std::vector<ItemRange> exactly_;
};

} // namespace winding
