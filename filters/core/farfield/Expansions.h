// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/RoundUp.h"

#include <Eigen/Core>

#include <vector>

/**
 * @file
 * Multipole and local expansions of winding numbers in solid harmonics: what the coefficients mean,
 * and every translation in its plainest form, in double. The fast kernels are tested against these,
 * and constant matrices are made by them.
 *
 * Harmonics, for 0 ≤ m ≤ n, with X_n^−m = (−1)^m conj X_n^m (Dehnen, A fast multipole method for
 * stellar dynamics, 2014, whose normalisation has no factorials in it):
 *
 *   regular    Y_0^0 = 1,    Y_n^n = (x+iy)/(2n) Y_{n−1}^{n−1},
 *              (n²−m²) Y_n^m = (2n−1) z Y_{n−1}^m − r² Y_{n−2}^m
 *   irregular  T_0^0 = 1/r,  T_n^n = (2n−1)(x+iy)/r² T_{n−1}^{n−1},
 *              r² T_n^m = (2n−1) z T_{n−1}^m − ((n−1)²−m²) T_{n−2}^m
 *
 * so that 1/|x−y| = Σ conj(Y_k^l(y)) T_k^l(x) for |y| < |x|. The winding number of dipoles a·n
 * (a: area / 4π) at p around c is, at a sample q farther from c than all of them,
 *
 *   w(q) = Σ conj(M_k^l) T_k^l(q−c),    M_k^l = −Σ a n·∇ Y_k^l(p−c),
 *
 * and that of distant sources is, at a sample q around t, w(q) = Σ conj(Y_n^m(q−t)) L_n^m.
 *
 * An expansion of order P is stored as (P+1)² real coefficients. There is no monopole: M_0^0 = 0.
 */
namespace winding
{

constexpr int coefficientCount(int order)
{
  return (order + 1) * (order + 1);
}

/// Place of the real part of coefficient (n, m), 0 ≤ m ≤ n.
constexpr int realPlace(int n, int m)
{
  return m == 0 ? n * n : n * n + 2 * m - 1;
}

/// Place of the imaginary part of coefficient (n, m), 0 < m ≤ n; the one of (n, 0) is 0 and not
/// stored.
constexpr int imaginaryPlace(int n, int m)
{
  return n * n + 2 * m;
}

using Expansion = std::vector<double>;

/// Adds a dipole (area · normal / 4π) at an offset from the centre to multipole moments.
void addDipole(
  int order, const Eigen::Vector3d& offset, const Eigen::Vector3d& dipole, Expansion& moments);

/// The moments of the same sources about another centre; offset: old centre − new centre.
Expansion shiftMoments(int order, const Expansion& moments, const Eigen::Vector3d& offset);

/// The local expansion of the moments' sources; offset: its centre − the moments' centre.
Expansion momentsToLocal(int order, const Expansion& moments, const Eigen::Vector3d& offset);

/// The same local expansion about another centre; offset: new centre − old centre.
Expansion shiftLocal(int order, const Expansion& local, const Eigen::Vector3d& offset);

/// The winding number that moments give at an offset from their centre.
double momentsAt(int order, const Expansion& moments, const Eigen::Vector3d& offset);

/// The winding number that a local expansion gives at an offset from its centre.
double localAt(int order, const Expansion& local, const Eigen::Vector3d& offset);

/**
 * The matrix that turns a local expansion into a polynomial: matrix · local = coefficients of
 * x^i y^j z^k, i + j + k ≤ order, in descending order of i, then j, then k.
 */
Eigen::MatrixXd polynomialMatrix(int order);

constexpr int monomialCount(int order)
{
  return (order + 1) * (order + 2) * (order + 3) / 6;
}

/// The number of rows of polynomialMatrix() in single precision, filled up to whole vectors.
constexpr std::size_t polynomialRows(int order)
{
  return roundUp(static_cast<std::size_t>(monomialCount(order)), floatLanes);
}

} // namespace winding
