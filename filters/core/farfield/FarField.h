// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "farfield/FarFieldTask.h"
#include "farfield/FarFieldTree.h"
#include "farfield/FarFieldWork.h"
#include "farfield/GridCells.h"

#include <memory>

namespace winding
{

class PointCells;
class PointSink;
struct FieldOutput;

/**
 * Winding numbers of many sources at many samples within a tolerance, by a fast multipole method
 * (Greengard and Rokhlin 1987; Dehnen 2014 for its form), at a cost per sample that hardly depends
 * on the number of sources.
 *
 * The evaluation goes from the whole grid down to small cells of samples. Each cell looks at those
 * nodes of the source tree that its parent could not deal with. Nodes far enough away
 * (NodeAcceptance.h) act through a local expansion, which the cell's children take over; large
 * nodes are replaced by their children; the rest is left to smaller cells. When nothing is left, a
 * polynomial gives the values. Near sources are summed one by one: triangles in double, points in
 * double or, for coarser tolerances, in single precision from offsets in double.
 *
 * Guaranteed: (1) all values are within the accuracy's tolerance of the direct sum, those next to
 * sources included, plus some 1e-7 of the sum of all shares' sizes, which is large near points;
 * (2) the bits of a sample's value depend on the sources and the grid as a whole, not on extents,
 * executor or threads; (3) finite values for finite samples. Nothing is locked, and nothing stored
 * per sample.
 *
 * Not guaranteed: the same bits with other instruction sets; they differ by rounding, and by where
 * rounding puts the border between near and far, within the tolerance.
 */
class FarField
{
public:
  /// Throws Interrupted when the executor was interrupted.
  FarField(
    std::unique_ptr<FarFieldSources> sources, const FarFieldAccuracy& accuracy, Executor& executor);

  double scale() const { return tree_.scale(); }
  int order() const { return tree_.order(); }

  /// The cells of a level as tasks, in the order of the hierarchy; it takes little time, as larger
  /// cells are few. The work done in the larger cells is added to `work`, unless that is null.
  std::vector<FarFieldTask> tasks(
    const TargetCells& cells, int level, FarFieldWork* work = nullptr) const;

  /// Evaluates the samples of a task and returns the work done. If watching, `cells` hear which
  /// samples lie on a source.
  FarFieldWork evaluate(const TargetCells& cells, const FarFieldTask& task, bool watching) const;

  /// Evaluates the samples of an extent of a grid, and adds the work done to `work`, unless that is
  /// null. Throws Interrupted.
  void evaluate(const Grid& grid, const Extent& extent, const FieldOutput& output,
    Executor& executor, FarFieldWork* work = nullptr) const;

  /// Hands the values of scattered samples to a sink; NaN at samples that are not finite. `work`
  /// does not count samples too far away for cells. If watching, the sink hears which samples lie
  /// on a source. Throws Interrupted.
  void evaluate(const VectorsView& samples, const PointSink& sink, bool watching,
    Executor& executor, FarFieldWork* work = nullptr) const;

  /// Writes the values of scattered samples, as the sink of the other function gets them.
  void evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor,
    FarFieldWork* work = nullptr) const;

  /**
   * Writes the gradients at scattered samples, #samples by 3 numbers, in 1/length of the caller's
   * coordinates. They come from the nodes that evaluate() takes, at one to two times its cost. They
   * are NaN at samples that are not finite, and finite at all others; an item that is not spread
   * over a length gives nothing to samples on it. Throws Interrupted.
   *
   * The part of w that expansions leave out changes over distances like that to the sources, so
   * errors are measured in units of tolerance/d, where d is the distance to the nearest source or,
   * if that is more, the length over which it is spread. They are not guaranteed, but were found to
   * be up to 8 and mostly less than 1 (tests/core/farfield/FarFieldGradientTest.cxx has the
   * figures, tests/core/field/RegularizationTest.cxx those for spread points). Roundings add about
   * 2⁻¹⁹/d of the sum of all sources' absolute values.
   */
  void gradient(const VectorsView& samples, double* gradients, Executor& executor) const;

private:
  PointCells cellsOf(const VectorsView& samples, const PointSink* sink, Executor& executor) const;
  void evaluateAll(const TargetCells& cells, int taskLevel, bool watching, Executor& executor,
    FarFieldWork* work) const;
  void evaluateWhole(const TargetCells& cells, const std::vector<std::vector<TargetCell>>& toWhole,
    bool watching, Executor& executor, std::vector<FarFieldWork>& work) const;
  double valueFarAway(const Eigen::Vector3d& sample) const;

  FarFieldTree tree_;
};

} // namespace winding
