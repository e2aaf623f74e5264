// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <nanoflann.hpp>

#include <cstddef>
#include <cstdint>

namespace winding
{

/// The interface through which nanoflann reads positions, which must outlive its trees.
struct SearchedPositions
{
  using Metric = nanoflann::L2_Simple_Adaptor<double, SearchedPositions, double, std::uint32_t>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, SearchedPositions, 3, std::uint32_t>;

  const Eigen::Vector3d* first;
  std::size_t count;

  std::size_t kdtree_get_point_count() const { return count; }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return first[i][axis]; }
  template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};

} // namespace winding
