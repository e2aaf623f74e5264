// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "base/RoundUp.h"

#include <cstddef>
#include <cstdint>

/**
 * @file
 * The inner loops of the far field in single precision, compiled once per instruction set and
 * chosen at run time (Highway). Formulas and storage of expansions: Expansions.h.
 *
 * Moments of a node of radius r are stored as M_k / r^k, local expansions of a cell of side B as
 * L_n B^n: so numbers stay of moderate size for sources of any size.
 *
 * Orders are 3, 5, 7 and 9: odd ones, since the even moments of flat, symmetric patches vanish and
 * an even order buys next to nothing.
 */
namespace winding
{

/// The farthest that samples may be from sources, in units of the sources' size: powers of larger
/// offsets would leave the range of single precision.
constexpr double farthestOffset = 1e12;

constexpr int largestOrder = 9;

/// Floats of an expansion in memory: coefficientCount(order), rounded up to whole vectors.
constexpr std::size_t paddedCoefficients(int order)
{
  return roundUp(static_cast<std::size_t>((order + 1) * (order + 1)), floatLanes);
}

/// Dipoles for moments, as structure of arrays: offsets from the centre divided by the radius, and
/// area · normal / (4π radius). Unused entries must be 0.
struct DipoleBatch
{
  static constexpr std::size_t capacity = 64; ///< whole vectors of every instruction set

  alignas(64) float x[capacity] = {};
  alignas(64) float y[capacity] = {};
  alignas(64) float z[capacity] = {};
  alignas(64) float nx[capacity] = {};
  alignas(64) float ny[capacity] = {};
  alignas(64) float nz[capacity] = {};
  std::size_t count = 0;
};

/// Adds the scaled moments of dipoles to moments[coefficientCount(order)].
void addMoments(int order, const DipoleBatch& dipoles, float* moments);

/// Nodes that act on one cell, as structure of arrays.
struct NodeBatch
{
  static constexpr std::size_t capacity = 16;

  alignas(64) std::int32_t node[capacity] = {};
  alignas(64) float dx[capacity] = {}; ///< centre of the cell − centre of the node
  alignas(64) float dy[capacity] = {};
  alignas(64) float dz[capacity] = {};
  alignas(64) float radius[capacity] = {};
  std::size_t count = 0;
};

/// Room for the sums of translateMoments(), one for each lane of the widest vectors.
struct LocalSums
{
  alignas(64) float lanes[(largestOrder + 1) * (largestOrder + 1) * 16];
};

/**
 * Adds the local expansions of a batch of nodes to sums. `moments` holds all nodes',
 * paddedCoefficients(order) floats each. side: B of the cell. Entries beyond the batch's count are
 * overwritten.
 */
void translateMoments(
  int order, const float* moments, NodeBatch& batch, float side, LocalSums& sums);

/// Adds the sums of all lanes to local[coefficientCount(order)].
void addLanes(int order, const LocalSums& sums, float* local);

/// to = matrix · from. The matrix is stored by columns of `rows` floats, a multiple of 16; `from`
/// has `columns` floats.
void multiplyMatrix(
  const float* matrix, std::size_t rows, std::size_t columns, const float* from, float* to);

/**
 * Adds the values that one node's scaled moments give at samples. Offsets from the node's centre
 * are taken in double, since a small node may be much nearer to some samples than these are to
 * anything else. values: aligned to 64 bytes and padded to whole vectors of 16.
 */
void addMomentValues(int order, const float* moments, const double (&center)[3], double radius,
  const SampleBlock& samples, float* values);

/**
 * values[i] = the polynomial at (x[i], y[i], z[i]); coefficients as polynomialMatrix() orders them.
 * x, y, z and values are aligned to 64 bytes and padded to whole vectors of 16.
 */
void evaluatePolynomial(int order, const float* coefficients, const float* x, const float* y,
  const float* z, std::size_t count, float* values);

/// values[i] = a polynomial in one variable at x[i]; coefficients: order + 1, of the highest power
/// first. x and values are aligned to 64 bytes and padded to whole vectors of 16.
void evaluateRow(
  int order, const float* coefficients, const float* x, std::size_t count, float* values);

} // namespace winding
