#include "cloud/ConsistentNormals.h"

#include "base/DividedShare.h"
#include "base/Pi.h"
#include "base/ShownExecutor.h"
#include "cloud/NeighborGraph.h"
#include "cloud/NoisySheets.h"
#include "cloud/NormalEstimation.h"
#include "cloud/NormalPatches.h"
#include "cloud/PatchSigns.h"
#include "cloud/PlacesField.h"
#include "source/CompareCoordinates.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

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
  std::vector<double> deviations = planeDeviations(places, graph, neighbors, executor);
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    deviations[place] /= spacings[place];
  }
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
    const Eigen::Vector3d farthest = places.positions()[*(end - 1)] - places.positions()[place];
    // Squares of the distances between places may underflow.
    const double radius = farthest.norm() > 0 ? farthest.norm() : farthest.stableNorm();
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

/// The normals that fit best so far. Those that were tried for several turns are shared.
struct Best
{
  explicit Best(const std::shared_ptr<const Normals>& first)
    : normals(first)
    , turns(first->size(), 0)
  {
  }

  std::shared_ptr<const Normals> normals;
  Turns turns;
  double deviation = std::numeric_limits<double>::infinity();

  void take(const std::shared_ptr<const Normals>& others, const Turns& otherTurns, double other)
  {
    if (other < deviation)
    {
      normals = others;
      turns = otherTurns;
      deviation = other;
    }
  }
};

/// The mean square of w − 1/2.
double deviationOf(const Eigen::VectorXd& w)
{
  return (w.array() - 0.5).square().mean();
}

/// Tries patches of some normals for all bounds of doubt.
void tryPatches(const DistinctPoints& places, const NeighborGraph& graph,
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Executor& executor,
  Best& best)
{
  DividedShare share(executor);
  share.set(0, 0.1);
  NormalPatches patches(places, graph, *normals, executor);
  std::size_t before = 0;
  for (std::size_t i = 0; i < std::size(doubts); ++i)
  {
    constexpr double ofDoubt = 0.9 / std::size(doubts);
    const double begin = 0.1 + ofDoubt * static_cast<double>(i);
    share.set(begin, begin + ofDoubt / 2);
    patches.grow(doubts[i]);
    const NormalPatches::Largest largest = patches.largest(fewestPlaces, mostPatches);
    if (largest.count() == 0 || (before == 1 && largest.count() == 1))
    {
      continue;
    }
    before = largest.count();
    Turns turns = patches.areOpposite();
    const Eigen::VectorXd signs = patchSigns(field.sharesOf(*normals, turns, largest));
    for (std::size_t patch = 0; patch < largest.count(); ++patch)
    {
      for (std::size_t place = largest.starts[patch];
           signs[static_cast<Eigen::Index>(patch)] < 0 && place < largest.starts[patch + 1];
           ++place)
      {
        turns[largest.places[place]] ^= 1;
      }
    }
    patches.handOn(largest, turns);
    share.set(begin + ofDoubt / 2, begin + ofDoubt);
    best.take(normals, turns, deviationOf(field.valuesOf(*normals, turns)));
  }
}

/// Tries directions of the planes of single sheets, which are known where senses are.
void trySheets(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<std::size_t>& sizes, const PlacesField& field, Executor& executor, Best& best)
{
  const Normals oriented = turned(*best.normals, best.turns);
  for (const std::size_t size : sizes)
  {
    const auto normals =
      std::make_shared<const Normals>(sheetNormals(places, graph, oriented, size, executor));
    const Turns none(normals->size(), 0);
    best.take(normals, none, deviationOf(field.valuesOf(*normals, none)));
  }
}

/// Turns points one by one as long as that helps.
void polish(const DistinctPoints& places, const PlacesField& field, Executor& executor, Best& best)
{
  constexpr int mostRounds = 3;
  DividedShare share(executor);
  for (int round = 0; round < mostRounds; ++round)
  {
    const double before = best.deviation;
    const double rest = std::pow(0.3, round); // a round is the last one mostly
    share.set(1 - rest, 1 - 0.4 * rest);
    const Turns turns =
      uphill(field.gradients(*best.normals, best.turns, places.positions()), *best.normals);
    share.set(1 - 0.4 * rest, 1 - 0.3 * rest);
    best.take(best.normals, turns, deviationOf(field.valuesOf(*best.normals, turns)));
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
  bool triedPatches;
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
void tryAsTheyAre(
  const std::shared_ptr<const Normals>& normals, const PlacesField& field, Best& best)
{
  const Eigen::VectorXd w = field.valuesOf(*normals, Turns(normals->size(), 0));
  best.take(normals, Turns(normals->size(), 0), deviationOf(w));
  best.take(normals, Turns(normals->size(), 1), deviationOf(-w));
}

/// Orients a cloud by all ways and takes the one with the least deviation. The graph has at least
/// so many neighbours; it is given up where it is needed no more. byTree: the normals that the
/// spanning tree gives, by place, or none where they are not known.
OrientedPlaces orientDensely(const DistinctPoints& places,
  std::unique_ptr<const NeighborGraph> graph, const std::vector<double>& spacings,
  std::size_t neighbors, bool isNoisy, Normals byTree, Executor& executor)
{
  constexpr double spreadOfNoise = 3;
  DividedShare share(executor);
  const PlacesField field(places, spacings, isNoisy ? spreadOfNoise : 1, executor);
  if (byTree.empty())
  {
    share.set(0, 0.02);
    byTree = planeNormals(places, *graph, neighbors, executor);
    share.set(0.02, 0.05);
    orientByTree(places, *graph, byTree, executor);
  }
  share.set(0.05, 0.1);
  Best best(std::make_shared<const Normals>(std::move(byTree)));
  tryAsTheyAre(best.normals, field, best);
  const std::size_t between = (fewNeighbors + neighbors) / 2;
  if (best.deviation < (isNoisy ? smallDeviationOfNoise : smallDeviation))
  {
    if (!isNoisy)
    {
      share.set(0.1, 1);
      trySheets(places, *graph, {between, neighbors}, field, executor, best);
    }
    return {turned(*best.normals, best.turns), best.deviation, false};
  }
  // Small planes tell the sheets of thin parts apart, and large ones see through noise, and across
  // sheets that are closer than the points.
  std::vector<std::size_t> sizes = {neighbors, 2 * neighbors};
  if (!isNoisy)
  {
    sizes.insert(sizes.begin(), {fewNeighbors, between});
  }
  // Points that are spread far take long to polish.
  const double endOfSizes = isNoisy ? 0.3 : 0.9;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const double ofSize = (endOfSizes - 0.1) / static_cast<double>(sizes.size());
    const double begin = 0.1 + ofSize * static_cast<double>(i);
    share.set(begin, begin + ofSize / 10);
    const auto normals =
      std::make_shared<const Normals>(planeNormals(places, *graph, sizes[i], executor));
    share.set(begin + ofSize / 10, begin + ofSize);
    tryPatches(places, *graph, normals, field, executor, best);
  }
  if (!isNoisy)
  {
    trySheets(places, *graph, {between, neighbors}, field, executor, best);
  }
  graph.reset();
  share.set(endOfSizes, 1);
  polish(places, field, executor, best);
  return {turned(*best.normals, best.turns), best.deviation, true};
}

/// Orients a noisy cloud by some of its places, where noise is small beside its parts.
OrientedPlaces orientThinned(const DistinctPoints& places,
  std::unique_ptr<const NeighborGraph> graph, const std::vector<double>& spacings,
  std::size_t neighbors, Normals byTree, Executor& executor)
{
  DividedShare share(executor);
  share.set(0, 0.1);
  std::vector<double> deviations = deviationsOf(places, *graph, spacings, 2 * neighbors, executor);
  const std::vector<Eigen::Vector3d> some = thinned(places, quantile(deviations, 0.5));
  constexpr std::size_t enough = 1000;
  share.set(0.1, 1);
  if (some.size() == places.size() || some.size() < enough)
  {
    return orientDensely(
      places, std::move(graph), spacings, neighbors, true, std::move(byTree), executor);
  }
  share.set(0.1, 0.15);
  const DistinctPoints sparse(some, 1, executor);
  auto sparseGraph = std::make_unique<const NeighborGraph>(sparse, 2 * neighbors, executor);
  const std::vector<double> wide = spacingsOf(sparse, *sparseGraph);
  const bool isStillNoisy = isNoisy(sparse, *sparseGraph, wide, executor);
  share.set(0.15, 0.8);
  const OrientedPlaces oriented =
    orientDensely(sparse, std::move(sparseGraph), wide, neighbors, isStillNoisy, {}, executor);
  share.set(0.8, 0.95);
  constexpr double spread = 2;
  const PlacesField field(sparse, wide, spread, executor);
  const Normals gradients =
    field.gradients(oriented.normals, Turns(sparse.size(), 0), places.positions());
  share.set(0.95, 1);
  const Normals normals = planeNormals(places, *graph, 2 * neighbors, executor);
  return {turned(normals, uphill(gradients, normals)), oriented.deviation, oriented.triedPatches};
}

/// How much w deviates from 1/2, where areas are known but for a common factor, as those of noisy
/// points are: the least mean square of f w − 1/2 for any f that is not negative.
double deviationUpToScale(const Eigen::VectorXd& w)
{
  const double mean = std::max(w.mean(), 0.0), square = w.array().square().mean();
  return square > 0 ? 0.25 * (1 - mean * mean / square) : 0.25;
}

/// The normal at each place. Where several points stand at a place, it is the one that comes first
/// by its coordinates, whatever the order of the points.
Normals normalsByPlace(const DistinctPoints& places, const Normals& normals)
{
  Normals byPlace(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    byPlace[place] = normals[*std::min_element(places.begin(place), places.end(place),
      [&](std::uint32_t a, std::uint32_t b)
      { return compareCoordinates(normals[a], normals[b]) < 0; })];
  }
  return byPlace;
}

/// Tells which normals patches turn, and whether points are turned one by one in the end.
Turns turnsByPatches(const std::vector<Eigen::Vector3d>& positions, const Normals& normals,
  bool turnsSinglePoints, Executor& executor)
{
  constexpr std::size_t neighbors = 10;
  DividedShare share(executor);
  share.set(0, 0.05);
  const DistinctPoints places(positions, unitScaleOf(positions), executor);
  const auto ofPlaces = std::make_shared<const Normals>(normalsByPlace(places, normals));
  Best best(ofPlaces);
  if (places.size() > 1)
  {
    share.set(0.05, 0.2);
    const NeighborGraph graph(places, neighbors, executor);
    const std::vector<double> spacings = spacingsOf(places, graph);
    const PlacesField field(places, spacings, 1, executor);
    share.set(0.2, 0.25);
    tryAsTheyAre(ofPlaces, field, best);
    if (best.deviation >= smallDeviation)
    {
      Normals byTree = *ofPlaces;
      share.set(0.25, 0.4);
      orientByTree(places, graph, byTree, executor);
      share.set(0.4, 0.45);
      tryAsTheyAre(std::make_shared<const Normals>(std::move(byTree)), field, best);
      share.set(0.45, 0.8);
      tryPatches(places, graph, ofPlaces, field, executor, best);
      if (turnsSinglePoints)
      {
        share.set(0.8, 1);
        polish(places, field, executor, best);
      }
    }
  }
  const Normals found = turned(*best.normals, best.turns);
  Turns turns(positions.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      turns[*point] = normals[*point].dot(found[place]) < 0;
    }
  }
  return turns;
}

/// Directions in either sense, turned outward.
Normals turnedOutward(const Normals& positions, Normals directions, Executor& executor)
{
  const Turns turns = turnsByPatches(positions, directions, false, executor);
  return turned(std::move(directions), turns);
}

/// The normals of noisy sheets that are close to each other: senses are found by the places moved
/// onto their sheets, which tell them apart, and directions are smoothed along them.
Normals normalsOfSheets(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Executor& executor)
{
  constexpr int rounds = 3;
  DividedShare share(executor);
  Normals normals;
  {
    share.set(0, 0.3);
    SheetPlanes planes = sheetPlanes(places, NeighborGraph(places, 2 * neighbors, executor),
      spacings, {fewNeighbors, neighbors, 2 * neighbors}, executor);
    share.set(0.3, 0.7);
    normals = turnedOutward(planes.feet, std::move(planes.normals), executor);
  }
  share.set(0.7, 1);
  const NeighborGraph graph(places, 2 * neighbors, executor);
  for (int round = 0; round < rounds; ++round)
  {
    normals = smoothedAlongSheets(places, graph, spacings, normals, executor);
  }
  return normals;
}

/// Orients a noisy cloud. Noise about as large as its parts are thick hides the sheets from planes
/// through some of its places; then all places are oriented, by the planes of sheets that are apart
/// still, and by planes through many places, which are those of whole parts. Either is taken only
/// where it fits far better, for noisy points tell little: better by 0.69 was worse, measured, and
/// by 0.54 right.
OrientedPlaces orientNoisy(
  const DistinctPoints& places, std::size_t neighbors, Normals byTree, Executor& executor)
{
  constexpr double spread = 3, good = 0.035, farBetter = 0.6;
  DividedShare share(executor);
  share.set(0, 0.05);
  auto graph = std::make_unique<const NeighborGraph>(places, 2 * neighbors, executor);
  const std::vector<double> spacings = spacingsOf(places, *graph);
  share.set(0.05, 0.4);
  OrientedPlaces best =
    orientThinned(places, std::move(graph), spacings, neighbors, std::move(byTree), executor);
  const PlacesField field(places, spacings, spread, executor);
  const Turns none(places.size(), 0);
  double least = deviationUpToScale(field.valuesOf(best.normals, none));
  if (!best.triedPatches || least < good)
  {
    return best;
  }
  const auto take = [&](Normals normals)
  {
    const Eigen::VectorXd w = field.valuesOf(normals, none);
    const double deviation = deviationUpToScale(w);
    if (deviation < farBetter * least)
    {
      best.normals = std::move(normals);
      best.deviation = deviationOf(w);
      least = deviation;
    }
  };
  share.set(0.4, 0.75);
  take(normalsOfSheets(places, spacings, neighbors, executor));
  share.set(0.75, 1);
  if (least >= good)
  {
    take(
      turnedOutward(places.positions(), planeNormals(places, 3 * neighbors, executor), executor));
  }
  return best;
}

OrientedPlaces orientPlaces(
  const DistinctPoints& places, std::size_t neighbors, Normals byTree, Executor& executor)
{
  if (places.size() < 2)
  {
    return {Normals(places.size(), Eigen::Vector3d(0, 0, 1)), 0, false};
  }
  DividedShare share(executor);
  share.set(0, 0.1);
  auto graph = std::make_unique<const NeighborGraph>(places, neighbors, executor);
  const std::vector<double> spacings = spacingsOf(places, *graph);
  const bool hasNoise = isNoisy(places, *graph, spacings, executor);
  share.set(0.1, 1);
  if (!hasNoise)
  {
    return orientDensely(
      places, std::move(graph), spacings, neighbors, false, std::move(byTree), executor);
  }
  graph.reset();
  return orientNoisy(places, neighbors, std::move(byTree), executor);
}

} // namespace

ConsistentNormals consistentNormals(const std::vector<Eigen::Vector3d>& positions, int neighbors,
  Executor& executor, std::vector<Eigen::Vector3d> byTree)
{
  DividedShare share(executor);
  share.set(0, 0.02);
  const DistinctPoints places(positions, unitScaleOf(positions), executor);
  share.set(0.02, 1);
  if (!byTree.empty())
  {
    byTree = normalsByPlace(places, byTree);
  }
  const OrientedPlaces oriented = orientPlaces(
    places, static_cast<std::size_t>(std::max(neighbors, 3)), std::move(byTree), executor);
  ConsistentNormals result;
  result.deviation = oriented.deviation;
  result.triedPatches = oriented.triedPatches;
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
  ShownExecutor shown(executor);
  return turnsByPatches(positions, normals, true, shown);
}

} // namespace winding
