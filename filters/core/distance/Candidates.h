// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/UninitializedVector.h"
#include "distance/NearestKernels.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// Finds which items may be nearer than a point x to a sample of a box; see Candidates.
struct CandidateTest
{
  double nearest[3];  ///< x
  double gradient[3]; ///< −2 (c − x), where c is the centre of the box
  double size[3];     ///< of the box
  double slack;       ///< what rounding may add to a difference of squared distances
};

/**
 * Items that may be nearest to the samples of a cell, a box: their numbers and their corners, with
 * an array for each coordinate, so that vectors of items can be tested at once.
 *
 * Let x be a point of the source. An item can be dropped if all of it is farther than x from all
 * samples q. f(p) = |p − q|² − |x − q|² = |p − x|² − 2 (p − x)·(q − x) is a number at each point p
 * of the item. For a mean p of corners vᵢ with weights λᵢ, f(p) = Σ λᵢ f(vᵢ) − Σ λᵢ λⱼ |vᵢ − vⱼ|²,
 * where the last sum, over pairs, is the squared distance that the weights give the corners from p
 * in the mean. It is ρ² at most, the square of the radius of the smallest circle around the item,
 * which is at most a third of the longest side's square (Jung's theorem). So an item is dropped
 * where f exceeds ρ² at all corners, and for all q: (v − x)·(q − x) is largest in a box with centre
 * c and sides s where it is (v − x)·(c − x) + Σ |v − x|ₖ sₖ/2.
 */
class Candidates
{
public:
  /// corners: how many an item has, 3 for triangles and 1 for points.
  explicit Candidates(std::size_t corners)
    : corners_(corners)
  {
  }

  std::size_t size() const { return size_; }
  const std::uint32_t* numbers() const { return numbers_.data(); }

  /// At least the squared radius of the smallest circle around the item at a place.
  double squaredRadius(std::size_t place) const { return rows_[3 * corners_ * stride_ + place]; }

  ///@{
  /// Replaces all by the items of some runs of an array.
  void assign(const NearTriangle* triangles, const std::vector<NearItems>& runs);
  void assign(const NearPoint* points, const std::vector<NearItems>& runs);
  ///@}

  /// Replaces all by those at some places of others.
  void assign(const Candidates& others, const std::vector<std::uint32_t>& places);

  /// Sets `places` to the places of the items that pass a test, in their order.
  void find(const CandidateTest& test, std::vector<std::uint32_t>& places) const;

private:
  double* row(std::size_t number) { return rows_.data() + number * stride_; }
  const double* row(std::size_t number) const { return rows_.data() + number * stride_; }
  void makeRoomFor(std::size_t count);

  std::size_t corners_;
  std::size_t size_ = 0;
  std::size_t stride_ = 0;           ///< from row to row
  UninitializedVector<double> rows_; ///< coordinates of corners, corner by corner; squared radii
  UninitializedVector<std::uint32_t> numbers_;
};

} // namespace winding
