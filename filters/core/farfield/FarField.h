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
struct FieldOutput;

/**
 * Winding numbers of many sources at many samples within a tolerance, by a fast multipole method
 * (Greengard and Rokhlin 1987; Dehnen 2014 for its form), at a cost per sample that hardly depends on
 * the number of sources.
 *
 * From the whole grid down to small cells of samples: each cell looks at those nodes of the source
 * tree that its parent could not deal with. Nodes far enough away (NodeAcceptance.h) act through a
 * local expansion, which its children take over; large ones are replaced by their children; the rest
 * is left to smaller cells. When nothing is left, a polynomial gives the values; where sources are
 * near, they are summed exactly, in double.
 *
 * Guaranteed: (1) all values are within the accuracy's tolerance of the direct sum, those next to
 * sources included, plus some 1e-7 of the sum of all shares' sizes, which is large beside points; (2) the bits of a sample's value depend on the sources and the grid as a whole,
 * not on extents, executor or threads; (3) finite values for finite samples. Nothing is locked, and
 * nothing stored per sample.
 *
 * Not guaranteed: the same bits with other instruction sets; they differ by rounding, and by where
 * that puts the border between near and far, within the tolerance.
 */
class FarField
{
public:
  /// Throws Interrupted when the executor is.
  FarField(
    std::unique_ptr<FarFieldSources> sources, const FarFieldAccuracy& accuracy, Executor& executor);

  double scale() const { return tree_.scale(); }
  int order() const { return tree_.order(); }

  /// The cells of a level, in the order of the hierarchy; takes a moment, as larger cells are few.
  /// Adds what was done above them to work, unless that is null.
  std::vector<FarFieldTask> tasks(
    const TargetCells& cells, int level, FarFieldWork* work = nullptr) const;

  /// Evaluates the samples of a task, and tells what was done. watching: tell which samples lie on a
  /// source.
  FarFieldWork evaluate(const TargetCells& cells, const FarFieldTask& task, bool watching) const;

  /// Evaluates the samples of an extent of a grid. False when the executor was interrupted. Adds what
  /// was done to work, unless that is null.
  bool evaluate(const Grid& grid, const Extent& extent, const FieldOutput& output,
    Executor& executor, FarFieldWork* work = nullptr) const;

  /// Evaluates scattered samples; NaN at samples that are not finite. False when interrupted. Samples
  /// too far away for cells are no work.
  bool evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor,
    FarFieldWork* work = nullptr) const;

  /**
   * The gradient at scattered samples, into #samples by 3 numbers, in 1/length of the caller's
   * coordinates: from the nodes that evaluate() takes, at one to two times its cost. NaN at samples
   * that are not finite, finite at all others; an item that is not spread over a length gives nothing to
   * samples on it. False when interrupted.
   *
   * What expansions leave out of values changes over distances like that to the sources, so errors are
   * in units of the tolerance over the distance d to the nearest source. Not guaranteed, but measured:
   * up to 8 tolerance/d and mostly less than 1 (tests/core/farfield/FarFieldGradientTest.cxx and, for spread
   * points, with their length for d if that is more, RegularizationTest.cxx have the figures); to which
   * come roundings, about 2⁻¹⁹/d of the sum of all sources' absolute values.
   */
  bool gradient(const VectorsView& samples, double* gradients, Executor& executor) const;

private:
  PointCells cellsOf(
    const VectorsView& samples, const FieldOutput& output, Executor& executor) const;
  bool evaluateAll(
    const TargetCells& cells, int taskLevel, Executor& executor, FarFieldWork* work) const;
  double valueFarAway(const Eigen::Vector3d& sample) const;

  FarFieldTree tree_;
};

} // namespace winding
