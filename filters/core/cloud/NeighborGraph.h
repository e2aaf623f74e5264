// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/DistinctPoints.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// The nearest other places of each place, nearest first: as many for all places.
class NeighborGraph
{
public:
  /// The most neighbours that a graph has, which is twice as many as planes go through by default.
  static constexpr std::size_t mostPerPlace = 40;

  /// Finds `most` neighbours of each place, or all others if there are fewer, or `mostPerPlace`:
  /// more would take more memory than all else. There must be two places or more. Takes 4 bytes for
  /// each neighbour. Throws Interrupted.
  NeighborGraph(const DistinctPoints& places, std::size_t most, Executor& executor);

  std::size_t neighborsPerPlace() const { return most_; }

  ///@{
  /// The `count` nearest neighbours of a place, or all where there are fewer.
  const std::uint32_t* begin(std::size_t place) const { return neighbors_.data() + place * most_; }
  const std::uint32_t* end(std::size_t place, std::size_t count) const
  {
    return this->begin(place) + (count < most_ ? count : most_);
  }
  ///@}

private:
  std::size_t most_;
  std::vector<std::uint32_t> neighbors_;
};

/// The normal, in either sense, of the plane through a place and its `count` nearest neighbours, or
/// through all that the graph has where there are fewer.
Eigen::Vector3d planeNormalOf(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t place, std::size_t count);

/// The normals of the planes of all places through their `count` nearest neighbours, which are
/// searched for. Throws Interrupted.
std::vector<Eigen::Vector3d> planeNormals(
  const DistinctPoints& places, std::size_t count, Executor& executor);

/// The normals of planes and their deviations, by place: the estimated root mean squares of the
/// distances from them.
struct PlacePlanes
{
  std::vector<Eigen::Vector3d> normals;
  std::vector<double> deviations;
};

/// The planes of all places through their `count` nearest neighbours, which are searched for.
/// Throws Interrupted.
PlacePlanes placePlanes(const DistinctPoints& places, std::size_t count, Executor& executor);

///@{
/// The normals of the planes of all places through their `count` nearest neighbours, or their
/// deviations. Neighbours that the graph does not have are searched for. Throws Interrupted.
std::vector<Eigen::Vector3d> planeNormals(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t count, Executor& executor);
std::vector<double> planeDeviations(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t count, Executor& executor);
///@}

/// The normals of the planes through each place and the ones among its `count` nearest neighbours
/// that are on its sheet: neighbours whose normals are similar to its own (areSimilar()). Given
/// normals point outward, and so do the new ones. Planes through all neighbours are tilted where
/// some of them lie on the other side of a thin part or around an edge. A place with less than
/// three neighbours on its sheet keeps its normal. Throws Interrupted.
std::vector<Eigen::Vector3d> sheetNormals(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<Eigen::Vector3d>& normals, std::size_t count, Executor& executor);

/// A step along the graph from a place to a neighbour; the most certain step is the greatest.
struct NeighborStep
{
  float doubt;
  std::uint32_t from, to;

  bool operator<(const NeighborStep& other) const
  {
    return doubt != other.doubt ? doubt > other.doubt
           : from != other.from ? from > other.from
                                : to > other.to;
  }
};

/// The step between two places with normals of any sense. It is the more certain the more similar
/// the normals are, and the less it goes along them: a place that lies along the normals rather
/// than across them belongs to another sheet.
NeighborStep stepBetween(const DistinctPoints& places, const std::vector<Eigen::Vector3d>& normals,
  std::size_t from, std::size_t to);

} // namespace winding
