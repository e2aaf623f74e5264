// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "farfield/FarFieldAccuracy.h"
#include "rays/PointCrossings.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "surface/RepeatedLoops.h"

#include <memory>
#include <optional>
#include <vector>

namespace winding
{

class TriangleFarField;

/// A sample of a grid that lies on a surface's cap within rounding, and χ of both there.
struct SampleOnCap
{
  int i, j, k;
  int rowValue;
};

/// A scattered sample that lies on a surface's cap within rounding, and χ of both there.
struct PointOnCap
{
  Eigen::Vector3d position;
  std::size_t sample; ///< number of the sample
  int integer;
};

/// −w of the fan at samples, and which of them lie on the fan.
struct FanValues
{
  std::vector<double> values;
  std::vector<char> areOnFan;
};

/**
 * The values of an open surface at samples on its cap (CappedSurface.h), where rounding could make
 * χ and w_C disagree about the side: there another cap decides, a fan that lies elsewhere. A sample
 * on both is most likely on the rim, and gets the direct sum. Where the surface is no larger than
 * both caps, the direct sum comes first; but a sample on the surface itself would get the mean of
 * both sides from it, so that the fan decides about that one.
 *
 * A slice through the plane of a hole lies on the cap as a whole. So w of the fan may come from its
 * far field, as w of the cap does, if there is an accuracy.
 *
 * Guaranteed: a sample's value has the same bits whatever other samples are resolved with it, if w
 * of the fan comes from the direct sum, and for any executor.
 */
class OtherCap
{
public:
  /// Keeps a reference to the surface; `cap` is capOf() its loops.
  OtherCap(const Surface& surface, const RepeatedLoops& repeated, const TriangleList& cap,
    const std::optional<FarFieldAccuracy>& accuracy);
  ~OtherCap();

  /// The far field of the fan; null without an accuracy.
  const TriangleFarField* fanFarField() const { return fanFarField_.get(); }

  /// Writes the value of each sample to `values`, in their order. `fan` has the values of its far
  /// field there, and is null where the direct sum gives them.
  void resolve(const Grid& grid, const std::vector<SampleOnCap>& samples, const FanValues* fan,
    std::vector<double>& values) const;

  /// Does the same for scattered samples, in O((n + m) log (n + m)) time for n samples and m edges
  /// of rims if `byFarField`. Throws Interrupted.
  void resolve(const std::vector<PointOnCap>& samples, bool byFarField, std::vector<double>& values,
    Executor& executor) const;

private:
  template <class PositionOf>
  std::vector<std::size_t> sumsAt(std::size_t count, const PositionOf& positionOf,
    const FanValues* fan, std::vector<double>& values, Executor& executor) const;

  const Surface& surface_;
  std::vector<Eigen::Vector3d> vertices_; ///< of the loops, and the fan's own
  TriangleList cap_, fan_, turnedCap_;    ///< the last is the cap, turned round
  Multiplicities capMultiplicities_, fanMultiplicities_;
  RowCrossings capRows_, fanRows_;
  Bounds bounds_;          ///< of the surface and the fan
  PointCrossings between_; ///< crossings of the fan less the cap, which are closed together
  TriangleSum surfaceSum_, fanSum_;
  std::unique_ptr<const TriangleFarField> fanFarField_;
};

} // namespace winding
