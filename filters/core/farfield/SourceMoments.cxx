// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/SourceMoments.h"

#include "farfield/Expansions.h"
#include "farfield/MultipoleKernels.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace winding
{

namespace
{

/// The smallest radius of a node, in units of the whole source; it is far below any voxel. Powers
/// of smaller radii would leave single precision's range.
constexpr double smallestRadius = 1e-6;

/// Nodes of fewer items get their exact radius. Radii of larger nodes are taken from the radii of
/// their children, which overestimates them.
constexpr std::uint32_t mostItemsForExactRadius = 2000;

/// Builds the moments of nodes, one node after the other; children must come before their parents.
class Builder
{
public:
  Builder(const SourceTree& tree, const FarFieldSources& sources, const FarFieldAccuracy& accuracy,
    SourceMoments& result)
    : tree_(tree)
    , sources_(sources)
    , accuracy_(accuracy)
    , result_(result)
    , strengths_(tree.nodes().size())
    , spreads_(tree.nodes().size())
  {
  }

  void build(std::size_t number)
  {
    const SourceNode& node = tree_.nodes()[number];
    double expectedNext = 0;
    if (node.children == 0)
    {
      expectedNext = this->buildLeaf(number, node);
    }
    else
    {
      this->buildInner(number, node);
    }
    const double radius = result_.criteria.radius[number];
    result_.criteria.splitRadius[number] = node.children == 0 ? -1.0f : static_cast<float>(radius);
    result_.criteria.setErrors(
      number, accuracy_, {result_.of(number), expectedNext, spreads_[number]});
  }

private:
  void setRadius(std::size_t number, double radius)
  {
    // The radius must still reach everything when it is rounded to float.
    constexpr double up = 1 + 1e-6;
    result_.criteria.radius[number] = static_cast<float>(up * std::max(radius, smallestRadius));
  }

  float* momentsOf(std::size_t number) { return &result_.moments[number * result_.stride]; }

  /// Returns expectedNext() of the leaf.
  double buildLeaf(std::size_t number, const SourceNode& node)
  {
    std::vector<FarFieldSources::Dipole> dipoles;
    sources_.appendDipoles({node.begin, node.end}, accuracy_.order, dipoles);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
    double strength = 0;
    for (const FarFieldSources::Dipole& dipole : dipoles)
    {
      const double weight = dipole.moment.norm();
      sum += weight * dipole.position;
      mean += dipole.position / static_cast<double>(dipoles.size());
      strength += weight;
    }
    const Eigen::Vector3d center = strength > 0 ? Eigen::Vector3d(sum / strength) : mean;
    result_.centers[number] = center;
    strengths_[number] = strength;
    this->setRadius(number, sources_.reach({node.begin, node.end}, center));
    spreads_[number] = accuracy_.spreadMargin * sources_.spread({node.begin, node.end});

    const double inverse = 1.0 / result_.criteria.radius[number];
    // Thousands of equal items make one leaf; summed in float, they would lose digits one by one.
    Expansion sums(result_.stride);
    for (std::size_t first = 0; first < dipoles.size(); first += DipoleBatch::capacity)
    {
      DipoleBatch batch;
      batch.count = std::min(DipoleBatch::capacity, dipoles.size() - first);
      for (std::size_t i = 0; i < batch.count; ++i)
      {
        const Eigen::Vector3f offset =
          (inverse * (dipoles[first + i].position - center)).cast<float>();
        const Eigen::Vector3f moment = (inverse * dipoles[first + i].moment).cast<float>();
        batch.x[i] = offset[0];
        batch.y[i] = offset[1];
        batch.z[i] = offset[2];
        batch.nx[i] = moment[0];
        batch.ny[i] = moment[1];
        batch.nz[i] = moment[2];
      }
      float moments[paddedCoefficients(largestOrder)] = {};
      addMoments(accuracy_.order, batch, moments);
      std::transform(sums.begin(), sums.end(), moments, sums.begin(), std::plus<>());
    }
    std::transform(sums.begin(), sums.end(), this->momentsOf(number),
      [](double moment) { return static_cast<float>(moment); });
    return this->expectedNext(dipoles, center, inverse);
  }

  /// The size of the degree above the order of the moments that is expected where the phases of few
  /// dipoles are random, in units of the node's radius. It is 0 for many dipoles, which the moments
  /// tell enough about.
  double expectedNext(const std::vector<FarFieldSources::Dipole>& dipoles,
    const Eigen::Vector3d& center, double inverse) const
  {
    constexpr std::size_t few = 8;
    if (dipoles.size() > few)
    {
      return 0;
    }
    double most = 0;
    for (const FarFieldSources::Dipole& dipole : dipoles)
    {
      const double distance = inverse * (dipole.position - center).norm();
      most += inverse * dipole.moment.norm() * std::pow(distance, accuracy_.order);
    }
    return (accuracy_.order + 1) * most / std::sqrt(static_cast<double>(dipoles.size()));
  }

  void buildInner(std::size_t number, const SourceNode& node)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
    double strength = 0;
    for (std::size_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      sum += strengths_[child] * result_.centers[child];
      mean += result_.centers[child] / node.children;
      strength += strengths_[child];
    }
    const Eigen::Vector3d center = strength > 0 ? Eigen::Vector3d(sum / strength) : mean;
    result_.centers[number] = center;
    strengths_[number] = strength;
    double radius = 0;
    for (std::size_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      spreads_[number] = std::max(spreads_[number], spreads_[child]);
      radius =
        std::max(radius, (result_.centers[child] - center).norm() + result_.criteria.radius[child]);
    }
    if (node.size() < mostItemsForExactRadius)
    {
      radius = std::min(radius, sources_.reach({node.begin, node.end}, center));
    }
    this->setRadius(number, radius);

    const double inverse = 1.0 / result_.criteria.radius[number];
    float* const moments = this->momentsOf(number);
    std::fill_n(moments, result_.stride, 0.0f);
    for (std::size_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      // The child's moments are brought to units of the parent's radius.
      const double ratio = inverse * result_.criteria.radius[child];
      Expansion scaled(static_cast<std::size_t>(coefficientCount(accuracy_.order)));
      double power = ratio;
      for (int k = 1; k <= accuracy_.order; ++k, power *= ratio)
      {
        for (int place = k * k; place < (k + 1) * (k + 1); ++place)
        {
          scaled[static_cast<std::size_t>(place)] = power * result_.of(child)[place];
        }
      }
      const Expansion shifted =
        shiftMoments(accuracy_.order, scaled, inverse * (result_.centers[child] - center));
      for (std::size_t place = 0; place < shifted.size(); ++place)
      {
        moments[place] += static_cast<float>(shifted[place]);
      }
    }
  }

  const SourceTree& tree_;
  const FarFieldSources& sources_;
  const FarFieldAccuracy& accuracy_;
  SourceMoments& result_;
  std::vector<double> strengths_; ///< by node: the sum of |moment| of its dipoles
  std::vector<double> spreads_;   ///< by node: distance within which its items are no pure dipoles
};

} // namespace

SourceMoments::SourceMoments(const SourceTree& tree, const FarFieldSources& sources,
  const FarFieldAccuracy& accuracy, Executor& executor)
  : centers(tree.nodes().size())
  , stride(paddedCoefficients(accuracy.order))
  , moments(tree.nodes().size() * stride)
{
  const std::size_t nodes = tree.nodes().size();
  criteria.resize(nodes);
  Builder builder(tree, sources, accuracy, *this);
  // Children are built before their parents: depth by depth, from below.
  const std::vector<std::size_t>& starts = tree.depthStarts();
  for (std::size_t depth = starts.size() - 1; depth-- > 0;)
  {
    constexpr std::size_t nodesPerBlock = 32;
    runBlocks(
      starts[depth + 1] - starts[depth], nodesPerBlock,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          builder.build(starts[depth] + i);
        }
      },
      executor);
  }
  origin = nodes > 0 ? centers[0] : Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < nodes; ++i)
  {
    const Eigen::Vector3f offset = (centers[i] - origin).cast<float>();
    criteria.x[i] = offset[0];
    criteria.y[i] = offset[1];
    criteria.z[i] = offset[2];
  }
}

} // namespace winding
