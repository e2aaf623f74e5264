// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "distance/DistanceTree.h"
#include "distance/NearestNumbers.h"
#include "source/Grid.h"
#include "surface/Mirror.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace winding
{

/// A place of an input: a point of one of its triangles, or one of its points.
struct InputPlace
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t view = none;                 ///< index of the view; none where there is no place
  std::uint32_t primitive = 0;               ///< index, in the view, of the triangle or point
  std::array<double, 3> weights = {1, 0, 0}; ///< of the triangle's corners, 0 to 1, with sum 1

  bool exists() const { return view != none; }
};

/// Returns the weights of the corners of a triangle at its point that is nearest to `sample`. They
/// are at least 0, and their sum is 1 up to rounding. Squares of lengths must stay finite.
std::array<double, 3> weightsOfNearest(const Eigen::Vector3d& sample, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/**
 * Finds the places of an input that are nearest to samples, so that results can be traced back to
 * it, and take over what it has there.
 *
 * All usable primitives count (isUsable() in Sanitize.h), as they came in: faces that a field
 * turns, takes once or leaves out are there, and bases and caps that it adds are not. Where the
 * source is mirrored, a sample is near to what it has an image of. Of several primitives that are
 * equally near up to rounding the first counts, in the order of the views (NearestNumbers.h).
 *
 * Guaranteed: a place depends on the input and the sample only, not on other samples or the
 * executor. The memory is bytesFor(). Throws Refusal as sanitize() does, and Interrupted.
 */
class InputPlaces
{
public:
  ///@{
  /// Makes what searches need. The arrays of the views must live as long as this object. `mirror`
  /// is the source's (Mirror.h).
  InputPlaces(
    const std::vector<TrianglesView>& views, const std::string& mirror, Executor& executor);
  InputPlaces(
    const std::vector<OrientedPointsView>& views, const std::string& mirror, Executor& executor);
  ///@}

  /// Returns the approximate memory for an input of `primitives` triangles or points, in bytes.
  static std::size_t bytesFor(bool areTriangles, std::size_t primitives);

  /// Finds the places that are nearest to `count` samples at positionOf(n), which is called from
  /// several threads. Neighbours that follow each other are found fastest. Samples that are not
  /// finite have no place, and none has one where the input is empty.
  void find(std::size_t count, const std::function<Eigen::Vector3d(std::size_t)>& positionOf,
    InputPlace* places, Executor& executor) const;

  ///@{
  /// Finds the views and primitives of places as find() does, without weights, for many samples
  /// that share the search: samples of an extent of a grid, and scattered ones.
  void findOnGrid(
    const Grid& grid, const Extent& extent, InputPlace* places, Executor& executor) const;
  void findAt(const VectorsView& samples, InputPlace* places, Executor& executor) const;
  ///@}

private:
  void describe(
    const std::vector<std::uint32_t>& numbers, InputPlace* places, Executor& executor) const;
  template <class View> void numberUsable(const std::vector<View>& views, std::size_t usable);
  void findImages(const Eigen::Vector3d& sample, std::vector<Eigen::Vector3d>& images) const;
  InputPlace placeOf(std::uint32_t number) const;
  InputPlace placeOf(const NearestNumbers::Answer& answer, const Eigen::Vector3d& image) const;

  std::vector<TrianglesView> triangles_;  ///< none for points
  std::vector<Plane> planes_;             ///< of symmetry
  std::vector<std::size_t> starts_;       ///< number of the first usable primitive of each view
  std::vector<std::uint32_t> primitives_; ///< by number; none where all are usable
  DistanceTree tree_;
  NearestNumbers numbers_;
};

} // namespace winding
