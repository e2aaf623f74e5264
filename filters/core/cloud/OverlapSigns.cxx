// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/OverlapSigns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

double faultAtWall(double w)
{
  const double fault = w - std::max(0.0, std::floor(w)) - 0.5;
  return fault * fault;
}

double faultsAtWalls(const Eigen::VectorXd& w)
{
  return w.unaryExpr(&faultAtWall).mean();
}

OverlapSigns::OverlapSigns(Eigen::MatrixXd shares, Eigen::MatrixXd bonds)
  : shares_(std::move(shares))
  , bonds_(std::move(bonds))
{
}

Eigen::VectorXd OverlapSigns::improved(Eigen::VectorXd signs) const
{
  constexpr int mostRounds = 50;
  constexpr double enough = 1e-9; // faults are 1/4 at most where w is not negative
  Eigen::VectorXd w = shares_ * signs, pulls = bonds_ * signs;
  double faults = faultsAtWalls(w);
  // Turns the sign `first`, and `second` where it is another one, if that helps.
  const auto turn = [&](Eigen::Index first, Eigen::Index second)
  {
    const bool isPair = first != second;
    Eigen::VectorXd others = w - 2 * signs[first] * shares_.col(first);
    double cost = signs[first] * pulls[first];
    if (isPair)
    {
      others -= 2 * signs[second] * shares_.col(second);
      cost +=
        signs[second] * pulls[second] - 2 * signs[first] * signs[second] * bonds_(first, second);
    }
    const double faultsOfOthers = faultsAtWalls(others);
    if (faultsOfOthers + cost >= faults - enough)
    {
      return false;
    }
    w = others;
    faults = faultsOfOthers;
    for (const Eigen::Index turned : {first, second})
    {
      pulls -= 2 * signs[turned] * bonds_.col(turned);
      signs[turned] = -signs[turned];
      if (!isPair)
      {
        break;
      }
    }
    return true;
  };
  bool hasTurned = true;
  for (int round = 0; round < mostRounds && hasTurned; ++round)
  {
    hasTurned = false;
    for (Eigen::Index patch = 0; patch < signs.size(); ++patch)
    {
      hasTurned = turn(patch, patch) || hasTurned;
    }
    for (Eigen::Index first = 1; first < signs.size() && !hasTurned; ++first)
    {
      for (Eigen::Index second = 0; second < first && !hasTurned; ++second)
      {
        hasTurned = bonds_(first, second) != 0 && turn(first, second);
      }
    }
  }
  return signs;
}

} // namespace winding
