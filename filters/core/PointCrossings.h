#pragma once

#include "Executor.h"
#include "FieldOutput.h"
#include "Sanitize.h"

namespace winding
{

/**
 * The exact integer winding numbers of a closed chain of triangles at scattered samples: the sum of
 * the signs of the crossings of a ray from the sample along +x. It is what RowCrossings is on grids.
 *
 * Seen along the rays, samples are points and triangles are triangles in the plane of y and z. Both
 * are put into columns, cells of a grid over the samples in that plane, and columns that still hold
 * many of both are divided again, by a grid over their own samples: so it matters little how unevenly
 * either is distributed.
 *
 * Guaranteed: (1) every value is an integer, and the right one for all samples off the chain; (2) a
 * sample on the chain gets one of the values that occur around it, chosen by the same rule everywhere
 * (sideOfPlane()); (3) a value depends on the chain and the sample only, not on other samples, the
 * executor or its threads. Samples that are NaN or infinite get NaN. For chains larger than 1e150
 * sample coordinates below 1e-150 of that leave the range of the predicates.
 *
 * Time: linear in triangles and samples, and in the pairs that are near to each other in that plane.
 * Memory: 40 bytes per sample, up to 64 per triangle.
 */
class PointCrossings
{
public:
  /// Keeps a reference; takes no time.
  explicit PointCrossings(const Surface& surface);

  /// False when the executor was interrupted.
  bool evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor) const;

private:
  const Surface& surface_;
};

} // namespace winding
