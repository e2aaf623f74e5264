#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/Grid.h"

namespace winding
{

///@{
/**
 * Tells whether samples, none of which is inside by InsideRule::signedThreshold, are outside
 * because the source is inside out: w is −threshold or less at one of them, so that it would be
 * inside if all faces or normals were turned round. Beside single points of a cloud w has any
 * value; of a cloud, most normals must point inward as well (CloudOrientation.h).
 *
 * The values are those of a grid, those of scattered samples, or known: `least` is the smallest.
 * Where they are not known they are made once more, in the time of the field, and less where the
 * answer is yes. Memory: a byte for each sample; a grid is looked at in slabs of at least one layer
 * along z, and of 64 MB at most where one layer is not larger. Throws Interrupted.
 */
bool isInsideOut(const Field& field, const Grid& grid, double threshold, Executor& executor);
bool isInsideOut(
  const Field& field, const VectorsView& samples, double threshold, Executor& executor);
bool isInsideOut(const Field& field, double least, double threshold, Executor& executor);
///@}

} // namespace winding
