#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * @file
 * Which nodes act on a cell through expansions. A node of radius r at distance d from the centre of a
 * cell of radius R (that of its samples) is accepted when
 *
 *   d ≥ (r + R) / θ        their expansions converge fast,
 *   d ≥ R + (2/θ − 1) r    those of nodes larger than the cell no slower than those of its size,
 *   d ≥ R + ρ              what the moments leave out, degrees above P, stays below ε, and
 *   d ≥ r + τ T(R)         what the local expansion leaves out stays below ε.
 *
 * If the sources are pure dipoles only from some distance s on (FarFieldSources::spread), ρ is at least
 * r + s: then no sample is nearer.
 *
 * The second matters where samples are far apart compared with the sources: there nodes of all sizes
 * act on single samples, and their errors have a sign in common.
 *
 * Degree k of the moments gives |w_k(x)| ≤ p_k / |x|^{k+1} with p_k² = Σ_m (k+m)! (k−m)! |M_k^m|²
 * (Dehnen 2014), so ρ = (p_{P+1} / ε)^{1/(P+2)}, the missing p_{P+1} being estimated from the last
 * two; and for sources of degree 1 and strength p the local degrees above P are at most
 * (P+2) R^{P+1} p / (d−r)^{P+3}, so τ = (p/ε)^{1/(P+3)} and T = ((P+2) R^{P+1})^{1/(P+3)}.
 */
namespace winding
{

/// What the test needs to know of nodes; by node, padded to whole vectors.
struct NodeCriteria
{
  std::vector<float> x, y, z; ///< centres
  std::vector<float> radius;
  std::vector<float> rho;
  std::vector<float> tau;
  std::vector<float> splitRadius; ///< the radius; −1 for leaves, which cannot be split

  void resize(std::size_t nodes);

  /// Sets rho and tau of a node from its moments scaled by its radius, and from the distance within
  /// which its sources are no pure dipoles.
  void setErrors(std::size_t node, int order, double epsilon, double spread, const float* moments);
};

/// What it needs to know of a cell.
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

/// Where nodes go; each has room for `count` entries and a whole vector more.
struct NodeLists
{
  std::int32_t* accepted;
  std::int32_t* split;
  std::int32_t* kept; ///< neither: smaller cells will see
  std::size_t acceptedCount = 0, splitCount = 0, keptCount = 0;
};

constexpr std::size_t nodeListSlack = 16;

/// Sorts candidates into the lists, which keep their order.
void classifyNodes(const NodeCriteria& nodes, const CellCriteria& cell,
  const std::int32_t* candidates, std::size_t count, NodeLists& lists);

} // namespace winding
