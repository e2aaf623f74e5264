// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "surface/RepeatedLoops.h"

#include <vector>

namespace winding
{

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

/**
 * The values of an open surface at samples on its cap (CappedSurface.h), where rounding could make
 * χ and w_C disagree about the side: there another cap decides, a fan that lies elsewhere. A sample
 * on both is most likely on the rim, and gets the direct sum. Where the surface is no larger than
 * both caps, the direct sum comes first; but a sample on the surface itself would get the mean of
 * both sides from it, so that the fan decides about that one.
 *
 * Guaranteed: a sample's value has the same bits whatever other samples are resolved with it. All
 * together cost little more than a sum over the surface for each; alone, a sample costs as much as
 * several, since sums are vectorised over samples.
 */
class OtherCap
{
public:
  /// Keeps a reference to the surface; `cap` is capOf() its loops.
  OtherCap(const Surface& surface, const RepeatedLoops& repeated, const TriangleList& cap);

  /// Writes the value of each sample to values, in their order.
  void resolve(
    const Grid& grid, const std::vector<SampleOnCap>& samples, std::vector<double>& values) const;

  /// Does the same for scattered samples.
  void resolve(const std::vector<PointOnCap>& samples, std::vector<double>& values) const;

private:
  template <class PositionOf>
  std::vector<std::size_t> sumsAt(
    std::size_t count, const PositionOf& positionOf, std::vector<double>& values) const;
  void addCrossings(const ChainView& chain, int factor, const std::vector<PointOnCap>& samples,
    const std::vector<std::size_t>& places, std::vector<double>& values) const;

  const Surface& surface_;
  std::vector<Eigen::Vector3d> vertices_; ///< of the loops, and the fan's own
  TriangleList cap_, fan_;
  Multiplicities capMultiplicities_, fanMultiplicities_;
  RowCrossings capRows_, fanRows_;
  TriangleSum surfaceSum_, fanSum_;
};

} // namespace winding
