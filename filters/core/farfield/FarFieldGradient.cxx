// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldGradient.h"

#include "base/FlushToZero.h"
#include "farfield/MomentGradients.h"
#include "source/UnitScale.h"
#include "sums/GradientKernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// The derivatives of a polynomial along x, y and z, as polynomials of the same order.
struct PolynomialDerivatives
{
  static constexpr std::size_t room = static_cast<std::size_t>(monomialCount(largestOrder));

  PolynomialDerivatives(int order, const float* coefficients)
  {
    // The coefficient of x^i y^j z^k stands behind the ones of higher i, then of higher j, then of
    // higher k.
    const auto place = [order](int i, int j, int k)
    {
      const int rest = order - i - j;
      return static_cast<std::size_t>(
        (order - i) * (order - i + 1) * (order - i + 2) / 6 + rest * (rest + 1) / 2 + rest - k);
    };
    for (int i = 0; i <= order; ++i)
    {
      for (int j = 0; i + j <= order; ++j)
      {
        for (int k = 0; i + j + k <= order; ++k)
        {
          const float coefficient = *(coefficients + place(i, j, k));
          if (i > 0)
          {
            x[place(i - 1, j, k)] = static_cast<float>(i) * coefficient;
          }
          if (j > 0)
          {
            y[place(i, j - 1, k)] = static_cast<float>(j) * coefficient;
          }
          if (k > 0)
          {
            z[place(i, j, k - 1)] = static_cast<float>(k) * coefficient;
          }
        }
      }
    }
  }

  float x[room] = {}, y[room] = {}, z[room] = {};
};

} // namespace

/// Writes the gradients of leaves.
class FarFieldGradient::Leaves final : public FarFieldLeafVisitor
{
public:
  explicit Leaves(const FarFieldGradient& gradient)
    : tree_(gradient.tree_)
    , cells_(gradient.cells_)
    , gradients_(gradient.gradients_)
  {
  }

  void visit(const FarFieldLeaf& leaf) override
  {
    const double perSide = 1 / cells_.level(leaf.cell.level).side;
    for (std::size_t first = 0; first < leaf.cell.samples; first += block_.samples.count)
    {
      cells_.fill(leaf.cell, first, block_);
      const std::size_t count = block_.samples.count;
      const std::size_t padded = roundUp(count, floatLanes);
      for (float* offsets : {block_.u, block_.v, block_.w})
      {
        std::fill(offsets + count, offsets + padded, 0.0f);
      }
      FloatGradientSums polynomial, moments;
      if (leaf.polynomial)
      {
        const PolynomialDerivatives derivatives(tree_.order(), leaf.polynomial);
        this->evaluatePolynomialsAt(derivatives.x, polynomial.x);
        this->evaluatePolynomialsAt(derivatives.y, polynomial.y);
        this->evaluatePolynomialsAt(derivatives.z, polynomial.z);
      }
      this->addMoments(leaf.byMoments, padded, moments);
      GradientSums sums;
      tree_.sources->addGradients(leaf.exactly, block_.samples, sums);
      for (std::size_t i = 0; i < count; ++i)
      {
        double* const to = gradients_ + 3 * cells_.numberOf(leaf.cell, first + i);
        to[0] =
          unscaledGradient(sums.x[i] + moments.x[i] + perSide * polynomial.x[i], tree_.scale());
        to[1] =
          unscaledGradient(sums.y[i] + moments.y[i] + perSide * polynomial.y[i], tree_.scale());
        to[2] =
          unscaledGradient(sums.z[i] + moments.z[i] + perSide * polynomial.z[i], tree_.scale());
      }
    }
  }

private:
  void evaluatePolynomialsAt(const float* coefficients, float* values) const
  {
    evaluatePolynomial(
      tree_.order(), coefficients, block_.u, block_.v, block_.w, block_.samples.count, values);
  }

  void addMoments(
    const std::vector<std::int32_t>& nodes, std::size_t padded, FloatGradientSums& sums) const
  {
    alignas(64) float x[SampleBlock::capacity], y[SampleBlock::capacity], z[SampleBlock::capacity];
    for (const std::int32_t number : nodes)
    {
      const auto node = static_cast<std::size_t>(number);
      const float inverse = 1 / tree_.moments.criteria.radius[node];
      const Eigen::Vector3d& center = tree_.moments.centers[node];
      for (std::size_t i = 0; i < padded; ++i)
      {
        const std::size_t sample = std::min(i, block_.samples.count - 1); // the last fills vectors
        x[i] = inverse * static_cast<float>(block_.samples.x[sample] - center[0]);
        y[i] = inverse * static_cast<float>(block_.samples.y[sample] - center[1]);
        z[i] = inverse * static_cast<float>(block_.samples.z[sample] - center[2]);
      }
      addMomentGradients(MomentDerivatives(tree_.order(), tree_.moments.of(node)), inverse, x, y, z,
        block_.samples.count, sums);
    }
  }

  const FarFieldTree& tree_;
  const PointCells& cells_;
  double* gradients_;
  TargetBlock block_;
};

FarFieldGradient::FarFieldGradient(
  const FarFieldTree& tree, const PointCells& cells, double* gradients)
  : tree_(tree)
  , cells_(cells)
  , gradients_(gradients)
{
}

void FarFieldGradient::evaluate(const FarFieldTask& task) const
{
  const FlushToZero flush;
  Leaves leaves(*this);
  FarFieldTraversal(tree_, cells_).visit(task, leaves);
}

void FarFieldGradient::evaluateFarAway(const Eigen::Vector3d& sample, std::size_t number) const
{
  double* const to = gradients_ + 3 * number;
  if (!sample.allFinite() || tree_.empty())
  {
    std::fill_n(to, 3, sample.allFinite() ? 0 : std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const double inverse = 1.0 / tree_.moments.criteria.radius[0];
  const MomentDerivatives derivatives(tree_.order(), tree_.moments.of(0));
  const Eigen::Vector3d offset = tree_.offsetFromRoot(sample);
  for (int axis = 0; axis < 3; ++axis)
  {
    const float* const along =
      axis == 0 ? derivatives.x : (axis == 1 ? derivatives.y : derivatives.z);
    const Expansion expansion(along, along + coefficientCount(derivatives.order));
    to[axis] = unscaledGradient(
      inverse * inverse * momentsAt(derivatives.order, expansion, offset), tree_.scale());
  }
}

} // namespace winding
