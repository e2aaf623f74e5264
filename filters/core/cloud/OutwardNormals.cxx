// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/OutwardNormals.h"

#include "base/Digits.h"
#include "base/Directions.h"
#include "base/Progress.h"
#include "cloud/AutomaticNormals.h"
#include "cloud/ConsistentNormals.h"
#include "cloud/NeighborSearch.h"
#include "source/UnitNormal.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace winding
{

namespace
{

/// Returns how far a field separates inside from outside, in words.
std::string figuresOf(const CloudOrientation& orientation)
{
  return joined("w is about 1 behind and 0 before ", inPlaces(100 * orientation.outward, 0),
    " % of the points, with medians of ", inPlaces(orientation.behind, 2), " and ",
    inPlaces(orientation.before, 2));
}

Eigen::Vector3d inSingle(Eigen::Vector3d normal)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // GCC 12 at -O2 turns pairs of conversions to single precision and back into nothing, unless
    // the number between them is volatile.
    const volatile float single = static_cast<float>(normal[axis]);
    normal[axis] = static_cast<double>(single);
  }
  return normal;
}

/// Returns whether two normals are equal up to noise, which is a thousandth.
bool areEqual(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  constexpr double noise = 1e-3;
  return (a - b).squaredNorm() <= noise * noise * b.squaredNorm();
}

/// Returns the value that more than half of the values have, if there is one (Boyer and Moore).
Eigen::Vector3d mostFrequent(const std::vector<Eigen::Vector3d>& values)
{
  Eigen::Vector3d candidate = values.front();
  std::size_t votes = 0;
  for (const Eigen::Vector3d& value : values)
  {
    if (votes == 0)
    {
      candidate = value;
    }
    votes = areEqual(value, candidate) ? votes + 1 : votes - 1;
  }
  return candidate;
}

/// Returns whether points lie in planes across `normal` with their neighbours, by about a thousand
/// of the points.
bool areFlatAround(const PointCloud& cloud, const Eigen::Vector3d& normal, Executor& executor)
{
  constexpr std::size_t most = 1000, neighborsOfEach = 6;
  // The mean square of the sine between neighbours and the plane is 1/3 all over a closed surface,
  // and 0.08 on slopes of 24°.
  constexpr double flat = 0.1;
  const DistinctPoints places(cloud.positions, unitScale(cloud.bounds), executor);
  const NeighborSearch search(places, executor);
  NeighborSearch::Last last;
  std::vector<Neighbor> neighbors;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t place = 0; place < places.size(); place += places.size() / most + 1)
  {
    if (!areEqual(cloud.normals[*places.begin(place)], normal))
    {
      continue;
    }
    search.find(place, neighborsOfEach, neighbors, last);
    for (const Neighbor& neighbor : neighbors)
    {
      const Eigen::Vector3d offset = places.positions()[neighbor.place] - places.positions()[place];
      const double height = normal.dot(offset);
      sum += height * height / (offset.squaredNorm() * normal.squaredNorm());
      ++count;
    }
  }
  return !(sum > flat * static_cast<double>(count));
}

/// Returns the directions of places, of the points that are there.
std::vector<Eigen::Vector3d> meanDirections(
  const DistinctPoints& places, const std::vector<Eigen::Vector3d>& ofPoints)
{
  std::vector<Eigen::Vector3d> directions(places.size(), Eigen::Vector3d::Zero());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      directions[place] += ofPoints[*point];
    }
    directions[place] = unitOrZero(directions[place]);
  }
  return directions;
}

/// Gives the cloud normals and, unless they came with it, areas; turns all normals round if their
/// field says that they point inward, and if `mayTurn`.
CloudOrientation takeOutward(PointCloud& cloud, const DistinctPoints& places,
  std::vector<Eigen::Vector3d> normals, bool hasOwnAreas, const PointAreaOptions& options,
  Executor& executor, bool mayTurn = true)
{
  // Areas and orientation belong to the unit vectors that come back once the rounded normals
  // have been stored.
  std::vector<Eigen::Vector3f> rounded(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Eigen::Vector3d single = inSingle(normals[i]).array() + 0.0;
    rounded[i] = single.cast<float>();
    normals[i] = unitNormal(single).array() + 0.0;
  }
  cloud.normals = std::move(normals);
  Progress progress(executor);
  progress.set(0, 0.6);
  const auto findAreas = [&]
  {
    if (!hasOwnAreas)
    {
      cloud.areas = pointAreas(cloud, places, options, executor);
    }
  };
  findAreas();
  progress.set(0.6, 1);
  CloudOrientation orientation = orientationOf(cloud, executor);
  const bool isInward = mayTurn && orientation.isInward();
  if (isInward)
  {
    orientation = orientation.reversed();
    for (Eigen::Vector3d& normal : cloud.normals)
    {
      normal = 0.0 - normal.array();
    }
    findAreas(); // which differ by rounding
  }
  for (std::size_t i = 0; i < rounded.size(); ++i)
  {
    const Eigen::Vector3d outward = (isInward ? -1 : 1) * rounded[i].cast<double>();
    cloud.normals[i] = outward.array() + 0.0; // has no −0
  }
  return orientation;
}

} // namespace

OutwardNormals giveOutwardNormals(PointCloud& cloud, NormalEstimation estimation,
  const Viewpoints& toward, const PointAreaOptions& areas, Executor& unseen)
{
  ShownExecutor executor(unseen);
  Progress progress(executor);
  const bool hasOwnAreas = !cloud.areas.empty();
  OutwardNormals found;
  // Progress has the parts of the time of a million points.
  const bool isTreeAlone = estimation == NormalEstimation::spanningTree;
  const double endOfTree = estimation == NormalEstimation::consistent ? 0 : isTreeAlone ? 1 : 0.15;
  const double endOfPlaces = isTreeAlone ? 0.06 : 0.02;
  progress.set(0, endOfPlaces);
  const DistinctPoints places(cloud.positions, unitScaleOf(cloud.positions), executor);
  if (!toward.empty() || !cloud.normals.empty())
  {
    progress.set(endOfPlaces, 0.6);
    SeenNormals seen = normalsToward(toward.empty() ? meanDirections(places, cloud.normals)
                                                    : toward.directionsFrom(places, executor),
      places, areas.neighbors, executor);
    progress.set(0.6, 1);
    found.estimation = NormalEstimation::toward;
    found.orientation =
      takeOutward(cloud, places, std::move(seen.normals), hasOwnAreas, areas, executor, false);
    found.opposed = toward.empty() || toward.areSeveral() ? seen.opposed : 0;
    return found;
  }
  if (estimation != NormalEstimation::consistent)
  {
    progress.set(endOfPlaces, 0.6 * endOfTree);
    std::vector<Eigen::Vector3d> normals = estimateNormals(places, areas.neighbors, executor);
    progress.set(0.6 * endOfTree, endOfTree);
    found.orientation =
      takeOutward(cloud, places, std::move(normals), hasOwnAreas, areas, executor);
  }
  // Parts of a tenth of all points may be the wrong way round where the field is clear near the
  // others. Where the spanning tree is right all the same, as for solids that overlap, its field is
  // the clearer one; where nothing is clear, as for noisy points, that says nothing.
  constexpr double sureShare = 0.98;
  if (isTreeAlone ||
      (estimation == NormalEstimation::automatic && found.orientation.outward >= sureShare))
  {
    return found;
  }
  Normals normals = std::exchange(cloud.normals, {});
  progress.set(std::max(endOfTree, endOfPlaces), 0.98);
  normals = estimation == NormalEstimation::automatic && places.size() > 1
              ? automaticNormals(places, std::move(normals), areas.neighbors, executor)
              : consistentNormals(places, areas.neighbors, executor, std::move(normals)).normals;
  progress.set(0.98, 1);
  found.estimation = NormalEstimation::consistent;
  found.orientation = takeOutward(cloud, places, std::move(normals), hasOwnAreas, areas, executor);
  return found;
}

Message missingNormals(bool areZero)
{
  return {areZero ? "all normals have length 0" : "the points have no normals",
    {{"", {{Parameter::estimateNormals, 1}}},
      {"compute oriented ones first", {Parameter::orientedNormals}}},
    "without them nothing tells inside from outside"};
}

std::optional<std::size_t> equalNormalsExcept(const PointCloud& cloud, Executor& executor)
{
  constexpr std::size_t few = 16;
  constexpr double leastDepth = 0.05; // of the size of the cloud
  const auto& normals = cloud.normals;
  if (normals.size() < few)
  {
    return std::nullopt;
  }
  const std::size_t mostOthers = std::max<std::size_t>(1, normals.size() / 100);
  const Eigen::Vector3d across = mostFrequent(normals);
  std::size_t others = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    if (!areEqual(normals[i], across))
    {
      if (++others > mostOthers)
      {
        return std::nullopt;
      }
      continue;
    }
    const double height = across.dot(cloud.positions[i] - cloud.bounds.center());
    least = std::min(least, height);
    most = std::max(most, height);
  }
  if (!(most - least > leastDepth * cloud.bounds.sizes().norm()) ||
      areFlatAround(cloud, across, executor))
  {
    return std::nullopt;
  }
  return others;
}

Message equalNormals(std::size_t except)
{
  const std::string others = except > 0 ? "except " + std::to_string(except) + " " : "";
  return {"all normals " + others + "are equal",
    {{"estimate others", {Parameter::replacedNormals}}}, "the points lie in no plane"};
}

Message opposedNormals(double share)
{
  return {"neighbours look opposite ways, and cancel",
    {{"leave out what one of the scanners saw of them", {}}},
    "they do at " + percentOf(share) +
      " of the points, as where scanners see a wall from both sides"};
}

Message keptNormals()
{
  return {"normals are taken as given or from faces",
    {{"to estimate others, give the points alone", {Parameter::replacedNormals}}}};
}

Message contradictingNormals(const CloudOrientation& orientation)
{
  return {"normals contradict each other, so that points cancel",
    {{"to estimate others, give the points alone", {Parameter::replacedNormals}}},
    figuresOf(orientation)};
}

Message adviceOnNormals(const CloudOrientation& orientation)
{
  std::vector<Remedy> remedies = {
    {"take more points", {}}, {"take normals from where the points come from", {}}};
  if (orientation.isOfSheet())
  {
    remedies = {{"name the side of the sheet that is inside", {Parameter::sheetSide}}};
  }
  return {"estimated normals are not right everywhere", remedies, figuresOf(orientation)};
}

} // namespace winding
