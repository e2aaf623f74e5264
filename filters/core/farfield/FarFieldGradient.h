// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "farfield/FarFieldTraversal.h"
#include "farfield/PointCells.h"

namespace winding
{

/// Computes FarField::gradient(), from the same nodes and items as values. The gradient is the sum
/// of that of the polynomial, for all that acts through expansions, that of the moments of nearer
/// nodes, and the exact one of near items.
class FarFieldGradient
{
public:
  /// gradients: #samples by 3 numbers, in the order of the samples that the cells were made from.
  FarFieldGradient(const FarFieldTree& tree, const PointCells& cells, double* gradients);

  /// Writes the gradients of the samples of a task.
  void evaluate(const FarFieldTask& task) const;

  /// Writes the gradient of a sample that the cells have left out; number: its place in that order.
  void evaluateFarAway(const Eigen::Vector3d& sample, std::size_t number) const;

private:
  class Leaves;

  const FarFieldTree& tree_;
  const PointCells& cells_;
  double* gradients_;
};

} // namespace winding
