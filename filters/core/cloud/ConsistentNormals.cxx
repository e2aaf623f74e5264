#include "cloud/ConsistentNormals.h"

#include "base/FieldOutput.h"
#include "base/Pi.h"
#include "cloud/NeighborGraph.h"
#include "cloud/NormalEstimation.h"
#include "cloud/NormalPatches.h"
#include "cloud/PatchSigns.h"
#include "farfield/FarField.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace winding
{

namespace
{

/// Neighbours of the smallest planes, by which the spacing of points and noise are measured.
constexpr std::size_t fewNeighbors = 8;

/// Bounds of doubt that are tried: small ones leave patches that end at edges and thin parts, large
/// ones leave few patches of noisy clouds.
constexpr float doubts[] = {0.05f, 0.1f, 0.15f, 0.2f, 0.3f};

/// Patches of fewer places, and the smallest of many patches, follow the others.
constexpr std::size_t fewestPlaces = 5, mostPatches = 256;

/// The field is looked at in so many places.
constexpr std::size_t mostTestimonies = 1536;

constexpr std::size_t placesPerBlock = 512;

using Turns = std::vector<unsigned char>;
using Normals = std::vector<Eigen::Vector3d>;

/// The quantile of some values, which it moves.
double quantile(std::vector<double>& values, double share)
{
  const auto at =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The deviations of points from the planes of their neighbourhoods, in spacings.
std::vector<double> deviationsOf(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, std::size_t neighbors, Executor& executor)
{
  std::vector<double> deviations(places.size());
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t place = first; place < last; ++place)
      {
        deviations[place] = planeOf(places, graph, place, neighbors).deviation / spacings[place];
      }
    },
    executor);
  return deviations;
}

/// The distance of each place from others: the square root of its area, which is that of the circle
/// through a near neighbour, for each place in it.
std::vector<double> spacingsOf(const DistinctPoints& places, const NeighborGraph& graph)
{
  std::vector<double> spacings(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    const std::uint32_t* const end = graph.end(place, fewNeighbors);
    const auto neighbors = static_cast<double>(end - graph.begin(place));
    const double radius = (places.positions()[*(end - 1)] - places.positions()[place]).norm();
    spacings[place] = radius * std::sqrt(pi / neighbors);
  }
  return spacings;
}

/// Whether points are scattered about their surface. Small planes of noisy points deviate by 0.3
/// spacings and more nearly everywhere; those of clean ones do so in some places only, at edges and
/// thin parts.
bool isNoisy(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, Executor& executor)
{
  constexpr double clean = 0.2;
  std::vector<double> deviations = deviationsOf(places, graph, spacings, fewNeighbors, executor);
  return quantile(deviations, 0.25) > clean;
}

Normals turned(Normals normals, const Turns& turns)
{
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    normals[place] *= turns[place] ? -1 : 1;
  }
  return normals;
}

/// Places of a cloud with what does not depend on their normals.
class Cloud
{
public:
  /// spread: the length over which places are spread, in their spacings.
  Cloud(const DistinctPoints& places, const std::vector<double>& spacings, double spread,
    Executor& executor)
    : places_(places)
    , executor_(executor)
  {
    cloud_.positions = places.positions();
    for (const Eigen::Vector3d& position : cloud_.positions)
    {
      cloud_.bounds.extend(position);
    }
    for (const double spacing : spacings)
    {
      cloud_.areas.push_back(spacing * spacing);
      cloud_.regularizationLengths.push_back(spread * spacing);
    }
    const std::size_t step =
      std::max<std::size_t>(1, (places.size() + mostTestimonies - 1) / mostTestimonies);
    for (std::size_t place = step / 2; place < places.size(); place += step)
    {
      testimonies_.push_back(static_cast<std::uint32_t>(place));
    }
  }

  /// Returns the share of each patch in w at the testimonies.
  Eigen::MatrixXd sharesOf(
    const Normals& normals, const NormalPatches::Largest& patches, const Turns& turns)
  {
    std::vector<ItemRange> ranges;
    for (std::size_t patch = 0; patch < patches.count(); ++patch)
    {
      ranges.push_back({static_cast<std::uint32_t>(patches.starts[patch]),
        static_cast<std::uint32_t>(patches.starts[patch + 1])});
    }
    return this->sums(normals, turns, patches.places, ranges);
  }

  /// The mean square of w − 1/2 at the testimonies.
  double deviationOf(const Normals& normals, const Turns& turns)
  {
    std::vector<std::uint32_t> all(places_.size());
    std::iota(all.begin(), all.end(), 0);
    const Eigen::MatrixXd w =
      this->sums(normals, turns, all, {{0, static_cast<std::uint32_t>(all.size())}});
    return (w.array() - 0.5).square().mean();
  }

  /// The gradients of w at some places, scaled as these are.
  Normals gradients(const Normals& normals, const Turns& turns, const Normals& at)
  {
    PointCloud spread = cloud_;
    spread.normals = turned(normals, turns);
    constexpr double wider = 1.5;
    for (double& length : spread.regularizationLengths)
    {
      length *= wider;
    }
    constexpr double tolerance = 1e-2;
    const FarField field(
      farFieldSources(spread, spread.areas), FarFieldAccuracy::of(tolerance), executor_);
    Normals gradients(at.size());
    if (!field.gradient({at[0].data(), at.size()}, gradients[0].data(), executor_))
    {
      throw Interrupted();
    }
    return gradients;
  }

private:
  /// Sums of ranges of the places in an order at the testimonies.
  Eigen::MatrixXd sums(const Normals& normals, const Turns& turns,
    const std::vector<std::uint32_t>& order, const std::vector<ItemRange>& ranges)
  {
    cloud_.normals = turned(normals, turns);
    const std::unique_ptr<FarFieldSources> sources = farFieldSources(cloud_, cloud_.areas);
    sources->arrange(order, true);
    Eigen::MatrixXd sums(testimonies_.size(), ranges.size());
    constexpr std::size_t perBlock = 128;
    runBlocks(
      testimonies_.size(), perBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        SampleBlock block;
        block.count = last - first;
        for (std::size_t i = first; i < last; ++i)
        {
          block.set(i - first, sources->scale() * places_.positions()[testimonies_[i]]);
        }
        double values[SampleBlock::capacity];
        std::vector<ItemRange> range(1);
        for (std::size_t r = 0; r < ranges.size(); ++r)
        {
          range[0] = ranges[r];
          sources->sum(range, block, values, nullptr);
          for (std::size_t i = first; i < last; ++i)
          {
            sums(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(r)) = values[i - first];
          }
        }
      },
      executor_);
    return sums;
  }

  const DistinctPoints& places_;
  Executor& executor_;
  PointCloud cloud_;
  std::vector<std::uint32_t> testimonies_; ///< places in which the field is looked at
};

/// Whether w increases along each normal.
Turns uphill(const Normals& gradients, const Normals& normals)
{
  Turns turns(normals.size());
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    turns[place] = gradients[place].dot(normals[place]) > 0;
  }
  return turns;
}

/// The normals that fit best so far.
struct Best
{
  Normals normals;
  Turns turns;
  double deviation = std::numeric_limits<double>::infinity();

  void take(const Normals& otherNormals, const Turns& otherTurns, double other)
  {
    if (other < deviation)
    {
      normals = otherNormals;
      turns = otherTurns;
      deviation = other;
    }
  }
};

/// Tries patches of some normals for all bounds of doubt.
void tryPatches(const DistinctPoints& places, const NeighborGraph& graph, const Normals& normals,
  Cloud& cloud, Executor& executor, Best& best)
{
  NormalPatches patches(places, graph, normals, executor);
  std::size_t before = 0;
  for (const float doubt : doubts)
  {
    patches.grow(doubt);
    const NormalPatches::Largest largest = patches.largest(fewestPlaces, mostPatches);
    if (largest.count() == 0 || (before == 1 && largest.count() == 1))
    {
      continue;
    }
    before = largest.count();
    Turns turns = patches.areOpposite();
    const Eigen::VectorXd signs = patchSigns(cloud.sharesOf(normals, largest, turns));
    for (std::size_t patch = 0; patch < largest.count(); ++patch)
    {
      for (std::size_t i = largest.starts[patch];
           signs[static_cast<Eigen::Index>(patch)] < 0 && i < largest.starts[patch + 1]; ++i)
      {
        turns[largest.places[i]] ^= 1;
      }
    }
    patches.handOn(largest, turns);
    best.take(normals, turns, cloud.deviationOf(normals, turns));
  }
}

/// Turns points one by one as long as that helps.
void polish(const DistinctPoints& places, Cloud& cloud, Best& best)
{
  constexpr int mostRounds = 3;
  Turns turns = best.turns;
  for (int round = 0; round < mostRounds; ++round)
  {
    const Normals normals = best.normals;
    const double before = best.deviation;
    turns = uphill(cloud.gradients(normals, turns, places.positions()), normals);
    best.take(normals, turns, cloud.deviationOf(normals, turns));
    if (best.deviation == before)
    {
      return;
    }
  }
}

/// A cloud whose points have normals: by place, and by how much w deviates from 1/2 there.
struct OrientedPlaces
{
  Normals normals;
  double deviation;
};

/// Every so manieth place of a noisy cloud, such that noise is no more than about half a spacing.
std::vector<Eigen::Vector3d> thinned(const DistinctPoints& places, double noise)
{
  constexpr double wanted = 0.6;
  const double ratio = noise / wanted;
  const std::size_t step =
    std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(std::min(ratio * ratio, 64.0))));
  std::vector<Eigen::Vector3d> some;
  for (std::size_t place = step / 2; place < places.size(); place += step)
  {
    some.push_back(places.positions()[place]);
  }
  return some;
}

/// The deviation of clean clouds whose normals are right is less than this: 0.001 to 0.01. It is
/// more where solids overlap, for w is 3/2 on the parts within others, and for noisy clouds.
constexpr double smallDeviation = 0.02, smallDeviationOfNoise = 0.05;

/// Takes normals as they are, or all turned round.
void tryAsTheyAre(const Normals& normals, Cloud& cloud, Best& best)
{
  for (const unsigned char isTurned : {0, 1})
  {
    const Turns turns(normals.size(), isTurned);
    best.take(normals, turns, cloud.deviationOf(normals, turns));
  }
}

/// Orients a cloud by all ways and takes the one with the least deviation. The graph has at least
/// so many neighbours.
OrientedPlaces orientDensely(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, std::size_t neighbors, bool isNoisy, Executor& executor)
{
  constexpr double spreadOfNoise = 3;
  Cloud cloud(places, spacings, isNoisy ? spreadOfNoise : 1, executor);
  Best best;
  Normals normals = planeNormals(places, graph, neighbors, executor);
  orientByTree(places, graph, normals);
  tryAsTheyAre(normals, cloud, best);
  if (best.deviation < (isNoisy ? smallDeviationOfNoise : smallDeviation))
  {
    return {turned(best.normals, best.turns), best.deviation};
  }
  // Small planes tell the sheets of thin parts apart, and large ones see through noise, and across
  // sheets that are closer than the points.
  std::vector<std::size_t> sizes = {neighbors, 2 * neighbors};
  if (!isNoisy)
  {
    sizes.insert(sizes.begin(), {fewNeighbors, (fewNeighbors + neighbors) / 2});
  }
  for (const std::size_t size : sizes)
  {
    normals = size <= graph.neighborsPerPlace()
                ? planeNormals(places, graph, size, executor)
                : planeNormals(places, NeighborGraph(places, size, executor), size, executor);
    tryPatches(places, graph, normals, cloud, executor, best);
  }
  polish(places, cloud, best);
  return {turned(best.normals, best.turns), best.deviation};
}

/// Orients a noisy cloud, of which only some places are needed to tell its sides.
OrientedPlaces orientNoisy(const DistinctPoints& places, std::size_t neighbors, Executor& executor)
{
  const NeighborGraph graph(places, 2 * neighbors, executor);
  const std::vector<double> spacings = spacingsOf(places, graph);
  std::vector<double> deviations = deviationsOf(places, graph, spacings, 2 * neighbors, executor);
  const std::vector<Eigen::Vector3d> some = thinned(places, quantile(deviations, 0.5));
  constexpr std::size_t enough = 1000;
  if (some.size() == places.size() || some.size() < enough)
  {
    return orientDensely(places, graph, spacings, neighbors, true, executor);
  }
  const DistinctPoints sparse(some, 1, executor);
  const NeighborGraph sparseGraph(sparse, 2 * neighbors, executor);
  const std::vector<double> wide = spacingsOf(sparse, sparseGraph);
  const OrientedPlaces oriented = orientDensely(
    sparse, sparseGraph, wide, neighbors, isNoisy(sparse, sparseGraph, wide, executor), executor);
  constexpr double spread = 2;
  Cloud cloud(sparse, wide, spread, executor);
  const Normals gradients =
    cloud.gradients(oriented.normals, Turns(sparse.size(), 0), places.positions());
  const Normals normals = planeNormals(places, graph, 2 * neighbors, executor);
  return {turned(normals, uphill(gradients, normals)), oriented.deviation};
}

OrientedPlaces orientPlaces(const DistinctPoints& places, std::size_t neighbors, Executor& executor)
{
  if (places.size() < 2)
  {
    return {Normals(places.size(), Eigen::Vector3d(0, 0, 1)), 0};
  }
  {
    const NeighborGraph graph(places, neighbors, executor);
    const std::vector<double> spacings = spacingsOf(places, graph);
    if (!isNoisy(places, graph, spacings, executor))
    {
      return orientDensely(places, graph, spacings, neighbors, false, executor);
    }
  }
  return orientNoisy(places, neighbors, executor);
}

} // namespace

ConsistentNormals consistentNormals(
  const std::vector<Eigen::Vector3d>& positions, int neighbors, Executor& executor)
{
  const DistinctPoints places(positions, unitScaleOf(positions), executor);
  const OrientedPlaces oriented =
    orientPlaces(places, static_cast<std::size_t>(std::max(neighbors, 3)), executor);
  ConsistentNormals result;
  result.deviation = oriented.deviation;
  result.normals.resize(positions.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      result.normals[*point] = oriented.normals[place];
    }
  }
  return result;
}

std::vector<unsigned char> normalsToTurn(const std::vector<Eigen::Vector3d>& positions,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor)
{
  constexpr std::size_t neighbors = 10;
  const DistinctPoints places(positions, unitScaleOf(positions), executor);
  Normals ofPlaces(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    ofPlaces[place] = normals[*places.begin(place)];
  }
  Best best;
  best.normals = ofPlaces;
  if (places.size() > 1)
  {
    const NeighborGraph graph(places, neighbors, executor);
    Cloud cloud(places, spacingsOf(places, graph), 1, executor);
    tryAsTheyAre(ofPlaces, cloud, best);
    if (best.deviation >= smallDeviation)
    {
      Normals byTree = ofPlaces;
      orientByTree(places, graph, byTree);
      tryAsTheyAre(byTree, cloud, best);
      tryPatches(places, graph, ofPlaces, cloud, executor, best);
      polish(places, cloud, best);
    }
    ofPlaces = turned(best.normals, best.turns);
  }
  std::vector<unsigned char> turns(positions.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      turns[*point] = normals[*point].dot(ofPlaces[place]) < 0;
    }
  }
  return turns;
}

} // namespace winding
