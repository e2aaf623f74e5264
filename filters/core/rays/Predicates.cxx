// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/Predicates.h"

#include <cmath>

// Notation: u, v are the two coordinates. The terms below are exact pairs (value, rounding error);
// this needs -ffp-contract=off, which the whole core is compiled with.

namespace winding
{

namespace
{

int signOf(double value)
{
  return (value > 0) - (value < 0);
}

/// A sum of doubles kept exactly, as non-overlapping components of increasing magnitude.
template <int Capacity> class Expansion
{
public:
  void add(double term)
  {
    int kept = 0;
    for (int i = 0; i < size_; ++i)
    {
      const double sum = term + components_[i];
      const double shadow = sum - term;
      const double error = (term - (sum - shadow)) + (components_[i] - shadow);
      if (error != 0)
      {
        components_[kept++] = error;
      }
      term = sum;
    }
    if (term != 0)
    {
      components_[kept++] = term;
    }
    size_ = kept;
  }

  void addProduct(double a, double b)
  {
    if (a == 0 || b == 0)
    {
      return; // as most rounding errors of differences are
    }
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  void addTriple(double a, double b, double c)
  {
    const double product = a * b;
    this->addProduct(std::fma(a, b, -product), c);
    this->addProduct(product, c);
  }

  int sign() const { return size_ == 0 ? 0 : signOf(components_[size_ - 1]); }

private:
  double components_[Capacity] = {}; // or GCC 16 fears that some are read before they are set
  int size_ = 0;
};

/// a − b = value + error, exactly.
struct ExactDifference
{
  ExactDifference(double a, double b)
    : value(a - b)
  {
    const double shadow = a - value;
    error = (a - (value + shadow)) + (shadow - b);
  }
  double value, error;
};

/// Sign of a1·b1 − a2·b2.
int exactSign(const ExactDifference& a1, const ExactDifference& b1, const ExactDifference& a2,
  const ExactDifference& b2)
{
  if ((a1.value == 0 || b1.value == 0) && (a2.value == 0 || b2.value == 0))
  {
    return 0; // as for samples in the plane of a rim
  }
  Expansion<16> sum;
  const auto add = [&sum](const ExactDifference& a, const ExactDifference& b, double sign)
  {
    sum.addProduct(sign * a.error, b.error);
    sum.addProduct(sign * a.error, b.value);
    sum.addProduct(sign * a.value, b.error);
    sum.addProduct(sign * a.value, b.value);
  };
  add(a1, b1, 1);
  add(a2, b2, -1);
  return sum.sign();
}

/// Sign of the area of (a, b, c) in the plane of two of their coordinates, u before v.
int exactOrientation(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, int u, int v)
{
  return exactSign({b[u], a[u]}, {c[v], a[v]}, {b[v], a[v]}, {c[u], a[u]});
}

/// Sign of (a − q) · ((b − a) × (c − a)).
int exactSideOfPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q)
{
  // The sum has six triple products of differences; every difference is a pair of value and error.
  Expansion<192> sum;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    for (int turn = 0; turn < 2; ++turn)
    {
      const ExactDifference f[3] = {
        {a[x], q[x]}, {b[turn ? z : y], a[turn ? z : y]}, {c[turn ? y : z], a[turn ? y : z]}};
      const double sign = turn ? -1 : 1;
      for (int parts = 0; parts < 8; ++parts)
      {
        const double p = parts & 1 ? f[0].value : f[0].error;
        const double r = parts & 2 ? f[1].value : f[1].error;
        const double s = parts & 4 ? f[2].value : f[2].error;
        sum.addTriple(sign * p, r, s);
      }
    }
  }
  return sum.sign();
}

} // namespace

int sideOfEdgeExactly(
  const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q)
{
  const int side = exactSign({to[0], from[0]}, {q[1], from[1]}, {to[1], from[1]}, {q[0], from[0]});
  if (side != 0)
  {
    return side;
  }
  // The infinitesimal steps of a q on the line decide: they add −(to − from)_v along u and
  // (to − from)_u along v.
  const int alongU = (from[1] > to[1]) - (from[1] < to[1]);
  return alongU != 0 ? alongU : (to[0] > from[0]) - (to[0] < from[0]);
}

int sideOfPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q)
{
  const Eigen::Vector3d u = b - a, v = c - a, offset = a - q;
  double sum = 0, magnitude = 0;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    const double first = u[y] * v[z], second = u[z] * v[y];
    sum += offset[x] * (first - second);
    magnitude += std::abs(offset[x]) * (std::abs(first) + std::abs(second));
  }
  // Each term has three differences and two products, and the sums round, too: (7 + 56ε)ε with
  // ε = 2^−53.
  constexpr double errorBound = 7.771561172376103e-16;
  if (std::abs(sum) > errorBound * magnitude)
  {
    return signOf(sum);
  }
  const int side = exactSideOfPlane(a, b, c, q);
  if (side != 0)
  {
    return side;
  }
  // The infinitesimal steps of a q in the plane decide: each adds −normal · step, the largest
  // first.
  if (const int alongY = exactOrientation(a, b, c, 2, 0))
  {
    return -alongY;
  }
  if (const int alongZ = exactOrientation(a, b, c, 0, 1))
  {
    return -alongZ;
  }
  return -exactOrientation(a, b, c, 1, 2);
}

} // namespace winding
