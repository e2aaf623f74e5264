// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Lazy.h"
#include "field/OtherCap.h"
#include "rays/PointCrossings.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "surface/Boundary.h"
#include "surface/RepeatedLoops.h"

#include <memory>
#include <optional>

namespace winding
{

class TriangleFarField;

/**
 * The winding number of a surface M on grids and at scattered samples, as the difference of two
 * parts that are each easy:
 *
 *   w_M = χ_{M+C} − w_C   for a cap C with ∂C = −∂M
 *
 * χ is an integer, found for whole rows at once (RowCrossings.h), or by a ray from each scattered
 * sample (PointCrossings.h); w_C is the winding number of the
 * cap (Cap.h), which has about as many triangles as the surface has boundary edges, and none if it
 * is closed. Without a tolerance w_C is the direct sum; with one, and for caps of more than a few
 * triangles, it comes from the far field (isCheaperDirectly() in FarFieldChoice.h decides).
 *
 * Guaranteed: (1) values of a closed surface are integers, and exact off the surface; (2) values of
 * an open surface are equal to the direct sum up to its rounding or the tolerance, also next to the
 * cap: χ and w_C jump by the same 1 there, and where rounding could make them disagree about the
 * side, another cap that lies elsewhere decides; (3) values have the same bits for any extent,
 * executor and number of threads, but that scattered samples depend on each other, within the
 * tolerance, where w_C comes from the far field. A sample on a closed surface gets the value of
 * one of the sides; a sample on an open surface gets a finite value, mostly the value on one of the
 * sides.
 */
class CappedSurface
{
public:
  /// The way in which w_C is found where the tolerance admits a choice.
  enum class CapSum
  {
    cheapest,
    farField
  };

  /// Keeps a reference to the surface, which must outlive this; chain is its boundary. tolerance is
  /// the largest absolute error of w; 0 leaves the direct sum. Throws Interrupted.
  CappedSurface(const Surface& surface, const BoundaryChain& chain, double tolerance,
    Executor& executor, CapSum capSum = CapSum::cheapest);
  ~CappedSurface();

  /// The number of the cap's different triangles: 0 if the surface is closed.
  std::size_t capTriangles() const { return cap_.size(); }

  /// About the area of the cap, in squares of the unit of length.
  double capArea() const { return capArea_; }

  /// The crossings of the surface and its cap, which give χ.
  const RowCrossings& rows() const { return rows_; }

  /// Returns whether w_C comes from the far field on grids of `samples` samples.
  bool usesFarField(std::size_t samples) const;

  /// Whether it comes from there on a grid, which must not reach too far for single precision.
  bool usesFarField(const Grid& grid) const;

  /// Builds what a grid needs beforehand, as Field::prepare() does.
  void prepare(const Grid& grid, Executor& executor) const;

  /// Evaluates the samples of an extent of a grid. Throws Interrupted.
  void evaluate(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;

  /// Returns whether w_C comes from the far field at `samples` scattered samples.
  bool usesFarFieldAtPoints(std::size_t samples) const;

  /// The crossings that give χ at scattered samples.
  const PointCrossings& points() const { return points_; }

  /// Builds what scattered samples need beforehand, as Field::prepare() does.
  void prepare(const VectorsView& samples, Executor& executor) const;

  /// Evaluates scattered samples: NaN where they are NaN or infinite. Takes 4 bytes for each.
  /// Throws Interrupted.
  void evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor) const;

private:
  class Bar;
  class Differences;

  void evaluateByFarField(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;
  void subtractDirectly(
    const VectorsView& samples, const Differences& differences, Executor& executor) const;
  void evaluateRow(const Grid& grid, const Extent& extent, int j, int k,
    const std::vector<RowRun>& runs, const FieldOutput& output,
    std::vector<SampleOnCap>& onCap) const;
  /// The other cap, made when it is first asked for; only where there is a cap.
  const OtherCap& otherCap() const;
  void resolveOnCap(const Grid& grid, const Extent& extent, const std::vector<SampleOnCap>& samples,
    const FanValues* fan, const FieldOutput& output) const;

  const Surface& surface_;
  TriangleList cap_;
  Multiplicities capMultiplicities_;
  double capArea_ = 0;
  std::unique_ptr<const RepeatedLoops> loops_; ///< the surface's rims; null where there is no cap
  Lazy<std::unique_ptr<const OtherCap>> otherCap_; ///< made for the first sample on the cap
  RowCrossings rows_;                              ///< crossings of M + C
  PointCrossings points_;                          ///< the same at scattered samples
  TriangleSum capSum_;
  Bounds bounds_; ///< box of the surface
  CapSum choice_;
  int order_ = 0;                                       ///< order of the cap's far field
  std::optional<FarFieldAccuracy> accuracy_;            ///< of that
  std::unique_ptr<const TriangleFarField> capFarField_; ///< null where the cap is summed directly
};

} // namespace winding
