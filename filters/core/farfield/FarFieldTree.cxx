// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldTree.h"

#include "farfield/Expansions.h"
#include "source/UnitScale.h"

namespace winding
{

namespace
{

/// Brings the sources into the tree's order, which their moments need, and returns them.
const FarFieldSources& arranged(FarFieldSources& sources, const SourceTree& hierarchy,
  const FarFieldAccuracy& accuracy, Executor& executor)
{
  sources.arrange(hierarchy.order(), accuracy.allowsSingleSums(), executor);
  return sources;
}

std::vector<float> polynomialColumns(int order)
{
  const Eigen::MatrixXd matrix = polynomialMatrix(order);
  const std::size_t rows = polynomialRows(order);
  std::vector<float> columns(rows * static_cast<std::size_t>(matrix.cols()));
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    {
      columns[static_cast<std::size_t>(column) * rows + static_cast<std::size_t>(row)] =
        static_cast<float>(matrix(row, column));
    }
  }
  return columns;
}

} // namespace

FarFieldTree::FarFieldTree(std::unique_ptr<FarFieldSources> sourcesToArrange,
  const FarFieldAccuracy& wanted, Executor& executor)
  : sources(std::move(sourcesToArrange))
  , accuracy(wanted)
  , hierarchy(sources->centers(executor), sources->leafSize(), executor,
      [this](std::uint32_t a, std::uint32_t b) { return sources->isBefore(a, b); })
  , moments(hierarchy, arranged(*sources, hierarchy, accuracy, executor), accuracy, executor)
  , toPolynomial(polynomialColumns(accuracy.order))
{
}

Eigen::Vector3d FarFieldTree::offsetFromRoot(const Eigen::Vector3d& sample) const
{
  Eigen::Vector3d offset;
  for (int axis = 0; axis < 3; ++axis)
  {
    offset[axis] = scaledCoordinate(sample[axis], this->scale()) - moments.origin[axis];
  }
  return offset / moments.criteria.radius[0];
}

} // namespace winding
