// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RowTriangle.h"

#include "rays/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Widens [low, high] by the y at which an edge meets z = k, give or take its rounding.
void addIntersection(
  const Eigen::Vector3d& from, const Eigen::Vector3d& to, double k, double& low, double& high)
{
  if ((from[2] > k && to[2] > k) || (from[2] < k && to[2] < k))
  {
    return;
  }
  const double rise = to[2] - from[2];
  const double scale = std::abs(k) + std::abs(from[2]) + std::abs(to[2]);
  const double edgeLow = std::min(from[1], to[1]), edgeHigh = std::max(from[1], to[1]);
  const double uncertainty = 8 * epsilon * scale / std::abs(rise); // in the fraction along the edge
  if (!(uncertainty < 0.25))
  {
    low = std::min(low, edgeLow);
    high = std::max(high, edgeHigh);
    return;
  }
  const double y = from[1] + (k - from[2]) / rise * (to[1] - from[1]);
  const double margin =
    uncertainty * (edgeHigh - edgeLow) + 8 * epsilon * (std::abs(edgeLow) + std::abs(edgeHigh));
  low = std::min(low, std::max(y - margin, edgeLow));
  high = std::max(high, std::min(y + margin, edgeHigh));
}

///@{
/// A value rounded down or up, within a range. The code avoids std::clamp, which would let NaN
/// pass: coordinates may be huge in units of the grid. It avoids std::floor, which is a call in
/// code for processors of any age.
int floorIndex(double value, int lowest, int highest)
{
  if (!(value > lowest))
  {
    return lowest;
  }
  const int truncated = value >= highest ? highest : static_cast<int>(value);
  return truncated - (truncated > value);
}

int ceilIndex(double value, int lowest, int highest)
{
  if (!(value > lowest))
  {
    return lowest;
  }
  const int truncated = value >= highest ? highest : static_cast<int>(value);
  return truncated + (truncated < value && truncated < highest);
}
///@}

} // namespace

RowTriangle::RowTriangle(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
  : a_(a)
  , b_(b)
  , c_(c)
  , lowX_(std::min({a[0], b[0], c[0]}))
  , highX_(std::max({a[0], b[0], c[0]}))
  , lowY_(std::min({a[1], b[1], c[1]}))
  , highY_(std::max({a[1], b[1], c[1]}))
{
  const Eigen::Vector3d u = b - a, v = c - a;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    normal_[x] = u[y] * v[z] - u[z] * v[y];
    normalMagnitude_[x] = std::abs(u[y] * v[z]) + std::abs(u[z] * v[y]);
  }
}

RowTriangle::Range RowTriangle::rowsIn(int k, int lowest, int highest) const
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  addIntersection(a_, b_, k, low, high);
  addIntersection(b_, c_, k, low, high);
  addIntersection(c_, a_, k, low, high);
  if (!(low <= high) || low > highest || high < lowest)
  {
    return {0, -1};
  }
  return {ceilIndex(low, lowest, highest), floorIndex(high, lowest, highest)};
}

int RowTriangle::crossingSign(int j, int k) const
{
  const Eigen::Vector2d q(j, k);
  const int side = sideOfEdge(a_.tail<2>(), b_.tail<2>(), q);
  const bool crosses = side != 0 && sideOfEdge(b_.tail<2>(), c_.tail<2>(), q) == side &&
                       sideOfEdge(c_.tail<2>(), a_.tail<2>(), q) == side;
  return crosses ? side : 0;
}

/// The x at which row (j, k) meets the triangle's plane, and a bound of that number's rounding
/// error.
double RowTriangle::crossingX(int j, int k, double& error) const
{
  const double nx = normal_[0], nxError = 4 * epsilon * normalMagnitude_[0];
  if (!(std::abs(nx) > 4 * nxError))
  {
    error = std::numeric_limits<double>::infinity();
    return 0;
  }
  const double dy = j - a_[1], dz = k - a_[2];
  const double shift = normal_[1] * dy + normal_[2] * dz;
  const double magnitude = normalMagnitude_[1] * std::abs(dy) + normalMagnitude_[2] * std::abs(dz);
  const double step = shift / nx;
  const double x = a_[0] - step;
  error = 8 * epsilon *
          ((magnitude + std::abs(step) * normalMagnitude_[0]) / std::abs(nx) + std::abs(a_[0]) +
            std::abs(x));
  return x;
}

double RowTriangle::crossingAt(int j, int k) const
{
  double error;
  const double x = this->crossingX(j, k, error);
  // Any place of a triangle along the rows is as good as another.
  return std::isfinite(error) ? std::clamp(x, lowX_, highX_) : 0.5 * (lowX_ + highX_);
}

int RowTriangle::firstBehind(int j, int k, int sign, int lowest, int highest) const
{
  double error;
  const double x = this->crossingX(j, k, error);
  // The crossing lies in [low, high] for certain. Samples below `before` are before it, samples
  // from `behind` on, which may be beyond the range, are behind it, and bisection asks those in
  // between.
  const double low = std::isfinite(error) ? std::max(x - error, lowX_) : lowX_;
  const double high = std::isfinite(error) ? std::min(x + error, highX_) : highX_;
  int before = ceilIndex(low, lowest, highest + 1);
  int behind = !(high >= lowest) ? lowest : floorIndex(high, lowest, highest) + 1;
  while (before < behind)
  {
    const int middle = before + (behind - before) / 2;
    if (sideOfPlane(a_, b_, c_, Eigen::Vector3d(middle, j, k)) == sign)
    {
      before = middle + 1; // the plane is still ahead
    }
    else
    {
      behind = middle;
    }
  }
  return behind;
}

} // namespace winding
