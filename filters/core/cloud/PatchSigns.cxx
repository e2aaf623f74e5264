// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PatchSigns.h"

#include <Eigen/Cholesky>

#include <limits>

namespace winding
{

namespace
{

/// The sum of squares of shares · s − 1/2, less what does not depend on s, and its decrease by
/// turns of signs.
class SignSearch
{
public:
  explicit SignSearch(const Eigen::MatrixXd& shares)
    : products_(shares.transpose() * shares)
    , halves_(0.5 * shares.colwise().sum().transpose())
  {
  }

  /// The real factors of least squares. Patches that give nothing anywhere, or the same as others,
  /// leave them undetermined, unless small factors are preferred a little.
  Eigen::VectorXd factors() const
  {
    constexpr double preference = 1e-3;
    const auto patches = static_cast<double>(products_.rows());
    Eigen::MatrixXd regular = products_;
    regular.diagonal().array() +=
      preference * products_.trace() / patches + std::numeric_limits<double>::min();
    return regular.ldlt().solve(halves_);
  }

  double energy(const Eigen::VectorXd& signs) const
  {
    return signs.dot(products_ * signs) - 2 * halves_.dot(signs);
  }

  /// Turns signs as long as the energy decreases by more than rounding.
  void improve(Eigen::VectorXd& signs) const
  {
    const double enough = 1e-9 * products_.trace();
    Eigen::VectorXd slopes = products_ * signs - halves_;
    for (bool hasTurned = true; hasTurned;)
    {
      Eigen::Index first = -1, second = -1;
      double most = -enough;
      const Eigen::VectorXd changes =
        4 * (products_.diagonal().array() - signs.array() * slopes.array());
      const double least = changes.minCoeff(&first);
      if (least < most)
      {
        most = least;
      }
      else
      {
        this->findPair(signs, changes, most, first, second);
      }
      hasTurned = most < -enough;
      for (const Eigen::Index turned : {first, second})
      {
        if (hasTurned && turned >= 0)
        {
          slopes -= 2 * signs[turned] * products_.col(turned);
          signs[turned] = -signs[turned];
        }
      }
    }
  }

private:
  /// Finds the two signs whose turning at once decreases the energy most.
  void findPair(const Eigen::VectorXd& signs, const Eigen::VectorXd& changes, double& most,
    Eigen::Index& first, Eigen::Index& second) const
  {
    for (Eigen::Index i = 1; i < signs.size(); ++i)
    {
      Eigen::Index j;
      const double change =
        changes[i] + (changes.head(i).array() +
                       8 * signs[i] * signs.head(i).array() * products_.col(i).head(i).array())
                       .minCoeff(&j);
      if (change < most)
      {
        most = change;
        first = i;
        second = j;
      }
    }
  }

  const Eigen::MatrixXd products_;
  const Eigen::VectorXd halves_;
};

} // namespace

Eigen::VectorXd patchSigns(const Eigen::MatrixXd& shares)
{
  const SignSearch search(shares);
  Eigen::VectorXd best = Eigen::VectorXd::Ones(shares.cols());
  search.improve(best);
  Eigen::VectorXd other = search.factors().unaryExpr([](double x) { return x < 0 ? -1.0 : 1.0; });
  search.improve(other);
  return search.energy(other) < search.energy(best) ? other : best;
}

} // namespace winding
