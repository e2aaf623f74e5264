// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/Expansions.h"

#include <algorithm>
#include <cstddef>

namespace winding
{

namespace
{

/// A complex number without the check of std::complex, which looks for infinities in every product
/// and costs more than the product.
struct Complex
{
  double re = 0, im = 0;
};

Complex operator+(Complex a, Complex b)
{
  return {a.re + b.re, a.im + b.im};
}

Complex operator*(Complex a, Complex b)
{
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Complex operator*(double a, Complex b)
{
  return {a * b.re, a * b.im};
}

Complex conj(Complex a)
{
  return {a.re, -a.im};
}

/// The coefficients (n, m) of an expansion, those with negative m included.
class Table
{
public:
  explicit Table(int order)
    : order_(order)
    , values_(static_cast<std::size_t>(coefficientCount(order)))
  {
  }

  Table(int order, const Expansion& packed)
    : Table(order)
  {
    for (int n = 0; n <= order; ++n)
    {
      at(n, 0) = {packed[realPlace(n, 0)], 0};
      for (int m = 1; m <= n; ++m)
      {
        at(n, m) = {packed[realPlace(n, m)], packed[imaginaryPlace(n, m)]};
      }
    }
    this->mirror();
  }

  Complex& at(int n, int m) { return values_[static_cast<std::size_t>(n * n + n + m)]; }
  Complex at(int n, int m) const { return values_[static_cast<std::size_t>(n * n + n + m)]; }

  /// Sets the coefficients of negative m from the ones of positive m.
  void mirror()
  {
    for (int n = 1; n <= order_; ++n)
    {
      for (int m = 1; m <= n; ++m)
      {
        at(n, -m) = (m % 2 ? -1.0 : 1.0) * conj(at(n, m));
      }
    }
  }

  Expansion packed() const
  {
    Expansion result(static_cast<std::size_t>(coefficientCount(order_)));
    for (int n = 0; n <= order_; ++n)
    {
      result[realPlace(n, 0)] = at(n, 0).re;
      for (int m = 1; m <= n; ++m)
      {
        result[realPlace(n, m)] = at(n, m).re;
        result[imaginaryPlace(n, m)] = at(n, m).im;
      }
    }
    return result;
  }

private:
  int order_;
  std::vector<Complex> values_;
};

Table regularHarmonics(int order, const Eigen::Vector3d& r)
{
  Table y(order);
  y.at(0, 0) = {1, 0};
  const double squared = r.squaredNorm();
  for (int n = 1; n <= order; ++n)
  {
    y.at(n, n) = Complex{r[0] / (2 * n), r[1] / (2 * n)} * y.at(n - 1, n - 1);
    for (int m = 0; m < n; ++m)
    {
      const Complex below = m <= n - 2 ? y.at(n - 2, m) : Complex();
      y.at(n, m) = 1.0 / (n * n - m * m) * ((2 * n - 1) * r[2] * y.at(n - 1, m) + -squared * below);
    }
  }
  y.mirror();
  return y;
}

Table irregularHarmonics(int order, const Eigen::Vector3d& r)
{
  Table t(order);
  const double inverse = 1 / r.squaredNorm();
  t.at(0, 0) = {1 / r.norm(), 0};
  for (int n = 1; n <= order; ++n)
  {
    const double odd = (2 * n - 1) * inverse;
    t.at(n, n) = Complex{odd * r[0], odd * r[1]} * t.at(n - 1, n - 1);
    for (int m = 0; m < n; ++m)
    {
      const Complex below = m <= n - 2 ? t.at(n - 2, m) : Complex();
      t.at(n, m) = odd * r[2] * t.at(n - 1, m) + -((n - 1) * (n - 1) - m * m) * inverse * below;
    }
  }
  t.mirror();
  return t;
}

/// A polynomial in x, y, z of at most some degree, by its coefficients.
class Polynomial
{
public:
  explicit Polynomial(int order)
    : order_(order)
    , coefficients_(static_cast<std::size_t>((order + 1) * (order + 1) * (order + 1)))
  {
  }

  Complex& at(int i, int j, int k)
  {
    return coefficients_[static_cast<std::size_t>((i * (order_ + 1) + j) * (order_ + 1) + k)];
  }

  /// Adds factor · x^dx y^dy z^dz · other.
  void add(Complex factor, int dx, int dy, int dz, Polynomial other)
  {
    for (int i = 0; i + dx <= order_; ++i)
    {
      for (int j = 0; j + dy <= order_; ++j)
      {
        for (int k = 0; k + dz <= order_; ++k)
        {
          at(i + dx, j + dy, k + dz) = at(i + dx, j + dy, k + dz) + factor * other.at(i, j, k);
        }
      }
    }
  }

private:
  int order_;
  std::vector<Complex> coefficients_;
};

/// The polynomials Y_n^m for 0 ≤ m ≤ n ≤ order, each at place n (n + 1) / 2 + m.
std::vector<Polynomial> harmonicPolynomials(int order)
{
  std::vector<Polynomial> y;
  const auto at = [&y](int n, int m) -> Polynomial&
  {
    return y[static_cast<std::size_t>(n * (n + 1) / 2 + m)];
  };
  for (int n = 0; n <= order; ++n)
  {
    for (int m = 0; m <= n; ++m)
    {
      Polynomial p(order);
      if (n == 0)
      {
        p.at(0, 0, 0) = {1, 0};
      }
      else if (m == n)
      {
        p.add({1.0 / (2 * n), 0}, 1, 0, 0, at(n - 1, n - 1));
        p.add({0, 1.0 / (2 * n)}, 0, 1, 0, at(n - 1, n - 1));
      }
      else
      {
        const double divisor = n * n - m * m;
        p.add({(2 * n - 1) / divisor, 0}, 0, 0, 1, at(n - 1, m));
        for (int axis = 0; m <= n - 2 && axis < 3; ++axis)
        {
          p.add({-1 / divisor, 0}, 2 * (axis == 0), 2 * (axis == 1), 2 * (axis == 2), at(n - 2, m));
        }
      }
      y.push_back(p);
    }
  }
  return y;
}

} // namespace

void addDipole(
  int order, const Eigen::Vector3d& offset, const Eigen::Vector3d& dipole, Expansion& moments)
{
  const Table y = regularHarmonics(order, offset);
  const auto harmonic = [&y](int n, int m)
  {
    return m < -n || m > n ? Complex() : y.at(n, m);
  };
  for (int n = 1; n <= order; ++n)
  {
    for (int m = 0; m <= n; ++m)
    {
      // The slope along the dipole follows from ∂z Y_n^m = Y_{n−1}^m,
      // (∂x−i∂y) Y_n^m = Y_{n−1}^{m−1} and (∂x+i∂y) Y_n^m = −Y_{n−1}^{m+1}.
      const Complex slope = dipole[2] * harmonic(n - 1, m) +
                            Complex{-0.5 * dipole[0], 0.5 * dipole[1]} * harmonic(n - 1, m + 1) +
                            Complex{0.5 * dipole[0], 0.5 * dipole[1]} * harmonic(n - 1, m - 1);
      moments[realPlace(n, m)] -= slope.re;
      if (m > 0)
      {
        moments[imaginaryPlace(n, m)] -= slope.im;
      }
    }
  }
}

Expansion shiftMoments(int order, const Expansion& moments, const Eigen::Vector3d& offset)
{
  // Y_n^m(y + s) = Σ Y_k^l(y) Y_{n−k}^{m−l}(s)
  const Table from(order, moments), y = regularHarmonics(order, offset);
  Table to(order);
  for (int n = 1; n <= order; ++n)
  {
    for (int m = 0; m <= n; ++m)
    {
      Complex sum;
      for (int k = 1; k <= n; ++k)
      {
        const int last = std::min(k, m + (n - k));
        for (int l = std::max(-k, m - (n - k)); l <= last; ++l)
        {
          sum = sum + y.at(n - k, m - l) * from.at(k, l);
        }
      }
      to.at(n, m) = sum;
    }
  }
  return to.packed();
}

Expansion momentsToLocal(int order, const Expansion& moments, const Eigen::Vector3d& offset)
{
  const Table from(order, moments), t = irregularHarmonics(2 * order, offset);
  Table to(order);
  for (int n = 0; n <= order; ++n)
  {
    for (int m = 0; m <= n; ++m)
    {
      Complex sum;
      for (int k = 1; k <= order; ++k)
      {
        for (int l = -k; l <= k; ++l)
        {
          sum = sum + conj(from.at(k, l)) * t.at(n + k, m + l);
        }
      }
      to.at(n, m) = (n % 2 ? -1.0 : 1.0) * sum;
    }
  }
  return to.packed();
}

Expansion shiftLocal(int order, const Expansion& local, const Eigen::Vector3d& offset)
{
  const Table from(order, local), y = regularHarmonics(order, offset);
  Table to(order);
  for (int k = 0; k <= order; ++k)
  {
    for (int l = 0; l <= k; ++l)
    {
      Complex sum;
      for (int n = k; n <= order; ++n)
      {
        const int last = std::min(n, l + (n - k));
        for (int m = std::max(-n, l - (n - k)); m <= last; ++m)
        {
          sum = sum + conj(y.at(n - k, m - l)) * from.at(n, m);
        }
      }
      to.at(k, l) = sum;
    }
  }
  return to.packed();
}

double momentsAt(int order, const Expansion& moments, const Eigen::Vector3d& offset)
{
  const Table from(order, moments), t = irregularHarmonics(order, offset);
  double sum = 0;
  for (int n = 1; n <= order; ++n)
  {
    for (int m = -n; m <= n; ++m)
    {
      sum += (conj(from.at(n, m)) * t.at(n, m)).re;
    }
  }
  return sum;
}

double localAt(int order, const Expansion& local, const Eigen::Vector3d& offset)
{
  const Table from(order, local), y = regularHarmonics(order, offset);
  double sum = 0;
  for (int n = 0; n <= order; ++n)
  {
    for (int m = -n; m <= n; ++m)
    {
      sum += (conj(y.at(n, m)) * from.at(n, m)).re;
    }
  }
  return sum;
}

Eigen::MatrixXd polynomialMatrix(int order)
{
  Eigen::MatrixXd matrix(monomialCount(order), coefficientCount(order));
  std::vector<Polynomial> harmonics = harmonicPolynomials(order);
  for (int n = 0; n <= order; ++n)
  {
    for (int m = 0; m <= n; ++m)
    {
      Polynomial& y = harmonics[static_cast<std::size_t>(n * (n + 1) / 2 + m)];
      int row = 0;
      for (int i = order; i >= 0; --i)
      {
        for (int j = order - i; j >= 0; --j)
        {
          for (int k = order - i - j; k >= 0; --k, ++row)
          {
            // Orders m and −m together give twice the real part.
            matrix(row, realPlace(n, m)) = (m > 0 ? 2 : 1) * y.at(i, j, k).re;
            if (m > 0)
            {
              matrix(row, imaginaryPlace(n, m)) = 2 * y.at(i, j, k).im;
            }
          }
        }
      }
    }
  }
  return matrix;
}

} // namespace winding
