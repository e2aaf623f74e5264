#pragma once

#include "base/EvaluationCost.h"

namespace winding
{

/// The expected cost of whole grid rows: their crossings and the filling of runs.
EvaluationCost costOfRows(const SampledSource& source);

/// How triangles lie across rays along x, in the box of all of them.
struct RaysThroughTriangles
{
  double layers = 2; ///< triangles on a line along x, on average
  /// The sums of the longer and the shorter sides of the triangles' own boxes, as parts of the box.
  double lengths = 0, widths = 0;
};

/// The expected cost of the crossings ahead of scattered samples, if samples are spread over the
/// box of the triangles. It does not know where samples lie: lines along x take less, and samples
/// at a place where more triangles overlap than elsewhere take more.
EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays = {});

} // namespace winding
