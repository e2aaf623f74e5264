#pragma once

#include "farfield/FarFieldTraversal.h"
#include "farfield/PointCells.h"

namespace winding
{

/// Where FarField::gradient() is computed: from the same nodes and items as values. A polynomial's
/// gradient for what acts through expansions, that of moments, and the exact one of near items.
class FarFieldGradient
{
public:
  /// gradients: #samples by 3, of all samples of the cells.
  FarFieldGradient(const FarFieldTree& tree, const PointCells& cells, double* gradients);

  /// Writes the gradients of the samples of a task.
  void evaluate(const FarFieldTask& task) const;

  /// Writes that of a sample that the cells have left out.
  void evaluateFarAway(const Eigen::Vector3d& sample, std::size_t number) const;

private:
  class Leaves;

  const FarFieldTree& tree_;
  const PointCells& cells_;
  double* gradients_;
};

} // namespace winding
