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
  double widths = 0; ///< of all triangles, each in widths of the box
};

/// The expected cost of the crossings ahead of scattered samples, if samples are spread over the
/// box of the triangles. It does not know where samples lie: lines along x take less, and samples
/// at a place where more triangles overlap than elsewhere take more.
EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays = {});

} // namespace winding
