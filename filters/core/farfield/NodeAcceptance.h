// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "farfield/FarFieldAccuracy.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * @file
 * The test of which nodes act on a cell through expansions. A node of radius r at distance d from
 * the centre of a cell of radius R (its samples') is accepted when
 *
 *   d ≥ (r + R) / θ        the expansions of both converge fast,
 *   d ≥ R + (2/θ − 1) r    nodes larger than the cell converge no slower than nodes of its size,
 *   d ≥ R + ρ              the moments leave out, in degrees above P, less than ε, and
 *   d ≥ r + τ T(R)         the local expansion leaves out less than ε.
 *
 * If the sources are pure dipoles only from some distance s on (FarFieldAccuracy::spreadMargin
 * times FarFieldSources::spread()), ρ is at least r + s, so that no sample is nearer.
 *
 * The second condition matters where samples are far apart compared with the sources: there nodes
 * of all sizes act on single samples, and their errors have a sign in common.
 *
 * Degree k of the moments gives |w_k(x)| ≤ p_k / |x|^{k+1} with p_k² = Σ_m (k+m)! (k−m)! |M_k^m|²
 * (Dehnen 2014), so ρ = (p_{P+1} / ε)^{1/(P+2)}, where the missing p_{P+1} is estimated from
 * p_{P−1} and p_P. The dipoles of a leaf may be few enough to cancel in these two degrees by
 * chance, and not in the next: n dipoles of strengths a_i at distances s_i from the centre have
 * p_{P+1} ≤ (P+1) Σ a_i s_i^P, and 1/√n of that is expected where their phases are random. The
 * larger estimate counts. Nodes of a few small clusters cancel in the same way and are not
 * recognised: measured, they err by up to 4 ε, which is a tolerance of 1e-2.
 *
 * For sources of degree 1 and strength p the local degrees above P are at most
 * (P+2) R^{P+1} p / (d−r)^{P+3}, so τ = (p/ε)^{1/(P+3)} and T = ((P+2) R^{P+1})^{1/(P+3)}.
 */
namespace winding
{

/// The properties of nodes that the test uses; one entry for each node.
struct NodeCriteria
{
  std::vector<float> x, y, z; ///< centres
  std::vector<float> radius;
  std::vector<float> rho;
  std::vector<float> tau;
  std::vector<float> splitRadius; ///< the radius; −1 for leaves, which cannot be split

  void resize(std::size_t nodes);

  /// The numbers, in addition to its radius, that the errors of a node follow from.
  struct Content
  {
    const float* moments; ///< scaled by its radius
    double expectedNext;  ///< expected p_{P+1}, scaled likewise; 0 where the moments suffice
    double spread;        ///< distance within which its sources are no pure dipoles
  };

  /// Sets rho and tau of a node.
  void setErrors(std::size_t node, const FarFieldAccuracy& accuracy, const Content& content);
};

/// The properties of a cell that the test uses.
struct CellCriteria
{
  float x, y, z; ///< centre
  float radius;  ///< R, the largest distance of a sample from the centre
  float reach;   ///< T(R)
  float inverseTheta;
  float momentMargin; ///< 2/θ − 1
  float splitRadius;  ///< nodes larger than this that are not accepted are split

  static float reachOf(int order, double radius);
};

/// The lists that candidates are sorted into; each has room for all of them and nodeListSlack more.
struct NodeLists
{
  std::int32_t* accepted;
  std::int32_t* split;
  std::int32_t* kept; ///< nodes neither accepted nor split, left to smaller cells
  std::size_t acceptedCount = 0, splitCount = 0, keptCount = 0;
};

constexpr std::size_t nodeListSlack = 16;

/// Sorts candidates into the lists, which keep their order.
void classifyNodes(const NodeCriteria& nodes, const CellCriteria& cell,
  const std::int32_t* candidates, std::size_t count, NodeLists& lists);

} // namespace winding
