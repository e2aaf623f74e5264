// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/Neighbor.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/**
 * All places in a ball, side by side in memory. Places that follow each other are mostly neighbours
 * of each other, so that a ball around one of them holds the nearest neighbours of many.
 */
class PlacesInBall
{
public:
  /// Begins a ball that holds nothing yet.
  void start(const Eigen::Vector3d& center, double radius);

  /// Adds a place within the ball; places outside it may be added, too.
  void add(std::uint32_t place, const Eigen::Vector3d& position)
  {
    places_.push_back({position, place});
  }

  std::size_t size() const { return places_.size(); }

  /**
   * Finds the `count` nearest other places of a place, in the order of isNearer(). Returns false
   * where others may be nearer that lie outside the ball. `likely` and `atMost` change no result:
   * squared distances that are likely, and certain, to be at least as large as all of theirs.
   */
  bool findNearest(std::uint32_t place, const Eigen::Vector3d& position, std::size_t count,
    double likely, double atMost, std::vector<Neighbor>& neighbors);

private:
  struct Place
  {
    Eigen::Vector3d position;
    std::uint32_t number;
  };

  std::size_t findWithin(
    double squaredDistance, std::uint32_t place, const Eigen::Vector3d& position);
  void sortNearest(
    std::size_t found, std::size_t count, double bound, std::vector<Neighbor>& neighbors);

  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  double radius_ = 0; ///< none: there is no ball yet
  std::vector<Place> places_;
  ///@{
  /// Memory of searches.
  std::vector<Neighbor> found_;
  std::vector<std::uint32_t> starts_;
  ///@}
};

} // namespace winding
